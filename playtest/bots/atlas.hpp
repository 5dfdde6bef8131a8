/// What the still ground of a level offers to the hero: a navigation mesh with its links, looked for once and kept in
/// the user's cache.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <surefoot/navigation_mesh.hpp>
#include <surefoot/world.hpp>

#include "game/level.hpp"

namespace surefoot::playtest {

/// From one place to another by two jumps.
struct Leap {
    dvec3 from{0, 0, 0};
    dvec3 to{0, 0, 0};
};

struct AtlasOptions {
    bool use_cache = true;
    int threads = 2;
    NavigationProgress progress{};  ///< of looking for links, which takes the longest
};

/// Read only once it is made: any number of bots share it.
class Atlas {
public:
    /// Fails as building a navigation mesh does.
    [[nodiscard]] static Expected<std::shared_ptr<const Atlas>> make(std::shared_ptr<const game::Level> level,
                                                                     const AtlasOptions& options = {});

    [[nodiscard]] const game::Level& level() const { return *level_; }
    /// The still ground, with all doors shut.
    [[nodiscard]] const World& ground() const { return ground_; }
    [[nodiscard]] const CharacterSettings& settings() const { return settings_; }

    /// A mesh of one's own, in which doors are opened and shut. All doors are shut in it.
    [[nodiscard]] Expected<NavigationMesh> mesh() const { return NavigationMesh::read(bytes_); }

    /// The area of the ground that a door bars, by the number of its body; 0 for what is no door.
    [[nodiscard]] std::uint32_t door_area(std::size_t body) const { return door_areas_[body]; }

    [[nodiscard]] std::span<const Leap> leaps() const { return leaps_; }

    [[nodiscard]] bool came_from_cache() const { return from_cache_; }
    [[nodiscard]] double seconds() const { return seconds_; }  ///< that making it took

private:
    explicit Atlas(std::shared_ptr<const game::Level> level);
    [[nodiscard]] Expected<void> build(const AtlasOptions& options);
    [[nodiscard]] Expected<void> find_leaps();

    std::shared_ptr<const game::Level> level_;
    World ground_;
    CharacterSettings settings_;
    std::vector<std::byte> bytes_;
    std::vector<Leap> leaps_;
    std::vector<std::uint32_t> door_areas_;
    bool from_cache_ = false;
    double seconds_ = 0;
};

}  // namespace surefoot::playtest
