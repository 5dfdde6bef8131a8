// Ladders as links: from the ground before a surface that is climbed to the ground behind its upper end.
#pragma once

#include "link_proposals.hpp"

namespace surefoot::navigation {

/// For each ladder, and each stretch of `spacing` of a wide one, the ways up on either side.
[[nodiscard]] std::vector<LinkProposal> ladder_proposals(const LinkGround& ground);

}  // namespace surefoot::navigation
