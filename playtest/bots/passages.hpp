/// Above the navigation mesh: on to what moves and off it again, and the manoeuvres that a level names. A passage leads
/// from a place or a body to a place or a body; walking and links join the places.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <surefoot/navigation_query.hpp>

#include "playtest/bots/atlas.hpp"
#include "playtest/bots/stand.hpp"

namespace surefoot::playtest {

class Foresight;

struct Passage {
    enum class How : std::uint8_t { board, transfer, alight, fly, leap, way } how = How::board;
    Stand from;
    Stand to;
    game::Manoeuvre manoeuvre = game::Manoeuvre::ride;  ///< of a way
    double gap = 0;                                     ///< at its narrowest, seen from above [m]
    double rise = 0;                                    ///< there [m]
    double seconds = 1;                                 ///< about what it takes
};

/// To take something that hangs in the air: from here out to it, and down again at one of these, the likeliest first.
struct Catch {
    Stand from;
    std::vector<Stand> ends;
    double effort = 0;
};

/// So high above feet is the middle of who takes something.
inline constexpr double catch_height = 0.8;

/// A plan: over these passages, by number, and then on foot.
struct Itinerary {
    std::vector<std::uint32_t> passages;
    double seconds = 0;
};

/// The graph of a level for one bot: doors open in it.
class Passages {
public:
    [[nodiscard]] static Expected<Passages> make(const Atlas& atlas);

    [[nodiscard]] std::span<const Passage> all() const { return all_; }
    [[nodiscard]] const NavigationQuery& query() const { return *query_; }

    void open_door(std::uint32_t area);

    /// From island to island by two jumps, where no link leads: each was rehearsed. For the atlas, which keeps them.
    [[nodiscard]] std::vector<Leap> find_leaps(Foresight& foresight) const;

    /// From where something that hangs in the air might be taken, the easiest first; nothing of it is rehearsed.
    [[nodiscard]] std::vector<Catch> catches(const dvec3& place) const;

    /// A place as the graph knows it; nothing if there is no ground near.
    [[nodiscard]] std::optional<Stand> stand_at(const dvec3& feet, double aside = 1.2, double vertical = 1.5) const;

    /// The quickest way by what it about takes; nothing if there is none. Over none of `without`.
    [[nodiscard]] std::optional<Itinerary> route(const Stand& from, const Stand& to,
                                                 std::span<const std::uint32_t> without = {}) const;

    /// Who swims stands on nothing; each water of the level has a number behind those of the bodies.
    [[nodiscard]] std::uint32_t water_number(std::size_t water) const;
    [[nodiscard]] std::optional<Stand> water_at(const dvec3& middle) const;

    /// Places of a body's mesh where feet can stand, relative to its origin.
    [[nodiscard]] std::span<const dvec3> spots(std::size_t body) const { return spots_[body]; }

private:
    struct Border {
        dvec3 place{0, 0, 0};
        std::uint32_t island = 0;
    };
    struct LinkEnds {
        dvec3 from{0, 0, 0};
        dvec3 to{0, 0, 0};
        std::uint32_t from_island = 0;
        std::uint32_t to_island = 0;
        double seconds = 1;
    };

    Passages(const Atlas& atlas, NavigationMesh mesh);
    void find_islands();
    void find_spots();
    void find_rides();
    void find_rides_of(std::size_t body);
    void find_transfers();
    void find_ways();
    void find_banks();
    void add_leaps();
    [[nodiscard]] std::vector<Border> beside_body(const std::vector<dvec3>& rims, const dvec3& middle) const;
    [[nodiscard]] bool is_one_way(std::uint32_t surface) const;
    [[nodiscard]] bool is_walled(const dvec3& from, const dvec3& to) const;
    [[nodiscard]] std::uint32_t island_of(NavigationPolygon polygon) const;

    const Atlas* atlas_;
    std::unique_ptr<NavigationMesh> mesh_;
    std::unique_ptr<NavigationQuery> query_;
    std::vector<NavigationOutline> outlines_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> island_by_polygon_;  ///< sorted by polygon
    std::vector<Border> borders_;
    std::vector<LinkEnds> links_;
    std::vector<std::vector<dvec3>> spots_;
    std::vector<std::vector<dvec3>> rims_;  ///< of the spots, those at the edge
    std::vector<Passage> all_;
    std::uint32_t islands_ = 0;
};

/// Can a hero get over, by two jumps and its hands?
[[nodiscard]] bool is_in_reach(double gap, double rise);

}  // namespace surefoot::playtest
