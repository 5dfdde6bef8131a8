// "Why did I stop?" A trace takes down every plane that was tried and what became of it. Explained in docs/using.md.
#include <array>
#include <cstddef>
#include <cstdio>

#include <surefoot/surefoot.hpp>

namespace {

const char* name(surefoot::Feature feature) {
    constexpr std::array names{"face", "edge", "vertex"};
    return names[static_cast<std::size_t>(feature)];
}

}  // namespace

int main() {
    const surefoot::Triangle step{.a = {-1, 0.3, 2}, .b = {1, 0.3, 2}, .c = {0, 0.3, 4}};
    const surefoot::Capsule player{.radius = 0.4, .half_height = 0.5};
    const surefoot::Motion walk{.from = {0, 0.95, 0}, .to = {0, 0.95, 3}};

    // [trace]
    std::array<surefoot::TraceRecord, 64> room;  // yours: a trace allocates nothing
    surefoot::Trace trace(room);
    const auto hit = surefoot::sweep(player, walk, step, {}, &trace);

    for (const surefoot::TraceRecord& record : trace.records()) {
        if (record.verdict != surefoot::Verdict::enters) continue;
        std::printf("%-6s  normal %5.2f %5.2f %5.2f  gap %6.3f m  closes at t = %.4f\n", name(record.feature),
                    record.normal.x, record.normal.y, record.normal.z, record.gap_from, record.t);
    }
    if (hit) std::printf("stopped at t = %.4f by the %s\n", hit->t, name(hit->feature));
    // [/trace]

    double last = 0;
    for (const surefoot::TraceRecord& record : trace.records()) {
        if (record.verdict == surefoot::Verdict::enters && record.t > last) last = record.t;
    }
    return hit && hit->feature == surefoot::Feature::edge && hit->t == last && trace.dropped() == 0 ? 0 : 1;
}
