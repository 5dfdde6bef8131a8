/// A crowd: which characters are near which, for thousands of them, so that all of them can step at once.
///
///     crowd.gather(characters, dt);               // where everybody is now
///     step_all(world, crowd, characters, dt);     // everybody steps, and sees the others where they were
///
/// Everybody reads the states of the tick's start and nobody's answer, so neither the order in which they are held, nor
/// the order in which they step, nor the number of threads that share the work changes a bit.
///
/// What is promised of two hard ones (docs/crowds.md has the reasons): they never get deeper into each other than they
/// begin, and two that were apart overlap after a tick by no more than either of them moved in it, so by less than
/// (v1 + v2) dt. An overlap is undone in the next tick, each of them doing half, wherever there is room.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <surefoot/character.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// How many others a character of a crowd heeds: the nearest ones.
inline constexpr std::size_t most_met_in_crowd = 32;

/// A grid over characters. Const calls may run on any number of threads at once. `reserve` and `gather` allocate, and
/// `gather` only when there are more than there ever was room for. A crowd that was moved from may only be destroyed or
/// assigned to.
class Crowd {
public:
    Crowd() noexcept = default;
    Crowd(Crowd&& other) noexcept;
    Crowd& operator=(Crowd&& other) noexcept;
    ~Crowd();

    /// Makes room for so many. False, and nothing is changed, if there is no memory for them.
    [[nodiscard]] bool reserve(std::size_t count) noexcept;

    /// Takes in where all characters are before they step by `dt` [s]. One with numbers that are out of range is met by
    /// nobody. False, and the crowd is empty, if there is no memory for so many, or if the spans do not fit.
    [[nodiscard]] bool gather(const Characters& characters, double dt) noexcept;

    [[nodiscard]] std::size_t size() const noexcept;

    /// Fills `room` with those that the character at `index` of the gathered ones might come to meet in its step, the
    /// nearest first, ties in an order that depends on their numbers alone. Returns how many there are, which may be
    /// more than found room.
    std::size_t neighbours(std::size_t index, std::span<Neighbour> room) const noexcept;

private:
    struct State;
    State* state_ = nullptr;
};

/// Steps each of the characters in `range`, among the others of the crowd. Threads may share the work: give each a
/// range of its own. Requires: the crowd gathered these very characters, before any of them was stepped; asserts that
/// there are as many, and with asserts off does nothing if there are not.
void step_all(const World& world, const Crowd& crowd, const Characters& characters, double dt,
              StepRange range = {}) noexcept;

}  // namespace v0
}  // namespace surefoot
