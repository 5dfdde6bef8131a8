/// Dust, sparkles and splashes: a small pool of puffs that fly, shrink and are gone. The same seed and the same calls
/// give the same puffs.
#pragma once

#include <cstdint>

#include <surefoot/character.hpp>
#include <surefoot/slab.hpp>

#include "platformer/hero/pose.hpp"
#include "view/renderer.hpp"

namespace surefoot::platformer {

struct Puff {
    dvec3 place{0, 0, 0};
    dvec3 before{0, 0, 0};  ///< where it was a tick ago
    dvec3 velocity{0, 0, 0};
    double age = 0;     ///< [s]
    double life = 0.5;  ///< [s]
    double size = 0.1;  ///< at first [m]
    double growth = 0;  ///< [m/s]
    double fall = 0;    ///< [m/s^2]
    double slows = 3;   ///< [1/s]
    view::Colour colour = view::paint::paper;
    float glow = 0;
    double stretch = 0;  ///< along its way, for streaks [s]
};

class Particles {
public:
    static constexpr std::uint32_t most = 256;

    explicit Particles(std::uint64_t seed = 1) : puffs_(most), random_(seed) {}

    bool reduced_motion = false;  ///< a third of them

    /// What a hero's tick raises: dust when it lands, starts or slides, streaks of a dash, puffs of a jump in the air.
    void follow(const HeroPose& pose, const CharacterState& before, const CharacterState& after,
                const CharacterEvents& events, double dt);

    void land(const dvec3& soles, double speed);
    void sparkle(const dvec3& place, view::Colour colour);
    void splash(const dvec3& place, double speed);
    void burst(const dvec3& place, view::Colour colour);  ///< of an enemy, or of the hero

    void advance(double dt);
    void clear() { puffs_.clear(); }
    void draw(view::Renderer& renderer, double blend) const;

    [[nodiscard]] std::uint32_t size() const { return puffs_.size(); }
    [[nodiscard]] const Slab<Puff>& puffs() const { return puffs_; }

private:
    void add(const Puff& puff);
    [[nodiscard]] int count(int usual) const { return reduced_motion ? (usual + 2) / 3 : usual; }
    [[nodiscard]] double random(double low, double high);
    [[nodiscard]] dvec3 around(double angle_share) const;

    Slab<Puff> puffs_;
    std::uint64_t random_;
    double since_dust_ = 0;
};

}  // namespace surefoot::platformer
