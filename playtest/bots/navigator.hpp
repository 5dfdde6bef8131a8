/// The bot that knows its way: over the navigation mesh and its links, on to what moves and off it again, with keys
/// first where doors bar the way, to the goal.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include <surefoot/navigation_follow.hpp>

#include "playtest/bots/bot.hpp"
#include "playtest/bots/caution.hpp"
#include "playtest/bots/foresight.hpp"
#include "playtest/bots/hop.hpp"
#include "playtest/bots/manoeuvre.hpp"
#include "playtest/bots/passages.hpp"
#include "playtest/bots/rehearsal.hpp"

namespace surefoot::playtest {

struct NavigatorOptions {
    std::uint64_t seed = 1;
    bool collects = false;  ///< goes for coins and stars first, as far as it gets there
    double patience = 150;  ///< so long without getting anywhere new, and it gives up [s]
};

class Navigator final : public Bot {
public:
    /// Fails as building a world does. Requires: the atlas outlives it.
    [[nodiscard]] static Expected<std::unique_ptr<Navigator>> make(std::shared_ptr<const Atlas> atlas,
                                                                   const NavigatorOptions& options = {});

    [[nodiscard]] game::HeroInput decide(const game::Game& game) override;
    [[nodiscard]] const std::string& gave_up() const override { return gave_up_; }
    [[nodiscard]] std::string name() const override { return options_.collects ? "collector" : "navigator"; }

    /// What it does now, for whoever watches: "waits for the lift".
    [[nodiscard]] const std::string& doing() const { return doing_; }
    [[nodiscard]] std::uint64_t presses() const { return hands_.presses(); }

private:
    enum class Phase : std::uint8_t { thinks, walks, waits, hops, manoeuvres, catches };

    Navigator(std::shared_ptr<const Atlas> atlas, const NavigatorOptions& options, Passages passages,
              std::unique_ptr<Foresight> foresight);

    [[nodiscard]] std::string why_unreachable(Passages& passages) const;
    void notice(const game::Game& game);
    [[nodiscard]] std::optional<Stand> here(const game::Game& game) const;
    void think(const game::Game& game);
    [[nodiscard]] bool choose_target(const game::Game& game, const Stand& from);
    [[nodiscard]] bool plan_to(const Stand& from, const Stand& to);
    void next_step(const game::Game& game);
    [[nodiscard]] Intent walk(const game::Game& game);
    [[nodiscard]] Intent wait(const game::Game& game);
    [[nodiscard]] Intent stay_on_body(const game::Game& game) const;
    [[nodiscard]] Intent hop(const game::Game& game);
    [[nodiscard]] Intent manoeuvre(const game::Game& game);
    [[nodiscard]] Intent catch_it(const game::Game& game);
    [[nodiscard]] Intent fly_to_catch(const game::Game& game, const dvec3& place);
    [[nodiscard]] bool catch_goes_well(const game::Game& game, const HopStyle& style, const dvec3& place,
                                       const Stand& end);
    [[nodiscard]] const Catch* next_catch(std::uint32_t pickup);
    [[nodiscard]] std::optional<Stand> stand_for(std::uint32_t pickup);
    void begin_catch();
    [[nodiscard]] bool leads_on(const Stand& from) const;
    [[nodiscard]] Intent find_back(const game::Game& game);
    [[nodiscard]] Intent save_oneself(const game::Game& game);
    [[nodiscard]] Intent shake_loose(const game::Game& game, const Intent& intent);
    [[nodiscard]] Intent let_go(const game::Game& game, const Intent& intent);
    [[nodiscard]] Intent mind(const game::Game& game, const Intent& intent);
    void fail(const game::Game& game);
    void try_to_hop(const game::Game& game);
    void avoid_what_comes(const game::Game& game, std::uint32_t body);
    [[nodiscard]] bool goes_well(const game::Game& game, const HopStyle& style, const Stand& to);
    [[nodiscard]] bool is_on(const game::Hero& hero, const dvec3& feet, const Stand& to) const;
    [[nodiscard]] std::span<const dvec3> spots_of(const Stand& stand) const;
    [[nodiscard]] HopAim aim_of(const Stand& to, const dvec3& feet) const;

    std::shared_ptr<const Atlas> atlas_;
    NavigatorOptions options_;
    Passages passages_;
    std::unique_ptr<Foresight> foresight_;
    Hands hands_;
    Dice dice_;
    NavigationFollower follower_;
    std::string gave_up_;
    std::string doing_ = "looks around";

    Phase phase_ = Phase::thinks;
    std::optional<Stand> target_;
    std::optional<std::uint32_t> target_pickup_;           ///< of `Level::pickups`
    const Catch* target_catch_ = nullptr;                  ///< how it is taken, if it is not walked to
    std::optional<Stand> catch_end_;                       ///< where it comes down, once it has jumped
    std::map<std::uint32_t, std::vector<Catch>> catches_;  ///< of pickups, as far as they were asked for
    std::vector<std::uint32_t> plan_;                      ///< passages
    std::size_t step_ = 0;
    Hop hop_;
    Stand hop_to_;
    Manoeuvring manoeuvring_;
    Caution caution_;
    std::map<std::uint32_t, int> failures_;         ///< of passages
    std::map<std::uint32_t, int> pickup_failures_;  ///< of pickups that it went for
    std::map<std::uint32_t, int> checkpoint_tries_;
    std::vector<std::uint32_t> banned_;
    int pause_ = 0;   ///< ticks until it reacts
    int waited_ = 0;  ///< ticks
    int phase_ticks_ = 0;
    int stands_for_ = 0;  ///< ticks on what it hopped to
    int style_turn_ = 0;
    int save_for_ = 0;  ///< a jump in the air [ticks]
    int wet_for_ = 0;   ///< ticks under water on what was to be a walk
    int think_in_ = 0;  ///< ticks until it plans again
    int thoughts_ = 0;  ///< of going for the same pickup, one after the other
    int held_for_ = 0;  ///< by something, on foot [ticks]
    dvec3 held_at_{0, 0, 0};
    int shakes_for_ = 0;  ///< ticks
    dvec3 shakes_to_{0, 0, 0};
    int hangs_for_ = 0;   ///< ticks
    double hung_at_ = 0;  ///< height of the feet in the last tick [m]
    int lost_for_ = 0;    ///< ticks without ground of the mesh
    double best_left_ = 1e300;
    double since_better_ = 0;
};

}  // namespace surefoot::playtest
