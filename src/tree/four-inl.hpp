// Vectors of four floats: Highway's, or on machines without any, four floats. Included once for each SIMD target.
#if defined(SUREFOOT_FOUR_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SUREFOOT_FOUR_INL_HPP
#undef SUREFOOT_FOUR_INL_HPP
#else
#define SUREFOOT_FOUR_INL_HPP
#endif

#include <bit>
#include <cstdint>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace surefoot::internal {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

struct Four {
    float lane[4];
};

template <typename Make>
HWY_INLINE Four four_of(const Make& make) noexcept {
    return {{make(0), make(1), make(2), make(3)}};
}
HWY_INLINE Four load(const float* from) noexcept {
    return {{from[0], from[1], from[2], from[3]}};
}
HWY_INLINE void store(const Four& v, float* to) noexcept {
    for (int i = 0; i < 4; ++i) to[i] = v.lane[i];
}
HWY_INLINE Four all(float x) noexcept {
    return {{x, x, x, x}};
}
HWY_INLINE Four min(const Four& a, const Four& b) noexcept {
    return four_of([&](int i) { return a.lane[i] < b.lane[i] ? a.lane[i] : b.lane[i]; });
}
HWY_INLINE Four max(const Four& a, const Four& b) noexcept {
    return four_of([&](int i) { return a.lane[i] > b.lane[i] ? a.lane[i] : b.lane[i]; });
}
HWY_INLINE Four operator+(const Four& a, const Four& b) noexcept {
    return four_of([&](int i) { return a.lane[i] + b.lane[i]; });
}
HWY_INLINE Four operator-(const Four& a, const Four& b) noexcept {
    return four_of([&](int i) { return a.lane[i] - b.lane[i]; });
}
HWY_INLINE Four operator*(const Four& a, const Four& b) noexcept {
    return four_of([&](int i) { return a.lane[i] * b.lane[i]; });
}
/// With 0 for the last.
HWY_INLINE Four first_three(const Four& v) noexcept {
    return {{v.lane[0], v.lane[1], v.lane[2], 0}};
}
HWY_INLINE void store_whole(const Four& v, std::int32_t* to) noexcept {
    for (int i = 0; i < 4; ++i) to[i] = static_cast<std::int32_t>(v.lane[i]);
}
/// The first, second and third floats of four vectors in a row.
HWY_INLINE void load_columns(const float* from, Four& x, Four& y, Four& z) noexcept {
    x = four_of([&](int i) { return from[4 * i]; });
    y = four_of([&](int i) { return from[4 * i + 1]; });
    z = four_of([&](int i) { return from[4 * i + 2]; });
}

#else

namespace hn = hwy::HWY_NAMESPACE;

using FourTag = hn::FixedTag<float, 4>;
using FourWholeTag = hn::FixedTag<std::int32_t, 4>;

struct Four {
    // Written out: those that g++ makes itself are not compiled for the target of the lanes.
    HWY_INLINE Four() noexcept {}
    HWY_INLINE Four(hn::Vec<FourTag> all_lanes) noexcept : lanes(all_lanes) {}

    hn::Vec<FourTag> lanes;
};

HWY_INLINE Four load(const float* from) noexcept {
    return {hn::Load(FourTag(), from)};
}
HWY_INLINE void store(const Four& v, float* to) noexcept {
    hn::Store(v.lanes, FourTag(), to);
}
HWY_INLINE Four all(float x) noexcept {
    return {hn::Set(FourTag(), x)};
}
HWY_INLINE Four min(const Four& a, const Four& b) noexcept {
    return {hn::Min(a.lanes, b.lanes)};
}
HWY_INLINE Four max(const Four& a, const Four& b) noexcept {
    return {hn::Max(a.lanes, b.lanes)};
}
HWY_INLINE Four operator+(const Four& a, const Four& b) noexcept {
    return {hn::Add(a.lanes, b.lanes)};
}
HWY_INLINE Four operator-(const Four& a, const Four& b) noexcept {
    return {hn::Sub(a.lanes, b.lanes)};
}
HWY_INLINE Four operator*(const Four& a, const Four& b) noexcept {
    return {hn::Mul(a.lanes, b.lanes)};
}
HWY_INLINE Four first_three(const Four& v) noexcept {
    alignas(16) static constexpr std::int32_t mask[4] = {-1, -1, -1, 0};
    return {hn::And(v.lanes, hn::BitCast(FourTag(), hn::Load(FourWholeTag(), mask)))};
}
HWY_INLINE void store_whole(const Four& v, std::int32_t* to) noexcept {
    hn::Store(hn::ConvertTo(FourWholeTag(), v.lanes), FourWholeTag(), to);
}
HWY_INLINE void load_columns(const float* from, Four& x, Four& y, Four& z) noexcept {
    hn::Vec<FourTag> unused;
    hn::LoadInterleaved4(FourTag(), from, x.lanes, y.lanes, z.lanes, unused);
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace surefoot::internal
HWY_AFTER_NAMESPACE();

#endif  // SUREFOOT_FOUR_INL_HPP
