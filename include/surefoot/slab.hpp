/// A slab: a table of objects that are born and die one by one, in memory that is taken beforehand, named by handles
/// that know when the object they named is gone. How it works and why: docs/memory.md.
#pragma once

#include <bit>
#include <cassert>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>
#include <utility>

#if defined(__SANITIZE_ADDRESS__)
extern "C" void __asan_poison_memory_region(void const volatile*, std::size_t);
extern "C" void __asan_unpoison_memory_region(void const volatile*, std::size_t);
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
extern "C" void __asan_poison_memory_region(void const volatile*, std::size_t);
extern "C" void __asan_unpoison_memory_region(void const volatile*, std::size_t);
#endif
#endif

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

namespace slab_internal {

/// Tells AddressSanitizer, where it runs, that nobody may touch these bytes until `unpoison`.
inline void poison([[maybe_unused]] const void* bytes, [[maybe_unused]] std::size_t count) noexcept {
#if defined(__SANITIZE_ADDRESS__)
    __asan_poison_memory_region(bytes, count);
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
    __asan_poison_memory_region(bytes, count);
#endif
#endif
}

inline void unpoison([[maybe_unused]] const void* bytes, [[maybe_unused]] std::size_t count) noexcept {
#if defined(__SANITIZE_ADDRESS__)
    __asan_unpoison_memory_region(bytes, count);
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
    __asan_unpoison_memory_region(bytes, count);
#endif
#endif
}

}  // namespace slab_internal

/// Names one object in a `Slab<T>`. Plain data: copy it, store it, send it. The default handle names nothing.
/// It belongs to the slab that gave it; another slab of the same type may have an object under the same numbers.
template <typename T, std::unsigned_integral Generation = std::uint32_t>
struct SlabHandle {
    std::uint32_t index = 0;    ///< which slot
    Generation generation = 0;  ///< which tenant of that slot; always odd for a handle that a slab gave

    /// Was it ever given by a slab? Whether the object is still alive, only the slab can say.
    explicit constexpr operator bool() const noexcept { return generation != 0; }
    friend constexpr bool operator==(const SlabHandle&, const SlabHandle&) noexcept = default;
};

/// Where iterating over a slab ends.
struct SlabEnd {};

/// A table of `T`.
///
/// - `insert`, `erase`, `get` and `operator[]` take constant time; iterating takes time in the number of slots ever
///   used.
/// - An object never moves: its address is good for as long as it lives, whatever is inserted or erased around it.
/// - Memory is taken by the constructor and by `reserve`, never by `insert`, and is given back by the destructor.
/// - A handle whose object is gone gives `nullptr` from `get`, for ever: a slot whose generations have run out (after
///   2^31 tenants by default) is retired, not started over.
/// - The same calls in the same order give the same handles and the same order of iteration, on every machine.
/// - Under AddressSanitizer, touching a slot that holds no object stops the program with a report.
///
/// Threads: as for a standard container: many readers, or one writer. Copying is not offered, since a copy's objects
/// would be other objects under the same handles; moving a slab moves no object and keeps every handle good.
/// `Generation` is there for tables in which handles must be smaller, and for tests.
template <typename T, std::unsigned_integral Generation = std::uint32_t>
class Slab {
    static_assert(std::is_object_v<T> && !std::is_const_v<T> && !std::is_volatile_v<T> && !std::is_array_v<T>,
                  "Slab<T> holds plain objects: not references, arrays or const types");

public:
    using Handle = SlabHandle<T, Generation>;

    /// The most slots a slab can have.
    static constexpr std::uint32_t max_capacity = std::uint32_t{1} << 31;

    template <bool is_const>
    class Iterator;

    Slab() noexcept = default;

    /// Takes room for at least `capacity` objects [0, max_capacity]: the next power of two. If memory does not suffice
    /// the slab is empty and `capacity()` says 0.
    explicit Slab(std::uint32_t capacity) noexcept { (void)reserve(capacity); }

    Slab(const Slab&) = delete;
    Slab& operator=(const Slab&) = delete;
    Slab(Slab&& other) noexcept { swap(other); }
    Slab& operator=(Slab&& other) noexcept {
        Slab taken(std::move(other));
        swap(taken);
        return *this;
    }

    /// Destroys what is alive, in slot order, and gives the memory back.
    ~Slab() {
        static_assert(std::is_nothrow_destructible_v<T>, "Slab<T> needs a T whose destructor does not throw");
        clear();
        for (std::uint32_t chunk = 0; chunk < chunk_count_; ++chunk) {
            slab_internal::unpoison(chunks_[chunk], object_bytes(chunk_size(chunk)));
            ::operator delete(static_cast<void*>(chunks_[chunk]), chunk_alignment);
        }
    }

    void swap(Slab& other) noexcept {
        for (std::uint32_t chunk = 0; chunk < chunk_limit; ++chunk) std::swap(chunks_[chunk], other.chunks_[chunk]);
        std::swap(chunk_count_, other.chunk_count_);
        std::swap(first_bits_, other.first_bits_);
        std::swap(used_, other.used_);
        std::swap(free_, other.free_);
        std::swap(size_, other.size_);
    }

