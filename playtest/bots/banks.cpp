// In and out of the water: each water is joined with the islands on its banks.
#include <algorithm>
#include <map>

#include "playtest/bots/passages.hpp"
#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr double beside = 1.6;     // the water, aside [m]
constexpr double leaps_out = 1.1;  // so high above its surface [m]
constexpr double deepest = 1.2;    // a bank lies so far below it at most, where one wades [m]
constexpr double jumps_in = 6;     // from so high above it [m]
constexpr double swims = 1.5;      // m/s, with all its turns; what a level names is the better way

}  // namespace

std::uint32_t Passages::water_number(std::size_t water) const {
    return std::uint32_t(atlas_->level().bodies.size() + water);
}

std::optional<Stand> Passages::water_at(const dvec3& middle) const {
    const std::vector<game::Zone>& waters = atlas_->level().waters;
    for (std::size_t i = 0; i < waters.size(); ++i)
        if (waters[i].holds(middle)) return Stand{.body = water_number(i), .place = middle};
    return std::nullopt;
}

void Passages::find_banks() {
    const std::vector<game::Zone>& waters = atlas_->level().waters;
    for (std::size_t i = 0; i < waters.size(); ++i) {
        const game::Zone& water = waters[i];
        const double surface = water.middle.y + water.half.y;
        const Stand in{.body = water_number(i), .place = water.middle};
        struct Bank {
            Stand stand;
            double score = 1e300;
        };
        std::map<std::uint32_t, Bank> out;
        std::map<std::uint32_t, Bank> into;
        for (const Border& border : borders_) {
            const dvec3 inside = to_body({water.middle, water.orientation}, border.place);
            const double aside = std::max({std::abs(inside.x) - water.half.x, std::abs(inside.z) - water.half.z, 0.0});
            const double above = border.place.y - surface;
            if (aside > beside || above < -deepest || above > jumps_in) continue;
            const Bank bank{{.place = border.place, .island = border.island}, aside + 2 * std::abs(above)};
            if (above <= leaps_out && bank.score < out[border.island].score) out[border.island] = bank;
            if (bank.score < into[border.island].score) into[border.island] = bank;
        }
        const auto seconds = [&](const Stand& stand) { return 1.5 + length(stand.place - water.middle) / swims; };
        for (const auto& [island, bank] : out)
            all_.push_back({Passage::How::way, in, bank.stand, game::Manoeuvre::swim, 0, 0, seconds(bank.stand)});
        for (const auto& [island, bank] : into)
            all_.push_back({Passage::How::way, bank.stand, in, game::Manoeuvre::swim, 0, 0, seconds(bank.stand)});
    }
}

}  // namespace surefoot::playtest
