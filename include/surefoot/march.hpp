/// March: walk along any path and ask at each step whether the shape touches. The way most games begin, with its
/// classic failure available on purpose (too large a step tunnels through thin walls), and with a guard that cannot
/// tunnel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// What can be a path.
template <typename T>
concept PathCallable = std::is_invocable_r_v<dvec3, const T&, double>;

/// A path: any callable `dvec3(double t)` for t in [0, 1]. Non-owning: it must outlive the call it is handed to, and it
/// may not throw.
class Path {
public:
    template <PathCallable Callable>
    Path(const Callable& callable) noexcept
        : callable_(&callable),
          call_([](const void* target, double t) -> dvec3 { return (*static_cast<const Callable*>(target))(t); }) {}

    [[nodiscard]] dvec3 operator()(double t) const { return call_(callable_, t); }

private:
    const void* callable_;
    dvec3 (*call_)(const void*, double);
};

/// The path of a thrown or jumping body without drag: with s = t * duration,
/// from + velocity * s + gravity * s^2 / 2.
struct JumpArc {
    dvec3 from{0, 0, 0};         ///< [m]
    dvec3 velocity{0, 5, 0};     ///< at the start [m/s]
    dvec3 gravity{0, -9.81, 0};  ///< [m/s^2]
    double duration = 1;         ///< [s]

    [[nodiscard]] dvec3 operator()(double t) const noexcept;
};

struct MarchOptions {
    /// How many steps the path is cut into, equal in t [1, 2^24]. Samples are at t = 0, 1/steps, 2/steps, ..., 1.
    std::uint32_t steps = 60;
    /// Sweep each chord between two samples instead of only looking at the samples. A guarded march cannot tunnel
    /// through anything that the polyline of samples passes; an unguarded one tunnels as soon as a step is longer than
    /// the shape and the wall together.
    bool guarded = true;
    bool one_sided = false;  ///< see SweepOptions and OverlapOptions
};

/// What a march met.
struct MarchHit {
    Hit hit;  ///< its `t` is the time along the whole path: in a guarded march the touch itself, else the sample
    dvec3 position{0, 0, 0};  ///< of the reference point at that time [m]
    std::uint32_t step = 0;   ///< in which step, counted from 0
};

/// Walks `volume` along `path` against one triangle; the first step that touches ends it. An unguarded march reports
/// the first sample that overlaps; a guarded one the first touch of the swept chords, by the rules of `sweep`.
/// Guarantees: allocates nothing; a path that yields NaN or leaves +-1e9 m blocks there with status `invalid`.
[[nodiscard]] std::optional<MarchHit> march(const Volume& volume, const Path& path, const Triangle& triangle,
                                            const MarchOptions& options = {});

}  // namespace v0
}  // namespace surefoot
