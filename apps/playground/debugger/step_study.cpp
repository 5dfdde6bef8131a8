#include "debugger/step_study.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "character_words.hpp"
#include "debugger/equation.hpp"
#include "debugger/saved_step.hpp"
#include "debugger/step_words.hpp"

namespace surefoot::debugger {

namespace {

constexpr std::array all_dials{
    Dial{"Slope limit", &CharacterSettings::slope_limit_deg, 0, 89, "%.1f°", false,
         "The steepest ground to walk and to stand on."},
    Dial{"Step up", &CharacterSettings::step_up, 0, 1.5, "%.2f m", false, "The highest step; 0 switches steps off."},
    Dial{"Step depth", &CharacterSettings::step_depth, 0.01, 1, "%.2f m", true,
         "How far ahead of what blocks it a step must offer ground."},
    Dial{"Snap down", &CharacterSettings::snap_down, 0, 1.5, "%.2f m", false,
         "How far the ground may drop away before feet leave it."},
    Dial{"Perch", &CharacterSettings::perch_distance, 0, 1, "%.2f m", false,
         "How far from the axis an edge may hold the body."},
    Dial{"Skin", &CharacterSettings::skin, 1e-4, 0.1, "%.4f m", true, "How far from everything the body is kept."},
    Dial{"Gravity", &CharacterSettings::gravity, 0, 60, "%.1f m/s²", false, "Against up."},
    Dial{"Acceleration", &CharacterSettings::acceleration, 0, 300, "%.0f m/s²", false, "Towards the wish, on ground."},
    Dial{"Braking", &CharacterSettings::braking, 0, 300, "%.0f m/s²", false, "When the wish is slower, on ground."},
    Dial{"In the air", &CharacterSettings::air_acceleration, 0, 100, "%.0f m/s²", false,
         "Towards the wish, in the air."},
    Dial{"Jump height", &CharacterSettings::jump_height, 0, 5, "%.2f m", false, "Of a full jump."},
    Dial{"Coyote time", &CharacterSettings::coyote_time, 0, 1, "%.2f s", false,
         "How long after leaving the ground a jump still counts as from there."},
};

bool same_bits(const StepRecord& a, const StepRecord& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

std::string away(const MadeStep& then, const MadeStep& now) {
    const dvec3 moved = now.result.state.position - then.result.state.position;
    const double far = glm::length(moved);
    if (far == 0) return "It ends at the same place.";
    const dvec3 up = up_of(then.order.input);
    const double higher = glm::dot(moved, up);
    const dvec3 wish = then.order.input.wish - up * glm::dot(then.order.input.wish, up);
    std::string text = fmt::format("It ends {} m from there", short_text(far));
    std::string parts;
    const auto add = [&](double size, const char* positive, const char* negative) {
        if (std::abs(size) < 1e-3 * far) return;
        parts += fmt::format("{}{} m {}", parts.empty() ? "" : ", ", short_text(std::abs(size)),
                             size > 0 ? positive : negative);
    };
    if (glm::length(wish) > 0)
        add(glm::dot(moved, glm::normalize(wish)), "farther along its wish", "less far along its wish");
    add(higher, "higher", "lower");
    return text + (parts.empty() ? "." : ": " + parts + ".");
}

/// Is it of one kind and about one thing, whatever the numbers?
bool tell_the_same(const StepRecord& a, const StepRecord& b) {
    return a.act == b.act && a.rule == b.rule && a.triangle == b.triangle && a.body == b.body;
}

/// The lines in which something is decided about the step itself, and not about a look for a step.
std::vector<std::size_t> decisions(const std::vector<StepRecord>& records) {
    std::vector<std::size_t> lines;
    bool in_look = false;
    for (std::size_t i = 0; i < records.size(); ++i) {
        const StepAct act = records[i].act;
        if (act == StepAct::step_refused || act == StepAct::stepped_up) in_look = false;
        const bool is_detail = act == StepAct::wants || act == StepAct::pass || act == StepAct::touch ||
                               act == StepAct::passed_over || act == StepAct::step_tried;
        if (!in_look && !is_detail) lines.push_back(i);
        if (act == StepAct::step_tried) in_look = true;
    }
    return lines;
}

/// Where something else is decided; where nothing is, the first line with another number.
std::string parting(const std::vector<StepRecord>& then, const std::vector<StepRecord>& now) {
    const std::vector<std::size_t> before = decisions(then);
    const std::vector<std::size_t> after = decisions(now);
    const std::size_t shared = std::min(before.size(), after.size());
    std::size_t i = 0;
    while (i < shared && tell_the_same(then[before[i]], now[after[i]])) ++i;
    if (i < shared)
        return fmt::format("The stories part at line {}: \"{}\" then, \"{}\" now.", before[i] + 1,
                           title_of(then[before[i]]), title_of(now[after[i]]));
    if (i < after.size()) return fmt::format("Its story goes on: \"{}\".", title_of(now[after[i]]));
    if (i < before.size()) return fmt::format("Its story ends before \"{}\".", title_of(then[before[i]]));
    const std::size_t lines = std::min(then.size(), now.size());
    std::size_t line = 0;
    while (line < lines && same_bits(then[line], now[line])) ++line;
    if (line == then.size() && line == now.size()) return {};
    return fmt::format("The same is decided; numbers differ from line {} on.", line + 1);
}

}  // namespace

std::span<const Dial> dials() {
    return all_dials;
}

StepStudy::StepStudy(StepCapture capture) {
    const auto kept = std::make_shared<const StepCapture>(std::move(capture));
    recorded_ = recorded_step(*kept);
    make_ = [kept](const StepOrder& order) {
        StepCapture other = *kept;
        other.settings = order.settings;
        other.surfaces.assign(order.settings.surfaces.all().begin(), order.settings.surfaces.all().end());
        StepReplay replayed = replay(other);
        return MadeStep{order, replayed.result, std::move(replayed.records)};
    };
    find_ = [kept](std::uint32_t body, std::uint32_t triangle) { return triangle_at_start(*kept, body, triangle); };
    capture_ = [kept] { return *kept; };
    why_ = explain(recorded_.story());
    reset();
}

StepStudy::StepStudy(const Arena& arena, MadeStep made) : recorded_(std::move(made)) {
    make_ = [arena](const StepOrder& order) { return make_step(arena.world(), order); };
    find_ = [arena](std::uint32_t body, std::uint32_t triangle) { return arena.world().triangle(body, triangle); };
    capture_ = [arena, order = recorded_.order] {
        return capture_step(arena.world(), order.settings, order.input, order.dt, order.before);
    };
    why_ = explain(recorded_.story());
    reset();
}

void StepStudy::reset() {
    edited_ = recorded_.order.settings;
    surfaces_.assign(edited_.surfaces.all().begin(), edited_.surfaces.all().end());
    make_again();
}

void StepStudy::set(const Dial& dial, double value) {
    edited_.*dial.field = value;
    make_again();
}

void StepStudy::set_response(Response response) {
    edited_.response = response;
    make_again();
}

double StepStudy::grip() const {
    return edited_.surfaces[recorded_.order.before.ground_surface].grip;
}

void StepStudy::set_grip(double grip) {
    const std::size_t surface = recorded_.order.before.ground_surface;
    constexpr std::size_t most = 4096;  // rules that are made for a surface that has none
    if (surface >= most) return;
    if (surface >= surfaces_.size()) surfaces_.resize(surface + 1);
    surfaces_[surface].grip = grip;
    make_again();
}

bool StepStudy::is_edited() const {
    const CharacterSettings& then = recorded_.order.settings;
    const std::uint32_t surface = recorded_.order.before.ground_surface;
    return edited_.response != then.response || grip() != then.surfaces[surface].grip ||
           std::any_of(all_dials.begin(), all_dials.end(),
                       [&](const Dial& dial) { return edited_.*dial.field != then.*dial.field; });
}

void StepStudy::make_again() {
    edited_.surfaces = SurfaceRules(surfaces_);
    StepOrder order = recorded_.order;
    order.settings = edited_;
    again_ = make_(order);
    why_again_ = explain(again_.story());
}

std::optional<Triangle> StepStudy::triangle_of(const StepRecord& record) const {
    return names_triangle(record) ? find_(record.body, record.triangle) : std::nullopt;
}

std::string StepStudy::difference() const {
    return difference_text(recorded_, again_);
}

std::string difference_text(const MadeStep& then, const MadeStep& now) {
    const CharacterState& a = then.result.state;
    const CharacterState& b = now.result.state;
    const std::string parts = parting(then.records, now.records);
    if (parts.empty() && a == b && then.result.events.set == now.result.events.set) return "The same, to the last bit.";
    std::string text = away(then, now);
    if (a.footing != b.footing)
        text +=
            fmt::format(" It is {} now, and was {}.", tools::footing_text(b.footing), tools::footing_text(a.footing));
    const CharacterEvents gained{.set = now.result.events.set & ~then.result.events.set};
    const CharacterEvents lost{.set = then.result.events.set & ~now.result.events.set};
    if (gained.set != 0) text += fmt::format(" Now: {}.", tools::events_text(gained));
    if (lost.set != 0) text += fmt::format(" No more: {}.", tools::events_text(lost));
    if (!parts.empty()) text += " " + parts;
    return text;
}

}  // namespace surefoot::debugger
