/// What a question is asked of: a few triangles as they are typed, in doubles, or the mesh of a level.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <surefoot/bounds.hpp>
#include <surefoot/mesh.hpp>
#include <surefoot/world.hpp>

#include "debugger/question.hpp"

namespace surefoot::debugger {

class Arena {
public:
    explicit Arena(std::vector<Triangle> triangles);
    explicit Arena(Mesh mesh);

    /// The first touch; of several at one time, that of the lowest triangle.
    [[nodiscard]] std::optional<Hit> sweep(const Volume& volume, const Motion& motion, bool one_sided = false) const;
    /// The deepest touch at a place; of several as deep, that of the lowest triangle.
    [[nodiscard]] std::optional<Overlap> deepest(const Volume& volume, const dvec3& position,
                                                 bool one_sided = false) const;
    [[nodiscard]] bool touches(const Volume& volume, const dvec3& position, bool one_sided = false) const;
    /// How far below a point the world begins, if it does within `farthest` [m].
    [[nodiscard]] std::optional<double> drop(const dvec3& point, double farthest) const;
    /// All triangles that may have something to do with a motion.
    [[nodiscard]] std::vector<Triangle> along(const Volume& volume, const Motion& motion) const;
    /// The level, or null for a few triangles.
    [[nodiscard]] const Mesh* mesh() const { return mesh_ ? &*mesh_ : nullptr; }
    /// The same as a world, for `step`: one body, 0, that stands. There is none in it while corners are no numbers.
    [[nodiscard]] const World& world() const;

private:
    struct Stage;  // does not move when this is copied, for the world refers to it

    std::vector<Triangle> triangles_;
    std::optional<Mesh> mesh_;
    std::shared_ptr<const Stage> stage_;
};

}  // namespace surefoot::debugger
