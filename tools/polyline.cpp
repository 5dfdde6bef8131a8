#include "polyline.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>

#include "command.hpp"
#include "parse.hpp"
#include "query.hpp"

namespace surefoot::tools {

dvec3 Polyline::operator()(double t) const {
    const double along = std::clamp(t, 0.0, 1.0) * segments();
    const double nearest = std::round(along);
    // t = k / segments must give point k itself, whatever the rounding of the division.
    if (std::abs(along - nearest) < 1e-12 * std::max(1.0, nearest)) return points[static_cast<std::size_t>(nearest)];
    const auto piece = static_cast<std::size_t>(along);
    const double share = along - static_cast<double>(piece);
    return points[piece] + share * (points[piece + 1] - points[piece]);
}

Polyline read_polyline(const std::string& file) {
    std::ifstream input(file, std::ios::binary);
    if (!input)
        throw Failure{ExitCode::file, fmt::format("{}: cannot be read; --path takes a file of lines x,y,z", file)};
    constexpr std::size_t most_points = 1U << 24U;  // as many as a march has steps
    Polyline line;
    std::string text;
    for (std::size_t number = 1; std::getline(input, text); ++number) {
        const std::string_view content = std::string_view(text).substr(0, text.find('#'));
        if (content.find_first_not_of(" \t\r") == content.npos) continue;
        const Parsed<dvec3> point = parse_vector(content);
        if (!point && number == 1 && content.find_first_of("0123456789") == content.npos) continue;
        if (!point) throw Failure{ExitCode::file, fmt::format("{}: line {}: {}", file, number, point.error())};
        if (const auto wrong = complaint(fmt::format("{}: line {}", file, number), *point))
            throw Failure{ExitCode::file, *wrong};
        if (line.points.size() == most_points)
            throw Failure{ExitCode::file, fmt::format("{}: more than {} points", file, most_points)};
        line.points.push_back(*point);
    }
    if (line.points.size() < 2)
        throw Failure{ExitCode::file, fmt::format("{}: a path needs two lines x,y,z or more", file)};
    return line;
}

}  // namespace surefoot::tools
