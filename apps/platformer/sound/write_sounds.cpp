// Writes every effect and both pieces as .wav files into a folder, and says what can be said of them in numbers.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>

#include "platformer/sound/band.hpp"
#include "platformer/sound/effects.hpp"
#include "platformer/sound/measure.hpp"
#include "platformer/sound/pieces.hpp"
#include "platformer/sound/wav.hpp"

namespace surefoot::sound {
namespace {

/// What the processor spent on it, whoever else it worked for meanwhile.
class Clock {
public:
    [[nodiscard]] double seconds() const { return double(std::clock() - start_) / CLOCKS_PER_SEC; }

private:
    std::clock_t start_ = std::clock();
};

double in_decibels(double share) {
    return 20 * std::log10(std::max(share, 1e-9));
}

/// The first of its channels.
Samples one_of(std::span<const float> samples, int channels) {
    Samples one;
    for (std::size_t i = 0; i < samples.size(); i += static_cast<std::size_t>(channels)) one.push_back(samples[i]);
    return one;
}

bool keep(const std::string& folder, const std::string& name, std::span<const float> samples, int channels,
          double cost) {
    const double seconds = double(samples.size()) / channels / rate;
    std::printf(
        "%-16s %7.2f s  peak %6.1f dB  loudest 50 ms %6.1f dB  RMS %6.1f dB  brightness %5.0f Hz  made in %7.1f ms\n",
        name.c_str(), seconds, in_decibels(peak(samples)), in_decibels(loudest(samples, 0.05 * channels)),
        in_decibels(rms(samples)), brightness(one_of(samples, channels)), 1000 * cost);
    const Expected<void> written = write_wav(folder + "/" + name + ".wav", samples, channels);
    if (!written) std::fprintf(stderr, "%s\n", written.error().text.c_str());
    return written.has_value();
}

bool write_effects(const std::string& folder) {
    bool good = true;
    for (int i = 0; i < effect_count; ++i) {
        const auto effect = static_cast<Effect>(i);
        for (int variation = 0; variation < variations_of(effect); ++variation) {
            const Clock clock;
            const Samples samples = make(effect, variation);
            std::string name(name_of(effect));
            if (variation > 0) name.append("_").append(std::to_string(variation + 1));
            good &= keep(folder, name, samples, 1, clock.seconds());
        }
    }
    return good;
}

/// The second round, over whose beginning the end of the first rings: such a file can be repeated without a seam.
bool write_pieces(const std::string& folder) {
    bool good = true;
    for (int i = 0; i < piece_count; ++i) {
        const auto piece = static_cast<Piece>(i);
        Band band(score_of(piece));
        Samples samples(2 * band.round());
        band.play(samples);
        const Clock clock;
        band.play(samples);
        good &= keep(folder, "music_" + std::string(name_of(piece)), samples, 2, clock.seconds());
    }
    return good;
}

}  // namespace
}  // namespace surefoot::sound

int main(int count, char** words) {
    if (count != 2) {
        std::fprintf(stderr, "surefoot-sounds FOLDER writes every sound of the platformer there, as .wav files.\n");
        return 2;
    }
    std::error_code error;
    std::filesystem::create_directories(words[1], error);
    const bool good = surefoot::sound::write_effects(words[1]) && surefoot::sound::write_pieces(words[1]);
    return good ? 0 : 1;
}
