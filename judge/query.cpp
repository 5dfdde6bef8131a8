#include "query.hpp"

#include <algorithm>
#include <cmath>

namespace judge {
namespace {

bool within(const Vec& v, double limit) {
    return std::fabs(v.x) <= limit && std::fabs(v.y) <= limit && std::fabs(v.z) <= limit;
}

double largest_of(const Vec& v) {
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

}  // namespace

const char* name_of(Kind kind) noexcept {
    constexpr const char* names[] = {"sphere", "ellipsoid", "capsule", "box", "cylinder", "cone"};
    return names[static_cast<int>(kind)];
}

int size_count(Kind kind) noexcept {
    if (kind == Kind::sphere) return 1;
    return kind == Kind::ellipsoid || kind == Kind::box ? 3 : 2;
}

bool is_valid(const Query& query) noexcept {
    constexpr double far = 1e9;
    for (const Vec* v : {&query.from, &query.to, &query.a, &query.b, &query.c})
        if (!within(*v, far)) return false;  // false for NaN as well
    const double dims[3] = {query.size.x, query.size.y, query.size.z};
    double low = dims[0], high = dims[0];
    for (int i = 0; i < size_count(query.kind); ++i) {
        if (!(dims[i] <= 1e6)) return false;
        // A capsule without a straight part is a ball, and fine.
        if (query.kind == Kind::capsule && i == 1 ? !(dims[i] >= 0) : !(dims[i] >= 1e-6)) return false;
        if (query.kind != Kind::capsule || i == 0) low = std::min(low, dims[i]);
        high = std::max(high, dims[i]);
    }
    if (high > 1e4 * low) return false;
    const double q[4] = {query.qw, query.qx, query.qy, query.qz};
    double size = 0;
    for (const double part : q) {
        if (!(std::fabs(part) <= 0x1p500)) return false;
        size = std::max(size, std::fabs(part));
    }
    return size >= 0x1p-500;
}

double largest(const Query& query) noexcept {
    double size = 0;
    for (const Vec* v : {&query.from, &query.to, &query.a, &query.b, &query.c}) size = std::max(size, largest_of(*v));
    return std::max(size, largest_dimension(query));
}

double largest_dimension(const Query& query) noexcept {
    const double dims[3] = {query.size.x, query.size.y, query.size.z};
    double size = 0;
    for (int i = 0; i < size_count(query.kind); ++i) size = std::max(size, dims[i]);
    return size;
}

}  // namespace judge
