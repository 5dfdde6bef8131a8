// Any bytes, as a map of Quake III and as a .pk3: a sound level or an error in words, within time and memory.
#include <chrono>
#include <span>
#include <sstream>
#include <string>

#include <surefoot/import.hpp>

#include "bytes.hpp"
#include "level_rules.hpp"
#include "quake3/pk3.hpp"
#include "quake3/reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace surefoot::internal;
    const ReadLimits limits{.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(2),
                            .bytes = std::uint64_t{1} << 27};
    std::string bytes(reinterpret_cast<const char*>(data), size);
    if (bytes.starts_with("PK")) {
        std::istringstream file(bytes);
        const auto map = quake3::read_pk3(file, size % 2 == 0 ? "" : "packed", limits);
        if (!map) {
            fuzz::require(!map.error().text.empty(), "an error says what is wrong");
            return 0;
        }
        fuzz::require(map->bytes.size() <= limits.bytes, "a packed map keeps within the limit");
        bytes = map->bytes;
    }
    for (const auto solids : {surefoot::Quake3Solids::drawn, surefoot::Quake3Solids::brushes}) {
        const auto level =
            quake3::read_bsp(std::as_bytes(std::span(bytes)), {.scale = 1.0 / 32, .up = surefoot::UpAxis::z}, limits,
                             {.tolerance = 0.5, .solids = solids});
        if (level) {
            fuzz::require_sound(*level);
        } else {
            fuzz::require(!level.error().text.empty(), "an error says what is wrong");
        }
    }
    return 0;
}
