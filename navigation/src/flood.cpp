#include <algorithm>
#include <atomic>
#include <cmath>
#include <unordered_map>

#include <surefoot/character.hpp>
#include <surefoot/navigation_flood.hpp>

#include "forbidden.hpp"
#include "mesh_state.hpp"
#include "threads.hpp"

namespace surefoot {
inline namespace v0 {
namespace {

using navigation::Forbidden;
using navigation::Frame;

constexpr double tick = 1.0 / 60;
// A move has arrived when it is so near to the middle of a cell, as a share of the cell.
constexpr double arrived = 0.1;

struct Column {
    std::int32_t x = 0;
    std::int32_t z = 0;
    friend bool operator==(const Column&, const Column&) = default;
};

struct ColumnHash {
    std::size_t operator()(const Column& column) const {
        const std::uint64_t both = static_cast<std::uint64_t>(static_cast<std::uint32_t>(column.x)) << 32 |
                                   static_cast<std::uint32_t>(column.z);
        return static_cast<std::size_t>(both * 0x9e3779b97f4a7c15U >> 7);
    }
};

struct Cell {
    CharacterState state;
    dvec3 feet{0, 0, 0};  ///< in the frame
};

/// Where a move from a cell ended, if it did in the middle of one.
struct Landing {
    std::uint32_t from = 0;
    bool arrived = false;
    Cell cell;
};

/// A link that was followed from a cell to a cell.
struct LinkWay {
    std::size_t link = 0;
    std::uint32_t from = 0;
    std::uint32_t to = 0;
};

class Flooder {
public:
    Flooder(const World& world, const CharacterSettings& settings, const NavigationMesh& mesh,
            const NavigationFloodOptions& options)
        : world_(world),
          settings_(settings),
          mesh_(mesh),
          agent_(navigation_agent(settings)),
          frame_(mesh.state().plan.frame),
          options_(options),
          side_(options.cell > 0 ? options.cell : agent_.radius) {
        settings_.jump_height = 0;
    }

    NavigationFlood run(std::span<const dvec3> seeds) {
        for (const dvec3& seed : seeds) stand(seed);
        std::size_t done = 0;
        while (done < cells_.size()) {
            const std::size_t end = cells_.size();
            std::vector<Landing> landings = moves_of(done, end);
            for (const Landing& landing : landings)
                if (landing.arrived) arrive(landing);
            follow_links(done, end);
            done = end;
            options_.progress(done, cells_.size());
            if (cells_.size() > options_.most_cells) {
                flood_.whole = false;
                break;
            }
        }
        mark_returns();
        flood_.links_used.resize(mesh_.links().size(), false);
        for (const LinkWay& way : link_ways_)
            if (flood_.cells[way.from].returns && flood_.cells[way.to].returns) flood_.links_used[way.link] = true;
        flood_.cell = side_;
        flood_.radius = agent_.radius;
        return std::move(flood_);
    }

private:
    [[nodiscard]] Column column_of(const dvec3& feet) const {
        return {static_cast<std::int32_t>(std::floor(feet.x / side_)),
                static_cast<std::int32_t>(std::floor(feet.z / side_))};
    }
    [[nodiscard]] dvec3 middle_of(const Column& column) const {
        return {(column.x + 0.5) * side_, 0, (column.z + 0.5) * side_};
    }
    [[nodiscard]] dvec3 feet_of(const CharacterState& state) const {
        dvec3 feet = frame_.turned_in(state.position - frame_.origin);
        feet.y -= agent_.feet;
        return feet;
    }

    /// Puts a character on the ground at a place and walks it to the middle of its cell.
    void stand(const dvec3& seed) {
        CharacterState state{.position = seed + frame_.y * (agent_.feet + agent_.climb / 2)};
        const Landing landing = walk(state, column_of(frame_.turned_in(seed - frame_.origin)), 0);
        if (landing.arrived) find_or_add(landing.cell);
    }

    /// Walks to the middle of a column; where it falls on the way, to the middle of that in which it lands.
    [[nodiscard]] Landing walk(CharacterState state, Column goal, std::uint32_t from) const {
        const double longest = side_ / options_.speed * 2 + 0.2;
        double in_air = 0;
        double walked = 0;
        CharacterInput input{.up = frame_.y};
        const Forbidden forbidden{options_.regions, options_.surface_areas};
        // It may fall off the cell in which it landed, again and again.
        const double longest_in_all = 3 * (longest + options_.longest_fall);
        for (double time = 0; walked < longest && time < longest_in_all; time += tick) {
            const dvec3 feet = feet_of(state);
            const dvec3 middle = middle_of(goal);
            const dvec3 way{middle.x - feet.x, 0, middle.z - feet.z};
            const double distance = navigation::length(way);
            const bool grounded = state.footing == Footing::ground;
            if (grounded && distance <= arrived * side_) return {from, true, {state, feet}};
            const double speed = std::min(options_.speed, distance / tick);
            input.wish = distance > 0 ? frame_.turned_out(way * (speed / distance)) : dvec3{0, 0, 0};
            const StepResult result = step(world_, settings_, input, tick, state);
            state = result.state;
            if (forbidden.any() && forbidden.holds(state, state.position - frame_.y * agent_.feet)) break;
            if (state.footing == Footing::ground) {
                if (in_air > 0.1) {
                    goal = column_of(feet_of(state));
                    walked = 0;
                }
                in_air = 0;
                // On ice feet get their speed late; a way from rest takes as the root of the grip.
                walked += tick * std::sqrt(std::clamp(settings_.surfaces[state.ground_surface].grip, 1e-3, 1.0));
            } else {
                in_air += tick;
                if (in_air > options_.longest_fall) break;
                walked += state.footing == Footing::steep ? tick : 0;
            }
        }
        return {from, false, {}};
    }

    std::vector<Landing> moves_of(std::size_t begin, std::size_t end) {
        constexpr int directions = 8;
        std::vector<Landing> landings((end - begin) * directions);
        std::atomic<std::size_t> next = begin;
        const auto work = [&] {
            for (std::size_t i = next++; i < end; i = next++) {
                const Column here = column_of(cells_[i].feet);
                for (int direction = 0; direction < directions; ++direction) {
                    constexpr int aside[directions] = {1, 1, 0, -1, -1, -1, 0, 1};
                    constexpr int ahead[directions] = {0, 1, 1, 1, 0, -1, -1, -1};
                    landings[(i - begin) * directions + static_cast<std::size_t>(direction)] =
                        walk(cells_[i].state, {here.x + aside[direction], here.z + ahead[direction]},
                             static_cast<std::uint32_t>(i));
                }
            }
        };
        navigation::on_threads(options_.threads, end - begin, work);
        flood_.moves += landings.size();
        return landings;
    }

    /// A link that begins in one of these cells leads on.
    void follow_links(std::size_t begin, std::size_t end) {
        if (begin == 0) {
            for (std::size_t i = 0; i < mesh_.links().size(); ++i)
                links_.emplace(column_of(frame_.turned_in(mesh_.links()[i].from - frame_.origin)), i);
        }
        for (std::size_t cell = begin; cell < end; ++cell) {
            const auto [first, last] = links_.equal_range(column_of(cells_[cell].feet));
            for (auto found = first; found != last; ++found) {
                const NavigationLink& link = mesh_.links()[found->second];
                const dvec3 from = frame_.turned_in(link.from - frame_.origin);
                if (std::abs(from.y - cells_[cell].feet.y) > agent_.height / 2) continue;
                CharacterState state{.position = link.to + frame_.y * (agent_.feet + agent_.climb / 2)};
                const Landing landing =
                    walk(state, column_of(frame_.turned_in(link.to - frame_.origin)), static_cast<std::uint32_t>(cell));
                if (!landing.arrived) continue;
                arrive(landing);
                link_ways_.push_back({found->second, landing.from, ways_.back().second});
            }
        }
    }

    void arrive(const Landing& landing) {
        const std::size_t at = find_or_add(landing.cell).first;
        ways_.emplace_back(landing.from, static_cast<std::uint32_t>(at));
    }

    std::pair<std::size_t, bool> find_or_add(const Cell& cell) {
        std::vector<std::uint32_t>& storeys = columns_[column_of(cell.feet)];
        for (const std::uint32_t known : storeys)
            if (std::abs(cells_[known].feet.y - cell.feet.y) < agent_.height / 2) return {known, false};
        storeys.push_back(static_cast<std::uint32_t>(cells_.size()));
        cells_.push_back(cell);
        return {cells_.size() - 1, true};
    }

    /// Follows the ways backwards from the first seed.
    void mark_returns() {
        std::sort(ways_.begin(), ways_.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
        flood_.cells.resize(cells_.size());
        for (std::size_t i = 0; i < cells_.size(); ++i) flood_.cells[i].feet = frame_.out(cells_[i].feet);
        if (cells_.empty()) return;
        std::vector<std::uint32_t> waiting{0};
        flood_.cells[0].returns = true;
        while (!waiting.empty()) {
            const std::uint32_t to = waiting.back();
            waiting.pop_back();
            const auto first = std::lower_bound(ways_.begin(), ways_.end(), to,
                                                [](const auto& way, std::uint32_t cell) { return way.second < cell; });
            for (auto way = first; way != ways_.end() && way->second == to; ++way) {
                if (flood_.cells[way->first].returns) continue;
                flood_.cells[way->first].returns = true;
                waiting.push_back(way->first);
            }
        }
    }

    const World& world_;
    CharacterSettings settings_;
    const NavigationMesh& mesh_;
    NavigationAgent agent_;  // of the feet, which the mesh's may not be
    const Frame& frame_;
    NavigationFloodOptions options_;
    double side_;
    std::vector<Cell> cells_;
    std::unordered_map<Column, std::vector<std::uint32_t>, ColumnHash> columns_;
    std::unordered_multimap<Column, std::size_t, ColumnHash> links_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ways_;  // from a cell to a cell
    std::vector<LinkWay> link_ways_;
    NavigationFlood flood_;
};

}  // namespace

double NavigationFlood::area() const noexcept {
    const auto count =
        std::count_if(cells.begin(), cells.end(), [](const NavigationFloodCell& found) { return found.returns; });
    return static_cast<double>(count) * cell * cell;
}

NavigationFlood flood_by_feet(const World& world, const CharacterSettings& settings, const NavigationMesh& mesh,
                              std::span<const dvec3> seeds, const NavigationFloodOptions& options) {
    return Flooder(world, settings, mesh, options).run(seeds);
}

}  // namespace v0
}  // namespace surefoot
