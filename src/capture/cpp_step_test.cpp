// "Copy as C++ test" of a step.
#include <type_traits>

#include <surefoot/capture_step.hpp>

#include "capture/cpp_words.hpp"
#include "capture/number.hpp"
#include "capture/words.hpp"
#include "character/fields.hpp"
#include "ieee_guard.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

std::string written(double value) {
    return literal(value);
}

std::string written(std::uint32_t value) {
    return literal(value);
}

std::string written(bool value) {
    return literal(value);
}

std::string written(const dvec3& v) {
    return joined({"surefoot::dvec3", braced(v)});
}

std::string written(const Volume& volume) {
    return joined({"surefoot::Volume(", made(volume.shape), ", ", turned(volume.orientation), ")"});
}

std::string written(const std::optional<Volume>& volume) {
    return volume ? written(*volume) : "std::nullopt";
}

// By its number: a state that came from elsewhere may hold what no word is for.
template <typename Enum>
requires std::is_enum_v<Enum> std::string enumerated(std::string_view type, Enum value) {
    return joined({"static_cast<surefoot::", type, ">(", std::to_string(static_cast<int>(value)), ")"});
}

std::string written(Response value) {
    return enumerated("Response", value);
}

std::string written(SlopeSpeed value) {
    return enumerated("SlopeSpeed", value);
}

std::string written(Firmness value) {
    return enumerated("Firmness", value);
}

std::string written(CharacterMode value) {
    return enumerated("CharacterMode", value);
}

std::string written(CharacterForm value) {
    return enumerated("CharacterForm", value);
}

std::string written(Footing value) {
    return enumerated("Footing", value);
}

std::string written(Hold value) {
    return enumerated("Hold", value);
}

std::string written(std::uint8_t value) {
    return std::to_string(value);
}

// `name.field = value;` for each field.
template <typename Fields>
std::string set_all(std::string_view name, const Fields& fields) {
    std::string out;
    visit_fields(fields, [&](const char* field, const auto& value) {
        using Value = std::remove_cvref_t<decltype(value)>;
        if constexpr (!std::is_same_v<Value, SurfaceRules>) {
            out += joined({"    ", name, ".", field, " = ", written(value), ";\n"});
        }
    });
    return out;
}

template <typename Fields>
std::string push_all(std::string_view type, std::string_view list, std::span<const Fields> all) {
    std::string out;
    for (const Fields& one : all) {
        const std::string place = joined({"moment.", list, ".back()"});
        out += joined({"    moment.", list, ".push_back(surefoot::", type, "{});\n"}) + set_all(place, one);
    }
    return out;
}

// Every number exactly; 0 and -0 count as the same.
template <typename Fields>
std::string expect_all(std::string_view name, const Fields& fields) {
    std::string out;
    visit_fields(fields, [&](const char* field, const auto& value) {
        using Value = std::remove_cvref_t<decltype(value)>;
        const std::string asked = joined({"again.result.", name, ".", field});
        const auto expect = [&](std::string_view part, std::string_view as) {
            out += joined({"    EXPECT_EQ(", asked, part, ", ", as, ");\n"});
        };
        if constexpr (std::is_same_v<Value, dvec3>) {
            expect(".x", literal(value.x));
            expect(".y", literal(value.y));
            expect(".z", literal(value.z));
        } else {
            expect("", written(value));
        }
    });
    return out;
}

}  // namespace

std::string capture_cpp_test(const StepCapture& capture, std::string_view name) {
    const IeeeGuard guard;
    std::string out = test_head(capture.origin, capture.note, "capture_step");
    out += joined({"TEST(Moments, ", in_a_name(name), ") {\n    surefoot::StepCapture moment;\n"});
    out += set_all("moment.settings", capture.settings);
    out += push_all("SurfaceRule", "surfaces", std::span(capture.surfaces));
    out += set_all("moment.input", capture.input);
    out += joined({"    moment.dt = ", literal(capture.dt), ";\n"});
    out += set_all("moment.before", capture.before);
    out += push_all("Neighbour", "neighbours", std::span(capture.neighbours));
    out += geometry_lines(capture.bodies, capture.triangles);
    out += "\n    const surefoot::StepReplay again = surefoot::replay(moment);\n";
    return out + expect_all("state", capture.after) + expect_all("events", capture.events) + "}\n";
}

}  // namespace v0
}  // namespace surefoot
