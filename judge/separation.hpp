/// Planes that keep the moving shape and the triangle apart: the certificate of "not late" and of "no hit".
#pragma once

#include <optional>

#include "frame.hpp"
#include "gjk.hpp"
#include "interval.hpp"

namespace judge {

/// One query, with what several certificates share.
class Examination {
public:
    explicit Examination(const Query& query) : query_(query), local_(query) {}

    [[nodiscard]] const Query& query() const { return query_; }
    [[nodiscard]] const Local<double>& local() const { return local_; }
    [[nodiscard]] const Frame<Interval>& intervals();
    [[nodiscard]] const Frame<Dyadic>& exactly();

    /// A normal of the world in the shape's frame.
    [[nodiscard]] V3<double> into_frame(const Vec& n) const;

    /// Does the plane with this normal separate over [0, t]: gap > 0 at 0, and > 0 (strict) or >= 0 at t? Decided
    /// rigorously: `true` is a proof.
    template <class F>
    [[nodiscard]] bool separates(const V3<F>& n, double t, bool strict);

    /// The same for a normal of exact numbers.
    [[nodiscard]] bool separates_exactly(const V3<Dyadic>& n, double t, bool strict);

    /// Looks for such a plane. `hint`: a normal in the shape's frame to try first, or none. A quick look takes what a
    /// search in doubles proposes; a thorough one goes on to wider floats and to normals in exact numbers.
    [[nodiscard]] bool find_quickly(const V3<double>* hint, double t, bool strict);
    [[nodiscard]] bool find_thoroughly(double t, bool strict);

    /// Do the two overlap beyond doubt at some time in [0, t]?
    [[nodiscard]] bool overlaps_within(double t);

    /// A rigorous upper bound on how far triangle and shape are apart at time t: the distance between the point with
    /// the given weights of b and c (clamped to the triangle) and a point of the shape near it. [m]
    [[nodiscard]] double reach(double t, double weight_b, double weight_c);
    /// The same for the nearest points that a search finds; it is content with `allowed`.
    [[nodiscard]] double reach(double t, double allowed);

    /// The gap along n at time t in doubles: a lower bound on the distance, but for its rounding. [m]
    [[nodiscard]] double gap(const V3<double>& n, double t) const;
    /// The support function of K' in doubles.
    [[nodiscard]] double support(const V3<double>& n) const;

private:
    [[nodiscard]] V3<double> best_box_facet(double t) const;
    template <class N>
    [[nodiscard]] bool find_facets(const Frame<N>& frame, double t, bool strict);
    template <class F>
    [[nodiscard]] Nearest<F> nearest(double t, const Local<F>& local) const;
    template <class F>
    [[nodiscard]] bool try_direction(const Nearest<F>& found, const Local<F>& local, double t, bool strict);
    template <class F>
    [[nodiscard]] double reach_by_search(const Local<F>& local, double t, int steps);
    template <class F>
    [[nodiscard]] bool find_curved(const Local<F>& local, double t, bool strict);
    [[nodiscard]] bool find_spanned(const Nearest<Quad>& found, double t, bool strict);
    [[nodiscard]] bool find_any_spanned(double t, bool strict);
    [[nodiscard]] V3<Dyadic> corner_exactly(int corner, int mate, double t);
    [[nodiscard]] bool try_span(const V3<Dyadic>* corners, int count, double t, bool strict);

    const Query& query_;
    Local<double> local_;
    std::optional<Frame<Interval>> intervals_;
    std::optional<Frame<Dyadic>> exact_;
};

}  // namespace judge
