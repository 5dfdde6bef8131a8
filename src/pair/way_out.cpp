#include "pair/way_out.hpp"

#include <utility>

namespace surefoot::internal {

namespace {

constexpr int most_turns = 40;
constexpr int most_tries = 6;
constexpr int start_count = 6;

struct Start {
    Vec normal;
    double depth = 1e300;
};

struct Starts {
    Start best[start_count];

    // Keeps the best few, the first of equals first.
    void offer(const Start& start, double hair) noexcept {
        Start carried = start;
        for (Start& kept : best) {
            if (carried.depth < kept.depth - hair) std::swap(carried, kept);
        }
    }
};

// Downhill over the directions, by planes alone. What the plane's two points are beside each other, seen along n, is
// how its depth changes when n turns (it is the gradient): so turn against that, by less when it did not help.
void descend(const PlacedPair& pair, const Vec& x, Start& start) noexcept {
    double turn = 0.5;
    for (int i = 0; i < most_turns && turn > 0x1p-12; ++i) {
        const Vec beside = pair.b.farthest(start.normal) - pair.a.farthest(-start.normal) - x;
        const Vec gradient = beside - start.normal * dot(start.normal, beside);
        const double size = length(gradient);
        if (!(size > 0)) return;
        const Vec n = unit(start.normal - gradient * (turn / size));
        const double depth = -pair.gap_along(n, x);
        if (depth < start.depth) {
            start = {n, depth};
        } else {
            turn *= 0.5;
        }
    }
}

}  // namespace

std::optional<Gap> way_out(const GeneralPair& pairing, const PlacedPair& pair, const Vec& x, double hair) noexcept {
    const double apart = 0x1p-8 * (pair.a.size() + pair.b.size());
    Starts starts;
    visit_usual_normals(pair, x, [&](const Vec& n) noexcept { starts.offer({n, -pair.gap_along(n, x)}, hair); });
    Start best;
    for (Start& start : starts.best) {
        if (start.depth == 1e300) continue;
        descend(pair, x, start);
        if (start.depth < best.depth - hair) best = start;
    }
    std::optional<Gap> shortest;
    for (int i = 0; i < most_tries; ++i) {
        // Back from where the plane has them well apart, to the touch.
        const double far = larger(best.depth, 0) + apart;
        const Advance back = advance(pairing, pair, x + best.normal * far, best.normal * -far, hair);
        if (back.outcome != Advance::Outcome::touches) break;
        const double exit = far * (1 - back.t);
        if (shortest && exit >= -shortest->least) break;
        shortest = Gap{.least = -exit, .most = -exit, .normal = best.normal};
        best = {back.gap.normal, -pair.gap_along(back.gap.normal, x)};
        if (best.depth >= exit - hair) break;
    }
    return shortest;
}

}  // namespace surefoot::internal
