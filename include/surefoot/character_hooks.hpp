/// Ways of moving of your own: what `step` asks instead of its own rules.
#pragma once

#include <cstdint>
#include <type_traits>

#include <surefoot/math.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// A way and the velocity that goes with it. A number in it that is not finite counts as standing still.
struct OwnMotion {
    dvec3 way{0, 0, 0};       ///< relative to where the character is [m]
    dvec3 velocity{0, 0, 0};  ///< what it has afterwards [m/s]
};

/// Something that is in the way of a move, for a response of your own.
struct MetOnTheWay {
    dvec3 position{0, 0, 0};  ///< of the reference point, where the touch is [m]
    dvec3 point{0, 0, 0};     ///< of the touch [m]
    dvec3 normal{0, 0, 0};    ///< unit, towards the body, in the world; seams are sorted out
    OwnMotion left{};         ///< what is left of the way, and the velocity so far
    std::uint32_t body = 0;   ///< of the world; of a neighbour its id
    std::uint32_t triangle = 0;
    std::uint32_t surface = 0;  ///< 0 of a neighbour
    bool is_neighbour = false;
    bool on_foot = false;  ///< it walks; else it falls, swims, flies or moves in a mode of your own
};

/// A tick in a mode of your own.
struct OwnTick {
    dvec3 position{0, 0, 0};  ///< of the reference point [m]
    dvec3 velocity{0, 0, 0};  ///< [m/s]
    dvec3 wish{0, 0, 0};      ///< the input's, whole [m/s]
    dvec3 up{0, 1, 0};        ///< unit
    double dt = 0;            ///< [s]
};

/// Any function object `OwnMotion(const Question&)`. Non-owning: it must outlive the call of `step`. It may not throw,
/// and its answer may depend on the question alone, or steps are no longer a function of their arguments.
template <typename Question>
class OwnRule {
public:
    constexpr OwnRule() noexcept = default;

    template <typename Callable>
    requires(!std::is_same_v<Callable, OwnRule> && std::is_object_v<Callable> &&
             std::is_invocable_r_v<OwnMotion, const Callable&, const Question&>) constexpr OwnRule(const Callable&
                                                                                                       rule) noexcept
        : rule_(&rule), call_([](const void* target, const Question& question) -> OwnMotion {
              return (*static_cast<const Callable*>(target))(question);
          }) {}

    [[nodiscard]] OwnMotion operator()(const Question& question) const { return call_(rule_, question); }
    [[nodiscard]] explicit operator bool() const noexcept { return call_ != nullptr; }

private:
    const void* rule_ = nullptr;
    OwnMotion (*call_)(const void*, const Question&) = nullptr;
};

/// What of `step` is your own. A capture does not keep it: replay such a step where the rules are.
struct CharacterHooks {
    /// What becomes of the rest of a move when something is in its way, in place of `CharacterSettings::response`:
    /// bounce, stick, slide with friction. The way that it returns is gone as far as nothing is in it, along what is;
    /// never through. It is asked a dozen times in a move at most.
    OwnRule<MetOnTheWay> respond{};

    /// The way of a tick in `CharacterMode::own`, which has no gravity and no ground: a grappling hook, a jet pack, a
    /// cut scene. Everything is still met. Without it that mode is `invalid`.
    OwnRule<OwnTick> move{};
};

}  // namespace v0
}  // namespace surefoot