    /// Grows until there is room for at least `capacity` objects in all; never shrinks. Each growth doubles the slab
    /// with one allocation. Returns false, with what was there untouched, if memory does not suffice or `capacity` is
    /// beyond `max_capacity`.
    [[nodiscard]] bool reserve(std::uint32_t capacity) noexcept {
        if (capacity > max_capacity) return false;
        if (chunk_count_ == 0 && capacity > 0) {
            first_bits_ = static_cast<std::uint32_t>(std::bit_width(std::bit_ceil(capacity))) - 1;
            if (!add_chunk()) return false;
        }
        while (this->capacity() < capacity) {
            if (!add_chunk()) return false;
        }
        return true;
    }

    /// Makes a `T` from `arguments`, in place, and names it. Returns the handle of nothing if every slot is taken
    /// (`reserve` first). The constructor of `T` may itself insert into or erase from this slab.
    template <typename... Arguments>
    [[nodiscard]] Handle insert(Arguments&&... arguments) {
        const std::uint32_t index = take_slot();
        if (index == no_slot) return {};
        Claim claim{this, index};
        T* const place = storage(index);
        slab_internal::unpoison(place, sizeof(T));
        if constexpr (std::is_constructible_v<T, Arguments...>) {
            ::new (static_cast<void*>(place)) T(std::forward<Arguments>(arguments)...);
        } else {
            ::new (static_cast<void*>(place)) T{std::forward<Arguments>(arguments)...};
        }
        claim.slab = nullptr;
        ++size_;
        return {index, ++tag(index).generation};
    }

    /// Destroys the object; from here on its handle is dead. Requires: the object is alive; asserts otherwise, and
    /// with asserts off does nothing and returns false. The destructor of `T` may itself erase others.
    bool erase(Handle handle) noexcept {
        const bool alive = contains(handle);
        assert(alive && "Slab::erase: this handle is dead or was never alive; ask contains() first");
        if (alive) destroy(handle.index);
        return alive;
    }

    /// Destroys all objects, in slot order, and keeps the memory. Every handle is dead afterwards.
    void clear() noexcept {
        for (std::uint32_t index = 0; index < used_; ++index) {
            if (is_alive(index)) destroy(index);
        }
    }

    /// Is the object that this handle names still alive?
    [[nodiscard]] bool contains(Handle handle) const noexcept {
        return (handle.generation & 1) != 0 && handle.index < used_ &&
               tag(handle.index).generation == handle.generation;
    }

    /// The object, or null if it is gone.
    [[nodiscard]] T* get(Handle handle) noexcept { return contains(handle) ? object(handle.index) : nullptr; }
    [[nodiscard]] const T* get(Handle handle) const noexcept {
        return contains(handle) ? object(handle.index) : nullptr;
    }

    /// The object. Requires: it is alive; asserts otherwise.
    [[nodiscard]] T& operator[](Handle handle) noexcept {
        assert(contains(handle) &&
               "Slab::operator[]: this handle is dead or was never alive; ask get(), which may say null");
        return *object(handle.index);
    }
    [[nodiscard]] const T& operator[](Handle handle) const noexcept {
        assert(contains(handle) &&
               "Slab::operator[]: this handle is dead or was never alive; ask get(), which may say null");
        return *object(handle.index);
    }

    /// How many objects are alive.
    [[nodiscard]] std::uint32_t size() const noexcept { return size_; }
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }

    /// How many slots there are, retired ones included.
    [[nodiscard]] std::uint32_t capacity() const noexcept {
        return chunk_count_ == 0 ? 0 : std::uint32_t{1} << (first_bits_ + chunk_count_ - 1);
    }

    /// The living objects in slot order. Erasing any object while iterating is fine; an object inserted meanwhile is
    /// visited if its slot lies ahead.
    [[nodiscard]] Iterator<false> begin() noexcept { return {this, 0}; }
    [[nodiscard]] Iterator<true> begin() const noexcept { return {this, 0}; }
    [[nodiscard]] SlabEnd end() const noexcept { return {}; }

