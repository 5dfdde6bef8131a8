#include "debugger/step_words.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <numbers>

#include "text.hpp"

namespace surefoot::debugger {

namespace {

using tools::short_vector;

/// Four digits, no more than a list has room for.
std::string short_number(double value) {
    return fmt::format("{:.4g}", value);
}

std::string metres(double length) {
    return short_number(length) + " m";
}

std::string way_of(const StepRecord& record) {
    return metres(glm::length(record.motion));
}

std::string part_of(const StepRecord& record) {
    const char* const part = record.feature == Feature::face   ? "the face"
                             : record.feature == Feature::edge ? "an edge"
                                                               : "a corner";
    return fmt::format("{} of triangle {}", part, record.triangle);
}

/// The angle from level of a plane whose normal rises by this much [degrees].
std::string degrees(double rises) {
    return short_number(std::acos(std::fmin(1, std::fmax(-1, rises))) * 180 / std::numbers::pi);
}

std::string rule_text(const StepRecord& record) {
    switch (record.rule) {
        case StepRule::slope_limit:
            return fmt::format("slope of {} degrees, limit {}", degrees(record.value), degrees(record.limit));
        case StepRule::step_height:
            return fmt::format("{} higher, allowed are {}", metres(record.value), metres(record.limit));
        case StepRule::head_room:
            return fmt::format("room for {}, needed are {}", metres(record.value), metres(record.limit));
        case StepRule::no_advance:
            return "raised, it gets no farther";
        case StepRule::not_higher:
            return "ground ahead is no higher";
        case StepRule::snap_distance:
            return record.value > 0
                       ? fmt::format("ground {} below, followed are {}", metres(record.value), metres(record.limit))
                       : "no ground near below";
        case StepRule::perch_distance:
            return fmt::format("held {} from the axis, allowed are {}", metres(record.value), metres(record.limit));
        case StepRule::slippery:
            return "slippery";
        case StepRule::steps_off:
            return "steps are switched off";
        case StepRule::coyote_time:
            return record.value < 1e6 ? fmt::format("{} s since ground, allowed are {} s", short_number(record.value),
                                                    short_number(record.limit))
                                      : "never on ground";
        case StepRule::none:
            break;
    }
    return {};
}

std::string with_rule(std::string text, const StepRecord& record) {
    const std::string rule = rule_text(record);
    return rule.empty() ? text : text + ": " + rule;
}

std::string triangle_text(const StepRecord& record) {
    return fmt::format("triangle {} of body {}", record.triangle, record.body);
}

}  // namespace

std::string title_of(const StepRecord& record) {
    switch (record.act) {
        case StepAct::carried:
            return "carried by " + way_of(record);
        case StepAct::recovered:
            return "moved out by " + way_of(record);
        case StepAct::wants:
            return "wants to go " + way_of(record);
        case StepAct::pass:
            return "pass of " + way_of(record);
        case StepAct::touch:
            return fmt::format("touch: {}, after {:.0f} %", part_of(record), 100 * record.value);
        case StepAct::obeyed:
            return fmt::format("obeyed: plane of triangle {}", record.triangle);
        case StepAct::passed_over:
            return fmt::format("passed over: {}", part_of(record));
        case StepAct::seam:
            return fmt::format("seam: plane replaced, triangle {}", record.triangle);
        case StepAct::wall:
            return with_rule("a wall too", record);
        case StepAct::gave_up_rising:
            return with_rule("gave up rising", record);
        case StepAct::rested:
            return "rested: nothing is left of the wish";
        case StepAct::step_tried:
            return fmt::format("looks for a step of up to {}", metres(record.value));
        case StepAct::step_refused:
            return with_rule("no step", record);
        case StepAct::stepped_up:
            return "stepped up by " + metres(record.value);
        case StepAct::ground:
            return fmt::format("stands on triangle {}", record.triangle);
        case StepAct::no_ground:
            return with_rule("nothing to stand on", record);
        case StepAct::snapped_down:
            return "followed the ground down by " + metres(record.value);
        case StepAct::jumped:
            return fmt::format("jumped with {} m/s", short_number(record.value));
        case StepAct::landed:
            return fmt::format("landed with {} m/s", short_number(record.value));
        case StepAct::left_ground:
            return with_rule("left the ground", record);
        case StepAct::jump_refused:
            return with_rule("no jump", record);
        case StepAct::changed_form:
            return "took another body";
        case StepAct::form_refused:
            return "no room for another body";
        case StepAct::ledge_wall:
            return record.value < 1 ? "a wall to hang on, after " + way_of(record) : "no wall to hang on";
        case StepAct::ledge_edge:
            return record.value < 1 ? "its edge is found" : "it has no edge in reach";
        case StepAct::ledge_refused:
            return with_rule("does not hold on", record);
        case StepAct::crushed:
            return "crushed";
        case StepAct::stuck:
            return "stuck";
        case StepAct::overflow:
            return "overflow: more than a step has room for";
        case StepAct::parted:
            return "parted from others by " + way_of(record);
        case StepAct::met_neighbour:
            return fmt::format("met neighbour {}", record.body);
    }
    return "unknown";
}

std::string meaning_of(const StepRecord& record) {
    switch (record.act) {
        case StepAct::carried:
            return "Moving bodies took it along, or pushed it.";
        case StepAct::recovered:
            return "It began closer to something than its skin allows, and was moved out before anything else.";
        case StepAct::wants:
            return "Where this tick would lead if nothing were in the way: its wish, its velocity and gravity.";
        case StepAct::pass:
            return "What is left of the wish, led along all planes that are obeyed by now. It goes on to the next "
                   "touch.";
        case StepAct::touch:
            return fmt::format(
                "The body, larger by its skin, meets {} of body {}. What follows decides about its plane.",
                part_of(record), record.body);
        case StepAct::obeyed:
            return "The plane is kept: from now on no motion leads into it.";
        case StepAct::passed_over:
            return "The plane is dropped: the surface there does not face the motion, or one that is obeyed already "
                   "says "
                   "the same.";
        case StepAct::seam:
            return "The touch lies on an inner edge, which nobody should feel: the plane of the face that covers it "
                   "takes the place of its own.";
        case StepAct::wall:
            return "The plane is steeper than the slope limit. On foot it counts as an upright wall besides, so that "
                   "nobody is led up along it.";
        case StepAct::gave_up_rising:
            return "A plane steeper than the slope limit would have lifted it: that part of the wish is dropped.";
        case StepAct::rested:
            return "Along all planes at once there is no way left that follows the wish.";
        case StepAct::step_tried:
            return "Something blocks it. Up by the step height, ahead by the step depth at the least, and down: is "
                   "there "
                   "ground that is higher than here?";
        case StepAct::step_refused:
            return "There is no step there, by this rule.";
        case StepAct::stepped_up:
            return "It was, and the way up is gone.";
        case StepAct::ground:
            return "The ground that carries it when the tick begins.";
        case StepAct::no_ground:
            return "Nothing carries it when the tick begins: it flies or falls.";
        case StepAct::snapped_down:
            return "The ground drops away by less than the snap distance: feet stay on it.";
        case StepAct::left_ground:
            return "From here on it falls, for the rest of the tick.";
        case StepAct::landed:
            return "It came down on something that it can stand on.";
        case StepAct::ledge_wall:
            return "A ball looks for a wall ahead of the hands.";
        case StepAct::ledge_edge:
            return "A column is let down behind the wall's face, to find the edge.";
        case StepAct::met_neighbour:
            return "Another character is in the way, and is obeyed like an upright wall.";
        default:
            return {};
    }
}

std::string numbers_of(const StepRecord& record) {
    std::string text = fmt::format("from    {}", short_vector(record.position));
    if (record.motion != dvec3(0, 0, 0)) {
        text += fmt::format("\nto      {}", short_vector(record.position + record.motion));
        text += fmt::format("\nlength  {}", way_of(record));
    }
    if (names_triangle(record))
        text += fmt::format("\npoint   {}\nnormal  {}\nof      {}", short_vector(record.point),
                            short_vector(record.normal), triangle_text(record));
    const std::string rule = rule_text(record);
    if (!rule.empty()) text += "\nrule    " + rule;
    return text;
}

std::vector<int> depths_of(std::span<const StepRecord> records) {
    std::vector<int> depths;
    bool in_look = false;
    bool in_pass = false;
    for (const StepRecord& record : records) {
        const bool is_met = record.act == StepAct::touch || record.act == StepAct::obeyed ||
                            record.act == StepAct::passed_over || record.act == StepAct::seam ||
                            record.act == StepAct::wall || record.act == StepAct::gave_up_rising ||
                            record.act == StepAct::met_neighbour;
        if (record.act == StepAct::pass) in_pass = true;
        if (record.act != StepAct::pass && !is_met) in_pass = false;
        const bool goes = record.act == StepAct::pass || record.act == StepAct::rested;
        depths.push_back((in_look && (goes || is_met) ? 1 : 0) + (in_pass && is_met ? 1 : 0));
        if (record.act == StepAct::step_tried) in_look = true;
        if (record.act == StepAct::step_refused || record.act == StepAct::stepped_up) in_look = false;
    }
    return depths;
}

bool names_triangle(const StepRecord& record) {
    const bool is_no_way = record.act != StepAct::changed_form && record.act != StepAct::form_refused &&
                           record.act != StepAct::met_neighbour;
    return is_no_way && glm::length(record.normal) > 0.5;
}

}  // namespace surefoot::debugger
