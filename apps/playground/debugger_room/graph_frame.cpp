#include "playground/debugger_room/graph_frame.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::playground {

view::dvec2 GraphFrame::at(double t, double g) const {
    return {low.x + t * (high.x - low.x), high.y - (g - least) / (most - least) * (high.y - low.y)};
}

double GraphFrame::t_at(double x) const {
    return std::clamp((x - low.x) / (high.x - low.x), 0.0, 1.0);
}

GraphFrame frame_of(std::span<const debugger::GapSample> samples, const view::dvec2& low, const view::dvec2& high) {
    double least = 0;
    double most = 0;
    for (const debugger::GapSample& sample : samples) {
        least = std::min(least, sample.g);
        most = std::max(most, sample.g);
    }
    const double range = most - least;
    const double air = range > 0 ? range * 0.1 : 1;
    return {low, high, least - air, most + air};
}

std::vector<double> round_marks(double low, double high, int most) {
    double unit = std::pow(10, std::floor(std::log10((high - low) / most)));
    const auto count = [&](double step) { return std::floor(high / step) - std::ceil(low / step) + 1; };
    double step = unit;
    for (const double factor : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0}) {
        step = unit * factor;
        if (count(step) <= most) break;
    }
    std::vector<double> marks;
    for (double k = std::ceil(low / step); k <= std::floor(high / step); ++k) marks.push_back(k * step + 0.0);
    return marks;
}

double curve_at(std::span<const debugger::GapSample> samples, double t) {
    const auto after = std::lower_bound(samples.begin(), samples.end(), t,
                                        [](const debugger::GapSample& sample, double at) { return sample.t < at; });
    if (after == samples.begin()) return after->g;
    const auto before = after - 1;
    if (after == samples.end()) return before->g;
    const double share = (t - before->t) / (after->t - before->t);
    return before->g + share * (after->g - before->g);
}

}  // namespace surefoot::playground
