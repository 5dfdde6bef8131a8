#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace surefoot::tools {

std::string short_number(double value) {
    // A hair's breadth of rounding is no information to a person: -1.2e-17 reads as 0.
    if (std::abs(value) < 1e-12) return "0";
    return fmt::format("{:.6g}", value);
}

std::string short_vector(const dvec3& v) {
    return fmt::format("{}, {}, {}", short_number(v.x), short_number(v.y), short_number(v.z));
}

std::string describe(const Volume& volume) {
    struct Words {
        std::string operator()(const Sphere& s) const { return fmt::format("sphere of radius {} m", s.radius); }
        std::string operator()(const Ellipsoid& s) const {
            return fmt::format("ellipsoid with radii {} x {} x {} m", s.radii.x, s.radii.y, s.radii.z);
        }
        std::string operator()(const Capsule& s) const {
            return fmt::format("capsule of radius {} m, {} m tall", s.radius, 2 * (s.half_height + s.radius));
        }
        std::string operator()(const Box& s) const {
            return fmt::format("box of {} x {} x {} m", 2 * s.half_extents.x, 2 * s.half_extents.y,
                               2 * s.half_extents.z);
        }
        std::string operator()(const Cylinder& s) const {
            return fmt::format("cylinder of radius {} m, {} m tall", s.radius, 2 * s.half_height);
        }
        std::string operator()(const Cone& s) const {
            return fmt::format("cone of radius {} m, {} m tall, apex down", s.radius, s.height);
        }
    };
    const dquat& q = volume.orientation;
    const bool upright = q.x == 0 && q.y == 0 && q.z == 0;
    return std::visit(Words{}, volume.shape) +
           (upright ? "" : fmt::format(", turned by ({}, {}, {}, {})", q.w, q.x, q.y, q.z));
}

std::string_view in_words(Feature feature) {
    switch (feature) {
        case Feature::face:
            return "face: the inside of the triangle";
        case Feature::edge:
            return "edge: a side of the triangle";
        case Feature::vertex:
            break;
    }
    return "vertex: a corner of the triangle";
}

std::string grouped(std::size_t count) {
    const std::string digits = std::to_string(count);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) text += ' ';
        text += digits[i];
    }
    return text;
}

std::string duration(double seconds) {
    if (seconds < 1e-3) return fmt::format("{:.3g} us", seconds * 1e6);
    if (seconds < 1) return fmt::format("{:.3g} ms", seconds * 1e3);
    return fmt::format("{:.1f} s", seconds);
}

std::string Table::text() const {
    std::vector<std::size_t> widths;
    std::vector<bool> numeric;
    for (std::size_t r = 0; r < rows_.size(); ++r)
        for (std::size_t c = 0; c < rows_[r].size(); ++c) {
            const std::string& cell = rows_[r][c];
            if (c == widths.size()) {
                widths.push_back(0);
                numeric.push_back(true);
            }
            widths[c] = std::max(widths[c], cell.size());
            const bool number = !cell.empty() && cell.find_first_not_of("0123456789 .,+-e%") == std::string::npos;
            if (r > 0 && !number) numeric[c] = false;
        }
    std::string out;
    for (const auto& row : rows_) {
        std::string line;
        for (std::size_t c = 0; c < row.size(); ++c)
            line +=
                numeric[c] ? fmt::format("{:>{}}  ", row[c], widths[c]) : fmt::format("{:<{}}  ", row[c], widths[c]);
        line.erase(line.find_last_not_of(' ') + 1);
        out += "  " + line + '\n';
    }
    return out;
}

}  // namespace surefoot::tools
