// What the copies of a mesh share.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <surefoot/mesh.hpp>

#include "file/container.hpp"
#include "platform/bytes.hpp"
#include "tree/view.hpp"
#include "tree/wide_tree.hpp"

namespace surefoot {
inline namespace v0 {

// Counted by hand rather than by shared_ptr: its header alone would be a quarter of what ours cost to compile, and its
// type information, which the core is built without, would be missed by a caller's sanitizers.
struct Mesh::Data {
    mutable std::atomic<std::uint64_t> owners{1};
    internal::MeshView view;

    /// A mesh that was built in this process.
    static Data* from(internal::WideTree&& tree, std::vector<std::uint32_t>&& surfaces, const internal::Box3& bounds,
                      std::uint64_t vertex_count) {
        auto* const data = new Data;
        data->tree_ = std::move(tree);
        data->surfaces_ = std::move(surfaces);
        data->view.nodes = data->tree_.nodes;
        data->view.leaves = data->tree_.leaves;
        data->view.places = data->tree_.places;
        data->view.surfaces = data->surfaces_;
        data->view.bounds = bounds;
        data->view.vertex_count = vertex_count;
        return data;
    }

    /// A mesh in a file, mapped or read.
    static Data* over(internal::MappedFile&& mapped, internal::Container&& container,
                      const internal::MeshView& within) {
        Data* const data = over(std::move(container), within);
        data->mapped_.emplace(std::move(mapped));
        return data;
    }
    static Data* over(internal::OwnedBytes&& bytes, internal::Container&& container, const internal::MeshView& within) {
        Data* const data = over(std::move(container), within);
        data->bytes_ = std::move(bytes);
        return data;
    }

    /// The file that the arrays lie in; null for a mesh that was built in this process.
    [[nodiscard]] const internal::Container* container() const noexcept {
        const Data& owner = owner_ != nullptr ? *owner_ : *this;
        return owner.container_ ? &*owner.container_ : nullptr;
    }

    /// Another view of the same arrays, which live as long as either.
    static Data* sharing(const Data& other) {
        const Data* const owner = other.owner_ != nullptr ? other.owner_ : &other;
        owner->owners.fetch_add(1, std::memory_order_relaxed);
        auto* const data = new Data;
        data->view = other.view;
        data->owner_ = owner;
        return data;
    }

    void hide_as(std::vector<std::uint64_t>&& bits) {
        hidden_ = std::move(bits);
        view.hidden = hidden_;
    }

    Data() = default;
    Data(const Data&) = delete;
    Data& operator=(const Data&) = delete;
    ~Data() {
        if (owner_ != nullptr && owner_->owners.fetch_sub(1, std::memory_order_acq_rel) == 1) delete owner_;
    }

private:
    static Data* over(internal::Container&& container, const internal::MeshView& within) {
        auto* const data = new Data;
        data->container_.emplace(std::move(container));
        data->view = within;
        return data;
    }

    std::optional<internal::MappedFile> mapped_;
    internal::OwnedBytes bytes_;
    std::optional<internal::Container> container_;
    internal::WideTree tree_;
    std::vector<std::uint32_t> surfaces_;
    std::vector<std::uint64_t> hidden_;
    const Data* owner_ = nullptr;
};

}  // namespace v0
}  // namespace surefoot
