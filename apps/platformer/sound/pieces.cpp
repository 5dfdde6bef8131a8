#include "platformer/sound/pieces.hpp"

#include <array>
#include <cassert>

namespace surefoot::sound {

namespace {

/// A slow bossa in F: the descent from F to Bb by way of A7 and F7, and a middle that leans on the minor subdominant.
constexpr std::string_view calm = R"(
title   Harbour in the morning
tempo   88
swing   0.54

part  melody   flute       gain 0.42  pan -0.12  room 0.40
part  bars     vibraphone  gain 0.36  pan  0.25  room 0.45
part  keys     piano       gain 0.19  pan  0.18  room 0.20
part  strings  pad         gain 0.15  pan  0     room 0.40
part  strings_too pad      gain 0.26  pan -0.3   room 0.40
part  bass     bass        gain 0.42  pan  0     room 0.06
part  kick     kick        gain 0.24  pan  0     room 0.05
part  rim      marimba     gain 0.26  pan -0.3   room 0.15
part  brush    brush       gain 0.75  pan  0.2   room 0.15
part  shaker   shaker      gain 0.60  pan -0.25  room 0.10

# The tune alone with the keys.
section first
chords   Fmaj9 | Em7b5 A7 | Dm9 | Cm9 F13 | Bbmaj9 | Am7 Dm7 | Gm9 | C9sus4 C7
melody   c5 - - a4 c5 - e5 - | d5 - - - c#5 - a4 - | f5 - e5 - c5 - a4 - | bb4 - - c5 a4 - - . | d5 - - c5 d5 - f5 - | e5 - - d5 c5 - a4 - | bb4 - d5 - a5! - g5 - | f5 - - - e5 - - .
keys     x - - x? - - x - | x - - x? x - - x?
bass     1 - - 5 1 - 5? - | 1 - - 5 1 - - 5?
shaker   x? x? x x? x? x? x x?
kick     x . . x? x . . .

# The middle: the bars sing, the flute answers.
section middle
chords   Bbmaj9 | Bbm6 | Am7 | D7b9 | Gm9 | C13 | Fmaj9 | Cm9 F13
bars     f5 - - g5 a5 - - g5 | g5 - f5 - c#5 - - f5 | e5 - - c5 e5 - g5 - | f#5 - - eb5 d5 - c5 - | d5 - - bb4 d5 - f5 - | e5 - - d5 a4 - bb4 - | g4 - a4 - c5 - - - | eb5 - d5 - c5 - a4 -
melody   . . . . . . . . | . . . . . . bb4 - | c5 - - - . . . . | . . . . . . . . | . . . . . . . . | . . . . . . e5 - | g5 - - - e5 - c5 - | . . . . . . . .
keys     . x - . x? - . x? | x - . x? - . x -
strings  x - - - - - - -
bass     1 - - 5 8 - 5 - | 1 - - 5 1 - 3 5?
kick     x . . x? x . . .
rim      . . . g5 . . g5? . | . . g5 . . g5? . .
brush    . . x . . . x .
shaker   x? x? x x? x? x? x x?

# The tune with the band, the bars a little above it, and an ending that closes.
section last like first
chords   Fmaj9 | Em7b5 A7 | Dm9 | Cm9 F13 | Bbmaj9 | Am7 Dm7 | Gm9 C13 | F69
melody   c5 - - a4 c5 - e5 - | d5 - - - c#5 - a4 - | f5 - e5 - c5 - a4 - | bb4 - - c5 a4 - - . | d5 - - c5 d5 - f5 - | e5 - - d5 c5 - a4 - | bb4 - d5 - a4 - g4 - | g4 - a4 - - - . .
strings  x - - - - - - -
rim      . . . g5 . . g5? . | . . g5 . . g5? . .
brush    . . x . . . x .
bars     v2' . v3' . v4' . v3' . | v4' . v2' . v3' . v1' . | v2' . v3' . v4' . v3' . | v4' . v3' . v2' . v1' . | v1' . v2' . v3' . v4' . | v4' . v3' . v2' . v3' . | v1' . v3' . v2' . v4' . | c6? - - - a5? - g5? -
keys     . x - . x? - . x? | x - . x? - . x -

# Once more the middle, one step on, and home by way of the dominant.
section bridge like middle
chords   Bbmaj9 | Bbm6 | Am7 | Dm9 | Gm9 | Gm7/C | C9sus4 | C7b9
bars     d5 - f5 - c6 - a5 - | g5 - f5 - c#5 - - - | c5 - e5 - g5 - e5 - | f5 - - - e5 - a4 - | d5 - bb4 - d5 - a5 - | g5 - - f5 d5 - - - | f5 - - - d5 - c5 - | c#5 - - - bb4 - g4 -
melody   . . . . . . . . | . . . . bb5 - g5 - | . . . . . . . . | . . . . . . . . | . . . . . . . . | . . . . . . . . | . . bb4 - a4 - g4 - | e4 - - - - - . .
strings_too . . . . . . . . | % | % | % | c5 - - - - - - - | c5 - - - - - - - | d5 - - - - - - - | c#5 - - - - - - -

order    first middle last bridge
)";

/// A stride in G, with a middle that climbs from C and one that borrows Eb and F from the minor.
constexpr std::string_view lively = R"(
title   Up the scaffolding
tempo   138
swing   0.58

part  melody   reed        gain 0.34  pan -0.10  room 0.20
part  double   marimba     gain 0.30  pan  0.25  room 0.20
part  answer   bell        gain 0.40  pan  0.35  room 0.35
part  horns    brass       gain 0.17  pan -0.25  room 0.25
part  strum    ukulele     gain 0.32  pan  0.30  room 0.12
part  comp     piano       gain 0.18  pan -0.30  room 0.15
part  strings  pad         gain 0.13  pan  0     room 0.40
part  bass     bass        gain 0.46  pan  0     room 0.04
part  kick     kick        gain 0.60  pan  0     room 0.03
part  snare    snare       gain 0.70  pan  0.05  room 0.15
part  clap     clap        gain 0.60  pan -0.1   room 0.20
part  hat      hat         gain 0.90  pan  0.25  room 0.06
part  ride     ride        gain 0.40  pan -0.3   room 0.10
part  open     open_hat    gain 0.45  pan  0.25  room 0.10

section first
chords   G6 | B7 | Em7 | Dm7 G7 | Cmaj7 | Cm6 | G6 Em7 | Am7 D7
melody   d5! . d5 e5 . d5 b4 - | d#5 - f#5 . a5 - f#5 . | g5! - - e5 . e5 g5 . | a5 . g5 f5 - . d5 . | e5! - . g5 - . e5 - | eb5 - . c5 a4 - c5 . | b4 . d5 . e5 . g5 . | a5! - . g5 f#5 . d5 .
strum    . x . x . x . x | . x . x x? x . x
bass     1 . 5 . 1 . 5 . | 1 . 5 . 1 . 3 5
kick     x . . . x . . x? | x . . . x . x? .
snare    . . x . . . x . | . . x . . . x x?
hat      x? x x? x x? x x? x

# The tune doubled, and closed.
section second like first
chords   G6 | B7 | Em7 | Dm7 G7 | Cmaj7 Cm6 | G6 Em7 | Am7 D7 | G6
melody   d5! . d5 e5 . d5 b4 - | d#5 - f#5 . a5 - f#5 . | g5! - - e5 . e5 g5 . | a5 . g5 f5 - . d5 . | e5! . g5 . eb5 . c5 . | b4 . d5 . e5 . g5 . | a5 . c6 b5 . a5 f#5 . | g5! - . d5 g5! . . .
double   d5 . d5 e5 . d5 b4 . | d#5 . f#5 . a5 . f#5 . | g5 . . e5 . e5 g5 . | a5 . g5 f5 . . d5 . | e5 . g5 . eb5 . c5 . | b4 . d5 . e5 . g5 . | a5 . c6 b5 . a5 f#5 . | g5 . . d5 g5 . . .
answer   . . . . . . . . | % | . . . . . . . . | % | % | % | % | . . . . . b5? d6? g6?
clap     . . x . . . x .

# Up from C by steps; the horns carry it.
section climb
chords   Cmaj7 | D6 | Bm7 | Em7 | Cmaj7 | D7 | G6 | Dm7 G7
melody   e5 - - g5 - - a5 . | a5! - - f#5 - - d5 . | d5 - - f#5 - - a5 . | g5! - - b5 - - - . | c6! - - b5 - - g5 . | a5 - - f#5 - - e5 f#5 | g5! - - d5 - - e5 . | f5 - - d5 - - b4 .
answer   . . . . . . . . | . . . . . . a5? d6? | . . . . . . . . | . . . . e6? d6? b5? g5? | . . . . . . . . | % | . . . . d6? b5? g5? . | . . . . . . . .
horns    x - - x - - . . | x - - x - - . .
strings  x - - - - - - -
strum    . x . x . x . x | . x . x x? x . x
bass     1 . . 1 . . 5 . | 1 . . 1 . . 5 3
kick     x . . x . . x . 
snare    . . x . . . x . | . . x . . . x x?
ride     x x? x x? x x? x x?

# Borrowed chords: Eb and F, and G as if nothing had happened.
section lookout
chords   Ebmaj7 | F6 | G6 | G6 | Ebmaj7 | F6 | D7sus4 | D7
melody   g5! - bb5 - d6 - bb5 - | c6! - a5 - f5 - a5 - | b5! - - g5 d5 - e5 . | g5 - - - . . . . | bb5! - g5 - eb5 - g5 - | a5! - c6 - a5 - f5 - | g5 - a5 - g5 - e5 . | f#5! - - a5 - - d5 .
double   eb5 . g5 . bb5 . g5 . | a5 . f5 . c5 . f5 . | g5 . . d5 b4 . b4 . | d5 b4 g4 b4 d5 g5 b5 d6 | g5 . eb5 . bb4 . eb5 . | f5 . a5 . f5 . c5 . | . . . . . . . . | a4 . d5 . f#5 . a5 .
horns    x! - - - - - - . | x! - - - - - - . | x! - . x - . x . | . . . . . . . .  | x! - - - - - - . | x! - - - - - - . | x - - . x - - . | x! . . x! . . x! .
strings  x - - - - - - -
comp     . x . x . x . x
bass     1 . 1 . 5 . 8 . | 1 . 1 . 5 . 8 5 | 1 . 5 . 8 . 5 . | 1 . 5 . 3 . 2 .
kick     x . . . x . . . 
snare    . . x . . . x . | . . x . . . x . | . . x . . . x . | . . x . . x x x | . . x . . . x . | % | % | x? x? x x? x x x! x!
hat      x x? x x? x x? x x?
open     . . . . . . . . | . . . . . . . x

# All of them, for the last time.
section last like second
comp     . x . x . x . x
horns    . . . . . . . . | . . . . x? - x? . | . . . . . . . . | . . . . x? - x? . | x - . . x - . . | . . . . . . . . | x - . . x - . . | x! . . x! x! . . .
answer   . . . . . . b5? d6? | . . . . . . . . | . . . . . . e6? b5? | . . . . . . . . | . . . . . . . . | % | % | . . . . . d6? b5? g5?
open     . . . . . . . x
bass     1 . 5 . 1 . 5 . | 1 . 5 . 1 . 3 5 | 1 . 5 . 1 . 5 . | 1 . 5 . 1 . 5 . | 1 . 5 . 1 . 5 . | 1 . 5 . 1 . 5 . | 1 . 5 . 1 . 5 . | 1 . . 5 8 . 5 3

order    first second climb lookout last
)";

constexpr std::array<std::string_view, piece_count> texts{calm, lively};
constexpr std::array<std::string_view, piece_count> names{"calm", "lively"};

Score read(Piece piece) {
    Expected<Score> score = read_score(text_of(piece));
    assert(score && "a piece of our own is written wrongly");
    return score ? *std::move(score) : Score{};
}

}  // namespace

std::string_view name_of(Piece piece) {
    return names[static_cast<std::size_t>(piece)];
}

std::string_view text_of(Piece piece) {
    return texts[static_cast<std::size_t>(piece)];
}

const Score& score_of(Piece piece) {
    static const std::array<Score, piece_count> scores{read(Piece::calm), read(Piece::lively)};
    return scores[static_cast<std::size_t>(piece)];
}

}  // namespace surefoot::sound
