#include "mesh/weld.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

namespace surefoot::internal {
namespace {

std::uint64_t bits_of(double x) noexcept {
    return std::bit_cast<std::uint64_t>(x + 0.0);  // -0 becomes 0
}

// Any good mixing will do: equal places are told apart from equal hashes by comparing. This is the finaliser of
// Steele, Lea, Flood: Fast splittable pseudorandom number generators (2014), fed with the three coordinates.
std::uint32_t hash_of(double x, double y, double z) noexcept {
    std::uint64_t h = bits_of(x) * 0x9E3779B97F4A7C15;
    h = (std::rotl(h, 23) ^ bits_of(y)) * 0xBF58476D1CE4E5B9;
    h = (std::rotl(h, 23) ^ bits_of(z)) * 0x94D049BB133111EB;
    h = (h ^ (h >> 30U)) * 0xBF58476D1CE4E5B9;
    return static_cast<std::uint32_t>((h ^ (h >> 27U)) >> 32U);
}

struct Keyed {
    std::uint32_t hash;
    std::uint32_t index;
};

// Into 2^bits parts by the highest bits of the hash; within a part the indices stay in order. Returns where each part
// begins, and the end.
std::vector<std::size_t> part_by_hash(std::vector<Keyed>& keys, unsigned bits) {
    const auto part_of = [&](const Keyed& key) { return std::size_t{key.hash} >> (32 - bits); };
    std::vector<std::size_t> begin((std::size_t{1} << bits) + 1, 0);
    for (const Keyed& key : keys) ++begin[part_of(key) + 1];
    for (std::size_t part = 0; part + 1 < begin.size(); ++part) begin[part + 1] += begin[part];
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    std::vector<Keyed> parted(keys.size());
    for (const Keyed& key : keys) parted[next[part_of(key)]++] = key;
    keys.swap(parted);
    return begin;
}

template <typename Vertex>
class Welder {
public:
    explicit Welder(std::span<const Vertex> vertices) : vertices_(vertices), lowest_(vertices.size()) {}

    std::vector<std::uint32_t> run() {
        std::vector<Keyed> keys(vertices_.size());
        for (std::uint32_t i = 0; i < keys.size(); ++i) {
            const Vertex& v = vertices_[i];
            keys[i] = {hash_of(static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)), i};
        }
        // Parts that fit into the nearest cache, with a table of their own.
        constexpr std::size_t part_size = 1024;
        unsigned bits = 1;
        while (bits < 16 && (part_size << bits) < keys.size()) ++bits;
        const std::vector<std::size_t> begin = part_by_hash(keys, bits);
        for (std::size_t part = 0; part + 1 < begin.size(); ++part) {
            const std::span<Keyed> members = std::span(keys).subspan(begin[part], begin[part + 1] - begin[part]);
            if (!weld_by_table(members, 32 - bits)) weld_by_sorting(members);
        }
        return std::move(lowest_);
    }

private:
    [[nodiscard]] bool same(std::uint32_t i, std::uint32_t k) const {
        const Vertex& a = vertices_[i];
        const Vertex& b = vertices_[k];
        return a.x == b.x && a.y == b.y && a.z == b.z;
    }

    // False when hashes collide far more than by accident: then somebody chose the vertices for that.
    bool weld_by_table(std::span<const Keyed> members, unsigned hash_bits) {
        constexpr std::uint32_t empty = 0xFFFFFFFF;
        constexpr std::size_t longest_search = 128;
        std::size_t size = 16;
        while (size < 2 * members.size()) size *= 2;
        table_.assign(size, Keyed{0, empty});
        for (const Keyed& key : members) {
            std::size_t slot = (key.hash ^ (key.hash >> (hash_bits / 2))) & (size - 1);
            std::size_t searched = 0;
            while (table_[slot].index != empty &&
                   (table_[slot].hash != key.hash || !same(table_[slot].index, key.index))) {
                if (++searched > longest_search) return false;
                slot = (slot + 1) & (size - 1);
            }
            if (table_[slot].index == empty) table_[slot] = key;
            lowest_[key.index] = table_[slot].index;
        }
        return true;
    }

    void weld_by_sorting(std::span<Keyed> members) {
        std::sort(members.begin(), members.end(), [&](const Keyed& i, const Keyed& k) {
            const Vertex& a = vertices_[i.index];
            const Vertex& b = vertices_[k.index];
            if (a.x != b.x) return a.x < b.x;
            if (a.y != b.y) return a.y < b.y;
            if (a.z != b.z) return a.z < b.z;
            return i.index < k.index;
        });
        std::uint32_t current = members.empty() ? 0 : members[0].index;
        for (const Keyed& key : members) {
            if (!same(key.index, current)) current = key.index;
            lowest_[key.index] = current;
        }
    }

    std::span<const Vertex> vertices_;
    std::vector<std::uint32_t> lowest_;
    std::vector<Keyed> table_;
};

}  // namespace

std::vector<std::uint32_t> same_places(std::span<const vec3> vertices) {
    return Welder(vertices).run();
}

std::vector<std::uint32_t> same_places(std::span<const dvec3> vertices) {
    return Welder(vertices).run();
}

}  // namespace surefoot::internal
