#include "playground/walk/walker.hpp"

#include <algorithm>
#include <variant>

namespace surefoot::playground {
namespace {

struct Foot {
    double operator()(const Sphere& s) const { return s.radius; }
    double operator()(const Ellipsoid& s) const { return s.radii.y; }
    double operator()(const Capsule& s) const { return s.radius + s.half_height; }
    double operator()(const Box& s) const { return s.half_extents.y; }
    double operator()(const Cylinder& s) const { return s.half_height; }
    double operator()(const Cone& /*s*/) const { return 0; }
};

}  // namespace

double foot_of(const Shape& shape) {
    return std::visit(Foot{}, shape);
}

const Volume& body_of(const CharacterSettings& settings, CharacterForm form) {
    switch (form) {
        case CharacterForm::crouched:
            return settings.crouched ? *settings.crouched : settings.volume;
        case CharacterForm::in_air:
            return settings.in_air ? *settings.in_air : settings.volume;
        case CharacterForm::on_ramp:
            return settings.on_ramp ? *settings.on_ramp : settings.volume;
        case CharacterForm::on_ledge:
            return settings.on_ledge ? *settings.on_ledge : settings.volume;
        case CharacterForm::standing:
            break;
    }
    return settings.volume;
}

bool is_stop(const CharacterEvents& events) {
    return events.has(CharacterEvent::blocked) || events.has(CharacterEvent::crushed) ||
           events.has(CharacterEvent::stuck) || events.has(CharacterEvent::no_room);
}

Walker::Walker(const Mesh& mesh) : room_(most_ticks), ring_(room_), stops_(most_ticks) {
    // A mesh at the origin of an empty world is never refused, but for want of memory, and then there is nothing.
    static_cast<void>(world_.add(mesh));
}

bool Walker::put(const dvec3& place) {
    CharacterState state;
    constexpr double raise = 0.1;  // [m]
    constexpr int most_raises = 40;
    for (int i = 0; i < most_raises; ++i) {
        state.position = place + dvec3(0, foot_of(settings_.volume.shape) + settings_.skin + raise * i, 0);
        if (!fits(world_, settings_, state.position)) continue;
        put(state);
        // It comes down to stand, which is nothing to remember.
        constexpr int settle = 60;
        for (int k = 0; k < settle && now_.footing != Footing::ground; ++k) make_tick({});
        put(CharacterState(now_));
        return true;
    }
    return false;
}

void Walker::put(const CharacterState& state) {
    now_ = before_ = state;
    clock_.waiting = 0;
    begin_past();
}

void Walker::begin_past() {
    looks_at_.reset();
    ring_.clear();
    past_surfaces_ = surfaces_;
    past_settings_ = settings_;
    past_settings_.surfaces = SurfaceRules(past_surfaces_);
    is_changed_ = false;
    touch();
}

void Walker::touch() {
    told_.reset();
    stop_.reset();
    what_if_.reset();
}

void Walker::change(const CharacterSettings& settings) {
    const double rise = foot_of(settings.volume.shape) - foot_of(settings_.volume.shape);
    settings_ = settings;
    settings_.surfaces = {};
    is_changed_ = true;
    ++changes_;
    what_if_.reset();
    if (rise == 0) return;
    CharacterState moved = state();
    moved.position.y += rise;
    put(moved);
}

void Walker::change(const std::vector<SurfaceRule>& surfaces) {
    surfaces_ = surfaces;
    is_changed_ = true;
    ++changes_;
    what_if_.reset();
}

void Walker::make_tick(const CharacterInput& input) {
    if (looks_at_) {
        look_at(*looks_at_ + 1);
        return;
    }
    if (is_changed_) begin_past();
    const StepResult result = step(world_, past_settings_, input, tick, now_);
    ring_.push(input, tick, now_);
    stops_[made_++ % most_ticks] = is_stop(result.events) ? 1 : 0;
    before_ = now_;
    now_ = result.state;
    touch();
}

void Walker::look_at(std::size_t when) {
    if (when < ticks()) {
        looks_at_ = when;
        paused = true;
    } else {
        looks_at_.reset();
    }
    touch();
}

void Walker::go_on_from_here() {
    if (!looks_at_) return;
    std::vector<RingTick> kept;
    for (std::size_t i = 0; i < *looks_at_; ++i) kept.push_back(ring_[i]);
    const CharacterState here = ring_[*looks_at_].before;
    made_ -= ticks() - kept.size();
    ring_.clear();
    for (const RingTick& one : kept) ring_.push(one.input, one.dt, one.before);
    now_ = before_ = here;
    clock_.waiting = 0;
    looks_at_.reset();
    touch();
}

const CharacterState& Walker::state() const {
    return looks_at_ ? ring_[*looks_at_].before : now_;
}

dvec3 Walker::drawn_position(double waiting) const {
    if (paused || looks_at_) return state().position;
    const double share = std::clamp((clock_.waiting + waiting * speed) / tick, 0.0, 1.0);
    return before_.position + (now_.position - before_.position) * share;
}

ToldStep Walker::tell(std::size_t when) const {
    std::vector<StepRecord> records(most_records);
    StepTrace trace(records);
    const RingTick& made = ring_[when];
    ToldStep told;
    told.input = made.input;
    told.before = made.before;
    told.result = step(world_, past_settings_, made.input, made.dt, made.before, {}, &trace);
    told.dropped = trace.dropped();
    records.resize(trace.records().size());
    told.records = std::move(records);
    return told;
}

const ToldStep* Walker::told() const {
    if (looks_at() == 0) return nullptr;
    if (!told_) told_ = tell(looks_at() - 1);
    return &*told_;
}

Walker::Stop Walker::last_stop() const {
    const std::size_t end = looks_at();
    if (!stop_) {
        const std::uint64_t first = made_ - ticks();
        for (std::size_t i = end; i > 0 && !stop_; --i) {
            if (stops_[(first + i - 1) % most_ticks] == 0) continue;
            stop_ = tell(i - 1);
            stop_tick_ = i;
        }
        if (!stop_) return {};
    }
    return {&*stop_, static_cast<double>(end - stop_tick_) * tick};
}

std::vector<StepSentence> Walker::why(const ToldStep& step) const {
    return explain({.settings = past_settings_,
                    .input = step.input,
                    .dt = tick,
                    .before = step.before,
                    .result = step.result,
                    .records = step.records,
                    .dropped = step.dropped});
}

std::optional<StepCapture> Walker::moment() const {
    if (looks_at() == 0) return std::nullopt;
    const RingTick& made = ring_[looks_at() - 1];
    return capture_step(world_, past_settings_, made.input, made.dt, made.before);
}

Session Walker::session() const {
    return session_of(ring_, world_, past_settings_, now_);
}

const std::vector<dvec3>& Walker::what_if() const {
    if (what_if_) return *what_if_;
    what_if_.emplace();
    if (!is_changed_ || looks_at() == ticks()) return *what_if_;
    CharacterSettings settings = settings_;
    settings.surfaces = SurfaceRules(surfaces_);
    CharacterState state = this->state();
    what_if_->push_back(state.position);
    for (std::size_t i = looks_at(); i < ticks(); ++i) {
        state = step(world_, settings, ring_[i].input, ring_[i].dt, state).state;
        what_if_->push_back(state.position);
    }
    return *what_if_;
}

std::vector<dvec3> Walker::trail() const {
    std::vector<dvec3> places;
    for (std::size_t i = 0; i < ticks(); ++i) places.push_back(ring_[i].before.position);
    places.push_back(now_.position);
    return places;
}

}  // namespace surefoot::playground
