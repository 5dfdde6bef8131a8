#include "capture/sentences.hpp"

#include <charconv>

#include "angle.hpp"
#include "capture/number.hpp"
#include "character/body.hpp"
#include "character/form.hpp"

namespace surefoot::internal {

namespace {

// A face whose normal rises or falls by less than this stands upright.
constexpr double upright = 0.02;

std::string metres(double value) {
    return short_text(value) + " m";
}

const char* part_of(const StepRecord& record) noexcept {
    if (record.feature == Feature::face) return "that face";
    return record.feature == Feature::edge ? "its edge" : "its corner";
}

}  // namespace

std::string short_text(double value) {
    char text[40];
    const auto [end, error] = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 4);
    static_cast<void>(error);  // 40 characters hold every number
    return {text, end};
}

double angle_deg(double cosine) noexcept {
    if (cosine < 0) return 180 - angle_deg(-cosine);
    double low = 0;
    double high = 90;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (cosine_deg(middle) > cosine ? low : high) = middle;
    }
    return high;
}

Speaker::Speaker(const StepStory& told) noexcept : story(told) {
    const Vec along = to_vec(told.input.up);
    up = along / length(along);
    body = body_of(volume_of(told.settings, told.result.state.form), told.settings.skin, up);
}

std::string Speaker::name(const StepRecord& record) const {
    if (record.act == StepAct::met_neighbour) return joined({"neighbour ", std::to_string(record.body)});
    return joined({"triangle ", std::to_string(record.triangle), " of body ", std::to_string(record.body)});
}

std::string Speaker::slope(const StepRecord& record) const {
    return joined({"rises by ", short_text(angle_deg(record.value)), " degrees, and the slope limit is ",
                   short_text(story.settings.slope_limit_deg)});
}

std::string Speaker::perch(const StepRecord& record) const {
    return joined({"holds it by an edge ", metres(record.value), " from its axis, and perch_distance is ",
                   short_text(record.limit)});
}

std::string Speaker::ledge(const StepRecord& record) const {
    if (record.rule == StepRule::slope_limit) {
        return joined({"It does not hold on to ", name(record), ": that face ", slope(record), "."});
    }
    if (record.rule == StepRule::head_room) {
        return joined({"It does not hold on to ", name(record), ": there is no room for it."});
    }
    return joined({"It does not hold on to ", name(record), "."});
}

std::string Speaker::lie(const StepRecord& record) const {
    if (record.act == StepAct::met_neighbour) return "it is hard, and in the way like a wall";
    const std::string part = part_of(record);
    if (record.rule == StepRule::slope_limit) {
        if (record.feature == Feature::face) return part + " " + slope(record);
        return joined({part, " is met as a slope of ", short_text(angle_deg(record.value)),
                       " degrees, and the slope limit is ", short_text(story.settings.slope_limit_deg)});
    }
    const double rises = dot(to_vec(record.normal), up);
    if (absolute(rises) <= upright) {
        return part + (record.feature == Feature::face ? " stands upright" : " is met as an upright wall");
    }
    if (rises > 0) return joined({part, " rises by ", short_text(angle_deg(rises)), " degrees"});
    const double height = dot(to_vec(record.point) - to_vec(record.position), up) + body.foot;
    const double tall = body.foot + reach_along(body.volume, up);
    return joined(
        {part, " hangs over: it is met ", metres(height), " above the feet, and the body is ", metres(tall), " tall"});
}

