// surefoot export: the triangles exactly as they are held, for any other program to look at.
#include <CLI/CLI.hpp>
#include <bit>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <system_error>

#include "command.hpp"
#include "level.hpp"
#include "number.hpp"
#include "text.hpp"

namespace surefoot::tools {
namespace {

struct ExportOptionsGiven {
    LevelOptions level;
    std::string output;
};

struct CloseFile {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
};

/// Vertices that are the same bits are written once.
class ObjWriter {
public:
    explicit ObjWriter(std::FILE* file) : file_(file) {}

    void triangle(const Triangle& triangle) {
        std::size_t corners[3];
        std::size_t next = 0;
        for (const dvec3& corner : {triangle.a, triangle.b, triangle.c}) corners[next++] = vertex(corner);
        text_ += fmt::format("f {} {} {}\n", corners[0], corners[1], corners[2]);
        if (text_.size() > (1U << 16U)) flush();
    }

    [[nodiscard]] bool finish() {
        flush();
        return good_ && std::fflush(file_) == 0;
    }

private:
    std::size_t vertex(const dvec3& position) {
        const std::array<float, 3> xyz{static_cast<float>(position.x), static_cast<float>(position.y),
                                       static_cast<float>(position.z)};
        const auto bits = std::bit_cast<std::array<std::uint32_t, 3>>(xyz);
        const auto [found, is_new] = ids_.try_emplace(bits, ids_.size() + 1);
        if (is_new) {
            text_ += 'v';
            for (const float x : xyz) {
                text_ += ' ';
                append_number(text_, x);
            }
            text_ += '\n';
        }
        return found->second;
    }

    void flush() {
        good_ = good_ && std::fwrite(text_.data(), 1, text_.size(), file_) == text_.size();
        text_.clear();
    }

    std::FILE* file_;
    std::string text_;
    std::map<std::array<std::uint32_t, 3>, std::size_t> ids_;
    bool good_ = true;
};

ExitCode run_export(const ExportOptionsGiven& given) {
    const Level level = load_level(given.level);
    const auto fail = [&](const std::string& why) {
        throw Failure{ExitCode::file, fmt::format("{}: cannot be written: {}", given.output, why)};
    };
    // Written beside and renamed, so that a failure leaves what was there before.
    const std::string beside = given.output + ".part";
    bool good = false;
    {
        const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(beside.c_str(), "wb"));
        if (!file) fail("is the folder there, and may you write to it?");
        ObjWriter writer(file.get());
        for (std::uint32_t id = 0; id < level.mesh.triangle_count(); ++id) writer.triangle(level.mesh.triangle(id));
        good = writer.finish();
    }
    std::error_code error;
    if (good) std::filesystem::rename(beside, given.output, error);
    if (!good || error) {
        std::error_code ignored;
        std::filesystem::remove(beside, ignored);
        fail(error ? error.message() : "is the disk full?");
    }
    fmt::print("{}: {} triangles in the order of their ids\n", given.output, grouped(level.mesh.triangle_count()));
    return ExitCode::ok;
}

}  // namespace

void add_export(CLI::App& program, Run& run) {
    auto* command = program.add_subcommand("export", "Write the triangles exactly as held, as an OBJ");
    const auto given = std::make_shared<ExportOptionsGiven>();
    given->level.add_to(*command, "FILE");
    command->add_option("-o,--output", given->output, "The OBJ to write")->type_name("OUT.obj")->required();
    command->footer(help_footer(
        "  surefoot export castle.glb -o castle.obj\n"
        "\nLine N of the faces is triangle N, counted from 0. Every coordinate reads back to the same float.\n"
        "Exit codes: 0 written, 2 wrong usage, 3 a file cannot be read or written."));
    command->callback([given, &run] { run = [given] { return run_export(*given); }; });
}

}  // namespace surefoot::tools
