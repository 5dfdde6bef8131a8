/// What a surface does to the feet of a character: your own table, by the number that the level's triangles carry.
#pragma once

#include <cstdint>
#include <span>
#include <type_traits>

#include <surefoot/math.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

struct SurfaceRule {
    /// Share of acceleration and braking that feet get on it [>= 0]: 1 is firm ground, 0.05 is ice.
    double grip = 1;

    /// How fast it carries what stands on it, in the frame of its body [m/s]. A conveyor belt.
    dvec3 conveyor{0, 0, 0};

    /// Exists only for a body that comes from its front: jumped through from below, stood on from above.
    bool one_way = false;

    /// Nobody stands on it, however level it is.
    bool slippery = false;

    /// Can be climbed, see `CharacterSettings::ladder_speed`.
    bool ladder = false;
};

static_assert(std::is_trivially_copyable_v<SurfaceRule>);

/// The rules by number. A surface beyond the end is firm ground. Non-owning: the table must outlive the steps.
class SurfaceRules {
public:
    constexpr SurfaceRules() noexcept = default;
    constexpr SurfaceRules(std::span<const SurfaceRule> rules) noexcept : rules_(rules) {}

    [[nodiscard]] constexpr SurfaceRule operator[](std::uint32_t surface) const noexcept {
        return surface < rules_.size() ? rules_[surface] : SurfaceRule{};
    }
    [[nodiscard]] constexpr std::span<const SurfaceRule> all() const noexcept { return rules_; }

private:
    std::span<const SurfaceRule> rules_;
};

}  // namespace v0
}  // namespace surefoot
