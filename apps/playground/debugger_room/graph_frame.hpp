/// Where a curve over t lies on the screen: values to places and back, and where its axes have marks.
#pragma once

#include <span>
#include <vector>

#include "debugger/gap_curve.hpp"
#include "view/input.hpp"

namespace surefoot::playground {

struct GraphFrame {
    view::dvec2 low{0, 0};   ///< the upper left corner of the plot [window units]
    view::dvec2 high{1, 1};  ///< the lower right one
    double least = -1;       ///< g at the lower border
    double most = 1;         ///< g at the upper border

    [[nodiscard]] view::dvec2 at(double t, double g) const;

    /// The moment above or below this place, within 0 and 1 however far out it is.
    [[nodiscard]] double t_at(double x) const;
};

/// The frame that shows all samples and the line g = 0, with some air above and below.
/// Requires: at least one sample, all finite.
[[nodiscard]] GraphFrame frame_of(std::span<const debugger::GapSample> samples, const view::dvec2& low,
                                  const view::dvec2& high);

/// At most `most` round numbers from `low` to `high`: multiples of 1, 2 or 5 times a power of ten.
/// Requires: low < high, most >= 1.
[[nodiscard]] std::vector<double> round_marks(double low, double high, int most);

/// g at t, between the two samples around it. Requires: as `frame_of`.
[[nodiscard]] double curve_at(std::span<const debugger::GapSample> samples, double t);

}  // namespace surefoot::playground
