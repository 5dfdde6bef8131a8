#include "platformer/sound/mixer.hpp"

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "platformer/sound/music_stream.hpp"
#include "platformer/sound/quiet.hpp"

namespace surefoot::sound {

namespace {

constexpr std::uint32_t voices_at_once = 32;
constexpr double lowered = 0.35;  // music while paused

/// Sliders are heard evenly if the gain goes by the square.
double gain_of(double slider) {
    const double share = std::clamp(slider, 0.0, 1.0);
    return share * share;
}

bool is_finite(const dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::array<ALfloat, 3> floats(const dvec3& v) {
    return {static_cast<ALfloat>(v.x), static_cast<ALfloat>(v.y), static_cast<ALfloat>(v.z)};
}

Error cannot(ErrorCode code, std::string text) {
    return {code, std::move(text), "", 0};
}

}  // namespace

struct Mixer::Parts {
    ALCdevice* device = nullptr;
    ALCcontext* context = nullptr;
    LPALCRENDERSAMPLESSOFT render = nullptr;
    bool tells_when_gone = false;
    Voices voices{voices_at_once};
    std::vector<ALuint> sources;                          ///< one a slot of `voices`
    std::array<std::vector<ALuint>, effect_count> ready;  ///< buffers, by variation
    std::array<int, effect_count> turn{};                 ///< which variation is next
    Listener listener;
    Volumes volumes;
    std::vector<std::unique_ptr<MusicStream>> streams;  ///< what plays, and what is on its way out
    bool paused = false;
    int prepared = 0;

    Parts() = default;
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    ~Parts() {
        streams.clear();
        if (context != nullptr) {
            for (const ALuint source : sources) alSourceStop(source);
            alDeleteSources(static_cast<ALsizei>(sources.size()), sources.data());
            for (const auto& buffers : ready) alDeleteBuffers(static_cast<ALsizei>(buffers.size()), buffers.data());
            alcMakeContextCurrent(nullptr);
            alcDestroyContext(context);
        }
        if (device != nullptr) alcCloseDevice(device);
    }

    /// The buffer of a variation; makes those up to it that are not there yet.
    ALuint buffer_of(Effect effect, int variation) {
        std::vector<ALuint>& buffers = ready[static_cast<std::size_t>(effect)];
        while (static_cast<int>(buffers.size()) <= variation) {
            const Samples samples = make(effect, static_cast<int>(buffers.size()));
            std::vector<std::int16_t> converted(samples.size());
            std::transform(samples.begin(), samples.end(), converted.begin(), [](float x) { return to_16_bits(x); });
            ALuint buffer = 0;
            alGenBuffers(1, &buffer);
            alBufferData(buffer, AL_FORMAT_MONO16, converted.data(),
                         static_cast<ALsizei>(converted.size() * sizeof converted[0]), rate);
            buffers.push_back(buffer);
        }
        return buffers[static_cast<std::size_t>(variation)];
    }

