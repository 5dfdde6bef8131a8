// The vtable slot trick: objects with virtual functions, used straight from the bytes of a file. It works on g++ and
// clang++ (Itanium C++ ABI) and is outside of what the standard promises. Explained in docs/memory.md, with the
// reasons why the project's own formats do without.
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <span>
#include <type_traits>
#include <vector>

#include "check.hpp"

namespace {

// [classes]
struct FromFile {};  // "your fields are there already: leave them alone"

struct Part {
    explicit Part(FromFile) {}
    Part() = default;
    virtual ~Part() = default;
    virtual double area() const = 0;
};

struct Disc final : Part {
    double radius;
    std::uint64_t id;

    Disc(double disc_radius, std::uint64_t disc_id) : radius(disc_radius), id(disc_id) {}
    explicit Disc(FromFile tag) : Part(tag) {}  // writes the vtable pointer and nothing else
    double area() const override { return 3.0 * radius * radius; }
};

struct Plate final : Part {
    double width;
    std::uint64_t id;

    Plate(double plate_width, std::uint64_t plate_id) : width(plate_width), id(plate_id) {}
    explicit Plate(FromFile tag) : Part(tag) {}
    double area() const override { return width * width; }
};
// [/classes]

// [record]
// The same bytes, seen as a file sees them. Where the vtable pointer will stand, the file has a number for the type.
struct PartRecord {
    std::uint64_t slot;  // in the file: which class. In memory: the vtable pointer
    double size;
    std::uint64_t id;
};
enum : std::uint64_t { is_disc = 1, is_plate = 2 };
static_assert(std::is_trivially_copyable_v<PartRecord>);
static_assert(sizeof(PartRecord) == sizeof(Disc) && alignof(PartRecord) == alignof(Disc));
static_assert(sizeof(PartRecord) == sizeof(Plate) && sizeof(void*) == sizeof(std::uint64_t));
// [/record]

// [barrier]
// The compiler may not carry anything it knows about memory across this line, in either direction. It costs nothing
// at run time.
inline void* forget(void* address) {
    asm volatile("" : "+r"(address) : : "memory");
    return address;
}
// [/barrier]

// [construct]
// First way: a constructor that leaves the fields alone, run by placement new over bytes that are already there.
template <typename T>
T* wake_by_constructor(void* bytes) {
    void* const loaded = forget(bytes);  // whatever was stored there before has really been stored
    T* const object = ::new (loaded) T(FromFile{});
    return static_cast<T*>(forget(object));  // and what the fields hold now is not known to be nothing
}
// [/construct]

// [copy]
// Second way: eight bytes copied from a living object of the class. No constructor runs at all.
template <typename T>
T* wake_by_copy(void* bytes, const T& living) {
    std::memcpy(bytes, static_cast<const void*>(&living), sizeof(void*));
    return static_cast<T*>(forget(bytes));
}
// [/copy]

// [legal]
// The way that the standard allows: take the fields out, then make a new object in their place.
template <typename T>
T* wake_legally(void* bytes) {
    PartRecord record;
    std::memcpy(&record, bytes, sizeof(record));
    return ::new (bytes) T(record.size, record.id);
}
// [/legal]

std::vector<PartRecord> a_file() {
    return {{is_disc, 2.0, 70}, {is_plate, 5.0, 71}, {is_disc, 10.0, 72}};
}

std::uint64_t first_word(const void* object) {
    std::uint64_t word = 0;
    std::memcpy(&word, object, sizeof(word));
    return word;
}

void where_the_pointer_stands() {
    const Disc one(1, 1);
    const Disc other(2, 2);
    const Plate plate(1, 1);
    check(first_word(&one) == first_word(&other), "two objects of one class begin with the same word");
    check(first_word(&one) != first_word(&plate), "an object of another class does not");
    PartRecord seen;
    std::memcpy(&seen, static_cast<const void*>(&other), sizeof(seen));
    check(seen.size == 2 && seen.id == 2, "and the fields follow in the order of their declaration");
}

template <typename Wake>
void wake_a_file(Wake&& wake, const char* sentence) {
    std::vector<PartRecord> file = a_file();  // aligned for its type; a real file is read into such memory
    double area = 0;
    std::uint64_t ids = 0;
    for (PartRecord& record : file) {
        // [dispatch]
        const std::uint64_t type = record.slot;
        if (type != is_disc && type != is_plate) continue;  // before anything is called: the file is not to be trusted
        Part* const part = wake(type, static_cast<void*>(&record));
        area += part->area();  // a virtual call on bytes that came from a file
        // [/dispatch]
        ids += type == is_disc ? static_cast<Disc*>(part)->id : static_cast<Plate*>(part)->id;
    }
    check(area == 12.0 + 25.0 + 300.0 && ids == 213, sentence);
}

}  // namespace

int main() {
    where_the_pointer_stands();
    wake_a_file(
        [](std::uint64_t type, void* bytes) -> Part* {
            if (type == is_disc) return wake_by_constructor<Disc>(bytes);
            return wake_by_constructor<Plate>(bytes);
        },
        "objects woken by a constructor that leaves the fields alone");
    const Disc living_disc(0, 0);
    const Plate living_plate(0, 0);
    wake_a_file(
        [&](std::uint64_t type, void* bytes) -> Part* {
            if (type == is_disc) return wake_by_copy(bytes, living_disc);
            return wake_by_copy(bytes, living_plate);
        },
        "objects woken by a copied vtable pointer");
    wake_a_file(
        [](std::uint64_t type, void* bytes) -> Part* {
            if (type == is_disc) return wake_legally<Disc>(bytes);
            return wake_legally<Plate>(bytes);
        },
        "objects made anew from their fields, as the standard has it");
}
