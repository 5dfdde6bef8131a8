/// An equation in t of at most the second degree, written out and solved.
#pragma once

#include <string>

namespace surefoot::debugger {

/// a t^2 + b t + c = 0; linear if a is 0.
struct Equation {
    double a = 0;
    double b = 0;
    double c = 0;

    [[nodiscard]] double operator()(double t) const { return (a * t + b) * t + c; }
    [[nodiscard]] bool is_quadratic() const { return a != 0; }
    [[nodiscard]] double discriminant() const { return b * b - 4 * a * c; }
    /// "2.5 t^2 - 3 t + 0.8 = 0"; what is 0 is left out, but not the t of a linear one.
    [[nodiscard]] std::string text() const;
};

struct Roots {
    int count = 0;     ///< real ones: 0, 1 (a linear equation) or 2, which may be equal
    double lower = 0;  ///< the smaller one: of a quadratic here, where the touch begins
    double upper = 0;  ///< the larger one: where it ends
};

/// The real roots. With q = -(b + sign(b) sqrt(b^2 - 4ac)) / 2 they are q / a and c / q: nothing of like size is ever
/// subtracted but in the discriminant.
[[nodiscard]] Roots roots_of(const Equation& equation);

/// Four significant digits.
[[nodiscard]] std::string short_text(double value);

}  // namespace surefoot::debugger
