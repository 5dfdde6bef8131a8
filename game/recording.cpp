#include "game/recording.hpp"

#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <zlib.h>

#include "game/whole_file.hpp"

namespace surefoot::game {
namespace {

// magic, checksum of the rest, length of the header, header (JSON), length of what is packed, inputs in runs of equal
// ones, packed, hashes.
constexpr std::string_view magic = "SFRUN\x02\r\n";
constexpr std::string_view magic_1 = "SFRUN\x01\r\n";  // without a checkpoint in its header, and with nothing packed
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

// How often an input is held in a row, and the input.
constexpr std::size_t row_size = sizeof(std::uint32_t) + sizeof(HeroInput);

// Rows side by side differ little: their first bytes one after the other, then their second ones and so on, each less
// that of the row before, deflate to a fourth.
std::string packed(std::string_view rows) {
    const std::size_t count = rows.size() / row_size;
    std::string columns(rows.size(), '\0');
    for (std::size_t byte = 0; byte < row_size; ++byte)
        for (std::size_t row = 0; row < count; ++row) {
            const char before = row > 0 ? rows[(row - 1) * row_size + byte] : '\0';
            columns[byte * count + row] = char(std::uint8_t(rows[row * row_size + byte]) - std::uint8_t(before));
        }
    uLongf size = compressBound(uLong(columns.size()));
    std::string out(size, '\0');
    compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(columns.data()),
              uLong(columns.size()), Z_BEST_COMPRESSION);
    out.resize(size);
    return out;
}

// Back again, if it is so many rows; else nothing.
std::optional<std::string> unpacked(std::string_view bytes, std::size_t count) {
    std::string columns(count * row_size, '\0');
    uLongf size = uLong(columns.size());
    const int result = uncompress(reinterpret_cast<Bytef*>(columns.data()), &size,
                                  reinterpret_cast<const Bytef*>(bytes.data()), uLong(bytes.size()));
    if (result != Z_OK || size != columns.size()) return std::nullopt;
    std::string rows(columns.size(), '\0');
    for (std::size_t byte = 0; byte < row_size; ++byte)
        for (std::size_t row = 0; row < count; ++row) {
            const char before = row > 0 ? rows[(row - 1) * row_size + byte] : '\0';
            rows[row * row_size + byte] = char(std::uint8_t(columns[byte * count + row]) + std::uint8_t(before));
        }
    return rows;
}

// Inputs until there are as many as ticks; `at.good` is false where they are no such rows.
void take_rows(Bytes& at, std::uint64_t ticks, std::vector<HeroInput>& inputs) {
    while (at.good && inputs.size() < ticks) {
        const auto same = at.take<std::uint32_t>();
        const auto input = at.take<HeroInput>();
        if (same == 0 || same > ticks - inputs.size()) at.good = false;
        if (at.good) inputs.insert(inputs.end(), same, input);
    }
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

std::string to_bytes(const Recording& recording) {
    nlohmann::json decisions = nlohmann::json::array();
    for (const RunDecision& decision : recording.decisions)
        decisions.push_back({{"give_up", decision.kind == RunDecision::Kind::give_up}, {"tick", decision.tick}});
    std::string rows;
    for (std::size_t i = 0; i < recording.inputs.size();) {
        std::uint32_t same = 1;
        while (i + same < recording.inputs.size() && recording.inputs[i + same] == recording.inputs[i]) ++same;
        put(rows, same);
        put(rows, recording.inputs[i]);
        i += same;
    }
    const nlohmann::json header{{"level", recording.level},          {"level_hash", recording.level_hash},
                                {"player", recording.player},        {"checkpoint", recording.checkpoint},
                                {"ticks", recording.inputs.size()},  {"rows", rows.size() / row_size},
                                {"hashes", recording.hashes.size()}, {"won", recording.won},
                                {"seconds", recording.seconds},      {"decisions", decisions}};
    const std::string words = header.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    std::string body;
    put(body, std::uint32_t(words.size()));
    body += words;
    const std::string inputs = packed(rows);
    put(body, std::uint32_t(inputs.size()));
    body += inputs;
    for (const std::uint64_t hash : recording.hashes) put(body, hash);
    std::string bytes(magic);
    put(bytes, checksum(body));
    return bytes + body;
}

Expected<void> write_recording(const std::string& path, const Recording& recording) {
    return write_whole(path, to_bytes(recording));
}

Expected<Recording> recording_of(std::string_view bytes, const std::string& path) {
    Bytes at{bytes};
    const auto fail = [&](ErrorCode code, const std::string& what) {
        return tl::unexpected(Error{code, path + ": " + what, path, bytes.size() - at.left.size()});
    };
    const std::string damaged = "the recording is damaged; record the run again";
    if (bytes.substr(0, 5) != magic.substr(0, 5)) return fail(ErrorCode::unreadable, "this is no recording of a run");
    const bool is_first = bytes.substr(0, magic_1.size()) == magic_1;
    if (!is_first && bytes.substr(0, magic.size()) != magic)
        return fail(ErrorCode::unsupported, "this recording is of another version; record the run again");
    at.left.remove_prefix(magic.size());
    if (at.take<std::uint64_t>() != checksum(at.left) || !at.good) return fail(ErrorCode::unreadable, damaged);
    const auto length = at.take<std::uint32_t>();
    if (!at.good || length > at.left.size()) return fail(ErrorCode::unreadable, damaged);
    const auto header = nlohmann::json::parse(at.left.substr(0, length), nullptr, false);
    at.left.remove_prefix(length);
    Recording made;
    std::uint64_t ticks = 0;
    std::uint64_t rows = 0;
    std::uint64_t hashes = 0;
    try {
        made.level = header.at("level").get<std::string>();
        made.level_hash = header.at("level_hash").get<std::uint64_t>();
        made.player = header.at("player").get<std::string>();
        if (!is_first) made.checkpoint = header.at("checkpoint").get<std::uint32_t>();
        made.won = header.at("won").get<bool>();
        made.seconds = header.at("seconds").get<double>();
        ticks = header.at("ticks").get<std::uint64_t>();
        if (!is_first) rows = header.at("rows").get<std::uint64_t>();
        hashes = header.at("hashes").get<std::uint64_t>();
        for (const auto& decision : header.at("decisions"))
            made.decisions.push_back(
                {decision.at("give_up").get<bool>() ? RunDecision::Kind::give_up : RunDecision::Kind::retry,
                 decision.at("tick").get<std::uint64_t>()});
    } catch (const nlohmann::json::exception&) {
        return fail(ErrorCode::unreadable, damaged);
    }
    if (ticks > most_ticks || rows > ticks || hashes > ticks) return fail(ErrorCode::unreadable, damaged);
    if (is_first) {
        take_rows(at, ticks, made.inputs);
    } else {
        const auto size = at.take<std::uint32_t>();
        if (!at.good || size > at.left.size()) return fail(ErrorCode::unreadable, damaged);
        const auto inputs = unpacked(at.left.substr(0, size), std::size_t(rows));
        if (!inputs) return fail(ErrorCode::unreadable, damaged);
        at.left.remove_prefix(size);
        Bytes row{*inputs};
        take_rows(row, ticks, made.inputs);
        at.good = row.good && row.left.empty();
    }
    if (!at.good) return fail(ErrorCode::unreadable, damaged);
    for (std::uint64_t i = 0; at.good && i < hashes; ++i) made.hashes.push_back(at.take<std::uint64_t>());
    if (!at.good || !at.left.empty()) return fail(ErrorCode::unreadable, damaged);
    return made;
}

Expected<Recording> read_recording(const std::string& path) {
    const auto bytes = read_whole(path);
    if (!bytes) return tl::unexpected(bytes.error());
    return recording_of(*bytes, path);
}

}  // namespace surefoot::game
