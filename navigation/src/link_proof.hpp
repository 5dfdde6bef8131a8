// Is a link one? A character is simulated over it, again and again, each time a little off.
#pragma once

#include <surefoot/navigation_links.hpp>
#include <surefoot/navigation_query.hpp>

#include "link_borders.hpp"

namespace surefoot::navigation {

class LinkProof {
public:
    LinkProof(const World& world, const CharacterSettings& settings, const NavigationMesh& mesh, const Islands& islands,
              const NavigationLinkOptions& options);

    /// Does the character get from `from` to `to` and stand there, also within the margins? Then the link has its
    /// inputs, its time and its end.
    [[nodiscard]] bool holds(NavigationLink& link, std::uint32_t island);

    [[nodiscard]] std::uint64_t ticks() const { return ticks_; }

private:
    [[nodiscard]] bool gets_over(const NavigationLink& link, std::uint32_t island, NavigationLink* record);
    [[nodiscard]] bool gets_over(const NavigationLink& link, CharacterState state, std::uint32_t island,
                                 NavigationLink* record);
    [[nodiscard]] bool begins_beside(const NavigationLink& link, const dvec3& forward, std::uint32_t island);
    [[nodiscard]] bool is_forbidden(const CharacterState& state) const;
    [[nodiscard]] bool stands(CharacterState state, const dvec3& to, std::uint32_t island);

    const World& world_;
    const CharacterSettings& settings_;
    const Islands& islands_;
    const NavigationLinkOptions& options_;
    NavigationAgent agent_;
    dvec3 up_;
    NavigationQuery query_;
    std::uint64_t ticks_ = 0;
};

}  // namespace surefoot::navigation
