#include "platformer/sound/band.hpp"

#include <algorithm>

namespace surefoot::sound {

namespace {

/// Below the effects, which are to be heard over it, and far from where the limit bends.
constexpr double level = 0.55;

}  // namespace

Band::Band(const Score& score) : score_(&score), round_(samples_in(score.length)), room_(1.7) {}

void Band::play(std::span<float> stereo) {
    while (!stereo.empty()) {
        if (now_ == round_) {
            now_ = 0;
            next_ = 0;
        }
        const std::vector<Note>& notes = score_->notes;
        while (next_ < notes.size() && samples_in(notes[next_].start) <= now_) begin_note(next_++);
        const std::size_t until = next_ < notes.size() ? std::min(round_, samples_in(notes[next_].start)) : round_;
        const std::size_t count = std::min(stereo.size() / 2, until - now_);
        play_until_next_note(stereo.first(2 * count));
        stereo = stereo.subspan(2 * count);
        now_ += count;
    }
}

void Band::begin_note(std::size_t index) {
    const Note& note = score_->notes[index];
    const Part& part = score_->parts[note.part];
    // Seats in a half circle: as loud in the middle as at the sides.
    const double angle = (part.pan + 1) / 8, gain = level * part.gain;
    sounding_.push_back({sound::play(part.instrument, {note.pitch, note.length, note.velocity, index}), 0,
                         static_cast<float>(gain * sine(angle + 0.25)), static_cast<float>(gain * sine(angle)),
                         static_cast<float>(gain * part.room)});
}

void Band::play_until_next_note(std::span<float> stereo) {
    std::fill(stereo.begin(), stereo.end(), 0.0F);
    const std::size_t count = stereo.size() / 2;
    to_room_.assign(count, 0.0F);
    for (Sounding& sound : sounding_) {
        const std::size_t left = std::min(count, sound.samples.size() - sound.played);
        const float* const from = sound.samples.data() + sound.played;
        for (std::size_t i = 0; i < left; ++i) {
            stereo[2 * i] += sound.left * from[i];
            stereo[2 * i + 1] += sound.right * from[i];
            to_room_[i] += sound.room * from[i];
        }
        sound.played += left;
    }
    std::erase_if(sounding_, [](const Sounding& sound) { return sound.played == sound.samples.size(); });
    for (std::size_t i = 0; i < count; ++i) {
        const Reverb::Heard room = room_.next(to_room_[i]);
        stereo[2 * i] = static_cast<float>(soft_limit(stereo[2 * i] + room.left));
        stereo[2 * i + 1] = static_cast<float>(soft_limit(stereo[2 * i + 1] + room.right));
    }
}

}  // namespace surefoot::sound
