#include "height_field/check.hpp"

#include <string>
#include <utility>

#include "limits.hpp"

namespace surefoot::internal {

namespace {

constexpr std::uint64_t most_quads = std::uint64_t{1} << 30;

tl::unexpected<Error> invalid(std::string text) {
    return tl::unexpected(Error{ErrorCode::invalid, std::move(text), {}, 0});
}

Expected<void> check_length(const char* what, std::size_t length, std::uint64_t wanted) {
    if (length == 0 || length == wanted) return {};
    return invalid("there are " + std::to_string(length) + " " + what + " where " + std::to_string(wanted) +
                   " are needed: give that many, or none");
}

Expected<void> check_line(const char* what, const char* axis, const GridLine& line) {
    if (line.told_apart(largest_coordinate)) return {};
    return invalid(
        std::string("neighbouring ") + what + " would round to the same float along " + axis +
        ", or the field reaches beyond 1e9 m: bring its origin nearer, or make its cells larger than 2^-22 of "
        "the largest coordinate, finite and above 0");
}

template <typename Sample>
Expected<void> check_heights(std::span<const Sample> samples, double scale, double offset) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
        // The same sum as HeightSamples::height_of, before a float could overflow.
        if (absolute(offset + scale * static_cast<double>(samples[i])) <= largest_coordinate) continue;
        return invalid("height sample " + std::to_string(i) +
                       " is not finite or lies beyond 1e9 m: repair it, or make height_scale smaller");
    }
    return {};
}

Expected<void> check_materials(std::span<const std::uint8_t> materials, std::size_t surfaces) {
    if (surfaces == 0) return {};
    for (std::size_t i = 0; i < materials.size(); ++i) {
        if (materials[i] < surfaces) continue;
        return invalid("triangle " + std::to_string(i) + " of the materials has material " +
                       std::to_string(materials[i]) + ", but there are only " + std::to_string(surfaces) + " surfaces");
    }
    return {};
}

}  // namespace

Expected<void> check_input(const HeightFieldInput& input) {
    if (input.columns < 2 || input.rows < 2)
        return invalid("a height field needs 2 columns and 2 rows of samples or more");
    const std::uint64_t quads = std::uint64_t{input.columns - 1} * (input.rows - 1);
    if (quads > most_quads) {
        return tl::unexpected(Error{ErrorCode::limit, "a height field holds at most 2^30 quads: split it", {}, 0});
    }
    if (input.heights.empty() == input.levels.empty()) {
        return invalid("a height field is made of heights or of levels: give one of the two");
    }
    const std::uint64_t samples = std::uint64_t{input.columns} * input.rows;
    return check_length("heights", input.heights.size(), samples)
        .and_then([&] { return check_length("levels", input.levels.size(), samples); })
        .and_then([&] { return check_length("quads", input.quads.size(), quads); })
        .and_then([&] { return check_length("materials", input.materials.size(), 2 * quads); })
        .and_then([&] {
            return check_line("columns", "x", {input.origin.x, input.cell_x, 0, std::int64_t{input.columns} - 1});
        })
        .and_then([&] {
            return check_line("rows", "z", {input.origin.z, input.cell_z, 0, std::int64_t{input.rows} - 1});
        })
        .and_then([&] { return check_heights(input.heights, input.height_scale, input.origin.y); })
        .and_then([&] { return check_heights(input.levels, input.height_scale, input.origin.y); })
        .and_then([&] { return check_materials(input.materials, input.surfaces.size()); });
}

Expected<void> check_patch(const HeightSamples& samples, const HeightFieldPatch& patch) {
    const std::uint64_t right = std::uint64_t{patch.column} + patch.columns;
    const std::uint64_t bottom = std::uint64_t{patch.row} + patch.rows;
    if (patch.columns == 0 || patch.rows == 0 || right > static_cast<std::uint64_t>(samples.x.count()) + 1 ||
        bottom > static_cast<std::uint64_t>(samples.z.count()) + 1) {
        return invalid("the patch is empty or leaves the height field, which has " +
                       std::to_string(samples.x.count() + 1) + " columns and " + std::to_string(samples.z.count() + 1) +
                       " rows");
    }
    if ((!patch.heights.empty() && samples.heights.empty()) || (!patch.levels.empty() && samples.levels.empty())) {
        return invalid("a field made of heights is patched with heights, one made of levels with levels");
    }
    if ((!patch.quads.empty() && samples.quads.empty()) || (!patch.materials.empty() && samples.materials.empty())) {
        return invalid("the field was built without quads or materials to change: give them when building");
    }
    const std::uint64_t count = std::uint64_t{patch.columns} * patch.rows;
    const std::uint64_t quads = std::uint64_t{patch.columns - 1} * (patch.rows - 1);
    return check_length("heights", patch.heights.size(), count)
        .and_then([&] { return check_length("levels", patch.levels.size(), count); })
        .and_then([&] { return check_length("quads", patch.quads.size(), quads); })
        .and_then([&] { return check_length("materials", patch.materials.size(), 2 * quads); })
        .and_then([&] { return check_heights(patch.heights, samples.scale, samples.offset); })
        .and_then([&] { return check_heights(patch.levels, samples.scale, samples.offset); })
        .and_then([&] { return check_materials(patch.materials, samples.surfaces.size()); });
}

}  // namespace surefoot::internal
