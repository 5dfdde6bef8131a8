/// One run of a level as it is shown: the game, what is drawn of it from tick to tick, the recording that is made of
/// it, and perhaps a ghost beside it.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/game.hpp"
#include "game/recording.hpp"
#include "platformer/camera/game_camera.hpp"
#include "platformer/hero/pose.hpp"
#include "platformer/play/actors.hpp"
#include "platformer/play/level_look.hpp"
#include "platformer/screens/controls.hpp"

namespace surefoot::platformer {

/// Who plays instead of the player.
struct Pilot {
    std::function<void(const game::Game&)> study{};              ///< once a game, before its first tick; on any thread
    std::function<game::HeroInput(const game::Game&)> decide{};  ///< the input of each tick

    [[nodiscard]] explicit operator bool() const { return decide != nullptr; }
};

class Run {
public:
    struct Plan {
        std::shared_ptr<const game::Level> level;
        std::string player = "player";
        std::optional<game::Recording> ghost{};            ///< runs beside it
        std::shared_ptr<const game::Recording> watched{};  ///< plays instead of the player
        double watched_from = 0;                           ///< into the recording: what was before is not shown [s]
        Pilot pilot{};                                     ///< plays instead of the player, too
    };

    /// A run but for what is drawn of it.
    struct Prepared {
        Plan plan;
        std::unique_ptr<game::Game> game;
        std::unique_ptr<game::Game> ghost{};
        std::optional<game::Player> player{};  ///< of what is watched
        double section_began = 0;              ///< of the section in which that begins [s]
        World decor{};
    };

    /// What takes long, on any thread. Fails as `Game::start` does.
    [[nodiscard]] static Expected<Prepared> prepare(Plan plan, const std::atomic<bool>* stop = nullptr);

    /// Makes what is drawn: on the thread of the picture.
    [[nodiscard]] static std::unique_ptr<Run> start(Prepared prepared);

    /// One tick. What happened in it is `game().events()`.
    void tick(const Asked& asked, const CameraSettings& camera);

    /// For eyes of this kind.
    void set_colours(ColourVision colours) { actors_->set_colours(colours); }

    /// From the checkpoint.
    void retry();
    void give_up();

    /// Is a watched recording, or its game, at its end?
    [[nodiscard]] bool is_at_end() const;

    [[nodiscard]] const game::Game& game() const { return *game_; }
    [[nodiscard]] const game::Recording& recording() const { return recorder_.recording(); }
    [[nodiscard]] bool is_watched() const { return plan_.watched != nullptr; }
    [[nodiscard]] bool is_piloted() const { return bool(plan_.pilot); }

    /// Everything in the world, `blend` of the way between the last two ticks.
    void draw(view::Renderer& renderer, double blend, bool shows_volume) const;

    [[nodiscard]] const HeroPose& pose() const { return pose_; }
    [[nodiscard]] const HeroPose& pose_before() const { return pose_before_; }
    [[nodiscard]] const CameraState& camera() const { return camera_; }
    [[nodiscard]] view::Camera camera_at(double blend) const { return camera_between(camera_before_, camera_, blend); }

    struct Ghost {
        std::unique_ptr<game::Game> game;
        std::unique_ptr<game::Player> player;
        HeroPose before{};
        HeroPose pose{};
    };
    [[nodiscard]] const std::optional<Ghost>& ghost() const { return ghost_; }

    /// From where the last blow came, and how long ago [s].
    [[nodiscard]] const dvec3& hurt_from() const { return hurt_from_; }
    [[nodiscard]] double since_hurt() const { return since_hurt_; }
    [[nodiscard]] double since_coin() const { return since_coin_; }

    /// The time at which the section that the hero is in began [s].
    [[nodiscard]] double section_began() const { return section_began_; }

private:
    explicit Run(Plan plan);
    [[nodiscard]] game::HeroInput input_of(const Asked& asked) const;
    [[nodiscard]] CameraScene scene() const { return {game_->world(), &decor_, game_->settings().surfaces}; }
    [[nodiscard]] view::ScreenDoor door(double blend) const;
    void stand();

    Plan plan_;
    std::unique_ptr<game::Game> game_;
    LevelLook look_;
    World decor_;  // of what is drawn and not solid, for the camera
    std::optional<Actors> actors_;
    game::Recorder recorder_;
    std::optional<game::Player> player_;
    std::optional<Ghost> ghost_;
    HeroPose pose_{};
    HeroPose pose_before_{};
    CameraState camera_{};
    CameraState camera_before_{};
    dvec3 hurt_from_{0, 0, 0};
    double since_hurt_ = 1e9;
    double since_coin_ = 1e9;
    double section_began_ = 0;
    bool is_over_ = false;
};

/// The angle about up of a level direction: 0 along Z, a quarter turn along X [rad].
[[nodiscard]] double facing_of(const dvec3& direction);

}  // namespace surefoot::platformer
