#include "platform/bytes.hpp"

#include <cstring>
#include <new>
#include <utility>

#include "platform/memory.hpp"

namespace surefoot::internal {

OwnedBytes OwnedBytes::allocate(std::size_t size) noexcept {
    OwnedBytes owned;
    if (size == 0) return owned;
    auto* const memory =
        static_cast<std::byte*>(::operator new (size, std::align_val_t{alignment_for(size)}, std::nothrow));
    if (memory == nullptr) return owned;
    advise_huge_pages(memory, size);
    std::memset(memory, 0, size);
    owned.bytes_ = {memory, size};
    return owned;
}

OwnedBytes::OwnedBytes(OwnedBytes&& other) noexcept : bytes_(std::exchange(other.bytes_, {})) {}

OwnedBytes& OwnedBytes::operator=(OwnedBytes&& other) noexcept {
    std::swap(bytes_, other.bytes_);
    return *this;
}

OwnedBytes::~OwnedBytes() {
    if (!bytes_.empty()) ::operator delete (bytes_.data(), std::align_val_t{alignment_for(bytes_.size())});
}

MappedFile::MappedFile(MappedFile&& other) noexcept : bytes_(std::exchange(other.bytes_, {})) {}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept {
    std::swap(bytes_, other.bytes_);
    return *this;
}

MappedFile::~MappedFile() {
    if (!bytes_.empty()) unmap(bytes_);
}

}  // namespace surefoot::internal
