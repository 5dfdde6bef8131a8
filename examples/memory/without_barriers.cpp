// The vtable slot trick as it is usually told, without telling the compiler: not a test but a warning. Under g++ 12
// with -O1 and more it prints zeros, since a constructor promises that it has no use for what was in the memory before.
// Explained in docs/memory.md.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <new>

namespace {

struct FromFile {};

struct Part {
    explicit Part(FromFile) {}
    virtual ~Part() = default;
    virtual double area() const = 0;
};

struct Disc final : Part {
    double radius;
    std::uint64_t id;
    explicit Disc(FromFile tag) : Part(tag) {}
    double area() const override { return 3.0 * radius * radius; }
};

struct Record {
    std::uint64_t slot;
    double radius;
    std::uint64_t id;
};

}  // namespace

int main() {
    // [naive]
    const Record record{1, 2.0, 70};
    alignas(Disc) std::byte bytes[sizeof(Disc)];
    std::memcpy(bytes, &record, sizeof(record));  // "the file"

    Disc* const disc = ::new (static_cast<void*>(bytes)) Disc(FromFile{});
    std::printf("area %g, id %llu\n", disc->area(), static_cast<unsigned long long>(disc->id));
    // [/naive]
    disc->~Disc();
}
