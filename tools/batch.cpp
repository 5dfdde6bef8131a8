#include "batch.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace surefoot::tools {
namespace {

/// Lines from a stream buffer, taken in the pieces in which they arrive.
class Lines {
public:
    explicit Lines(std::streambuf& source) : source_(source) {}

    /// Would the next line have to wait for the other end of a pipe?
    [[nodiscard]] bool dry() { return begin_ == end_ && source_.in_avail() <= 0; }

    /// False at the end of the input. A line that is too long is cut, and `too_long` says so.
    bool next(std::string& line, bool& too_long) {
        line.clear();
        too_long = false;
        bool any = false;
        for (;;) {
            if (begin_ == end_ && !fill()) return any;
            any = true;
            const char* const stop = std::find(begin_, end_, '\n');
            const std::size_t length = static_cast<std::size_t>(stop - begin_);
            const std::size_t room = longest_line - line.size();
            if (length > room) too_long = true;
            line.append(begin_, std::min(length, room));
            begin_ = stop;
            if (stop != end_) {
                ++begin_;
                return true;
            }
        }
    }

private:
    bool fill() {
        if (source_.sgetc() == std::char_traits<char>::eof()) return false;
        const std::streamsize ready = std::clamp<std::streamsize>(source_.in_avail(), 1, sizeof buffer_);
        const std::streamsize taken = source_.sgetn(buffer_, ready);
        begin_ = buffer_;
        end_ = buffer_ + taken;
        return taken > 0;
    }

    std::streambuf& source_;
    char buffer_[1U << 16U];
    const char* begin_ = buffer_;
    const char* end_ = buffer_;
};

void append_line(std::string& out, const Mesh& mesh, const QueryDefaults& defaults, std::string_view line,
                 std::uint64_t number, BatchCount& count) {
    const Parsed<SweepQuery> query = parse_query(line, defaults);
    if (!query) {
        append_error(out, number, query.error());
        ++count.bad;
        return;
    }
    const std::optional<Hit> hit = mesh.sweep(query->volume, query->motion, {.one_sided = query->one_sided});
    if (hit && hit->status != HitStatus::ok) {
        append_error(out, number, "this query is beyond what can be computed, so it counts as blocked");
        ++count.bad;
        return;
    }
    append_answer(out, hit);
}

}  // namespace

BatchCount run_batch(const Mesh& mesh, const QueryDefaults& defaults, std::istream& input, std::FILE* output) {
    constexpr std::size_t flush_at = 1U << 16U;
    BatchCount count;
    Lines lines(*input.rdbuf());
    std::string line;
    std::string out;
    const auto flush = [&] {
        count.written = std::fwrite(out.data(), 1, out.size(), output) == out.size() && std::fflush(output) == 0;
        out.clear();
    };
    for (bool too_long = false; count.written && lines.next(line, too_long);) {
        ++count.lines;
        if (too_long) {
            append_error(out, count.lines, fmt::format("longer than {} bytes", longest_line));
            ++count.bad;
        } else {
            append_line(out, mesh, defaults, line, count.lines, count);
        }
        out += '\n';
        if (out.size() >= flush_at || lines.dry()) flush();
    }
    if (count.written) flush();
    return count;
}

}  // namespace surefoot::tools
