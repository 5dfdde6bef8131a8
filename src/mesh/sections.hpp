// A mesh as the sections of a file, and back.
#pragma once

#include <string_view>
#include <vector>

#include <surefoot/error.hpp>
#include <surefoot/file.hpp>

#include "file/container.hpp"
#include "tree/view.hpp"

namespace surefoot::internal {

inline constexpr std::string_view surefoot_owner = "surefoot";
inline constexpr std::uint32_t mesh_version = 1;  ///< of all sections below

/// The section "mesh": what is not an array.
struct MeshInfo {
    std::uint64_t triangle_count = 0;
    std::uint64_t vertex_count = 0;
    double low[3] = {0, 0, 0};  ///< bounds [m]
    double high[3] = {0, 0, 0};
    std::uint32_t node_size = sizeof(WideNode);
    std::uint32_t leaf_padding_words = leaf_padding;
};

static_assert(sizeof(MeshInfo) == 72);

[[nodiscard]] MeshInfo info_of(const MeshView& view) noexcept;

/// The arrays of a view as sections, in the order in which they lie in a file. They point into the view and at `info`.
[[nodiscard]] std::vector<Section> sections_of(const MeshView& view, const MeshInfo& info);

/// Is this section one of those that `sections_of` makes?
[[nodiscard]] bool is_mesh_section(const Section& section) noexcept;

/// The arrays where they lie. Looks only at sizes: the arrays may hold anything, and reading them through the view is
/// safe. `structure` and `everything` look further; see Check.
[[nodiscard]] Expected<MeshView> view_of(const Container& container, Check check);

/// Every node and every leaf: what `Check::structure` says. `byte` of the error is counted from where the arrays lie.
[[nodiscard]] Expected<void> check_structure(const MeshView& view, const Container& container);

}  // namespace surefoot::internal
