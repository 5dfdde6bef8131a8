// Any bytes, as an OBJ and as the answer of the helper program: a sound level or an error in words, within memory.
#include <chrono>
#include <string_view>

#include <surefoot/import.hpp>

#include "bytes.hpp"
#include "obj_reader.hpp"
#include "reply.hpp"

namespace {

void require_sound(const surefoot::ImportedLevel& level) {
    fuzz::require(level.indices.size() % 3 == 0, "three indices a triangle");
    fuzz::require(level.surfaces.size() == level.triangle_count(), "one surface a triangle");
    for (const std::uint32_t index : level.indices)
        fuzz::require(index < level.vertices.size(), "indices are in range");
    for (const std::uint32_t surface : level.surfaces)
        fuzz::require(surface < level.surface_names.size(), "surfaces have names");
    for (const surefoot::vec3& v : level.vertices)
        fuzz::require(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z), "vertices are finite");
    std::uint32_t next = 0;
    for (const surefoot::ImportedPart& part : level.parts) {
        fuzz::require(part.first_triangle == next && part.triangle_count > 0, "parts lie one after the other");
        next += part.triangle_count;
    }
    fuzz::require(next == level.triangle_count(), "parts cover all triangles");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span bytes(data, size);
    if (const auto reply = surefoot::internal::decode_reply(std::as_bytes(bytes))) {
        require_sound(*reply);
        const auto again = surefoot::internal::encode_level(*reply);
        fuzz::require(surefoot::internal::decode_reply(again).has_value(), "what was decoded can be sent again");
    }
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    const auto level = surefoot::internal::read_obj(text, {}, {.deadline = deadline, .bytes = std::uint64_t{1} << 28});
    if (level) {
        require_sound(*level);
    } else {
        fuzz::require(!level.error().text.empty(), "an error says what is wrong");
    }
    return 0;
}