std::string Speaker::no_step(const StepRecord& record) const {
    const std::string step_up = short_text(story.settings.step_up);
    switch (record.rule) {
        case StepRule::step_height:
            return joined({"No step there: ground ahead, ", name(record), ", is ", metres(record.value),
                           " higher, and step_up is ", step_up, "."});
        case StepRule::head_room:
            return joined({"No step there: there is room for ", metres(record.value), " above it, and it would need ",
                           metres(record.limit), "."});
        case StepRule::slope_limit:
            return joined({"No step there: what it would stand on, ", name(record), ", ", slope(record), "."});
        case StepRule::perch_distance:
            return joined({"No step there: ", name(record), " ", perch(record), "."});
        case StepRule::slippery:
            return joined({"No step there: what it would stand on, ", name(record), ", is slippery."});
        case StepRule::no_advance:
            return joined({"No step there: raised by step_up, ", step_up, " m, it gets no farther."});
        case StepRule::not_higher:
            return joined({"No step there: raised by step_up, ", step_up, " m, it reaches no ground that is higher."});
        case StepRule::steps_off:
            if (record.value > 0) {
                return joined({"Steps are switched off: ground ahead, ", name(record), ", is ", metres(record.value),
                               " higher, and step_up is 0."});
            }
            return "Steps are switched off: step_up is 0.";
        default:
            return "No step there.";
    }
}

std::string Speaker::no_ground(const StepRecord& record) const {
    if (record.rule == StepRule::slope_limit) {
        return joined({"It does not stand on ", name(record), ": that face ", slope(record), "."});
    }
    if (record.rule == StepRule::perch_distance) {
        return joined({"It does not stand on ", name(record), ": it ", perch(record), "."});
    }
    if (record.rule == StepRule::slippery) {
        return joined({"It does not stand on ", name(record), ": its surface is slippery."});
    }
    return {};
}

std::string Speaker::left_ground(const StepRecord& record) const {
    switch (record.rule) {
        case StepRule::snap_distance:
            if (!(record.value > 0)) {
                return joined(
                    {"It left the ground: there is none near below, and snap_down is ", short_text(record.limit), "."});
            }
            return joined({"It left the ground: the ground below, ", name(record), ", is ", metres(record.value),
                           " lower, and snap_down is ", short_text(record.limit), "."});
        case StepRule::slope_limit:
            return joined({"It left the ground: what is below, ", name(record), ", ", slope(record), "."});
        case StepRule::slippery:
            return joined({"It left the ground: what is below, ", name(record), ", is slippery."});
        case StepRule::perch_distance:
            return joined({"It left the ground: ", name(record), " ", perch(record), "."});
        default:
            return "It left the ground.";
    }
}

std::string Speaker::act(const StepRecord& record) const {
    const std::string way = metres(length(to_vec(record.motion)));
    switch (record.act) {
        case StepAct::carried:
            return joined({"What moves took it along by ", way, "."});
        case StepAct::recovered:
            return joined({"It was too close to something, and was moved out by ", way, "."});
        case StepAct::parted:
            return joined({"It was ", metres(record.value), " too close to neighbour ", std::to_string(record.body),
                           record.motion == dvec3{0, 0, 0} ? ", and there was no room to move out."
                                                           : ", and was moved out by " + way + "."});
        case StepAct::stuck:
            return "It is stuck: it begins inside of something, and there is no way out that crosses nothing.";
        case StepAct::crushed:
            return "It is crushed: no room is left between things that move.";
        case StepAct::overflow:
            return "The move ended early: more is near than a step has room for.";
        case StepAct::no_ground:
            return no_ground(record);
        case StepAct::jumped:
            return joined({"It jumped with ", short_text(record.value), " m/s."});
        case StepAct::jump_refused:
            return joined({"It did not jump: it is ", record.value < 1e6 ? short_text(record.value) : "long",
                           record.value < 1e6 ? " s" : "", " since it was on the ground, and coyote_time is ",
                           short_text(record.limit), "."});
        case StepAct::snapped_down:
            return joined({"It followed the ground, ", name(record), ", down by ", metres(record.value), "."});
        case StepAct::left_ground:
            return left_ground(record);
        case StepAct::landed:
            return joined({"It landed on ", name(record), " with ", short_text(record.value), " m/s."});
        case StepAct::form_refused:
            return "It keeps the body that it has: there is no room for another.";
        case StepAct::ledge_refused:
            return ledge(record);
        case StepAct::gave_up_rising:
            return joined({"It does not climb ", name(record), " in the air: that face ", slope(record), "."});
        default:
            return {};
    }
}

}  // namespace surefoot::internal
