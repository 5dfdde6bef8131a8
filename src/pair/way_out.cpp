#include "pair/way_out.hpp"

#include <utility>

namespace surefoot::internal {

namespace {

constexpr int most_tries = 8;
constexpr int start_count = 4;

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

}  // namespace

std::optional<Gap> way_out(const GeneralPair& pairing, const PlacedPair& pair, const Vec& x, double hair) noexcept {
    const double apart = 0x1p-8 * (pair.a.size() + pair.b.size());
    Starts starts;
    visit_usual_normals(pair, x, [&](const Vec& n) noexcept { starts.offer({n, -pair.gap_along(n, x)}, hair); });
    std::optional<Gap> best;
    for (const Start& start : starts.best) {
        Vec n = start.normal;
        double depth = start.depth;
        double shortest = 1e300;
        for (int i = 0; i < most_tries && depth < 1e300; ++i) {
            // Back from where the plane of n has them well apart, to the touch.
            const double far = larger(depth, 0) + apart;
            const Advance back = advance(pairing, pair, x + n * far, n * -far, hair);
            if (back.outcome != Advance::Outcome::touches) break;
            const double exit = far * (1 - back.t);
            if (exit >= shortest) break;
            shortest = exit;
            if (!best || exit < -best->least - hair) best = Gap{.least = -exit, .most = -exit, .normal = n};
            n = back.gap.normal;
            depth = -pair.gap_along(n, x);
            if (depth >= exit - hair) break;
        }
    }
    return best;
}

}  // namespace surefoot::internal
