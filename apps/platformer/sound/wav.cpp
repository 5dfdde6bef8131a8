#include "platformer/sound/wav.hpp"

#include <cstdint>
#include <fstream>

#include "platformer/sound/samples.hpp"

namespace surefoot::sound {

namespace {

/// Least significant byte first, whatever the machine.
void put(std::string& bytes, std::uint32_t value, int size) {
    for (int i = 0; i < size; ++i) bytes.push_back(static_cast<char>(value >> 8 * i & 0xFF));
}

}  // namespace

Expected<void> write_wav(const std::string& path, std::span<const float> samples, int channels) {
    const auto size = static_cast<std::uint32_t>(samples.size() * 2), lanes = static_cast<std::uint32_t>(channels);
    std::string bytes = "RIFF";
    put(bytes, 36 + size, 4);
    bytes += "WAVEfmt ";
    put(bytes, 16, 4);
    put(bytes, 1, 2);  // integers, not compressed
    put(bytes, lanes, 2);
    put(bytes, rate, 4);
    put(bytes, rate * lanes * 2, 4);
    put(bytes, lanes * 2, 2);
    put(bytes, 16, 2);
    bytes += "data";
    put(bytes, size, 4);
    for (const float sample : samples) put(bytes, static_cast<std::uint16_t>(to_16_bits(sample)), 2);
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) {
        return tl::unexpected(Error{ErrorCode::write_failed,
                                    "The sound " + path + " could not be written: is the folder there, and writable?",
                                    path, 0});
    }
    return {};
}

}  // namespace surefoot::sound
