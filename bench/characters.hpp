/// Many characters that walk about in a scene, timed: what an update costs, alone and among the others.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "workload.hpp"

namespace surefoot::bench {

struct CharacterOptions {
    std::size_t count = 1000;   ///< characters
    std::size_t ticks = 200;    ///< timed, of 1/60 s
    std::size_t settling = 90;  ///< before that, not timed
    std::size_t bullets = 200;  ///< characters of Bullet's, which are slow
    std::size_t bullet_ticks = 60;
};

/// How many walk how.
struct CharacterRow {
    std::string name;
    double median = 0;       ///< of ticks, each divided by its characters [ns an update]
    double p50 = 0;          ///< of single updates [ns]
    double p99 = 0;          ///< [ns]
    double p999 = 0;         ///< [ns]
    double worst = 0;        ///< [ns]
    double walked = 0;       ///< as seen from above, of `speed_asked` [m/s]
    double grounded = 0;     ///< share of all updates that end on ground [0, 1]
    double blocked = 0;      ///< share of all updates that met something in the way [0, 1]
    double gather = 0;       ///< the crowd's own: taking everybody in [ns a character]
    double neighbours = 0;   ///< the crowd's own: finding the others [ns a character]
    double met = 0;          ///< how many others a character is given
    double two_threads = 0;  ///< time of a tick on one thread over that on two; 0 where it was not measured
};

struct CharacterReport {
    double ray = 0;  ///< E: Embree's long ray, random order, in the same run [ns]; 0 without Embree
    std::vector<CharacterRow> rows;
};

inline constexpr double speed_asked = 6;  ///< [m/s]

/// Everything in turns, so that a slow minute of the machine is slow for all.
[[nodiscard]] CharacterReport run_characters(const Stage& stage, const CharacterOptions& options);

/// The same walk by Bullet's btKinematicCharacterController; nothing where Bullet is missing.
[[nodiscard]] std::vector<CharacterRow> run_bullet_characters(const Stage& stage, const CharacterOptions& options,
                                                              const std::vector<dvec3>& places);

/// Where characters begin: clear of everything, all over the scene or `dense` about its middle.
[[nodiscard]] std::vector<dvec3> make_places(const Stage& stage, std::size_t count, bool dense);

/// Where to walk: a heading that wanders, and turns back at the edge of the scene and where something is in the way.
class Wanderer {
public:
    explicit Wanderer(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15ULL + 1) { heading_ = random() * 6.283; }
    /// A velocity of `speed_asked`, level [m/s].
    dvec3 wish(const dvec3& at, double half_width, bool was_blocked);

private:
    double random();
    std::uint64_t state_;
    double heading_ = 0;
};

}  // namespace surefoot::bench
