// What is left of a mesh once the feet have judged it.
#pragma once

#include <surefoot/navigation_flood.hpp>

namespace surefoot::navigation {

/// The second half of `keep_reached`: what is not joined to the seed both ways is taken out, and `agreement` is kept up
/// to date. Enough after links or polygons went: where the feet get is known.
void keep_joined(NavigationMesh& mesh, const NavigationFlood& flood, const dvec3& seed, NavigationAgreement& agreement);

}  // namespace surefoot::navigation
