#include "platformer/sound/music_stream.hpp"

#include <algorithm>

namespace surefoot::sound {

MusicStream::MusicStream(Piece piece)
    : piece_(piece), band_(score_of(piece)), samples_(2 * block), converted_(2 * block) {
    alGenSources(1, &source_);
    alGenBuffers(static_cast<ALsizei>(buffers_.size()), buffers_.data());
    alSourcei(source_, AL_SOURCE_RELATIVE, AL_TRUE);
    alSourcef(source_, AL_ROLLOFF_FACTOR, 0);
}

MusicStream::~MusicStream() {
    alSourceStop(source_);
    alDeleteSources(1, &source_);
    alDeleteBuffers(static_cast<ALsizei>(buffers_.size()), buffers_.data());
}

void MusicStream::fade_to(double share, double seconds) {
    target_ = share;
    speed_ = 1 / std::max(seconds, 1e-3);
}

bool MusicStream::update(double seconds, double gain) {
    const double step = speed_ * seconds;
    share_ = share_ < target_ ? std::min(target_, share_ + step) : std::max(target_, share_ - step);
    if (share_ <= 0 && target_ <= 0) return false;
    // A quarter of a sine: two pieces that cross are together as loud as one.
    alSourcef(source_, AL_GAIN, static_cast<ALfloat>(gain * sine(share_ / 4)));
    ALint done = 0;
    alGetSourcei(source_, AL_BUFFERS_PROCESSED, &done);
    for (; done > 0; --done) {
        ALuint buffer = 0;
        alSourceUnqueueBuffers(source_, 1, &buffer);
        feed(buffer);
    }
    // Two at a time at the beginning: what is heard first need not wait for what comes later.
    for (int i = 0; i < 2 && filled_ < buffers_.size(); ++i) feed(buffers_[filled_++]);
    ALint state = 0;
    alGetSourcei(source_, AL_SOURCE_STATE, &state);
    if (state != AL_PLAYING) alSourcePlay(source_);
    return true;
}

void MusicStream::feed(ALuint buffer) {
    band_.play(samples_);
    std::transform(samples_.begin(), samples_.end(), converted_.begin(), [](float x) { return to_16_bits(x); });
    alBufferData(buffer, AL_FORMAT_STEREO16, converted_.data(),
                 static_cast<ALsizei>(converted_.size() * sizeof converted_[0]), rate);
    alSourceQueueBuffers(source_, 1, &buffer);
}

}  // namespace surefoot::sound
