#include "cook/findings.hpp"

namespace surefoot::internal {

void find_faults(const Soup& soup, const EdgeMatches& matches, std::size_t most_places, CookReport& report) {
    for (std::uint32_t id = 0; id < soup.triangle_count(); ++id) {
        const Vec& a = soup.corner(3 * id);
        const Vec area = cross(soup.corner(3 * id + 1) - a, soup.corner(3 * id + 2) - a);
        if (area == Vec{}) add_place(report.degenerate, id, a, most_places);
        for (std::uint32_t side = 3 * id; side < 3 * id + 3; ++side) {
            const std::uint32_t partner = matches.partner[side];
            if (partner == EdgeMatches::gone) break;
            const Vec middle = (soup.corner(side) + soup.corner(next_side(side))) * 0.5;
            if (partner == EdgeMatches::none) {
                add_place(report.open_edges, id, middle, most_places);
            } else if (partner == EdgeMatches::many) {
                add_place(report.non_manifold_edges, id, middle, most_places);
            } else if (partner > side && soup.indices[partner] == soup.indices[side]) {
                add_place(report.flipped_edges, id, middle, most_places);
            }
        }
    }
}

}  // namespace surefoot::internal
