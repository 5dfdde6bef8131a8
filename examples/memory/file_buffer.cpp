// Using objects straight from the bytes of a file: what C++20 allows, and what it needs. Explained in docs/memory.md.
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "check.hpp"

namespace {

// [record]
struct Spawn {  // as it stands in the file: fixed widths, no pointers, no padding, little-endian
    double x, y, z;
    std::uint32_t team;
    std::uint32_t flags;
};
static_assert(std::is_trivially_copyable_v<Spawn> && std::is_standard_layout_v<Spawn>);
static_assert(sizeof(Spawn) == 32 && std::has_unique_object_representations_v<std::uint32_t>);
// [/record]

// [load]
// Reads a T out of a buffer at any offset, aligned or not. Always legal: memcpy into an object that is alive.
template <typename T>
std::optional<T> load(std::span<const std::byte> file, std::size_t offset) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (offset > file.size() || file.size() - offset < sizeof(T))
        return std::nullopt;  // no overflow, whatever the bytes
    T value;
    std::memcpy(&value, file.data() + offset, sizeof(T));
    return value;
}
// [/load]

// [view]
// Looks at a whole array in place. Null if the bytes are too few or stand at an address unfit for T.
template <typename T>
const T* view(std::span<std::byte> bytes, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
    const bool is_aligned = reinterpret_cast<std::uintptr_t>(bytes.data()) % alignof(T) == 0;
    if (!is_aligned || count > bytes.size() / sizeof(T)) return nullptr;
    void* const same_bytes = std::memmove(bytes.data(), bytes.data(), count * sizeof(T));  // begins the lifetimes
    return std::launder(static_cast<const T*>(same_bytes));
}
// [/view]

std::vector<Spawn> three_spawns() {
    return {{1, 2, 3, 0, 0}, {4, 5, 6, 1, 0}, {7, 8, 9, 1, 6}};
}

void out_of_a_misaligned_buffer() {
    const std::vector<Spawn> spawns = three_spawns();
    std::vector<std::byte> file(5 +
                                spawns.size() * sizeof(Spawn));  // a header of five bytes: nothing behind it is aligned
    std::memcpy(file.data() + 5, spawns.data(), spawns.size() * sizeof(Spawn));

    const std::optional<Spawn> last = load<Spawn>(file, 5 + 2 * sizeof(Spawn));
    check(last && last->z == 9 && last->flags == 6, "memcpy reads a record from a misaligned place");
    check(!load<Spawn>(file, file.size() - 31), "a record that ends beyond the file is refused");
    check(!load<Spawn>(file, ~std::size_t{0}), "and so is an offset that would wrap around");

    const std::span<std::byte> all(file);
    check(view<Spawn>(all.subspan(5), 3) == nullptr, "a misaligned place cannot be viewed as objects");
}

void in_place() {
    const std::vector<Spawn> spawns = three_spawns();
    const std::size_t byte_count = spawns.size() * sizeof(Spawn);

    // [buffer]
    struct Free {
        void operator()(std::byte* bytes) const { ::operator delete (bytes, std::align_val_t{64}); }
    };
    // Memory from operator new is fit for any object of implicit lifetime, and aligned because we ask for it.
    const std::unique_ptr<std::byte, Free> buffer(
        static_cast<std::byte*>(::operator new (byte_count, std::align_val_t{64})));
    // [/buffer]
    std::memcpy(buffer.get(), spawns.data(), byte_count);  // stands for fread

    const std::span<std::byte> bytes(buffer.get(), byte_count);
    const Spawn* const viewed = view<Spawn>(bytes, 3);
    check(viewed != nullptr && viewed[1].y == 5 && viewed[2].team == 1, "an aligned array of records is used in place");
    check(static_cast<const void*>(viewed) == buffer.get(), "without a copy");
    check(view<Spawn>(bytes, 4) == nullptr, "more records than bytes are refused");
    check(view<Spawn>(bytes, ~std::size_t{0} / 16) == nullptr, "even where the product would wrap around");
}

}  // namespace

int main() {
    out_of_a_misaligned_buffer();
    in_place();
}
