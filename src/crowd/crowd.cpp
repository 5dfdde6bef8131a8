#include <algorithm>
#include <array>
#include <cassert>
#include <new>
#include <utility>

#include <surefoot/crowd.hpp>

#include "character/body.hpp"
#include "character/many.hpp"
#include "character/recover.hpp"
#include "crowd/grid.hpp"
#include "crowd/order.hpp"
#include "ieee_guard.hpp"
#include "limits.hpp"
#include "sweep/query.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

struct Crowd::State {
    std::size_t room = 0;
    std::size_t count = 0;
    std::unique_ptr<Neighbour[]> members;
    std::unique_ptr<Block[]> blocks;
    Grid grid;
};

namespace {

// All that a step might come near to is within this of where it begins [m].
double way_of(const CharacterSettings& settings, const CharacterInput& input, const CharacterState& state,
              double dt) noexcept {
    const double jump = input.jump ? std::sqrt(2 * settings.gravity * settings.jump_height) : 0;
    const double speed = larger(length(to_vec(state.velocity)), length(to_vec(input.wish))) +
                         length(to_vec(state.ground_velocity)) + length(to_vec(input.impulse)) + settings.gravity * dt +
                         jump + recovery_speed;
    const double size = size_of(settings.volume.shape) / smallest_of(settings.volume.shape);
    return speed * dt + settings.step_depth + settings.skin * (2 + size);
}

bool is_usable(const CharacterInput& input, const Neighbour& neighbour, double way) noexcept {
    const double up = dot(to_vec(input.up), to_vec(input.up));
    return up > 1e-12 && up < 1e12 && is_valid(neighbour.volume) && is_valid_point(neighbour.position) &&
           is_valid_point(neighbour.velocity) && way >= 0 && way <= 1e12;
}

Vec extent_of(const Volume& volume) noexcept {
    const Box3 box = reach_box(volume);
    return {larger(box.max.x, -box.min.x), larger(box.max.y, -box.min.y), larger(box.max.z, -box.min.z)};
}

// Two in the very same place have no way out of each other that both could take. Each sees the other a hair beside
// itself, on opposite sides; which these are depends on their numbers, so that many do not end up in one row.
Vec beside(const Neighbour& met, std::uint32_t own) noexcept {
    constexpr double hair = 0x1p-20;  // share of the size
    const bool is_lower = met.id < own;
    const std::uint64_t low = is_lower ? met.id : own;
    const std::uint64_t high = is_lower ? own : met.id;
    std::uint64_t hash = (low << 32 | high) * 0x9e3779b97f4a7c15;
    hash ^= hash >> 32;
    const auto part = [&](int shift) noexcept {
        return static_cast<double>(static_cast<int>(hash >> shift & 15) * 2 - 15) / 15;  // odd over 15: never zero
    };
    const double size = size_of(met.volume.shape) * (is_lower ? -hair : hair);
    return Vec{part(0), part(4), part(8)} * size;
}

}  // namespace

Crowd::Crowd(Crowd&& other) noexcept : state_(std::exchange(other.state_, nullptr)) {}

Crowd& Crowd::operator=(Crowd&& other) noexcept {
    std::swap(state_, other.state_);
    return *this;
}

Crowd::~Crowd() {
    delete state_;
}

bool Crowd::reserve(std::size_t count) noexcept {
    if (state_ == nullptr) state_ = new (std::nothrow) State;
    if (state_ == nullptr) return false;
    if (count <= state_->room) return true;
    std::unique_ptr<Neighbour[]> members(new (std::nothrow) Neighbour[count]);
    std::unique_ptr<Block[]> blocks(new (std::nothrow) Block[count]);
    Grid grid;
    if (!members || !blocks || !grid.reserve(count)) return false;
    std::copy_n(state_->members.get(), state_->count, members.get());
    std::copy_n(state_->blocks.get(), state_->count, blocks.get());
    state_->room = count;
    state_->members = std::move(members);
    state_->blocks = std::move(blocks);
    state_->grid = std::move(grid);
    state_->grid.build({state_->blocks.get(), state_->count});
    return true;
}

bool Crowd::gather(const Characters& characters, double dt) noexcept {
    const IeeeGuard guard;
    if (state_ != nullptr) state_->count = 0;
    const std::size_t count = characters.before.size();
    if (!fit_together(characters) || !reserve(count)) return false;
    State& state = *state_;
    for (std::size_t i = 0; i < count; ++i) {
        const CharacterSettings& settings = one_of(characters.settings, i);
        const CharacterInput& input = one_of(characters.inputs, i);
        const std::uint32_t id = characters.ids.empty() ? static_cast<std::uint32_t>(i) : characters.ids[i];
        state.members[i] = neighbour_of(settings, input, characters.before[i], id);
        const double way = way_of(settings, input, characters.before[i], dt);
        state.blocks[i] = {to_vec(characters.before[i].position), {-1, -1, -1}};
        if (is_usable(input, state.members[i], way)) {
            state.blocks[i].reach = extent_of(state.members[i].volume) + Vec{way, way, way};
        }
    }
    state.count = count;
    state.grid.build({state.blocks.get(), count});
    return true;
}

std::size_t Crowd::size() const noexcept {
    return state_ == nullptr ? 0 : state_->count;
}

std::size_t Crowd::neighbours(std::size_t index, std::span<Neighbour> room) const noexcept {
    const IeeeGuard guard;
    if (index >= size()) return 0;
    const State& state = *state_;
    const Block& own = state.blocks[index];
    NearestFirst nearest(own.centre, room);
    state.grid.each_near(own, [&](std::uint32_t other) noexcept {
        if (other != index) nearest.offer(state.members[other]);
    });
    for (Neighbour& met : nearest.found()) {
        if (!(to_vec(met.position) == own.centre)) continue;
        met.position = to_dvec3(own.centre + beside(met, state.members[index].id));
    }
    return nearest.count();
}

void step_all(const World& world, const Crowd& crowd, const Characters& characters, double dt,
              StepRange range) noexcept {
    if (!fit_together(characters) || crowd.size() != characters.before.size()) {
        assert(false && "step_all: the crowd has to gather these characters first");
        return;
    }
    each_in(characters, range, [&](std::size_t i) noexcept {
        std::array<Neighbour, most_met_in_crowd> room;
        const std::size_t near = crowd.neighbours(i, room);
        const std::span<const Neighbour> met(room.data(), near < room.size() ? near : room.size());
        answer(
            characters, i,
            step(world, one_of(characters.settings, i), one_of(characters.inputs, i), dt, characters.before[i], met));
    });
}

}  // namespace v0
}  // namespace surefoot