private:
    /// Stands beside each slot. The generation is even while the slot is empty and odd while it is taken, so that one
    /// comparison answers "alive, and still the same tenant?".
    struct Tag {
        Generation generation = 0;
        std::uint32_t next_free = no_slot;
    };

    /// Gives a slot back if the constructor of T leaves by an exception.
    struct Claim {
        Slab* slab;
        std::uint32_t index;
        ~Claim() {
            if (slab != nullptr) slab->give_slot_back(index);
        }
    };

    static constexpr std::uint32_t no_slot = ~std::uint32_t{0};
    static constexpr std::uint32_t chunk_limit = 32;
    static constexpr std::align_val_t chunk_alignment{alignof(T) > alignof(Tag) ? alignof(T) : alignof(Tag)};

    // Chunk 0 has 2^first_bits_ slots and each later chunk as many as all before it, so that the highest set bit of an
    // index names its chunk: no search, and no table that would have to grow.
    static constexpr std::size_t object_bytes(std::size_t slots) noexcept { return slots * sizeof(T); }
    static constexpr std::size_t tag_offset(std::size_t slots) noexcept {
        return (object_bytes(slots) + alignof(Tag) - 1) / alignof(Tag) * alignof(Tag);
    }
    [[nodiscard]] std::size_t chunk_size(std::uint32_t chunk) const noexcept {
        return std::size_t{1} << (first_bits_ + (chunk == 0 ? 0 : chunk - 1));
    }
    [[nodiscard]] std::uint32_t chunk_of(std::uint32_t index) const noexcept {
        return static_cast<std::uint32_t>(std::bit_width(index >> first_bits_));
    }
    [[nodiscard]] std::size_t place_in_chunk(std::uint32_t index, std::uint32_t chunk) const noexcept {
        return chunk == 0 ? index : index - std::bit_floor(index);
    }

    [[nodiscard]] bool add_chunk() noexcept {
        if (capacity() == max_capacity) return false;
        const std::size_t slots = chunk_size(chunk_count_);
        if (slots > (~std::size_t{0} - alignof(Tag)) / (sizeof(T) + sizeof(Tag))) return false;
        void* const bytes = ::operator new(tag_offset(slots) + slots * sizeof(Tag), chunk_alignment, std::nothrow);
        if (bytes == nullptr) return false;
        slab_internal::poison(bytes, object_bytes(slots));
        chunks_[chunk_count_++] = static_cast<std::byte*>(bytes);
        return true;
    }

    [[nodiscard]] T* storage(std::uint32_t index) const noexcept {
        const std::uint32_t chunk = chunk_of(index);
        return reinterpret_cast<T*>(chunks_[chunk] + place_in_chunk(index, chunk) * sizeof(T));
    }
    [[nodiscard]] T* object(std::uint32_t index) const noexcept { return std::launder(storage(index)); }
    [[nodiscard]] void* tag_storage(std::uint32_t index) const noexcept {
        const std::uint32_t chunk = chunk_of(index);
        return chunks_[chunk] + tag_offset(chunk_size(chunk)) + place_in_chunk(index, chunk) * sizeof(Tag);
    }
    [[nodiscard]] Tag& tag(std::uint32_t index) const noexcept {
        return *std::launder(static_cast<Tag*>(tag_storage(index)));
    }
    [[nodiscard]] bool is_alive(std::uint32_t index) const noexcept { return (tag(index).generation & 1) != 0; }

    [[nodiscard]] std::uint32_t take_slot() noexcept {
        if (free_ != no_slot) return std::exchange(free_, tag(free_).next_free);
        if (used_ == capacity()) return no_slot;
        ::new (tag_storage(used_)) Tag{};
        return used_++;
    }

    void give_slot_back(std::uint32_t index) noexcept {
        slab_internal::poison(storage(index), sizeof(T));
        tag(index).next_free = std::exchange(free_, index);
    }

    void destroy(std::uint32_t index) noexcept {
        const bool last_generation = ++tag(index).generation == 0;
        --size_;
        object(index)->~T();
        if (last_generation) {
            slab_internal::poison(storage(index), sizeof(T));
        } else {
            give_slot_back(index);
        }
    }

    std::byte* chunks_[chunk_limit] = {};
    std::uint32_t chunk_count_ = 0;
    std::uint32_t first_bits_ = 0;
    std::uint32_t used_ = 0;
    std::uint32_t free_ = no_slot;
    std::uint32_t size_ = 0;
};

/// Walks the living objects of a slab in slot order.
template <typename T, std::unsigned_integral Generation>
template <bool is_const>
class Slab<T, Generation>::Iterator {
    using Owner = std::conditional_t<is_const, const Slab, Slab>;

public:
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using reference = std::conditional_t<is_const, const T&, T&>;
    using pointer = std::conditional_t<is_const, const T*, T*>;
    // A forward iterator by what it can do: its tag would cost 6,000 lines of <iterator>.

    Iterator() noexcept = default;
    Iterator(Owner* slab, std::uint32_t index) noexcept : slab_(slab), index_(index) { skip_empty(); }

    [[nodiscard]] reference operator*() const noexcept { return *slab_->object(index_); }
    [[nodiscard]] pointer operator->() const noexcept { return slab_->object(index_); }
    [[nodiscard]] Handle handle() const noexcept { return {index_, slab_->tag(index_).generation}; }

    Iterator& operator++() noexcept {
        ++index_;
        skip_empty();
        return *this;
    }
    Iterator operator++(int) noexcept {
        Iterator before = *this;
        ++*this;
        return before;
    }

    [[nodiscard]] friend bool operator==(const Iterator& one, const Iterator& other) noexcept {
        return one.slab_ == other.slab_ && one.index_ == other.index_;
    }
    [[nodiscard]] friend bool operator==(const Iterator& one, SlabEnd) noexcept { return one.is_at_end(); }

private:
    [[nodiscard]] bool is_at_end() const noexcept { return slab_ == nullptr || index_ >= slab_->used_; }

    void skip_empty() noexcept {
        while (index_ < slab_->used_ && !slab_->is_alive(index_)) ++index_;
    }

    Owner* slab_ = nullptr;
    std::uint32_t index_ = 0;
};

}  // namespace v0
}  // namespace surefoot
