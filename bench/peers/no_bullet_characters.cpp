// Stands in for bullet_characters.cpp where Bullet's character controller was not found.
#include "characters.hpp"

namespace surefoot::bench {

std::vector<CharacterRow> run_bullet_characters(const Stage& /*stage*/, const CharacterOptions& /*options*/,
                                                const std::vector<dvec3>& /*places*/) {
    return {};
}

}  // namespace surefoot::bench
