/// Play it again: all that one character was asked, tick by tick, with a hash of what came out. On the same level any
/// build makes the same steps, or says in which tick the first difference is (`surefoot replay SESSION --level LEVEL`).
///
/// A `StepRing` keeps the last seconds in memory that is yours. It can always be on: pushing a tick copies a few
/// hundred bytes and allocates nothing. Out of it come a session, or one step to be saved (capture_step.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <surefoot/capture.hpp>
#include <surefoot/character.hpp>
#include <surefoot/error.hpp>
#include <surefoot/world.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// One tick of a session.
struct SessionTick {
    CharacterInput input{};
    double dt = 0;                      ///< [s]
    std::uint64_t hash = 0;             ///< of the state that came out
    std::vector<BodyPose> moved;        ///< the bodies that moved, or were put elsewhere, in this tick
    std::vector<Neighbour> neighbours;  ///< that the step was given
};

/// What one character did from a state on.
struct Session {
    CharacterSettings settings{};       ///< without `surfaces`: see `settings_of`
    std::vector<SurfaceRule> surfaces;  ///< what the settings' `surfaces` refer to
    std::uint64_t level = 0;            ///< `level_hash` of the world
    std::vector<BodyPose> bodies;       ///< all of them as they stood at the beginning, by number
    CharacterState first{};
    std::vector<SessionTick> ticks;
    CaptureOrigin origin{};
    std::string note;  ///< yours [UTF-8]
};

/// A hash of all triangles of all bodies with their numbers and surfaces, each body in its own frame: poses do not
/// count. It goes over all of them and allocates; once a session is enough.
[[nodiscard]] std::uint64_t level_hash(const World& world);

/// A session that begins with this state. The settings stay the same for all of it.
[[nodiscard]] Session begin_session(const World& world, const CharacterSettings& settings, const CharacterState& first);

/// Adds a tick after `step` has made it.
void record(Session& session, const CharacterInput& input, double dt, const CharacterState& after,
            std::span<const BodyPose> moved = {}, std::span<const Neighbour> neighbours = {});

/// The settings with their table of surfaces, which is the session's: good as long as it is.
[[nodiscard]] CharacterSettings settings_of(const Session& session) noexcept;

/// A session played again.
struct SessionReplay {
    bool is_same_level = false;                ///< otherwise no tick was made
    std::string wrong;                         ///< what the world lacks, in words; then it ended at `ticks`
    std::size_t ticks = 0;                     ///< how many were made
    std::optional<std::size_t> first_differs;  ///< the first tick of which the hash is another; it ends there
    CharacterState before{};                   ///< the state before the last tick that was made
    CharacterState after{};                    ///< and after it

    [[nodiscard]] bool is_same() const noexcept { return is_same_level && wrong.empty() && !first_differs; }
};

/// Plays up to `most` ticks of a session in a world with the same bodies, by their numbers. The bodies are moved as
/// they were; they are left where they are in the last tick, so that it can be captured.
[[nodiscard]] SessionReplay replay(const Session& session, World& world, std::size_t most = ~std::size_t{0});

/// The file's text.
[[nodiscard]] std::string session_text(const Session& session);

/// Reads the text of a file, as strictly as `parse_capture` and with the same errors; `limit` beyond 2^20 ticks, poses
/// or neighbours.
[[nodiscard]] Expected<Session> parse_session(std::string_view text, std::string_view file = {});

/// Writes the file. Whoever looks finds the whole old file or the whole new one. Fails with `write_failed`.
[[nodiscard]] Expected<void> write_session(const Session& session, const std::string& path);

/// Reads the file. Fails with `not_found`, and as above.
[[nodiscard]] Expected<Session> read_session(const std::string& path);

/// What a `StepRing` keeps of a tick.
struct RingTick {
    CharacterInput input{};
    double dt = 0;  ///< [s]
    CharacterState before{};
    std::uint64_t first_pose = 0;  ///< of all that were ever pushed
    std::uint64_t pose_count = 0;
    std::uint64_t first_neighbour = 0;  ///< of all that were ever pushed
    std::uint64_t neighbour_count = 0;
};

static_assert(std::is_trivially_copyable_v<RingTick>);

/// The last ticks of one character, as many as there is room for.
class StepRing {
public:
    /// `ticks` is the room: 60 a second at 60 Hz. `poses` is room for those of moving bodies, as many as move in all of
    /// these ticks, and `neighbours` for all that the steps are given; a tick of which some are gone is gone itself.
    explicit StepRing(std::span<RingTick> ticks, std::span<BodyPose> poses = {},
                      std::span<Neighbour> neighbours = {}) noexcept
        : ticks_(ticks), poses_(poses), neighbours_(neighbours) {}

    /// Keeps what a step is made of; `moved` are the bodies that move in this tick, `neighbours` what `step` is given.
    void push(const CharacterInput& input, double dt, const CharacterState& before,
              std::span<const BodyPose> moved = {}, std::span<const Neighbour> neighbours = {}) noexcept;

    /// How many of the last ticks are there.
    [[nodiscard]] std::size_t size() const noexcept;

    /// The oldest is 0. Requires: `index` < `size()`.
    [[nodiscard]] const RingTick& operator[](std::size_t index) const noexcept;

    /// A pose of that tick. Requires: `pose` < its `pose_count`.
    [[nodiscard]] const BodyPose& pose(const RingTick& tick, std::size_t pose) const noexcept;

    /// A neighbour of that tick. Requires: `neighbour` < its `neighbour_count`.
    [[nodiscard]] const Neighbour& neighbour(const RingTick& tick, std::size_t neighbour) const noexcept;

    /// Forgets all, as when settings change or a character is put elsewhere by hand.
    void clear() noexcept { pushed_ = 0; }

private:
    std::span<RingTick> ticks_;
    std::span<BodyPose> poses_;
    std::span<Neighbour> neighbours_;
    std::uint64_t pushed_ = 0;
    std::uint64_t poses_pushed_ = 0;
    std::uint64_t neighbours_pushed_ = 0;
};

/// The ticks of a ring as a session that ends with the state `now`. Bodies that do not move stand where they are in
/// `world`.
[[nodiscard]] Session session_of(const StepRing& ring, const World& world, const CharacterSettings& settings,
                                 const CharacterState& now);

}  // namespace v0
}  // namespace surefoot
