#include "level_builder.hpp"

#include <utility>

namespace surefoot::internal {
namespace {

constexpr std::uint64_t max_triangles = std::uint64_t{1} << 31;

}  // namespace

Error time_error() {
    return {
        .code = ErrorCode::limit,
        .text = "reading took longer than ImportOptions::time_limit; raise it if the file is meant to be that large",
        .file = {}};
}

Error memory_error() {
    return {.code = ErrorCode::limit,
            .text =
                "reading needs more memory than ImportOptions::memory_limit; raise it if the file is meant to be that "
                "large, or split the level",
            .file = {}};
}

LevelBuilder::LevelBuilder(const ReadLimits& limits) : limits_(limits) {
    level_.surface_names.emplace_back();
    level_.surface_extras.emplace_back();
    surface_numbers_.emplace(std::pair<std::string, std::string>(), 0);
}

void LevelBuilder::begin_part(std::string_view name) {
    const auto end = static_cast<std::uint32_t>(level_.triangle_count());
    if (end > part_first_) {
        level_.parts.push_back(
            {.name = std::move(part_name_), .first_triangle = part_first_, .triangle_count = end - part_first_});
    }
    part_name_ = name;
    part_first_ = end;
}

void LevelBuilder::set_surface(std::string_view name, std::string_view extras) {
    surface_name_ = name;
    surface_extras_ = extras;
    surface_.reset();
}

void LevelBuilder::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (!surface_) {
        const auto next = static_cast<std::uint32_t>(level_.surface_names.size());
        const auto [place, is_new] = surface_numbers_.try_emplace({surface_name_, surface_extras_}, next);
        if (is_new) {
            level_.surface_names.push_back(surface_name_);
            level_.surface_extras.push_back(surface_extras_);
        }
        surface_ = place->second;
    }
    for (const std::uint32_t corner : {a, b, c}) level_.indices.push_back(corner);
    level_.surfaces.push_back(*surface_);
    if (is_degenerate(level_.vertices[a], level_.vertices[b], level_.vertices[c])) ++level_.notes.degenerate_triangles;
}

std::optional<Error> LevelBuilder::add_face(std::span<const std::uint32_t> corners) {
    if (corners.empty()) return std::nullopt;
    if (corners.size() == 1) {
        ++level_.notes.points_skipped;
        return std::nullopt;
    }
    if (corners.size() == 2) {
        ++level_.notes.lines_skipped;
        return std::nullopt;
    }
    if (corners.size() == 3) {
        add_triangle(corners[0], corners[1], corners[2]);
    } else {
        corner_places_.clear();
        for (const std::uint32_t corner : corners) corner_places_.push_back(level_.vertices[corner]);
        const PolygonCut cut = cut_polygon(corner_places_, limits_.deadline, cut_);
        if (cut == PolygonCut::timed_out) return time_error();
        ++level_.notes.polygons_split;
        if (cut == PolygonCut::ears) ++level_.notes.polygons_concave;
        if (cut == PolygonCut::crossed) ++level_.notes.polygons_crossed;
        for (std::size_t i = 0; i < cut_.size(); i += 3) {
            add_triangle(corners[cut_[i]], corners[cut_[i + 1]], corners[cut_[i + 2]]);
        }
    }
    // Looking at the clock costs as much as a face does, so it is done now and then.
    if (++faces_since_check_ < 1024) return std::nullopt;
    faces_since_check_ = 0;
    return check_limits();
}

std::uint64_t LevelBuilder::bytes_held() const {
    return level_.vertices.capacity() * sizeof(vec3) +
           (level_.indices.capacity() + level_.surfaces.capacity()) * sizeof(std::uint32_t);
}

std::optional<Error> LevelBuilder::check_limits() const {
    if (bytes_held() > limits_.bytes) return memory_error();
    if (level_.triangle_count() > max_triangles) {
        return Error{
            .code = ErrorCode::limit, .text = "there are more than 2^31 triangles; split the level", .file = {}};
    }
    if (std::chrono::steady_clock::now() > limits_.deadline) return time_error();
    return std::nullopt;
}

ImportedLevel LevelBuilder::take() {
    begin_part({});
    return std::exchange(level_, {});
}

}  // namespace surefoot::internal
