#include "playtest/bots/atlas.hpp"

#include <array>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>

#include <surefoot/cook.hpp>
#include <surefoot/navigation_links.hpp>

#include "game/hero.hpp"
#include "playtest/bots/passages.hpp"
#include "playtest/bots/rehearsal.hpp"

namespace surefoot::playtest {
namespace {

constexpr std::uint64_t atlas_version = 9;  // of what is kept, and of what it is made with
constexpr Section leaps_section{.owner = "playtest", .name = "leaps"};
constexpr std::size_t most_doors = 50;  // of the areas that a mesh can have
constexpr double beside_pad = 0.2;      // beyond its box nobody walks [m]
constexpr double around_door = 0.25;    // beyond its box the ground is barred, too [m]

}  // namespace

Atlas::Atlas(std::shared_ptr<const game::Level> level)
    : level_(std::move(level)), settings_(game::hero_settings(level_->rules)), door_areas_(level_->bodies.size(), 0) {}

Expected<std::shared_ptr<const Atlas>> Atlas::make(std::shared_ptr<const game::Level> level,
                                                   const AtlasOptions& options) {
    std::shared_ptr<Atlas> atlas(new Atlas(std::move(level)));
    if (auto built = atlas->build(options); !built) return tl::unexpected(built.error());
    return std::shared_ptr<const Atlas>(std::move(atlas));
}

Expected<void> Atlas::build(const AtlasOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    // The mesh goes through doors, and its areas say that they are shut; links and leaps do not.
    World open;
    if (const auto added = open.add(level_->ground); !added) return tl::unexpected(added.error());
    if (const auto added = ground_.add(level_->ground); !added) return tl::unexpected(added.error());

    std::vector<NavigationArea> areas{{.name = "ground"}};
    std::vector<NavigationRegion> regions = navigation_regions(level_->markers);
    for (std::size_t i = 0; i < level_->bodies.size() && areas.size() < most_doors; ++i) {
        const game::BodyPlan& body = level_->bodies[i];
        const Bounds around = body.mesh.bounds();
        // Nobody who walks steps on what throws.
        if (body.kind == game::BodyKind::bounce)
            regions.push_back({.name = body.name,
                               .pose = {body.origin + (around.min + around.max) * 0.5, {1, 0, 0, 0}},
                               .half_extents = (around.max - around.min) * 0.5 + dvec3{beside_pad, 1, beside_pad},
                               .kind = NavigationRegion::Kind::forbid});
        if (body.kind != game::BodyKind::door) continue;
        if (const auto added = ground_.add(body.mesh, {.pose = {body.origin, {1, 0, 0, 0}}}); !added)
            return tl::unexpected(added.error());
        door_areas_[i] = std::uint32_t(areas.size());
        regions.push_back(
            {.name = body.name,
             .pose = {body.origin + (around.min + around.max) * 0.5, {1, 0, 0, 0}},
             .half_extents = (around.max - around.min) * 0.5 + dvec3{around_door, around_door, around_door},
             .kind = NavigationRegion::Kind::area,
             .area = door_areas_[i]});
        areas.push_back({.name = body.name, .closed = true});
    }
    std::vector<std::uint32_t> surface_areas;
    for (const game::Material& material : level_->materials)
        surface_areas.push_back(material.deadly ? forbidden_area : 0);

    const std::uint64_t key = hash_bytes(std::as_bytes(std::span(&level_->hash, 1)), atlas_version);
    const std::string path = options.use_cache && level_->hash != 0 ? cache_path(key) : std::string{};
    if (!path.empty()) {
        const auto kept = Mesh::read(path, Check::everything);
        const auto section = kept ? kept->section("surefoot", navigation_section({}).name) : std::nullopt;
        if (section && section->made_from == key && NavigationMesh::read(section->bytes)) {
            const auto leaps = kept->section(leaps_section.owner, leaps_section.name);
            if (leaps && leaps->made_from == key && leaps->bytes.size() % sizeof(Leap) == 0) {
                bytes_.assign(section->bytes.begin(), section->bytes.end());
                leaps_.resize(leaps->bytes.size() / sizeof(Leap));
                if (!leaps_.empty()) std::memcpy(leaps_.data(), leaps->bytes.data(), leaps->bytes.size());
                from_cache_ = true;
            }
        }
    }
    if (!from_cache_) {
        auto mesh = NavigationMesh::build(
            open, settings_,
            {.areas = areas, .surface_areas = surface_areas, .regions = regions, .threads = options.threads});
        if (!mesh) return tl::unexpected(mesh.error());
        // One jump each: where it takes two, leaps do. Proving both as links would take minutes.
        CharacterSettings one_jump = settings_;
        one_jump.air_jumps = 0;
        const auto links =
            find_links(ground_, one_jump, *mesh,
                       {.run_speed = game::run_speed,
                        .spacing = 3.5,
                        .shortcut = 1e6,  // what is joined on foot needs no link: a bot does not mind the way round
                        .margins = {.aside = 0, .begin = 0},
                        .regions = regions,
                        .surface_areas = surface_areas,
                        .threads = options.threads,
                        .progress = options.progress});
        if (const auto set = mesh->set_links(links); !set) return tl::unexpected(set.error());
        bytes_ = mesh->to_bytes();
        if (auto found = find_leaps(); !found) return found;
        if (!path.empty()) {
            std::error_code error;
            std::filesystem::create_directories(std::filesystem::path(path).parent_path(), error);
            // A cache that cannot be written costs time the next time, and nothing else.
            Section leaps = leaps_section;
            leaps.made_from = key;
            leaps.bytes = std::as_bytes(std::span(leaps_));
            const std::array sections{navigation_section(bytes_, key), leaps};
            (void)level_->ground.write(path, sections);
        }
    }
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return {};
}

// Over the still ground alone: nothing that moves lends a hand, and nothing is in the way.
Expected<void> Atlas::find_leaps() {
    auto still = std::make_shared<game::Level>(*level_);
    std::erase_if(still->bodies, [](const game::BodyPlan& body) { return body.kind != game::BodyKind::door; });
    still->enemies.clear();
    auto foresight = Foresight::make(std::move(still));
    if (!foresight) return tl::unexpected(foresight.error());
    auto passages = Passages::make(*this);
    if (!passages) return tl::unexpected(passages.error());
    leaps_ = passages->find_leaps(**foresight);
    return {};
}

}  // namespace surefoot::playtest
