// Any bytes, as an OBJ and as the answer of the helper program: a sound level or an error in words, within memory.
#include <chrono>
#include <string_view>

#include <surefoot/import.hpp>

#include "bytes.hpp"
#include "level_rules.hpp"
#include "obj_reader.hpp"
#include "reply.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span bytes(data, size);
    if (const auto reply = surefoot::internal::decode_reply(std::as_bytes(bytes))) {
        fuzz::require_sound(*reply);
        const auto again = surefoot::internal::encode_level(*reply);
        fuzz::require(surefoot::internal::decode_reply(again).has_value(), "what was decoded can be sent again");
    }
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    const auto level = surefoot::internal::read_obj(text, {}, {.deadline = deadline, .bytes = std::uint64_t{1} << 28});
    if (level) {
        fuzz::require_sound(*level);
    } else {
        fuzz::require(!level.error().text.empty(), "an error says what is wrong");
    }
    return 0;
}
