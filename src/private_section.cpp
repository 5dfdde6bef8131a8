#include <utility>

#include <surefoot/private_section.hpp>

#include "file/container.hpp"
#include "platform/bytes.hpp"
#include "platform/memory.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

Expected<std::optional<PrivateSection>> PrivateSection::open(const std::string& path, std::string_view owner,
                                                             std::string_view name, Check check) {
    auto mapped = MappedFile::open_private(path);
    if (!mapped) return tl::unexpected(std::move(mapped.error()));
    const auto container = Container::parse(mapped->bytes(), path);
    if (!container) return tl::unexpected(container.error());
    const Section* const found = container->find(owner, name);
    if (found == nullptr) return std::nullopt;
    const std::uint64_t offset = container->offset_of(*found);
    if (check == Check::everything)
        if (const auto sum = container->check_sum(*found); !sum) return tl::unexpected(sum.error());
    PrivateSection section;
    section.version_ = found->version;
    section.made_from_ = found->made_from;
    section.of_mesh_ = container->made_from();
    section.offset_ = offset;
    // The mapping is private and writable; `Container` looks at any bytes, so it sees them const.
    section.bytes_ = {const_cast<std::byte*>(found->bytes.data()), found->bytes.size()};
    section.mapped_ = mapped->release();
    return section;
}

PrivateSection::PrivateSection(PrivateSection&& other) noexcept
    : mapped_(std::exchange(other.mapped_, {})),
      bytes_(std::exchange(other.bytes_, {})),
      version_(other.version_),
      made_from_(other.made_from_),
      of_mesh_(other.of_mesh_),
      offset_(other.offset_) {}

PrivateSection& PrivateSection::operator=(PrivateSection&& other) noexcept {
    std::swap(mapped_, other.mapped_);
    std::swap(bytes_, other.bytes_);
    version_ = other.version_;
    made_from_ = other.made_from_;
    of_mesh_ = other.of_mesh_;
    offset_ = other.offset_;
    return *this;
}

PrivateSection::~PrivateSection() {
    if (!mapped_.empty()) unmap(mapped_);
}

}  // namespace v0
}  // namespace surefoot
