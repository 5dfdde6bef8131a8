#include "overlap/side.hpp"

#include "exact/vector.hpp"
#include "vec.hpp"

namespace surefoot::internal {

int side_of_plane(const Triangle& triangle, const dvec3& p) noexcept {
    const Vec a = to_vec(triangle.a);
    const Vec ab = to_vec(triangle.b) - a;
    const Vec ac = to_vec(triangle.c) - a;
    const Vec ap = to_vec(p) - a;
    const double rounded = dot(cross(ab, ac), ap);
    // Nine roundings at most on the way to each of six products, none of which is larger than the product of the sums.
    // The second term covers products that fall below the normal doubles.
    const double doubt = 0x1p-47 * (norm1(ab) * norm1(ac) * norm1(ap)) + 0x1p-1000;
    if (rounded > doubt) return 1;
    if (rounded < -doubt) return -1;
    // Doubles up to 1e9 are at most 35 limbs wide, so three of them multiplied and six such terms summed fit in 112.
    using Number = ExactNumber<112>;
    const auto origin = to_exact<Number>(a);
    const auto to_b = to_exact<Number>(to_vec(triangle.b)) - origin;
    const auto to_c = to_exact<Number>(to_vec(triangle.c)) - origin;
    const auto to_p = to_exact<Number>(to_vec(p)) - origin;
    return dot(cross(to_b, to_c), to_p).sign();
}

}  // namespace surefoot::internal
