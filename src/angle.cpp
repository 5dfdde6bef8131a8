#include "angle.hpp"

namespace surefoot::internal {

namespace {

constexpr double radians_per_degree = 0.017453292519943295;

// Taylor's series from 0 to 45 degrees, nested. What comes after the last term is below 1e-17.
double cosine_series(double x) noexcept {
    double sum = 1;
    for (int k = 16; k >= 2; k -= 2) sum = 1 - sum * (x * x) / static_cast<double>(k * (k - 1));
    return sum;
}

double sine_series(double x) noexcept {
    double sum = 1;
    for (int k = 17; k >= 3; k -= 2) sum = 1 - sum * (x * x) / static_cast<double>(k * (k - 1));
    return sum * x;
}

}  // namespace

double cosine_deg(double angle) noexcept {
    if (angle <= 45) return cosine_series(angle * radians_per_degree);
    return sine_series((90 - angle) * radians_per_degree);
}

}  // namespace surefoot::internal
