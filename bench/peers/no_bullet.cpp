// Stands in for bullet.cpp where Bullet was not found.
#include "peers/peer.hpp"

namespace surefoot::bench {

std::unique_ptr<Peer> make_bullet(const Scene& /*scene*/) {
    return nullptr;
}

std::string_view bullet_missing() {
    return "Bullet is not built in: apt install libbullet-dev, configure and build again";
}

}  // namespace surefoot::bench
