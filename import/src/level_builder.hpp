/// Collects faces, in order, into an ImportedLevel: cuts polygons, counts what is odd, numbers surfaces by first use,
/// and keeps within the limits.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <surefoot/import.hpp>

#include "polygon.hpp"

namespace surefoot::internal {

/// The bounds of one reading.
struct ReadLimits {
    Deadline deadline = Deadline::max();
    std::uint64_t bytes = ~std::uint64_t{0};
};

class LevelBuilder {
public:
    explicit LevelBuilder(const ReadLimits& limits);

    void add_vertex(const vec3& v) { level_.vertices.push_back(v); }
    [[nodiscard]] std::size_t vertex_count() const { return level_.vertices.size(); }

    /// The faces that follow are part of `name`. A part that gets no triangle leaves no trace.
    void begin_part(std::string_view name);

    /// The faces that follow are made of `name`. The number is given when the first face uses it; what has one name and
    /// the same extras is one surface.
    void set_surface(std::string_view name, std::string_view extras = {});

    /// One face. Requires: every corner is below vertex_count(). Fails with `limit`.
    [[nodiscard]] std::optional<Error> add_face(std::span<const std::uint32_t> corners);

    /// Fails with `limit` when time or memory has run out: for loops that add no faces.
    [[nodiscard]] std::optional<Error> check_limits() const;

    ImportNotes& notes() { return level_.notes; }

    /// The level, without a file name and without markers; the builder is empty after.
    [[nodiscard]] ImportedLevel take();

private:
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    [[nodiscard]] std::uint64_t bytes_held() const;

    ReadLimits limits_;
    ImportedLevel level_;
    std::map<std::pair<std::string, std::string>, std::uint32_t> surface_numbers_;  ///< by name and extras
    std::string surface_name_;
    std::string surface_extras_;
    std::optional<std::uint32_t> surface_;  ///< none until a face uses the name
    std::string part_name_;
    std::uint32_t part_first_ = 0;
    std::vector<vec3> corner_places_;  ///< scratch
    std::vector<std::uint32_t> cut_;   ///< scratch
    std::uint64_t faces_since_check_ = 0;
};

[[nodiscard]] Error time_error();
[[nodiscard]] Error memory_error();

}  // namespace surefoot::internal
