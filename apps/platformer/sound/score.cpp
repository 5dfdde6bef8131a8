#include "platformer/sound/score.hpp"

#include <algorithm>
#include <array>
#include <locale>
#include <map>
#include <optional>
#include <sstream>

#include "platformer/sound/chord.hpp"
#include "platformer/sound/random.hpp"

namespace surefoot::sound {

namespace {

using Bar = std::vector<std::string>;

/// The bars of one part, or of the chords, in one section.
struct Line {
    int number = 0;  ///< where it stands in the text
    std::vector<Bar> bars;
};

struct Section {
    std::map<std::string, Line, std::less<>> lines;  ///< by the names of the parts; "chords" are the chords
};

/// A chord, from a beat of the section on.
struct Placed {
    double beat;
    Chord chord;
    Voicing voicing;
};

/// Thrown within this file alone: whoever reads a line need not pass its failure on by hand.
struct Misread {
    int line;
    std::string what;
};

double number_in(const std::string& word, int line) {
    std::istringstream in(word);
    in.imbue(std::locale::classic());
    double value = 0;
    if (!(in >> value) || !in.eof()) throw Misread{line, "\"" + word + "\" is not a number"};
    return value;
}

std::vector<Bar> bars_in(std::istringstream& words, int number) {
    std::vector<Bar> bars(1);
    for (std::string word; words >> word;) {
        if (word == "|") {
            bars.emplace_back();
        } else {
            bars.back().push_back(word);
        }
    }
    for (std::size_t i = 0; i < bars.size(); ++i) {
        if (bars[i].empty()) throw Misread{number, "bar " + std::to_string(i + 1) + " is empty; a rest is a dot"};
        if (bars[i].size() == 1 && bars[i][0] == "%") {
            if (i == 0) throw Misread{number, "there is no bar before the first for % to repeat"};
            bars[i] = bars[i - 1];
        }
    }
    return bars;
}

class Reader {
public:
    Score read(std::string_view text) {
        std::istringstream in{std::string(text)};
        std::string line;
        for (int number = 1; std::getline(in, line); ++number) {
            std::istringstream words(line);
            std::string first;
            if (words >> first && first[0] != '#') take(first, words, number);
        }
        if (order_.empty()) throw Misread{0, "no line says in which order the sections are played"};
        for (const std::string& name : order_) play_section(sections_.find(name)->second);
        score_.length = beat_ * 60 / tempo_;
        std::stable_sort(score_.notes.begin(), score_.notes.end(),
                         [](const Note& a, const Note& b) { return a.start < b.start; });
        return std::move(score_);
    }

private:
    void take(const std::string& first, std::istringstream& words, int number) {
        std::string word;
        if (first == "title") {
            std::getline(words >> std::ws, score_.title);
        } else if (first == "tempo" || first == "swing") {
            words >> word;
            const double value = number_in(word, number), low = first == "tempo" ? 20 : 0.3;
            const double high = first == "tempo" ? 300 : 0.8;
            if (!(value >= low && value <= high)) throw Misread{number, word + " is out of range for the " + first};
            (first == "tempo" ? tempo_ : swing_) = value;
        } else if (first == "part") {
            take_part(words, number);
        } else if (first == "section") {
            words >> word;
            section_ = &sections_[word];
            if (std::string like; words >> like) {
                if (like != "like" || !(words >> like) || !sections_.contains(like)) {
                    throw Misread{number, "what should stand here is: section NAME like NAME OF AN EARLIER ONE"};
                }
                *section_ = sections_[like];
            }
        } else if (first == "order") {
            while (words >> word) {
                if (!sections_.contains(word)) throw Misread{number, "there is no section " + word};
                order_.push_back(word);
            }
        } else {
            const bool known = first == "chords" || std::any_of(score_.parts.begin(), score_.parts.end(),
                                                                [&](const Part& part) { return part.name == first; });
            if (!known) throw Misread{number, "there is no part \"" + first + "\""};
            if (section_ == nullptr) throw Misread{number, "notes belong into a section"};
            section_->lines[first] = {number, bars_in(words, number)};
        }
    }

