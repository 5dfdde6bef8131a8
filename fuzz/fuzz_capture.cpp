// Any bytes as a saved moment: reading says yes or why not, and what was read is written, read and replayed to the
// same.
#include <array>
#include <string>

#include "bytes.hpp"

namespace {

using namespace fuzz;

// Bodies that turn are asked in thousands of pieces; many triangles in each would only look like a hang.
constexpr std::size_t most_triangles = 64;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto capture = surefoot::parse_capture({reinterpret_cast<const char*>(data), size}, "moment.json");
    if (!capture) {
        require(!capture.error().text.empty(), "an error says what is wrong");
        require(capture.error().byte <= size, "an error says where");
        return 0;
    }
    const std::string text = surefoot::capture_text(*capture);
    const auto again = surefoot::parse_capture(text);
    require(again.has_value(), "what is written can be read");
    require(surefoot::capture_text(*again) == text, "what is read is what was written");
    static_cast<void>(surefoot::capture_cpp_test(*capture));
    if (capture->triangles.size() > most_triangles) return 0;
    std::array<surefoot::TraceRecord, 64> room;
    surefoot::Trace trace(room);
    const surefoot::Replay first = surefoot::replay(*capture, &trace);
    const surefoot::Replay second = surefoot::replay(*again);
    require(!surefoot::difference_of(first.answer, second.answer).any(), "a replay depends on the capture alone");
    return 0;
}
