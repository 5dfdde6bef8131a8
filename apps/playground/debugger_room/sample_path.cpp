#include "playground/debugger_room/sample_path.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace surefoot::playground {

std::vector<Sample> samples_along(const debugger::Arena& arena, const Volume& volume, const Motion& motion, double step,
                                  bool one_sided, std::size_t most) {
    const double length = glm::length(motion.to - motion.from);
    std::vector<Sample> samples;
    bool looks = true;
    double along = 0;
    while (samples.size() < most && (samples.empty() || along < length)) {
        along = std::min(length, static_cast<double>(samples.size() + 1) * step);
        const dvec3 position = along < length ? motion.from + (motion.to - motion.from) * (along / length) : motion.to;
        const bool touches = arena.touches(volume, position, one_sided);
        samples.push_back({position, along, touches, looks});
        looks = looks && !touches;
    }
    return samples;
}

}  // namespace surefoot::playground
