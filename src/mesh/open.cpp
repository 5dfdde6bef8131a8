// A mesh in a file: opening, reading, writing, and what else lies in it.
#include <algorithm>
#include <cstring>

#include <surefoot/mesh.hpp>

#include "mesh/data.hpp"
#include "mesh/sections.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

// Over bytes that stay where they are, mapped or owned.
template <typename Bytes>
Expected<Mesh> Mesh::over(Bytes&& bytes, const std::string& file, Check check) {
    auto container = Container::parse(bytes.bytes(), file);
    if (!container) return tl::unexpected(std::move(container.error()));
    const auto view = view_of(*container, check);
    if (!view) return tl::unexpected(view.error());
    return Mesh(Data::over(std::forward<Bytes>(bytes), std::move(*container), *view));
}

Expected<Mesh> Mesh::open(const std::string& path, Check check) {
    auto mapped = MappedFile::open(path);
    if (!mapped) return tl::unexpected(std::move(mapped.error()));
    return over(std::move(*mapped), path, check);
}

Expected<Mesh> Mesh::read(const std::string& path, Check check) {
    auto owned = OwnedBytes::read(path);
    if (!owned) return tl::unexpected(std::move(owned.error()));
    return over(std::move(*owned), path, check);
}

Expected<Mesh> Mesh::read(std::span<const std::byte> bytes, Check check) {
    OwnedBytes owned = OwnedBytes::allocate(bytes.size());
    if (owned.bytes().size() != bytes.size())
        return tl::unexpected(Error{ErrorCode::out_of_memory, "there is no memory for a copy of this mesh", {}, 0});
    if (!bytes.empty()) std::memcpy(owned.writable().data(), bytes.data(), bytes.size());
    return over(std::move(owned), {}, check);
}

Expected<void> Mesh::write(const std::string& path, std::span<const Section> extra) const {
    for (const Section& section : extra) {
        if (!is_mesh_section(section)) continue;
        return tl::unexpected(Error{ErrorCode::invalid,
                                    "a section cannot be called 'surefoot/" + std::string(section.name) +
                                        "', which holds the mesh itself: give it an owner and a name of your own",
                                    {},
                                    0});
    }
    const MeshInfo info = info_of(data_->view);
    std::vector<Section> all = sections_of(data_->view, info);
    for (const Section& carried : sections()) {
        const bool replaced = std::any_of(extra.begin(), extra.end(), [&](const Section& section) {
            return section.owner == carried.owner && section.name == carried.name;
        });
        if (!replaced && !is_mesh_section(carried)) all.push_back(carried);
    }
    all.insert(all.end(), extra.begin(), extra.end());
    return write_file(path, all, made_from());
}

std::span<const Section> Mesh::sections() const noexcept {
    const Container* const container = data_->container();
    return container == nullptr ? std::span<const Section>{} : container->sections();
}

std::optional<Section> Mesh::section(std::string_view owner, std::string_view name) const noexcept {
    const Container* const container = data_->container();
    const Section* const found = container == nullptr ? nullptr : container->find(owner, name);
    return found == nullptr ? std::nullopt : std::optional(*found);
}

std::uint64_t Mesh::made_from() const noexcept {
    const Container* const container = data_->container();
    return container == nullptr ? 0 : container->made_from();
}

}  // namespace v0
}  // namespace surefoot
