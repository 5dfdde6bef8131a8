// A writer of JSON: pieces of text one after the other, and the parts that several forms share.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <surefoot/capture.hpp>

#include "capture/number.hpp"

namespace surefoot::internal {

class Writer {
public:
    [[nodiscard]] std::string take() { return std::move(out_); }
    void word(std::string_view text) { out_ += text; }
    void number(std::uint32_t value) { append_shortest(out_, value); }
    void number(double value);
    template <typename... Numbers>
    void list(double first, Numbers... rest) {
        out_ += '[';
        number(first);
        ((out_ += ", ", number(rest)), ...);
        out_ += ']';
    }
    void list(const dvec3& v) { list(v.x, v.y, v.z); }
    void list(const dquat& q) { list(q.w, q.x, q.y, q.z); }
    /// In quotes, 16 hexadecimal digits.
    void bits(std::uint64_t value) {
        out_ += '"';
        append_bits(out_, value);
        out_ += '"';
    }
    void yes(bool value) { out_ += value ? "true" : "false"; }
    /// In quotes. What is no UTF-8 becomes question marks, so that the file is JSON for everyone.
    void text(std::string_view text);

private:
    std::string out_;
};

void write_volume(Writer& w, const Volume& volume, std::string_view between);
void write_body(Writer& w, const CapturedBody& body);
void write_triangle(Writer& w, const CapturedTriangle& one);
void write_pose(Writer& w, const Pose& pose);
/// Which body, and where it goes in a tick: the fields, without the braces around them.
void write_poses(Writer& w, std::uint32_t body, const Pose& start, const Pose& end);

/// The members that say what the file is and what wrote it, and the note.
void write_origin(Writer& w, std::string_view kind, std::uint32_t form, const CaptureOrigin& origin,
                  std::string_view note);

/// Replaces the file in one step.
[[nodiscard]] Expected<void> write_text(std::string_view text, const std::string& path);

/// One a line.
template <typename T, typename Write>
void write_list(Writer& w, std::string_view name, const std::vector<T>& list, const Write& write) {
    w.word("  \"");
    w.word(name);
    w.word("\": [");
    for (const T& one : list) {
        w.word(&one == list.data() ? "\n    " : ",\n    ");
        write(w, one);
    }
    w.word(list.empty() ? "]" : "\n  ]");
}

}  // namespace surefoot::internal
