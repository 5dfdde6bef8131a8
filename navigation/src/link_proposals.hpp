// What might be a link: for each place on a border the ways that could lead on from there.
#pragma once

#include <vector>

#include <surefoot/navigation_links.hpp>
#include <surefoot/navigation_query.hpp>

#include "link_borders.hpp"
#include "spots.hpp"

namespace surefoot::navigation {

struct LinkProposal {
    NavigationLink link;
    std::uint32_t from_island = 0;
    std::uint32_t to_island = 0;
    double rank = 0;  ///< the lower the sooner it is tried
};

/// What is the same for all threads.
struct LinkGround {
    const World& world;
    const CharacterSettings& settings;
    const NavigationMesh& mesh;
    const NavigationLinkOptions& options;
    const Islands& islands;
    const std::vector<BorderPlace>& places;
    const Spots& spots;  ///< of the places, with `longest_jump` as their reach
};

/// How far a jump leads that ends so much higher, seen from above [m]; 0 if it does not rise so high.
[[nodiscard]] double jump_range(const CharacterSettings& settings, double speed, double rise, std::uint32_t air_jumps);

/// How high a jump leads, by hands too [m].
[[nodiscard]] double highest_jump(const CharacterSettings& settings, double radius, std::uint32_t air_jumps);

/// How many jumps in the air a link may have.
[[nodiscard]] std::uint32_t most_air_jumps(const CharacterSettings& settings);

/// No proposal goes farther than this [m].
[[nodiscard]] double longest_jump(const CharacterSettings& settings, const NavigationLinkOptions& options);

class LinkProposer {
public:
    explicit LinkProposer(const LinkGround& ground);

    /// All ways on from a place of the border, those first that are likely and short.
    [[nodiscard]] std::vector<LinkProposal> from(const BorderPlace& place);

    /// Would anybody want it, who has these others from the same place already? It joins what walking does not, or is
    /// much shorter than the walk.
    [[nodiscard]] bool is_useful(const LinkProposal& proposal, std::span<const LinkProposal> others);

private:
    void add_drops(const BorderPlace& place);
    void add_crossings(const BorderPlace& place);
    void add_crossing(const BorderPlace& place, const BorderPlace& goal);
    void add_jumps(const BorderPlace& place, const BorderPlace& goal, const dvec3& to, double rank);
    /// Is the walk so long that the link is wanted?
    [[nodiscard]] bool is_far(const dvec3& from, const dvec3& to, const NavigationLink& link);
    void add(NavigationLinkKind kind, const BorderPlace& place, const dvec3& to, std::uint32_t to_island, double behind,
             double rank, std::uint32_t air_jumps = 0);
    /// Is there a wall between them that reaches up farther than a jump leads, or for those who walk at all?
    [[nodiscard]] bool is_walled(const dvec3& from, const dvec3& to, bool jumps) const;
    /// Along the ground, as far as it goes and `most` at most.
    [[nodiscard]] dvec3 along_ground(const dvec3& place, const dvec3& way, double most);
    [[nodiscard]] double above(const dvec3& from, const dvec3& to) const;
    [[nodiscard]] dvec3 level(const dvec3& v) const;

    const LinkGround& ground_;
    NavigationAgent agent_;
    dvec3 up_;
    NavigationQuery query_;
    std::vector<LinkProposal> found_;
};

}  // namespace surefoot::navigation
