/// Answers for people: calm sentences with units.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

namespace surefoot::tools {

/// Six significant digits, no more than anyone wants to read; `--json` has them all.
[[nodiscard]] std::string short_number(double value);

/// "1.5, 0, -2".
[[nodiscard]] std::string short_vector(const dvec3& v);

/// "ellipsoid 0.4 x 0.9 x 0.4 m" and the like, with its dimensions in words.
[[nodiscard]] std::string describe(const Volume& volume);

/// What was met, in words: "the face of the triangle, away from its border".
[[nodiscard]] std::string_view in_words(Feature feature);

/// 12 345 678.
[[nodiscard]] std::string grouped(std::size_t count);

/// "18 ms", "1.2 s".
[[nodiscard]] std::string duration(double seconds);

/// Columns of text: the first row is the heading, numbers are set flush right.
class Table {
public:
    explicit Table(std::vector<std::string> heading) : rows_{std::move(heading)} {}
    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
    [[nodiscard]] std::string text() const;

private:
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace surefoot::tools
