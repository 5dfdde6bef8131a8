/// What a bot wants and what its hands make of it: no more than ten presses a second, a tick or two late.
#pragma once

#include <array>
#include <cstdint>

#include "game/hero.hpp"
#include "playtest/bots/dice.hpp"

namespace surefoot::playtest {

/// What a bot wants in a tick.
struct Intent {
    dvec3 move{0, 0, 0};  ///< level; its length is the share of full speed [0 to 1]
    dvec3 look{0, 0, 0};  ///< in this direction; zero: where it goes
    bool jump = false;    ///< wants it held
    bool crouch = false;
    bool dash = false;
};

inline constexpr double most_presses_per_second = 10;

/// Presses of all buttons together are at least a tenth of a second apart. A press that was seen coming is up to two
/// ticks late; what was pressed is held for three ticks at least, as a finger does.
class Hands {
public:
    explicit Hands(std::uint64_t seed) : dice_(seed) {}

    [[nodiscard]] game::HeroInput act(const Intent& intent);

    [[nodiscard]] std::uint64_t presses() const { return presses_; }

private:
    struct Finger {
        bool holds = false;
        bool waits = false;  ///< to press
        int late = 0;        ///< ticks until it does
        int held = 0;        ///< for so many ticks
    };
    [[nodiscard]] bool finger(Finger& finger, bool wants);

    Dice dice_;
    std::array<Finger, 3> fingers_{};
    int since_press_ = 1000;  ///< ticks
    std::uint64_t presses_ = 0;
    float yaw_ = 0;
    float pitch_ = 0;
};

/// Something changed that nobody could see coming: it counts once it has been so for about 150 ms.
class Reaction {
public:
    [[nodiscard]] bool after(bool is_so, Dice& dice);

private:
    int for_ = 0;
    int needs_ = 0;
};

/// Where somebody looks who looks along this direction, in the words of `HeroInput` [degrees].
[[nodiscard]] double yaw_of(const dvec3& direction);

}  // namespace surefoot::playtest
