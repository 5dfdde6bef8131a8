// Current .blend files: only Blender knows the format of its own day, so Blender is asked to export a .glb. It runs
// with factory settings and with the file's own scripts disabled, under the limits that the helper program sets before
// it becomes Blender.
#include <algorithm>
#include <filesystem>
#include <random>

#include "child_process.hpp"
#include "level_builder.hpp"
#include "limited_read.hpp"
#include "programs.hpp"

namespace surefoot::internal {
namespace {

namespace fs = std::filesystem;

// Options that a version of the exporter does not know are left out: they were renamed from time to time. The axes stay
// Blender's own, so that ImportOptions::up means the same however a .blend is read.
constexpr const char* export_script = R"(
import bpy, sys
wanted = dict(filepath=sys.argv[-1], export_format='GLB', export_extras=True, export_apply=True, export_yup=False,
              export_animations=False, export_skins=False, export_morph=False, export_image_format='NONE',
              export_texcoords=False, export_normals=False, export_colors=False, export_cameras=False,
              export_lights=False)
try:
    known = bpy.ops.export_scene.gltf.get_rna_type().properties.keys()
    bpy.ops.export_scene.gltf(**{k: v for k, v in wanted.items() if k in known})
except Exception as error:
    print('\nsurefoot: ' + str(error).strip().splitlines()[-1])
    sys.exit(4)
)";

/// What the script above says went wrong, or how Blender ended if it did not come so far.
std::string reason(const ChildOutcome& outcome) {
    if (outcome.end == ChildOutcome::End::killed) return signal_name(outcome.signal);
    const std::string_view output(reinterpret_cast<const char*>(outcome.output.data()), outcome.output.size());
    constexpr std::string_view mark = "\nsurefoot: ";
    const std::size_t begin = output.rfind(mark);
    if (begin == std::string_view::npos) return "exit code " + std::to_string(outcome.exit_code);
    const std::string_view rest = output.substr(begin + mark.size());
    return std::string(rest.substr(0, std::min<std::size_t>(rest.find('\n'), 300)));
}

/// A folder that only we can enter, removed with all that is in it.
class TemporaryFolder {
public:
    static Expected<TemporaryFolder> make() {
        std::error_code error;
        const fs::path parent = fs::temp_directory_path(error);
        std::random_device random;
        for (int attempt = 0; !error && attempt < 16; ++attempt) {
            const fs::path path = parent / ("surefoot-import-" + std::to_string(random()) + std::to_string(random()));
            if (!fs::create_directory(path, error)) continue;
            fs::permissions(path, fs::perms::owner_all, error);
            return TemporaryFolder(path);
        }
        return tl::unexpected(Error{.code = ErrorCode::write_failed,
                                    .text = "no temporary folder could be made; free some space or set TMPDIR",
                                    .file = {}});
    }

    TemporaryFolder(TemporaryFolder&& other) noexcept : path_(std::move(other.path_)) { other.path_.clear(); }
    TemporaryFolder& operator=(TemporaryFolder&&) = delete;
    ~TemporaryFolder() {
        std::error_code ignored;
        if (!path_.empty()) fs::remove_all(path_, ignored);
    }

    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    explicit TemporaryFolder(fs::path path) : path_(std::move(path)) {}
    fs::path path_;
};

}  // namespace

Expected<ImportedLevel> read_through_blender(const LimitedRead& request) {
    const auto blender = find_blender();
    if (!blender) return tl::unexpected(blender.error());
    const auto importer = find_importer(request.options);
    if (!importer) return tl::unexpected(importer.error());
    const auto folder = TemporaryFolder::make();
    if (!folder) return tl::unexpected(folder.error());

    const std::string exported = (folder->path() / "level.glb").string();
    const std::vector<std::string> arguments{"blender",
                                             *blender,
                                             fs::absolute(request.path).string(),
                                             export_script,
                                             exported,
                                             std::to_string(request.options.memory_limit),
                                             seconds_until(request.deadline)};
    // What Blender prints on its way is small.
    const auto outcome = run_child(*importer, arguments, request.deadline, std::uint64_t{64} << 20);
    if (!outcome) return tl::unexpected(outcome.error());
    if (outcome->end == ChildOutcome::End::timed_out) return tl::unexpected(time_error());
    std::error_code error;
    if (!fs::exists(exported, error)) {
        return tl::unexpected(Error{.code = ErrorCode::unreadable,
                                    .text = "Blender could not export it (" + reason(*outcome) +
                                            "); open it in Blender and export it as .glb, or raise "
                                            "ImportOptions::memory_limit",
                                    .file = {}});
    }
    LimitedRead second = request;
    second.path = exported;
    second.format = Format::glb;
    return read_in_child(second);
}

}  // namespace surefoot::internal