    void take_part(std::istringstream& words, int number) {
        Part part;
        std::string instrument, word, value;
        words >> part.name >> instrument;
        const std::optional<Instrument> found = instrument_named(instrument);
        if (!found) throw Misread{number, "there is no instrument \"" + instrument + "\""};
        part.instrument = *found;
        while (words >> word >> value) {
            double* const field = word == "gain"   ? &part.gain
                                  : word == "pan"  ? &part.pan
                                  : word == "room" ? &part.room
                                                   : nullptr;
            if (field == nullptr) throw Misread{number, "a part has gain, pan and room, but no " + word};
            *field = number_in(value, number);
        }
        score_.parts.push_back(part);
    }

    void play_section(const Section& section) {
        const auto chords = section.lines.find("chords");
        if (chords == section.lines.end()) throw Misread{0, "a section has no chords"};
        lay_chords(chords->second);
        const std::size_t bars = chords->second.bars.size();
        for (std::size_t part = 0; part < score_.parts.size(); ++part) {
            const auto line = section.lines.find(score_.parts[part].name);
            if (line != section.lines.end()) play_line(part, line->second, bars);
        }
        beat_ += double(bars) * beats_a_bar;
    }

    void lay_chords(const Line& line) {
        placed_.clear();
        for (std::size_t bar = 0; bar < line.bars.size(); ++bar) {
            const Bar& symbols = line.bars[bar];
            for (std::size_t i = 0; i < symbols.size(); ++i) {
                const std::optional<Chord> chord = chord_named(symbols[i]);
                if (!chord) throw Misread{line.number, "\"" + symbols[i] + "\" is no chord that is known"};
                voicing_ = voiced(*chord, voicing_);
                placed_.push_back(
                    {beats_a_bar * (double(bar) + double(i) / double(symbols.size())), *chord, *voicing_});
            }
        }
    }

    /// A part with fewer bars than the section has chords begins again: a drummer needs one bar.
    void play_line(std::size_t part, const Line& line, std::size_t bars) {
        std::vector<std::size_t> held;  // the notes that a - makes longer
        for (std::size_t bar = 0; bar < bars; ++bar) {
            const Bar& signs = line.bars[bar % line.bars.size()];
            const double step = beats_a_bar / double(signs.size());
            for (std::size_t i = 0; i < signs.size(); ++i) {
                const double beat = double(bar) * beats_a_bar + double(i) * step;
                if (signs[i] == "-") {
                    for (const std::size_t note : held) {
                        score_.notes[note].length = seconds(beat + step) - score_.notes[note].start;
                    }
                    continue;
                }
                held.clear();
                if (signs[i] == ".") continue;
                const Instrument instrument = score_.parts[part].instrument;
                double start = seconds(beat);
                for (const double pitch :
                     is_drum(instrument) ? struck(signs[i], line.number) : pitches_of(signs[i], beat, line.number)) {
                    held.push_back(score_.notes.size());
                    score_.notes.push_back(
                        {start, seconds(beat + step) - start, pitch, velocity_of(signs[i], beat), part});
                    if (instrument == Instrument::ukulele) start += 0.011;  // a hand meets the strings one by one
                }
            }
        }
    }

    [[nodiscard]] const Placed& chord_at(double beat) const {
        const Placed* found = &placed_.front();
        for (const Placed& placed : placed_) {
            if (placed.beat <= beat + 1e-9) found = &placed;
        }
        return *found;
    }

    /// A drum knows one sign, and has one pitch.
    [[nodiscard]] static std::vector<double> struck(const std::string& sign, int line) {
        if (sign.substr(0, sign.find_last_not_of("!?") + 1) != "x") {
            throw Misread{line, "\"" + sign + "\" is nothing that a drum could play; a stroke is an x"};
        }
        return {60};
    }