    [[nodiscard]] double music_gain() const { return gain_of(volumes.music) * (paused ? lowered : 1); }
};

Expected<Mixer> Mixer::open(Output output) {
    auto parts = std::make_unique<Parts>();
    std::array<ALCint, 5> wanted{};
    if (output == Output::memory) {
        if (alcIsExtensionPresent(nullptr, "ALC_SOFT_loopback") == ALC_FALSE) {
            return tl::unexpected(cannot(ErrorCode::unsupported, "This OpenAL cannot render into memory."));
        }
        const auto open_in_memory =
            reinterpret_cast<LPALCLOOPBACKOPENDEVICESOFT>(alcGetProcAddress(nullptr, "alcLoopbackOpenDeviceSOFT"));
        parts->render = reinterpret_cast<LPALCRENDERSAMPLESSOFT>(alcGetProcAddress(nullptr, "alcRenderSamplesSOFT"));
        parts->device = open_in_memory(nullptr);
        wanted = {ALC_FORMAT_CHANNELS_SOFT, ALC_STEREO_SOFT, ALC_FORMAT_TYPE_SOFT, ALC_FLOAT_SOFT, 0};
    } else if (output == Output::device) {
        quieten_alsa();
        parts->device = alcOpenDevice(nullptr);
    }
    if (parts->device == nullptr) {
        return tl::unexpected(cannot(ErrorCode::not_found, "No sound: OpenAL finds no device to play it on."));
    }
    // Many sounds at once are held down together rather than cut off one by one.
    const std::array<ALCint, 9> attributes{
        ALC_FREQUENCY, rate, ALC_OUTPUT_LIMITER_SOFT, ALC_TRUE, wanted[0], wanted[1], wanted[2], wanted[3], 0};
    parts->context = alcCreateContext(parts->device, attributes.data());
    if (parts->context == nullptr || alcMakeContextCurrent(parts->context) == ALC_FALSE) {
        return tl::unexpected(cannot(ErrorCode::unsupported, "No sound: the device cannot be used by OpenAL."));
    }
    parts->tells_when_gone = alcIsExtensionPresent(parts->device, "ALC_EXT_disconnect") != ALC_FALSE;
    parts->sources.resize(parts->voices.capacity());
    alGetError();
    alGenSources(static_cast<ALsizei>(parts->sources.size()), parts->sources.data());
    if (alGetError() != AL_NO_ERROR) {
        parts->sources.clear();
        return tl::unexpected(cannot(ErrorCode::unsupported, "No sound: the device plays too few sounds at once."));
    }
    alDistanceModel(AL_INVERSE_DISTANCE_CLAMPED);
    Mixer mixer(std::move(parts));
    mixer.listen({});
    mixer.set_volumes({});
    return mixer;
}

Mixer::Mixer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Mixer::Mixer(Mixer&&) noexcept = default;
Mixer& Mixer::operator=(Mixer&&) noexcept = default;
Mixer::~Mixer() = default;

void Mixer::play(Effect effect, const PlayOptions& options) {
    Parts& p = *parts_;
    const dvec3 place = options.place.value_or(dvec3(0.0));
    // What is not finite has no place in the world; it would silence OpenAL for good.
    if (!is_finite(place) || !is_finite(options.velocity) || !std::isfinite(options.gain + options.pitch)) return;
    const double gain = std::clamp(options.gain, 0.0, 1.0);
    const std::optional<VoiceHandle> voice = p.voices.admit({effect, gain, options.place}, p.listener.place);
    if (!voice) return;
    int& turn = p.turn[static_cast<std::size_t>(effect)];
    const ALuint buffer = p.buffer_of(effect, turn), source = p.sources[voice->index];
    turn = (turn + 1) % variations_of(effect);
    alSourceStop(source);
    alSourcei(source, AL_BUFFER, static_cast<ALint>(buffer));
    alSourcei(source, AL_SOURCE_RELATIVE, options.place ? AL_FALSE : AL_TRUE);
    // OpenAL computes with floats: seen from the listener, a place far out is as exact as one at home.
    alSourcefv(source, AL_POSITION, floats(options.place ? place - p.listener.place : place).data());
    alSourcefv(source, AL_VELOCITY, floats(options.velocity).data());
    alSourcef(source, AL_GAIN, static_cast<ALfloat>(gain * gain_of(p.volumes.effects)));
    alSourcef(source, AL_PITCH, static_cast<ALfloat>(std::clamp(options.pitch, 0.25, 4.0)));
    alSourcef(source, AL_REFERENCE_DISTANCE, static_cast<ALfloat>(near_enough));
    alSourcef(source, AL_MAX_DISTANCE, static_cast<ALfloat>(far_enough));
    alSourcef(source, AL_ROLLOFF_FACTOR, options.place ? 1 : 0);
    alSourcePlay(source);
    if (p.paused && options.place) alSourcePause(source);
}

void Mixer::listen(const Listener& listener) {
    Parts& p = *parts_;
    if (!is_finite(listener.place) || !is_finite(listener.velocity) || !is_finite(listener.forward) ||
        !is_finite(listener.up)) {
        return;
    }
    p.listener = listener;
    const std::array<ALfloat, 3> forward = floats(listener.forward), up = floats(listener.up);
    const std::array<ALfloat, 6> both{forward[0], forward[1], forward[2], up[0], up[1], up[2]};
    alListenerfv(AL_ORIENTATION, both.data());
    alListenerfv(AL_VELOCITY, floats(listener.velocity).data());
    for (auto it = p.voices.playing().begin(); it != p.voices.playing().end(); ++it) {
        const Voice& voice = *it;
        if (!voice.place) continue;
        alSourcefv(p.sources[it.handle().index], AL_POSITION, floats(*voice.place - listener.place).data());
    }
}

void Mixer::set_volumes(const Volumes& volumes) {
    Parts& p = *parts_;
    p.volumes = volumes;
    alListenerf(AL_GAIN, static_cast<ALfloat>(gain_of(volumes.master)));
    for (auto it = p.voices.playing().begin(); it != p.voices.playing().end(); ++it) {
        alSourcef(p.sources[it.handle().index], AL_GAIN, static_cast<ALfloat>((*it).gain * gain_of(volumes.effects)));
    }
}

void Mixer::music(std::optional<Piece> piece, double fade) {
    Parts& p = *parts_;
    bool there = false;
    for (const auto& stream : p.streams) {
        const bool wanted = piece == stream->piece();
        stream->fade_to(wanted ? 1 : 0, fade);
        there = there || wanted;
    }
    if (!piece || there) return;
    // Out of silence it need not creep.
    const double rise = p.streams.empty() ? std::min(fade, 0.1) : fade;
    p.streams.emplace_back(std::make_unique<MusicStream>(*piece))->fade_to(1, rise);
}

void Mixer::pause(bool paused) {
    Parts& p = *parts_;
    p.paused = paused;
    for (auto it = p.voices.playing().begin(); it != p.voices.playing().end(); ++it) {
        const ALuint source = p.sources[it.handle().index];
        ALint state = 0;
        alGetSourcei(source, AL_SOURCE_STATE, &state);
        if ((*it).place && paused && state == AL_PLAYING) alSourcePause(source);
        if (!paused && state == AL_PAUSED) alSourcePlay(source);
    }
}

bool Mixer::update(double seconds) {
    Parts& p = *parts_;
    if (p.tells_when_gone && p.render == nullptr) {
        ALCint there = ALC_TRUE;
        alcGetIntegerv(p.device, ALC_CONNECTED, 1, &there);
        if (there == ALC_FALSE) return false;
    }
    for (auto it = p.voices.playing().begin(); it != p.voices.playing().end(); ++it) {
        ALint state = 0;
        alGetSourcei(p.sources[it.handle().index], AL_SOURCE_STATE, &state);
        if (state == AL_STOPPED) p.voices.end(it.handle());
    }
    std::erase_if(p.streams, [&](const auto& stream) { return !stream->update(seconds, p.music_gain()); });
    return true;
}

bool Mixer::prepare_one() {
    Parts& p = *parts_;
    for (; p.prepared < effect_count; ++p.prepared) {
        const auto effect = static_cast<Effect>(p.prepared);
        const int made = static_cast<int>(p.ready[static_cast<std::size_t>(effect)].size());
        if (made == variations_of(effect)) continue;
        p.buffer_of(effect, made);
        return true;
    }
    return false;
}

std::uint32_t Mixer::playing() const {
    return parts_->voices.playing().size();
}

void Mixer::mixed(std::span<float> stereo) {
    parts_->render(parts_->device, stereo.data(), static_cast<ALCsizei>(stereo.size() / 2));
}

}  // namespace surefoot::sound
