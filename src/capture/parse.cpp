// The reader of the form that text.cpp writes.
#include <surefoot/capture.hpp>

#include "capture/parts.hpp"
#include "capture/words.hpp"
#include "ieee_guard.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

using Names = std::span<const std::string_view>;

constexpr std::array<std::string_view, 8> sweep_names{"from",   "to",    "one_sided", "shape",
                                                      "rotate", "begin", "end",       "turn_gap"};
constexpr std::array<std::string_view, 6> ray_names{"from", "to", "one_sided", "begin", "end", "turn_gap"};

// True if it tells the times of a world's tick.
bool read_question(JsonReader& in, CapturedQuestion& q) {
    const bool is_ray = q.kind == CaptureKind::ray;
    const std::size_t required = is_ray ? 3 : 5;
    const std::uint64_t seen = in.object(is_ray ? Names(ray_names) : Names(sweep_names), required, [&](std::size_t i) {
        if (i >= 3 && is_ray) i += 2;
        switch (i) {
            case 0:
                q.motion.from = in.vector();
                break;
            case 1:
                q.motion.to = in.vector();
                break;
            case 2:
                q.one_sided = in.yes();
                break;
            case 3:
                q.volume.shape = read_shape(in);
                break;
            case 4:
                q.volume.orientation = in.turn();
                break;
            case 5:
                q.begin = in.number();
                break;
            case 6:
                q.end = in.number();
                break;
            default:
                q.turn_gap = in.number();
        }
    });
    const std::uint64_t times = seen >> required;
    if (times != 0 && times != 7) in.fail("\"begin\", \"end\" and \"turn_gap\" stand together");
    return times != 0;
}

Hit read_hit(JsonReader& in) {
    constexpr std::array<std::string_view, 9> names{"t",       "point", "normal", "feature",       "triangle",
                                                    "surface", "body",  "status", "started_inside"};
    Hit hit;
    in.object(names, names.size(), [&](std::size_t i) {
        switch (i) {
            case 0:
                hit.t = in.number();
                break;
            case 1:
                hit.point = in.vector();
                break;
            case 2:
                hit.normal = in.vector();
                break;
            case 3:
                hit.feature = static_cast<Feature>(in.one_of(feature_words));
                break;
            case 4:
                hit.triangle = in.whole_number();
                break;
            case 5:
                hit.surface = in.whole_number();
                break;
            case 6:
                hit.body = in.whole_number();
                break;
            case 7:
                hit.status = static_cast<HitStatus>(in.one_of(status_words));
                break;
            default:
                hit.started_inside = in.yes();
        }
    });
    return hit;
}

void check_whole(JsonReader& in, const Capture& capture, bool has_times) {
    if (has_times != !capture.bodies.empty())
        in.fail("\"bodies\" and the times of their tick, \"begin\", \"end\" and \"turn_gap\", stand together");
    check_bodies_known(in, capture.triangles, capture.bodies);
}

Capture read_whole(JsonReader& in) {
    // The questions are members by the name of their kind; a later kind of moment is another member here.
    constexpr std::array<std::string_view, 9> names{"surefoot_capture", "library",     "abi",         "note",  "answer",
                                                    "triangles",        kind_words[0], kind_words[1], "bodies"};
    Capture capture;
    bool has_times = false;
    const std::uint64_t seen = in.object(names, 6, [&](std::size_t i) {
        switch (i) {
            case 0:
                capture.origin.format = read_format(in, question_form, question_form);
                break;
            case 1:
                capture.origin.library = read_version(in);
                break;
            case 2:
                capture.origin.abi = in.text();
                break;
            case 3:
                capture.note = in.text();
                break;
            case 4:
                if (!in.null()) capture.answer = read_hit(in);
                break;
            case 5:
                read_triangles(in, capture.triangles);
                break;
            case 6:
            case 7:
                capture.question.kind = static_cast<CaptureKind>(i - 6);
                has_times = read_question(in, capture.question);
                break;
            default:
                read_bodies(in, capture.bodies);
        }
    });
    const std::uint64_t questions = seen >> 6U & 3U;
    if (questions != 1 && questions != 2) in.fail("one question, \"sweep\" or \"ray\", must be in the file");
    in.end();
    if (in.good()) check_whole(in, capture, has_times);
    return capture;
}

}  // namespace

Expected<Capture> parse_capture(std::string_view text, std::string_view file) {
    const IeeeGuard guard;
    JsonReader in(text);
    if (saved_kind(text) != SavedKind::question) {
        in.fail("the file is no question that was asked: see saved_kind", ErrorCode::unsupported);
        return tl::unexpected(error_of(in, file, "capture"));
    }
    Capture capture = read_whole(in);
    if (in.good()) return capture;
    return tl::unexpected(error_of(in, file, "capture"));
}

}  // namespace v0
}  // namespace surefoot
