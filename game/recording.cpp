#include "game/recording.hpp"

#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "game/whole_file.hpp"

namespace surefoot::game {
namespace {

// magic, checksum of the rest, length of the header, header (JSON), inputs in runs of equal ones, hashes.
constexpr std::string_view magic = "SFRUN\x02\r\n";
constexpr std::string_view magic_1 = "SFRUN\x01\r\n";  // which knew no checkpoint in its header
constexpr std::uint64_t hash_every = 60;               // ticks
constexpr std::uint64_t most_ticks = 60 * 60 * 600;    // ten hours

template <typename T>
void put(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

// Reads plain values from the front of bytes; `good` is false once there were too few.
struct Bytes {
    std::string_view left;
    bool good = true;

    template <typename T>
    T take() {
        T value{};
        if (left.size() < sizeof(T)) {
            good = false;
            return value;
        }
        std::memcpy(&value, left.data(), sizeof(T));
        left.remove_prefix(sizeof(T));
        return value;
    }
};

std::uint64_t checksum(std::string_view bytes) {
    return hash_bytes(std::as_bytes(std::span(bytes)));
}

}  // namespace

Recorder::Recorder(const Level& level, std::string player, std::uint32_t checkpoint) {
    recording_.level = level.id;
    recording_.level_hash = level.hash;
    recording_.player = std::move(player);
    recording_.checkpoint = checkpoint;
}

void Recorder::tick(const HeroInput& input, const Game& game) {
    recording_.inputs.push_back(input);
    if (recording_.inputs.size() % hash_every == 0) recording_.hashes.push_back(game.hash());
    recording_.won = game.outcome() == Outcome::won;
    recording_.seconds = game.seconds();
}

void Recorder::decide(RunDecision::Kind kind) {
    recording_.decisions.push_back({kind, recording_.inputs.size()});
}

Expected<std::unique_ptr<Game>> start_of(const std::shared_ptr<const Level>& level, const Recording& recording) {
    if (recording.level_hash != level->hash)
        return tl::unexpected(Error{ErrorCode::invalid,
                                    "the recording was made on another version of the level " + recording.level +
                                        ": it cannot be played on this one",
                                    {},
                                    0});
    return Game::start(level, {.checkpoint = recording.checkpoint});
}

bool Player::tick(Game& game) {
    while (decision_ < recording_->decisions.size() && recording_->decisions[decision_].tick == at_) {
        if (recording_->decisions[decision_].kind == RunDecision::Kind::retry)
            game.retry();
        else
            game.give_up();
        ++decision_;
    }
    if (at_ >= recording_->inputs.size()) return false;
    game.tick(recording_->inputs[at_++]);
    const std::size_t hash = at_ / hash_every;
    if (diverged_ == 0 && at_ % hash_every == 0 && hash <= recording_->hashes.size() &&
        recording_->hashes[hash - 1] != game.hash())
        diverged_ = at_;
    return true;
}

Expected<void> write_recording(const std::string& path, const Recording& recording) {
    nlohmann::json decisions = nlohmann::json::array();
    for (const RunDecision& decision : recording.decisions)
        decisions.push_back({{"give_up", decision.kind == RunDecision::Kind::give_up}, {"tick", decision.tick}});
    const nlohmann::json header{{"level", recording.level},
                                {"level_hash", recording.level_hash},
                                {"player", recording.player},
                                {"checkpoint", recording.checkpoint},
                                {"ticks", recording.inputs.size()},
                                {"hashes", recording.hashes.size()},
                                {"won", recording.won},
                                {"seconds", recording.seconds},
                                {"decisions", decisions}};
    const std::string words = header.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    std::string body;
    put(body, std::uint32_t(words.size()));
    body += words;
    for (std::size_t i = 0; i < recording.inputs.size();) {
        std::uint32_t same = 1;
        while (i + same < recording.inputs.size() && recording.inputs[i + same] == recording.inputs[i]) ++same;
        put(body, same);
        put(body, recording.inputs[i]);
        i += same;
    }
    for (const std::uint64_t hash : recording.hashes) put(body, hash);
    std::string bytes(magic);
    put(bytes, checksum(body));
    return write_whole(path, bytes + body);
}

Expected<Recording> read_recording(const std::string& path) {
    const auto bytes = read_whole(path);
    if (!bytes) return tl::unexpected(bytes.error());
    Bytes at{*bytes};
    const auto fail = [&](ErrorCode code, const std::string& what) {
        return tl::unexpected(Error{code, path + ": " + what, path, bytes->size() - at.left.size()});
    };
    const std::string damaged = "the recording is damaged; record the run again";
    if (bytes->substr(0, 5) != magic.substr(0, 5)) return fail(ErrorCode::unreadable, "this is no recording of a run");
    const bool is_first = bytes->substr(0, magic_1.size()) == magic_1;
    if (!is_first && bytes->substr(0, magic.size()) != magic)
        return fail(ErrorCode::unsupported, "this recording is of another version; record the run again");
    at.left.remove_prefix(magic.size());
    if (at.take<std::uint64_t>() != checksum(at.left) || !at.good) return fail(ErrorCode::unreadable, damaged);
    const auto length = at.take<std::uint32_t>();
    if (!at.good || length > at.left.size()) return fail(ErrorCode::unreadable, damaged);
    const auto header = nlohmann::json::parse(at.left.substr(0, length), nullptr, false);
    at.left.remove_prefix(length);
    Recording made;
    std::uint64_t ticks = 0;
    std::uint64_t hashes = 0;
    try {
        made.level = header.at("level").get<std::string>();
        made.level_hash = header.at("level_hash").get<std::uint64_t>();
        made.player = header.at("player").get<std::string>();
        if (!is_first) made.checkpoint = header.at("checkpoint").get<std::uint32_t>();
        made.won = header.at("won").get<bool>();
        made.seconds = header.at("seconds").get<double>();
        ticks = header.at("ticks").get<std::uint64_t>();
        hashes = header.at("hashes").get<std::uint64_t>();
        for (const auto& decision : header.at("decisions"))
            made.decisions.push_back(
                {decision.at("give_up").get<bool>() ? RunDecision::Kind::give_up : RunDecision::Kind::retry,
                 decision.at("tick").get<std::uint64_t>()});
    } catch (const nlohmann::json::exception&) {
        return fail(ErrorCode::unreadable, damaged);
    }
    if (ticks > most_ticks || hashes > ticks) return fail(ErrorCode::unreadable, damaged);
    while (at.good && made.inputs.size() < ticks) {
        const auto same = at.take<std::uint32_t>();
        const auto input = at.take<HeroInput>();
        if (same == 0 || same > ticks - made.inputs.size()) at.good = false;
        if (at.good) made.inputs.insert(made.inputs.end(), same, input);
    }
    for (std::uint64_t i = 0; at.good && i < hashes; ++i) made.hashes.push_back(at.take<std::uint64_t>());
    if (!at.good || !at.left.empty()) return fail(ErrorCode::unreadable, damaged);
    return made;
}

}  // namespace surefoot::game
