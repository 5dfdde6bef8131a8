// A step's records in order, cut into legs: each time that the character wants to go somewhere begins one.
#include <algorithm>
#include <cmath>

#include <surefoot/capture_explain.hpp>

#include "capture/number.hpp"
#include "capture/sentences.hpp"
#include "character/fields.hpp"
#include "ieee_guard.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

// Who got less than the first share of the way was stopped, less than the second slowed.
constexpr double stopped_below = 0.05;
constexpr double slowed_below = 0.98;

// Planes that are met less squarely than this are not what stops.
constexpr double squarely = 0.02;

// How many things that are in the way are named.
constexpr std::size_t most_named = 3;

// From where the character wanted to go, until it wanted something else or the step was over.
struct Leg {
    std::span<const StepRecord> records;  // `wants` is the first
    Vec end;
    bool on_foot = false;
};

bool ends_leg(StepAct act) noexcept {
    return act == StepAct::wants || act == StepAct::carried || act == StepAct::recovered || act == StepAct::left_ground;
}

class Explainer {
public:
    explicit Explainer(const StepStory& story)
        : story_(story), speaker_(story), parts_(std::ceil(story.dt / story.settings.longest_tick)) {}

    std::vector<StepSentence> run() {
        const std::span<const StepRecord> records = story_.records;
        bool on_foot = false;
        for (std::size_t i = 0; i < records.size(); ++i) {
            const StepAct act = records[i].act;
            if (act == StepAct::ground) on_foot = true;
            if (act == StepAct::no_ground || act == StepAct::jumped || act == StepAct::left_ground) on_foot = false;
            if (act == StepAct::wants) {
                tell_leg(leg_at(i, on_foot));
            } else {
                say(speaker_.act(records[i]), records[i]);
            }
        }
        if (sentences_.empty()) say(nothing_happened(), {});
        if (story_.dropped > 0) {
            say(joined({"There was no room in the trace for ", std::to_string(story_.dropped), " records more."}), {});
        }
        return std::move(sentences_);
    }

private:
    void say(std::string text, const StepRecord& about) {
        if (!text.empty()) sentences_.push_back({std::move(text), about});
    }

    Vec level(const Vec& v) const noexcept { return v - speaker_.up * dot(v, speaker_.up); }

    Leg leg_at(std::size_t first, bool on_foot) const {
        const std::span<const StepRecord> rest = story_.records.subspan(first);
        std::size_t count = 1;
        while (count < rest.size() && !ends_leg(rest[count].act)) ++count;
        const dvec3 end = count < rest.size() ? rest[count].position : story_.result.state.position;
        return {rest.first(count), to_vec(end), on_foot};
    }

    void tell_leg(const Leg& leg) {
        const StepRecord& wants = leg.records.front();
        Vec wanted = to_vec(wants.motion);
        Vec went = leg.end - to_vec(wants.position);
        if (leg.on_foot) {
            // Of its speed a wall may have left nothing; the wish is what was asked.
            const Vec wish = level(to_vec(story_.input.wish));
            if (dot(wish, wanted) > 0) wanted = wish * (story_.dt / parts_);
            went = level(went);
        }
        const double square = dot(wanted, wanted);
        if (!(square > 0)) return;
        const double share = dot(went, wanted) / square;
        const std::vector<StepRecord> in_the_way = obstacles(leg, wanted / length(wanted));
        if (in_the_way.empty()) return;
        if (!leg.on_foot && dot(to_vec(in_the_way[0].normal), speaker_.up) < -0.1 && dot(wanted, speaker_.up) > 0) {
            return say(ceiling(in_the_way[0]), in_the_way[0]);
        }
        if (share >= slowed_below) return;
        std::string text =
            share < stopped_below
                ? std::string("It stopped at ")
                : joined({"It got ", short_text(100 * share), " % of the way that was wished, because of "});
        for (const StepRecord& record : in_the_way) {
            if (&record != &in_the_way[0]) text += "; and at ";
            text += joined({speaker_.name(record), ": ", speaker_.lie(record)});
        }
        say(text + ".", in_the_way[0]);
        if (story_.settings.response == Response::stop) {
            say("It stays there and does not slide on, because response is stop.", in_the_way[0]);
        }
        // Nobody steps on to another.
        if (in_the_way[0].act != StepAct::met_neighbour) tell_steps(leg);
    }

    struct Met {
        StepRecord record;
        Vec plane;  // before it counted as a wall
    };

