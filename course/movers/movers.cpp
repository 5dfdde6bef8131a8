#include "course/movers/movers.hpp"

#include <array>

namespace surefoot::course {
namespace {

struct Entry {
    MoverName name;
    std::unique_ptr<Mover> (*make)();
};

template <bool Faults::*Fault>
std::unique_ptr<Mover> broken() {
    Faults faults;
    faults.*Fault = true;
    return make_textbook(faults);
}

constexpr Entry entries[] = {
    {{"ours", "surefoot::step"}, make_ours},
    {{"bullet", "Bullet's btKinematicCharacterController"}, make_bullet},
    {{"textbook", "a short controller of the usual build, without the faults below"}, [] { return make_textbook({}); }},
    {{"broken-hit-by-hit", "slides along what it hit last, forgets what it hit before", true},
     broken<&Faults::hit_by_hit>},
    {{"broken-tick-step", "looks for a step no farther than the tick's motion", true}, broken<&Faults::steps_by_tick>},
    {{"broken-seams", "believes the normals of inner edges", true}, broken<&Faults::raw_edges>},
    {{"broken-padding", "keeps its distance along the motion, not the normal", true}, broken<&Faults::pads_velocity>},
    {{"broken-one-body", "knows the contacts of one body at a time", true}, broken<&Faults::one_body>},
    {{"broken-discrete", "moves first, then pushes itself out of what it overlaps", true},
     broken<&Faults::moves_first>},
    {{"broken-float", "keeps its position in single precision", true}, broken<&Faults::single_precision>},
    {{"broken-restless", "pushes itself farther off than it stops before things", true},
     broken<&Faults::pushes_too_far>},
    {{"broken-stop", "stays where it meets something", true}, broken<&Faults::stops>},
    {{"broken-any-slope", "stands on whatever is under it, however steep", true}, broken<&Faults::any_slope>},
    {{"broken-lengths", "has lengths for a grown person in its code", true}, broken<&Faults::human_lengths>},
};

}  // namespace

std::span<const MoverName> movers() {
    static const auto names = [] {
        std::array<MoverName, std::size(entries)> list;
        for (std::size_t i = 0; i < list.size(); ++i) list[i] = entries[i].name;
        return list;
    }();
    return names;
}

std::unique_ptr<Mover> make_mover(std::string_view name) {
    for (const Entry& entry : entries) {
        if (entry.name.name == name) return entry.make();
    }
    return nullptr;
}

}  // namespace surefoot::course
