// The same bits whatever the caller has done to the processor. Linking a program with -ffast-math sets it to take
// denormals for zero; fesetround turns its rounding; feenableexcept makes inexact results trap. Each of them changes
// what a sum is, or whether it returns, so every public query runs under this guard.
//
// It compiles to a store and a compare when there is nothing to change.
#pragma once

#include <cstdint>
#include <type_traits>

#if defined(_M_X64) && !defined(__GNUC__)
#include <xmmintrin.h>
#endif

namespace surefoot::internal {

#if defined(__x86_64__) || defined(_M_X64)
inline constexpr std::uint32_t ieee_state = 0x1f80;  // MXCSR: to nearest, denormals kept, nothing traps
inline constexpr std::uint32_t ieee_flags = 0x3f;    // what has happened so far; no business of ours
#elif defined(__aarch64__)
inline constexpr std::uint64_t ieee_state = 0;  // FPCR: to nearest, denormals kept, nothing traps
inline constexpr std::uint64_t ieee_flags = 0;
#else
inline constexpr std::uint32_t ieee_state = 0;
inline constexpr std::uint32_t ieee_flags = 0;
#endif

// While one lives: rounding to nearest, denormals as they are, nothing traps.
class [[nodiscard]] IeeeGuard {
public:
    IeeeGuard() noexcept : callers_(read()) {
        if ((callers_ & ~ieee_flags) != ieee_state) write(ieee_state);
    }
    ~IeeeGuard() {
        if ((callers_ & ~ieee_flags) != ieee_state) write(callers_);
    }
    IeeeGuard(const IeeeGuard&) = delete;
    IeeeGuard& operator=(const IeeeGuard&) = delete;

private:
    using State = std::remove_const_t<decltype(ieee_state)>;

    // The memory clobber keeps loads of the query's numbers after the change, and stores of its answer before the
    // change back; without it a compiler is free to move arithmetic across.
#if defined(__x86_64__) && defined(__GNUC__)
    static State read() noexcept {
        State state = 0;
        asm volatile("stmxcsr %0" : "=m"(state));
        return state;
    }
    static void write(State state) noexcept {
        asm volatile("ldmxcsr %0" : : "m"(state) : "memory");
    }
#elif defined(_M_X64)
    static State read() noexcept {
        return _mm_getcsr();
    }
    static void write(State state) noexcept {
        _mm_setcsr(state);
    }
#elif defined(__aarch64__) && defined(__GNUC__)
    static State read() noexcept {
        State state = 0;
        asm volatile("mrs %0, fpcr" : "=r"(state));
        return state;
    }
    static void write(State state) noexcept {
        asm volatile("msr fpcr, %0" : : "r"(state) : "memory");
    }
#else
    static State read() noexcept {
        return ieee_state;
    }
    static void write(State) noexcept {}
#endif

    State callers_;
};

}  // namespace surefoot::internal
