// Stands in for embree.cpp where Embree was not found.
#include "peers/peer.hpp"

namespace surefoot::bench {

std::unique_ptr<Peer> make_embree(const Scene& /*scene*/) {
    return nullptr;
}

std::string_view embree_missing() {
    return "Embree is not built in, so there is no E to compare with: apt install libembree-dev, configure and build "
           "again";
}

}  // namespace surefoot::bench