    // The planes that the character went into and that cannot be walked on, the most squarely met first.
    std::vector<StepRecord> obstacles(const Leg& leg, const Vec& towards) const {
        std::vector<Met> met;
        bool tries_step = false;
        for (const StepRecord& record : leg.records) {
            if (record.act == StepAct::step_tried) tries_step = true;
            if (record.act == StepAct::step_refused || record.act == StepAct::stepped_up) tries_step = false;
            const Vec normal = to_vec(record.normal);
            if (tries_step || !(dot(normal, towards) < -squarely)) continue;
            if (record.act == StepAct::obeyed || record.act == StepAct::met_neighbour) {
                const auto is_same = [&](const Met& other) { return dot(other.plane, normal) > 1 - 1e-6; };
                if (std::none_of(met.begin(), met.end(), is_same)) met.push_back({record, normal});
            } else if (record.act == StepAct::wall && !met.empty() && is_same_triangle(met.back().record, record)) {
                met.back().record = record;
            }
        }
        std::vector<StepRecord> found;
        for (const Met& one : met) {
            const bool is_floor = one.record.act == StepAct::obeyed &&
                                  angle_deg(dot(one.plane, speaker_.up)) <= story_.settings.slope_limit_deg;
            if (!is_floor) found.push_back(one.record);
        }
        std::stable_sort(found.begin(), found.end(), [&](const StepRecord& a, const StepRecord& b) {
            return dot(to_vec(a.normal), towards) < dot(to_vec(b.normal), towards);
        });
        if (found.size() > most_named) found.resize(most_named);
        return found;
    }

    static bool is_same_triangle(const StepRecord& a, const StepRecord& b) noexcept {
        return a.act != StepAct::met_neighbour && a.triangle == b.triangle && a.body == b.body;
    }

    // Of several looks for a step the last one tells.
    void tell_steps(const Leg& leg) {
        for (std::size_t i = leg.records.size(); i-- > 0;) {
            const StepRecord& record = leg.records[i];
            if (record.act == StepAct::stepped_up) return;
            if (record.act == StepAct::step_refused) return say(speaker_.no_step(record), record);
        }
    }

    // How much higher it would have gone: from the speed that it had and the gravity that it rises against.
    std::string ceiling(const StepRecord& record) const {
        double speed = dot(to_vec(story_.before.velocity) + to_vec(story_.input.impulse), speaker_.up);
        for (const StepRecord& one : story_.records) {
            if (one.act == StepAct::jumped) speed = one.value;
        }
        const bool cut = story_.result.state.is_jumping != 0 && !story_.input.jump;
        const double gravity = story_.settings.gravity * (cut ? story_.settings.jump_cut : 1);
        const double risen = dot(to_vec(story_.result.state.position) - to_vec(story_.before.position), speaker_.up);
        std::string text = joined({"It stopped rising at ", speaker_.name(record), ", which is above it"});
        const double more = gravity > 0 ? speed * speed / (2 * gravity) - risen : 0;
        if (more > 0) text += joined({": it would have risen by ", short_text(more), " m more"});
        return text + ".";
    }

    std::string nothing_happened() const {
        const Vec went = to_vec(story_.result.state.position) - to_vec(story_.before.position);
        if (dot(went, went) > 0) return joined({"Nothing stopped it: it went ", short_text(length(went)), " m."});
        const Vec wish = to_vec(story_.input.wish);
        if (dot(wish, wish) == 0) return "It stood still: nothing was asked of it, the wish is zero.";
        return "It stood still.";
    }

    const StepStory& story_;
    Speaker speaker_;
    double parts_;  // that the step was done in
    std::vector<StepSentence> sentences_;
};

// Each setting that is out of its range, found by giving it to settings that are fine.
void tell_settings(const CharacterSettings& settings, std::vector<StepSentence>& sentences) {
    CharacterSettings fine;
    fine.skin = 1e-6;
    const bool has_volume = is_valid(settings.volume);
    if (!has_volume) sentences.push_back({"volume is out of its range.", {}});
    visit_fields(settings, [&](const char* name, const auto& field) {
        CharacterSettings one = fine;
        if (has_volume) one.volume = settings.volume;
        visit_fields(one, [&](const char* other, auto& its) {
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(its)>, std::remove_cvref_t<decltype(field)>>) {
                if (std::string_view(name) == other) its = field;
            }
        });
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(field)>, double>) {
            if (!is_valid(one))
                sentences.push_back({joined({name, ", ", short_text(field), ", is out of its range."}), {}});
        }
    });
}

std::vector<StepSentence> explain_invalid(const StepStory& story) {
    std::vector<StepSentence> sentences;
    if (!(story.dt > 0 && story.dt <= 60)) {
        sentences.push_back({joined({"dt, ", short_text(story.dt), " s, is out of its range."}), {}});
    }
    tell_settings(story.settings, sentences);
    if (sentences.empty()) sentences.push_back({"The input or the state has a number that is out of its range.", {}});
    sentences.insert(sentences.begin(), {"Nothing was moved: the step was asked for what cannot be.", {}});
    return sentences;
}

}  // namespace

std::vector<StepSentence> explain(const StepStory& story) {
    const IeeeGuard guard;
    const Vec up = to_vec(story.input.up);
    const bool can_be = is_valid(story.settings) && dot(up, up) > 1e-12 && dot(up, up) < 1e12;
    if (!can_be || story.result.events.has(CharacterEvent::invalid)) return explain_invalid(story);
    return Explainer(story).run();
}

std::string explain_text(const StepStory& story) {
    std::string text;
    for (const StepSentence& sentence : explain(story)) text += sentence.text + "\n";
    return text;
}

}  // namespace v0
}  // namespace surefoot
