/// A row of numbers that are dragged, or typed after a double click.
#pragma once

#include <optional>
#include <span>

#include <surefoot/math.hpp>

namespace surefoot::playground {

/// What happened to it. A drag is begun before it changes anything, and has ended after its last change.
struct RowNews {
    bool begun = false;
    bool changed = false;
    bool ended = false;
};

/// For scripts the fields are called as `names` says, after the label: "START x".
struct RowLook {
    std::span<const char* const> names;
    double speed = 0.01;  ///< of a drag, for each window unit
    double low = 0;       ///< a drag goes no further; typing does. No limit if both are 0
    double high = 0;
    const char* format = "%.6g";
};

RowNews number_row(const char* label, std::span<double> values, const RowLook& look);

/// The same for a vector.
RowNews vector_row(const char* label, dvec3& value, double speed, double low = 0, double high = 0);

}  // namespace surefoot::playground
