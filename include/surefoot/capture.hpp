/// Save this moment: one question with the triangles that it concerns and the answer that it got, in one small file.
/// Any build can ask the question again of those triangles alone and see whether it gets the same bits (`replay`;
/// `surefoot replay FILE` on the command line). It is what to send when an answer looks wrong.
///
/// It is in the core so that a game that links nothing but surefoot::surefoot can save a moment where it happens: on a
/// player's machine, with no importer, no JSON library and no debugger at hand. The file is JSON of a fixed form that
/// the core writes and reads itself; every number reads back to the same bits. docs/capture.md tells every line of it.
///
/// Saving allocates, and is no part of a query: ask as always, and save when something is worth it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <surefoot/bounds.hpp>
#include <surefoot/error.hpp>
#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/pose.hpp>
#include <surefoot/query.hpp>
#include <surefoot/shapes.hpp>
#include <surefoot/source.hpp>
#include <surefoot/sweep.hpp>
#include <surefoot/trace.hpp>
#include <surefoot/version.hpp>
#include <surefoot/world.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// The newest form of file that this library writes. It reads this one and those before it. Questions are of form 1,
/// steps of form 2; nothing is written in a newer form than it needs.
inline constexpr std::uint32_t capture_format = 2;

/// What kind of question was asked.
enum class CaptureKind : std::uint8_t {
    sweep,  ///< a volume along a motion
    ray,    ///< a point along a motion
};

/// The question.
struct CapturedQuestion {
    CaptureKind kind = CaptureKind::sweep;
    Volume volume{};          ///< what moved; a ray has none
    Motion motion{};          ///< whence and whither
    bool one_sided = false;   ///< see SweepOptions
    double begin = 0;         ///< of a world's tick; see WorldQuery
    double end = 1;           ///< see WorldQuery
    double turn_gap = 0.001;  ///< see WorldQuery
};

/// A triangle that the question could meet, in the frame of its body.
struct CapturedTriangle {
    Triangle triangle{};
    std::uint32_t id = 0;       ///< its source's own number of it
    std::uint32_t surface = 0;  ///< what it is made of
    std::uint32_t body = 0;     ///< which body of the world; 0 if one source was asked
};

/// A body of the world that was asked.
struct CapturedBody {
    std::uint32_t body = 0;  ///< its number, by which triangles name it
    Pose start{};            ///< at the start of the tick
    Pose end{};              ///< at its end
    Bounds bounds{};         ///< of its source, all triangles of which need not be here
};

/// Which build gave the answer.
struct CaptureOrigin {
    Version library{};         ///< the library's version
    std::string abi;           ///< its ABI, `abi_name`
    std::uint32_t format = 1;  ///< of the file
};

/// A moment: everything that `replay` needs, and nothing else.
struct Capture {
    CapturedQuestion question{};
    std::vector<CapturedTriangle> triangles;  ///< by (body, id), each once
    std::vector<CapturedBody> bodies;         ///< by number, each once; none: one source was asked, in its own frame
    std::optional<Hit> answer;                ///< as it was given; none if nothing was hit
    CaptureOrigin origin{};
    std::string note;  ///< yours: where it happened, what you expected [UTF-8]
};

/// Asks the question, and gathers the triangles that it can meet: those in whose boxes the moving shape comes by. The
/// source is a `Mesh`, a height field, voxels or your own. Triangles that the filter refuses do not exist. A trace and
/// counts in the options are those of the question itself.
/// Guarantees: `replay` of the capture gives the very bits that the source gave, for every source that keeps to
/// source.hpp.
[[nodiscard]] Capture capture_sweep(const SourceView& source, const Volume& volume, const Motion& motion,
                                    const QueryOptions& options = {});

/// The same on a world: the bodies that the question comes by, with their poses, and their triangles.
[[nodiscard]] Capture capture_sweep(const World& world, const Volume& volume, const Motion& motion,
                                    const WorldQuery& query = {});

/// The same on one triangle.
[[nodiscard]] Capture capture_sweep(const Triangle& triangle, const Volume& volume, const Motion& motion,
                                    const SweepOptions& options = {});

/// A ray's moment.
[[nodiscard]] Capture capture_ray(const SourceView& source, const Motion& motion, const QueryOptions& options = {});
[[nodiscard]] Capture capture_ray(const World& world, const Motion& motion, const WorldQuery& query = {});

/// Where two answers have different bits. If only one of them is a hit, `hit` alone is set.
struct AnswerDifference {
    bool hit = false;
    bool t = false;
    bool point = false;
    bool normal = false;
    bool feature = false;
    bool triangle = false;
    bool surface = false;
    bool body = false;
    bool status = false;
    bool started_inside = false;

    [[nodiscard]] bool any() const noexcept {
        return hit || t || point || normal || feature || triangle || surface || body || status || started_inside;
    }
};

[[nodiscard]] AnswerDifference difference_of(const std::optional<Hit>& a, const std::optional<Hit>& b) noexcept;

/// The question asked again.
struct Replay {
    std::optional<Hit> answer;   ///< what this build says
    AnswerDifference differs{};  ///< from what the capture says

    [[nodiscard]] bool is_same() const noexcept { return !differs.any(); }
};

/// Asks the captured triangles one by one and compares with the captured answer, bit for bit. A pure function of the
/// capture.
/// Requires: the order that `Capture` states; otherwise the answer may be another, but it comes. Allocates only if
/// there are bodies; a capture whose bodies make no world (a number twice, a pose that is not finite) answers
/// `invalid`.
[[nodiscard]] Replay replay(const Capture& capture, Trace* trace = nullptr);

/// What a file holds.
enum class SavedKind : std::uint8_t {
    question,  ///< a `Capture`, or nothing that is known
    step,      ///< a `StepCapture`, see capture_step.hpp
    session,   ///< a `Session`, see capture_session.hpp
};

/// Looks, without reading all of it, which of them a text could be.
[[nodiscard]] SavedKind saved_kind(std::string_view text) noexcept;

/// The file's text.
[[nodiscard]] std::string capture_text(const Capture& capture);

/// Reads the text of a file, called `file` in errors. Fails with `unreadable`, and the byte, for what is not such a
/// text to the letter: a member unknown, missing or there twice is no capture; with `unsupported` for a newer form and
/// for what is no question, and with `limit` beyond 2^20 triangles or 2^12 bodies.
[[nodiscard]] Expected<Capture> parse_capture(std::string_view text, std::string_view file = {});

/// Writes the file. Whoever looks finds the whole old file or the whole new one. Fails with `write_failed`.
[[nodiscard]] Expected<void> write_capture(const Capture& capture, const std::string& path);

/// Reads the file. Fails with `not_found`, and as above.
[[nodiscard]] Expected<Capture> read_capture(const std::string& path);

/// A GoogleTest case in C++ that asks the question again and expects the captured answer: a whole file that compiles
/// against this library. `name` becomes the test's name; what C++ does not take in a name becomes `_`.
[[nodiscard]] std::string capture_cpp_test(const Capture& capture, std::string_view name = "moment");

}  // namespace v0
}  // namespace surefoot
