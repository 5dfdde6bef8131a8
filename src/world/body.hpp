// One body of a world: a source and the way that it takes during a tick.
#pragma once

#include <optional>

#include <surefoot/world.hpp>

#include "query/reach.hpp"
#include "world/stance.hpp"

namespace surefoot::internal {

struct WorldBody {
    WorldBody(const Mesh& copied, const Placement& placement) noexcept
        : mesh(copied), source(*mesh), id(placement.body), layers(placement.layers) {}
    WorldBody(const SourceView& referred, const Placement& placement) noexcept
        : source(referred), id(placement.body), layers(placement.layers) {}
    WorldBody(const WorldBody&) = delete;  // `source` may point to `mesh`
    WorldBody& operator=(const WorldBody&) = delete;
    ~WorldBody() = default;

    /// Requires: valid poses.
    void place(const Pose& new_start, const Pose& new_end) noexcept;
    /// Reads the source's bounds.
    void measure() noexcept;

    [[nodiscard]] bool moves() const noexcept { return moves_; }
    [[nodiscard]] bool turns() const noexcept { return turn_.turns(); }
    [[nodiscard]] Vec position_at(double time) const noexcept {
        return mix(to_vec(start.position), to_vec(end.position), time);
    }
    [[nodiscard]] Quat orientation_at(double time) const noexcept { return turn_.at(time); }
    [[nodiscard]] Stance stance_at(double time) const noexcept { return {position_at(time), turn_.at(time)}; }

    /// Everything that the body may reach during the tick, rounding included.
    [[nodiscard]] const Box3& box() const noexcept { return box_; }

    std::optional<Mesh> mesh;  ///< if the world holds it
    SourceView source;
    std::uint32_t id;
    std::uint64_t layers;
    BodyHandle handle{};
    std::uint32_t leaf = 0;  ///< in the top tree
    Pose start{};
    Pose end{};

private:
    void reach() noexcept;

    Turn turn_{start.orientation, start.orientation};
    Box3 own_box_;
    Box3 box_;
    bool moves_ = false;
};

}  // namespace surefoot::internal
