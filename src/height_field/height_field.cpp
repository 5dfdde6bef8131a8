#include <algorithm>
#include <utility>

#include <surefoot/height_field.hpp>

#include "height_field/check.hpp"
#include "height_field/finder.hpp"
#include "ieee_guard.hpp"
#include "query/ask.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

struct HeightField::Data {
    HeightSamples samples;
    HeightPyramid pyramid;

    [[nodiscard]] HeightFieldFinder finder() const noexcept { return {samples, pyramid}; }

    void refit(const CellRange& quads) noexcept {
        pyramid.refit(quads, [this](const CellRange& leaf) noexcept { return samples.range_of(leaf); });
    }
};

HeightField::HeightField(Data* data) noexcept : data_(data) {}
HeightField::HeightField(const HeightField& other) : data_(new Data(*other.data_)) {}
HeightField::HeightField(HeightField&& other) noexcept : data_(std::exchange(other.data_, nullptr)) {}
HeightField& HeightField::operator=(HeightField other) noexcept {
    std::swap(data_, other.data_);
    return *this;
}
HeightField::~HeightField() {
    delete data_;
}

Expected<HeightField> HeightField::build(const HeightFieldInput& input) {
    const IeeeGuard guard;
    if (auto usable = check_input(input); !usable) return tl::unexpected(std::move(usable.error()));
    auto* data = new Data;
    HeightSamples& samples = data->samples;
    samples.x = {input.origin.x, input.cell_x, 0, std::int64_t{input.columns} - 1};
    samples.z = {input.origin.z, input.cell_z, 0, std::int64_t{input.rows} - 1};
    samples.scale = input.height_scale;
    samples.offset = input.origin.y;
    samples.diagonal = input.diagonal;
    samples.heights.assign(input.heights.begin(), input.heights.end());
    samples.levels.assign(input.levels.begin(), input.levels.end());
    samples.quads.assign(input.quads.begin(), input.quads.end());
    samples.materials.assign(input.materials.begin(), input.materials.end());
    samples.surfaces.assign(input.surfaces.begin(), input.surfaces.end());
    data->pyramid = HeightPyramid(samples.x.count(), samples.z.count());
    data->refit({0, samples.x.count() - 1, 0, samples.z.count() - 1});
    return HeightField(data);
}

Expected<void> HeightField::set(const HeightFieldPatch& patch) {
    const IeeeGuard guard;
    HeightSamples& samples = data_->samples;
    if (auto usable = check_patch(samples, patch); !usable) return usable;
    const auto copy = [](const auto& from, std::size_t first, auto& to, std::size_t begin, std::size_t count) {
        if (from.empty()) return;
        for (std::size_t i = 0; i < count; ++i) to[begin + i] = from[first + i];
    };
    const std::size_t columns = patch.columns;
    const auto all_columns = static_cast<std::size_t>(samples.x.count() + 1);
    for (std::size_t row = 0; row < patch.rows; ++row) {
        const std::size_t sample = (patch.row + row) * all_columns + patch.column;
        copy(patch.heights, row * columns, samples.heights, sample, columns);
        copy(patch.levels, row * columns, samples.levels, sample, columns);
        if (row + 1 == patch.rows) break;
        const std::size_t quad = samples.quad_at(patch.column, static_cast<std::int64_t>(patch.row + row));
        copy(patch.quads, row * (columns - 1), samples.quads, quad, columns - 1);
        copy(patch.materials, row * 2 * (columns - 1), samples.materials, 2 * quad, 2 * (columns - 1));
    }
    if (!patch.heights.empty() || !patch.levels.empty()) {
        const auto before = [](std::uint32_t first) { return std::max<std::int64_t>(std::int64_t{first} - 1, 0); };
        const auto last = [](std::uint32_t first, std::uint32_t count, const GridLine& line) {
            return std::min<std::int64_t>(std::int64_t{first} + count - 1, line.count() - 1);
        };
        data_->refit({before(patch.column), last(patch.column, patch.columns, samples.x), before(patch.row),
                      last(patch.row, patch.rows, samples.z)});
    }
    return {};
}

std::optional<Hit> HeightField::sweep(const Volume& volume, const Motion& motion,
                                      const QueryOptions& options) const noexcept {
    return ask_sweep(data_->finder(), volume, motion, options);
}

bool HeightField::sweep_any(const Volume& volume, const Motion& motion, const QueryOptions& options) const noexcept {
    return ask_sweep_any(data_->finder(), volume, motion, options);
}

std::optional<Hit> HeightField::ray(const Motion& motion, const QueryOptions& options) const noexcept {
    return ask_ray(data_->finder(), motion, options);
}

bool HeightField::ray_any(const Motion& motion, const QueryOptions& options) const noexcept {
    return ask_ray_any(data_->finder(), motion, options);
}

std::size_t HeightField::overlap(const Volume& volume, const dvec3& position, std::span<Overlap> found,
                                 const QueryOptions& options) const noexcept {
    return ask_overlap(data_->finder(), volume, position, found, options);
}

std::optional<NearestPoint> HeightField::nearest(const dvec3& point, double farthest,
                                                 const QueryOptions& options) const noexcept {
    return ask_nearest(data_->finder(), point, farthest, options);
}

std::size_t HeightField::gather(const Bounds& near, std::span<SourceTriangle> found,
                                const QueryOptions& options) const noexcept {
    return ask_gather(data_->finder(), near, found, options);
}

std::uint32_t HeightField::triangle_count() const noexcept {
    return static_cast<std::uint32_t>(2 * data_->samples.x.count() * data_->samples.z.count());
}

Bounds HeightField::bounds() const noexcept {
    const IeeeGuard guard;
    const Box3 box = data_->finder().box();
    return {to_dvec3(box.min), to_dvec3(box.max)};
}

Triangle HeightField::triangle(std::uint32_t id) const noexcept {
    const IeeeGuard guard;
    const HeightSamples& samples = data_->samples;
    const std::int64_t column = id / 2 % samples.x.count();
    const std::int64_t row = id / 2 / samples.x.count();
    const HeightQuad quad(samples, column, row);
    const bool rising = samples.is_rising(column, row);
    return id % 2 == 0 ? quad.first(rising) : quad.second(rising);
}

std::uint32_t HeightField::surface(std::uint32_t id) const noexcept {
    return data_->samples.surface(id);
}

bool HeightField::is_hole(std::uint32_t id) const noexcept {
    return data_->samples.is_hole(id / 2);
}

std::size_t HeightField::bytes() const noexcept {
    const HeightSamples& samples = data_->samples;
    return sizeof(Data) + samples.heights.capacity() * sizeof(float) +
           samples.levels.capacity() * sizeof(std::uint16_t) + samples.quads.capacity() + samples.materials.capacity() +
           samples.surfaces.capacity() * sizeof(std::uint32_t) + data_->pyramid.bytes();
}

}  // namespace v0
}  // namespace surefoot
