// More triangles than there is room for, a room full at a time.
#pragma once

#include <cstddef>
#include <cstdint>

#include <surefoot/source.hpp>
#include <surefoot/world.hpp>

#include "query/reach.hpp"
#include "raw_array.hpp"
#include "vec.hpp"

namespace surefoot::internal {

/// Calls `visit(triangle)` once for every triangle in a box, however many there are. The box is searched in slices with
/// a room full or so in each; where a slice holds more, such as a fan about one corner, it is searched again for those
/// that come after the ones that were visited.
template <typename Visit>
class EachOfMany {
public:
    EachOfMany(const World& world, const WorldQuery& query, const Box3& box, const Visit& visit) noexcept
        : world_(world), query_(query), box_(box), visit_(visit) {
        const Vec size = box.max - box.min;
        axis_ = size.x >= size.y && size.x >= size.z ? &Vec::x : size.y >= size.z ? &Vec::y : &Vec::z;
        const std::size_t slices = 1 + gather(box, {}, query) / (room / 2);
        slices_ = slices < most_slices ? slices : most_slices;
    }

    void run() noexcept {
        for (std::size_t i = 0; i < slices_; ++i) search(i);
    }

private:
    static constexpr std::size_t room = 256;
    static constexpr std::size_t most_slices = 256;

    std::size_t gather(const Box3& box, std::span<SourceTriangle> found, const WorldQuery& query) const noexcept {
        return world_.gather({to_dvec3(box.min), to_dvec3(box.max)}, found, query);
    }

    double begin_of(std::size_t slice) const noexcept {
        if (slice == slices_) return box_.max.*axis_;
        const double share = static_cast<double>(slice) / static_cast<double>(slices_);
        return box_.min.*axis_ + (box_.max.*axis_ - box_.min.*axis_) * share;
    }

    void search(std::size_t slice) noexcept {
        Box3 box = box_;
        box.min.*axis_ = begin_of(slice);
        box.max.*axis_ = begin_of(slice + 1);
        std::size_t done = 0;
        std::size_t seen = 0;
        const auto is_next = [&](std::uint32_t, std::uint32_t, std::uint32_t) noexcept {
            const std::size_t place = seen++;
            return place >= done && place < done + room;
        };
        WorldQuery query = query_;
        query.triangles = BodyTriangleFilter(is_next);
        do {
            seen = 0;
            const std::size_t count = gather(box, found_.all(), query);
            for (std::size_t i = 0; i < count && i < room; ++i) {
                // What begins before this slice was in one of those before it.
                const bool begins_here = slice == 0 || box_of(found_[i].triangle).min.*axis_ > box.min.*axis_;
                if (begins_here) visit_(found_[i]);
            }
            done += room;
        } while (seen > done);
    }

    const World& world_;
    const WorldQuery& query_;
    Box3 box_;
    const Visit& visit_;
    double Vec::*axis_ = &Vec::x;
    std::size_t slices_ = 1;
    RawArray<SourceTriangle, room> found_;
};

template <typename Visit>
void each_of_many(const World& world, const WorldQuery& query, const Box3& box, const Visit& visit) noexcept {
    EachOfMany<Visit>(world, query, box, visit).run();
}

}  // namespace surefoot::internal
