// "Copy as C++ test": the same moment, written in the library's own words.
#include <surefoot/capture.hpp>

#include "capture/cpp_words.hpp"
#include "capture/number.hpp"
#include "capture/words.hpp"
#include "ieee_guard.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

std::string question_lines(const Capture& capture) {
    const CapturedQuestion& q = capture.question;
    std::string out;
    const auto set = [&](std::string_view field, std::string_view value) {
        out += joined({"    moment.question.", field, " = ", value, ";\n"});
    };
    set("kind", joined({"surefoot::CaptureKind::", kind_words[static_cast<std::size_t>(q.kind)]}));
    if (q.kind == CaptureKind::sweep) {
        set("volume", joined({"surefoot::Volume(", made(q.volume.shape), ", ", turned(q.volume.orientation), ")"}));
    }
    set("motion", joined({"{", braced(q.motion.from), ", ", braced(q.motion.to), "}"}));
    set("one_sided", literal(q.one_sided));
    if (!capture.bodies.empty()) {
        set("begin", literal(q.begin));
        set("end", literal(q.end));
        set("turn_gap", literal(q.turn_gap));
    }
    return out;
}

std::string answer_lines(const Hit& hit) {
    std::string out = "    surefoot::Hit hit;\n";
    const auto set = [&](std::string_view field, std::string_view value) {
        out += joined({"    hit.", field, " = ", value, ";\n"});
    };
    set("t", literal(hit.t));
    set("point", braced(hit.point));
    set("normal", braced(hit.normal));
    set("triangle", literal(hit.triangle));
    set("surface", literal(hit.surface));
    set("body", literal(hit.body));
    set("feature", word_of(hit.feature));
    set("status", word_of(hit.status));
    set("started_inside", literal(hit.started_inside));
    return out + "    moment.answer = hit;\n";
}

std::string expectations(const std::optional<Hit>& hit) {
    std::string out = "\n    const surefoot::Replay again = surefoot::replay(moment);\n";
    if (!hit) return out + "    EXPECT_FALSE(again.answer) << \"hit at t = \" << again.answer->t;\n";
    out += "    ASSERT_TRUE(again.answer) << \"nothing was hit\";\n";
    const auto expect = [&](std::string_view part, std::string_view shown) {
        out += joined({"    EXPECT_FALSE(again.differs.", part, ") << ", shown, ";\n"});
    };
    const auto field = [](std::string_view part) { return joined({"again.answer->", part}); };
    for (const char* const part : {"t", "triangle", "surface", "body", "started_inside"}) expect(part, field(part));
    for (const char* const part : {"feature", "status"}) {
        expect(part, joined({"static_cast<int>(", field(part), ")"}));
    }
    for (const char* const part : {"point", "normal"}) {
        expect(part, joined({field(part), ".x << \", \" << ", field(part), ".y << \", \" << ", field(part), ".z"}));
    }
    return out;
}

}  // namespace

std::string capture_cpp_test(const Capture& capture, std::string_view name) {
    const IeeeGuard guard;
    std::string out = test_head(capture.origin, capture.note, "capture");
    out += joined({"TEST(Moments, ", in_a_name(name), ") {\n    surefoot::Capture moment;\n"});
    out += question_lines(capture) + geometry_lines(capture.bodies, capture.triangles);
    if (capture.answer) out += answer_lines(*capture.answer);
    return out + expectations(capture.answer) + "}\n";
}

}  // namespace v0
}  // namespace surefoot
