// Stands in for bullet.cpp where Bullet was not found.
#include "course/movers/movers.hpp"

namespace surefoot::course {

std::unique_ptr<Mover> make_bullet() {
    return nullptr;
}

std::string_view bullet_missing() {
    return "Bullet is not built in: apt install libbullet-dev, configure and build again";
}

}  // namespace surefoot::course
