// The file of a session, written and read. docs/capture.md tells its form.
#include <surefoot/capture_session.hpp>

#include "capture/fields_text.hpp"
#include "ieee_guard.hpp"
#include "platform/bytes.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

constexpr std::size_t most_ticks = std::size_t{1} << 20U;
constexpr std::size_t most_poses = std::size_t{1} << 20U;
constexpr std::size_t most_kept_neighbours = std::size_t{1} << 20U;

void write_body_pose(Writer& w, const BodyPose& pose) {
    w.word("{");
    write_poses(w, pose.body, pose.start, pose.end);
    w.word("}");
}

void write_tick(Writer& w, const SessionTick& tick) {
    w.word("{\"input\": ");
    write_fields(w, tick.input);
    w.word(", \"dt\": ");
    w.number(tick.dt);
    w.word(", \"hash\": ");
    w.bits(tick.hash);
    w.word(", \"moved\": [");
    for (const BodyPose& pose : tick.moved) {
        if (&pose != tick.moved.data()) w.word(", ");
        write_body_pose(w, pose);
    }
    w.word("], ");
    write_neighbours(w, tick.neighbours);
    w.word("}");
}

class SessionReader {
public:
    explicit SessionReader(JsonReader& in) noexcept : in_(in), fields_(in, session_.surfaces) {}

    Session read() {
        constexpr std::array<std::string_view, 9> names{"surefoot_session", "library", "abi",    "note", "level",
                                                        "settings",         "first",   "bodies", "ticks"};
        std::uint64_t newest_settings = 0;
        in_.object(names, names.size(), [&](std::size_t i) {
            if (i == 0) session_.origin.format = read_format(in_, first_session_form, session_form);
            if (i == 1) session_.origin.library = read_version(in_);
            if (i == 2) session_.origin.abi = in_.text();
            if (i == 3) session_.note = in_.text();
            if (i == 4) session_.level = in_.bits();
            if (i == 5) newest_settings = fields_.read(session_.settings);
            if (i == 6) fields_.read(session_.first);
            if (i == 7) read_poses(session_.bodies);
            if (i == 8) read_ticks();
        });
        in_.end();
        const bool is_newest = session_.origin.format == session_form;
        if (in_.good()) check_newest_settings(in_, newest_settings, is_newest);
        const bool fits = with_neighbours_ == (is_newest ? session_.ticks.size() : 0);
        if (in_.good() && !fits) check_newest(in_, "neighbours", !is_newest, is_newest);
        return std::move(session_);
    }

private:
    void read_ticks() {
        in_.array([&] {
            SessionTick tick = read_tick();
            if (session_.ticks.size() == most_ticks) in_.fail("more ticks than a session may have", ErrorCode::limit);
            if (in_.good()) session_.ticks.push_back(std::move(tick));
        });
    }

    SessionTick read_tick() {
        constexpr std::array<std::string_view, 5> names{"input", "dt", "hash", "moved", "neighbours"};
        SessionTick tick;
        in_.object(names, 4, [&](std::size_t i) {
            if (i == 0) fields_.read(tick.input);
            if (i == 1) tick.dt = in_.number();
            if (i == 2) tick.hash = in_.bits();
            if (i == 3) read_poses(tick.moved);
            if (i == 4) read_neighbours(tick.neighbours);
        });
        return tick;
    }

    void read_poses(std::vector<BodyPose>& poses) {
        constexpr std::array<std::string_view, 3> names{"body", "start", "end"};
        in_.array([&] {
            BodyPose pose;
            in_.object(names, names.size(), [&](std::size_t i) {
                if (i == 0) pose.body = in_.whole_number();
                if (i == 1) pose.start = read_pose(in_);
                if (i == 2) pose.end = read_pose(in_);
            });
            if (++poses_ > most_poses) in_.fail("more poses than a session may have", ErrorCode::limit);
            if (in_.good()) poses.push_back(pose);
        });
    }

    void read_neighbours(std::vector<Neighbour>& neighbours) {
        fields_.read_neighbours(neighbours, most_kept_neighbours - neighbours_);
        neighbours_ += neighbours.size();
        ++with_neighbours_;
    }

    JsonReader& in_;
    Session session_;
    FieldReader fields_;
    std::size_t poses_ = 0;
    std::size_t neighbours_ = 0;
    std::size_t with_neighbours_ = 0;  // ticks that tell theirs
};

}  // namespace

std::string session_text(const Session& session) {
    const IeeeGuard guard;
    Writer w;
    write_origin(w, "surefoot_session", session_form, session.origin, session.note);
    w.word("  \"level\": ");
    w.bits(session.level);
    w.word(",\n  \"settings\": ");
    write_fields(w, settings_of(session), "\n    ");
    w.word(",\n  \"first\": ");
    write_fields(w, session.first, "\n    ");
    w.word(",\n");
    write_list(w, "bodies", session.bodies, write_body_pose);
    w.word(",\n");
    write_list(w, "ticks", session.ticks, write_tick);
    w.word("\n}\n");
    return w.take();
}

Expected<void> write_session(const Session& session, const std::string& path) {
    return write_text(session_text(session), path);
}

Expected<Session> parse_session(std::string_view text, std::string_view file) {
    const IeeeGuard guard;
    JsonReader in(text);
    Session session = SessionReader(in).read();
    if (in.good()) return session;
    return tl::unexpected(error_of(in, file, "session"));
}

Expected<Session> read_session(const std::string& path) {
    const auto owned = OwnedBytes::read(path);
    if (!owned) return tl::unexpected(owned.error());
    const auto bytes = owned->bytes();
    return parse_session({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path);
}

}  // namespace v0
}  // namespace surefoot
