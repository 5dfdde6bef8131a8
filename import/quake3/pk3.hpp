/// A .pk3 is a zip file; the maps in it are at maps/*.bsp.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include <surefoot/error.hpp>

#include "level_builder.hpp"

namespace surefoot::internal::quake3 {

/// A map out of a .pk3.
struct PackedMap {
    std::string name;  ///< as in the zip: "maps/oa_dm1.bsp"
    std::string bytes;
};

/// The names of all maps, sorted. Takes no longer than the limits allow.
///
/// Fails with `unreadable` for what is no zip or whose list of files is damaged.
[[nodiscard]] Expected<std::vector<std::string>> maps_in_pk3(std::istream& file, const ReadLimits& limits);

/// The map that is wanted ("maps/oa_dm1.bsp", "oa_dm1.bsp" or "oa_dm1", in any case of letters), or the only one if
/// nothing is. Any bytes are fine: takes no more memory than the limits allow, and no longer.
///
/// Fails with `unreadable` for what is no zip or is damaged, `not_found` when there is no such map, or more than one
/// and none is wanted (the error lists them), `unsupported` when it is encrypted, `limit` when it is too large.
[[nodiscard]] Expected<PackedMap> read_pk3(std::istream& file, std::string_view wanted, const ReadLimits& limits);

}  // namespace surefoot::internal::quake3
