#include "debugger/equation.hpp"

#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace surefoot::debugger {

std::string short_text(double value) {
    return fmt::format("{:.4g}", value == 0 ? 0.0 : value);  // no -0 to puzzle a reader
}

std::string Equation::text() const {
    std::string text;
    const auto add = [&](double factor, const char* power, bool always) {
        if (factor == 0 && !always) return;
        if (text.empty())
            text += short_text(factor);
        else
            text += fmt::format(" {} {}", factor < 0 ? '-' : '+', short_text(std::abs(factor)));
        text += power;
    };
    add(a, " t^2", false);
    add(b, " t", a == 0);
    add(c, "", c != 0);
    return text + " = 0";
}

Roots roots_of(const Equation& equation) {
    const auto [a, b, c] = equation;
    if (a == 0) {
        if (b == 0) return {};
        return {1, -c / b, -c / b};
    }
    const double discriminant = equation.discriminant();
    if (!(discriminant >= 0)) return {};
    const double q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
    if (q == 0) return {2, 0, 0};
    Roots roots{2, q / a, c / q};
    if (roots.lower > roots.upper) std::swap(roots.lower, roots.upper);
    return roots;
}

}  // namespace surefoot::debugger
