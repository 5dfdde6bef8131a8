// Any bytes as a cooked file: opening says yes or why not, and whatever was opened answers every question and ends.
//
// The first byte chooses: the file as it is, or with its header summed again, so that the fuzzer gets past the
// checksum.
#include <array>
#include <cstring>
#include <optional>
#include <vector>

#include "bytes.hpp"

namespace {

using namespace fuzz;

// As docs/file-format.md tells: the sum stands at byte 8, and is that of byte 16 up to the end of the table.
void sum_again(std::vector<std::byte>& file) {
    constexpr std::size_t header = 64;
    constexpr std::size_t entry = 80;
    if (file.size() < header) return;
    const std::uint64_t size = file.size();
    std::memcpy(file.data() + 24, &size, sizeof size);
    std::uint32_t sections = 0;
    std::memcpy(&sections, file.data() + 32, sizeof sections);
    if (sections > (file.size() - header) / entry) return;
    const std::uint64_t sum = surefoot::hash_bytes(std::span(file).subspan(16, header - 16 + sections * entry));
    std::memcpy(file.data() + 8, &sum, sizeof sum);
}

using Answer = std::optional<surefoot::Hit>;

// Whatever the tree is, an answer is one. Where its structure was checked, it is also the right one.
void require_right(const Answer& by_tree, const Answer& by_force, const surefoot::Mesh& mesh, bool checked) {
    for (const Answer& hit : {by_tree, by_force}) {
        if (!hit) continue;
        require(hit->t >= 0 && hit->t <= 1, "t is within [0, 1]");
        require(is_finite(hit->point) && is_finite(hit->normal), "no NaN and no infinity in an answer");
        require(!checked || hit->triangle < mesh.triangle_count(), "what was hit is a triangle of the mesh");
    }
    require(!checked || !surefoot::difference_of(by_tree, by_force).any(), "tree equals brute force, bit for bit");
}

constexpr surefoot::QueryOptions brute_force{.search = surefoot::Search::brute_force};

void ask_sweep(const surefoot::Mesh& mesh, const surefoot::Volume& volume, const surefoot::Motion& motion,
               bool checked) {
    const auto capture = [&] { return surefoot::capture_sweep(mesh, volume, motion); };
    const auto bare = [&] { return unasked(mesh, {.volume = volume, .motion = motion}); };
    const Asking asking(capture, bare);
    require_right(mesh.sweep(volume, motion), mesh.sweep(volume, motion, brute_force), mesh, checked);
    static_cast<void>(mesh.sweep_any(volume, motion));
    static_cast<void>(mesh.sweep_any(volume, motion, brute_force));
}

void ask_ray(const surefoot::Mesh& mesh, const surefoot::Motion& motion, bool checked) {
    const auto capture = [&] { return surefoot::capture_ray(mesh, motion); };
    const auto bare = [&] { return unasked(mesh, {.kind = surefoot::CaptureKind::ray, .motion = motion}); };
    const Asking asking(capture, bare);
    require_right(mesh.ray(motion), mesh.ray(motion, brute_force), mesh, checked);
    static_cast<void>(mesh.ray_any(motion));
    static_cast<void>(mesh.ray_any(motion, brute_force));
}

void ask(const surefoot::Mesh& mesh, Bytes& bytes, bool checked) {
    const surefoot::Volume volume = bytes.volume(false);
    const surefoot::Motion motion{bytes.vector(false), bytes.vector(false)};
    std::array<surefoot::Overlap, 4> overlaps{};
    std::array<surefoot::SourceTriangle, 4> gathered{};
    ask_sweep(mesh, volume, motion, checked);
    ask_ray(mesh, motion, checked);
    for (const auto search : {surefoot::Search::tree, surefoot::Search::brute_force}) {
        const surefoot::QueryOptions options{.search = search};
        static_cast<void>(mesh.overlap(volume, motion.from, overlaps, options));
        static_cast<void>(mesh.nearest(motion.from, 5, options));
        static_cast<void>(mesh.gather({motion.from, motion.to}, gathered, options));
    }
    if (mesh.triangle_count() == 0) return;
    const auto id = static_cast<std::uint32_t>(bytes.take<std::uint32_t>() % mesh.triangle_count());
    static_cast<void>(mesh.triangle(id));
    static_cast<void>(mesh.surface(id));
    static_cast<void>(mesh.is_hidden(id));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t questions = 64;
    if (size < 1 + questions) return 0;
    Bytes bytes({data + 1, questions});
    const auto given = std::as_bytes(std::span(data, size)).subspan(1 + questions);
    std::vector<std::byte> file(given.begin(), given.end());
    if ((data[0] & 1) != 0) sum_again(file);
    const auto check = static_cast<surefoot::Check>(data[0] / 2 % 3);
    const auto mesh = surefoot::Mesh::read(file, check);
    if (!mesh) {
        require(!mesh.error().text.empty(), "an error says what is wrong");
        return 0;
    }
    static_cast<void>(surefoot::level_notes(*mesh));
    static_cast<void>(surefoot::cook_report(*mesh));
    for (int i = 0; i < 3; ++i) ask(*mesh, bytes, check != surefoot::Check::header);
    return 0;
}