    [[nodiscard]] std::vector<double> pitches_of(std::string sign, double beat, int line) const {
        const std::string whole = sign;
        while (!sign.empty() && (sign.back() == '!' || sign.back() == '?')) sign.pop_back();
        const Placed& now = chord_at(beat);
        double up = 0;
        for (; sign.size() > 1 && sign.back() == '\''; sign.pop_back()) up += 12;
        if (sign == "x") return {now.voicing.begin(), now.voicing.end()};
        if (sign.size() == 2 && sign[0] == 'v' && sign[1] >= '1' && sign[1] <= '4') {
            return {now.voicing[static_cast<std::size_t>(sign[1] - '1')] + up};
        }
        if (sign.size() == 1 && sign[0] >= '1' && sign[0] <= '8') {
            // The root of a bass lies between the low e and the d# above it.
            const int from = sign == "1" ? now.chord.bass : now.chord.root;
            const int root = 28 + (from - 28 % 12 + 12) % 12;
            return {root + (sign == "1" ? 0 : now.chord.degree(sign[0] - '0')) + up};
        }
        return {note_named(sign, whole, line) + up};
    }

    [[nodiscard]] static double note_named(const std::string& sign, const std::string& whole, int line) {
        constexpr std::array<int, 7> classes{9, 11, 0, 2, 4, 5, 7};
        const std::size_t octave = sign.size() == 3 ? 2 : 1;
        const bool fits = (sign.size() == 2 || (sign.size() == 3 && (sign[1] == '#' || sign[1] == 'b'))) &&
                          sign[0] >= 'a' && sign[0] <= 'g' && sign[octave] >= '0' && sign[octave] <= '9';
        if (!fits) throw Misread{line, "\"" + whole + "\" is neither a note nor a sign"};
        const int sharp = sign.size() == 2 ? 0 : sign[1] == '#' ? 1 : -1;
        return 12 * (sign[octave] - '0' + 1) + classes[static_cast<std::size_t>(sign[0] - 'a')] + sharp;
    }

    /// ! is an accent and ? a whisper; the first beat of a bar is a little heavier, and no two notes are alike.
    [[nodiscard]] double velocity_of(const std::string& sign, double beat) {
        const double said = sign.back() == '!' ? 0.92 : sign.back() == '?' ? 0.4 : 0.7;
        const double in_bar = beat - beats_a_bar * double(static_cast<int>(beat / beats_a_bar));
        return said + (in_bar < 1e-9 ? 0.05 : 0) + random_.between(-0.03, 0.03);
    }

    /// When a beat of this section is, in seconds from the beginning: its second half comes late by the swing.
    [[nodiscard]] double seconds(double beat) const {
        const double whole = double(static_cast<int>(beat + 1e-9)), share = std::max(0.0, beat - whole);
        const double swung = share < 0.5 ? 2 * share * swing_ : swing_ + (2 * share - 1) * (1 - swing_);
        return (beat_ + whole + swung) * 60 / tempo_;
    }

    static constexpr double beats_a_bar = 4;

    Score score_;
    double tempo_ = 100;
    double swing_ = 0.5;
    std::map<std::string, Section, std::less<>> sections_;
    Section* section_ = nullptr;
    std::vector<std::string> order_;
    std::vector<Placed> placed_;
    std::optional<Voicing> voicing_;
    double beat_ = 0;  ///< where the section that is being played begins
    Random random_{7};
};

}  // namespace

Expected<Score> read_score(std::string_view text) {
    try {
        return Reader().read(text);
    } catch (const Misread& misread) {
        const std::string where = misread.line > 0 ? "Line " + std::to_string(misread.line) : "As a whole";
        return tl::unexpected(
            Error{ErrorCode::unreadable, where + " of the piece cannot be played: " + misread.what + ".", "", 0});
    }
}

}  // namespace surefoot::sound
