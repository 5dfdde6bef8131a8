/// surefoot-importer: reads one level within limits and writes it to standard output. Started by surefoot::import; not
/// meant to be run by hand.
///
///     surefoot-importer read FILE SCALE x|y|z MEMORY_BYTES CPU_SECONDS
///     surefoot-importer blender BLENDER FILE SCRIPT OUTPUT MEMORY_BYTES CPU_SECONDS
///
/// Exit codes: 0 a reply was written (a level or an error), 2 called in a wrong way, 3 no reply could be written.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <unistd.h>

#include "assimp_reader.hpp"
#include "level_builder.hpp"
#include "limits.hpp"
#include "reply.hpp"

namespace surefoot::importer {
namespace {

bool write_all(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
        if (written <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
}

/// Made before memory is short.
std::vector<std::byte>& last_words() {
    static std::vector<std::byte> reply = internal::encode_error(internal::memory_error());
    return reply;
}

/// Assimp turns a failed allocation into one message among many; the limit deserves a clear one.
[[noreturn]] void out_of_memory() {
    std::_Exit(write_all(last_words()) ? 0 : 3);
}

std::optional<UpAxis> parse_axis(const std::string& name) {
    if (name == "x") return UpAxis::x;
    if (name == "y") return UpAxis::y;
    if (name == "z") return UpAxis::z;
    return std::nullopt;
}

int read_level(std::span<char*> arguments) {
    const std::string path = arguments[0];
    const double scale = std::strtod(arguments[1], nullptr);
    const auto up = parse_axis(arguments[2]);
    if (!up || !(scale > 0)) return 2;
    last_words();
    const std::uint64_t bytes = std::strtoull(arguments[3], nullptr, 10);
    limit_memory(bytes);
    limit_time(std::strtoull(arguments[4], nullptr, 10));
    std::set_new_handler(out_of_memory);

    const Expected<ImportedLevel> level = read_with_assimp(path, {.scale = scale, .up = *up}, bytes);
    return write_all(level ? internal::encode_level(*level) : internal::encode_error(level.error())) ? 0 : 3;
}

int become_blender(std::span<char*> arguments) {
    limit_memory(std::strtoull(arguments[4], nullptr, 10));
    limit_time(std::strtoull(arguments[5], nullptr, 10));
    const char* const blender = arguments[0];
    ::execl(blender, blender, "--background", "--factory-startup", "--disable-autoexec", "-noaudio", arguments[1],
            "--python-exit-code", "4", "--python-expr", arguments[2], "--", arguments[3], static_cast<char*>(nullptr));
    return 3;
}

int run(std::span<char*> arguments) {
    harden_process();
    const std::string task = arguments.size() > 1 ? arguments[1] : "";
    if (task == "read" && arguments.size() == 7) return read_level(arguments.subspan(2));
    if (task == "blender" && arguments.size() == 8) return become_blender(arguments.subspan(2));
    std::fputs("surefoot-importer reads level files for programs that use surefoot::import; it is not run by hand.\n",
               stderr);
    return 2;
}

}  // namespace
}  // namespace surefoot::importer

int main(int argc, char** argv) {
    try {
        return surefoot::importer::run({argv, static_cast<std::size_t>(argc)});
    } catch (const std::exception&) {
        return 3;
    }
}
