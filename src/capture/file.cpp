#include <surefoot/capture.hpp>
#include <surefoot/whole_file.hpp>

#include "capture/writer.hpp"
#include "platform/bytes.hpp"

namespace surefoot {

namespace internal {

Expected<void> write_text(std::string_view text, const std::string& path) {
    return write_whole_file(path, std::as_bytes(std::span(text)));
}

}  // namespace internal

inline namespace v0 {

using namespace internal;

Expected<void> write_capture(const Capture& capture, const std::string& path) {
    return write_text(capture_text(capture), path);
}

Expected<Capture> read_capture(const std::string& path) {
    const auto owned = OwnedBytes::read(path);
    if (!owned) return tl::unexpected(owned.error());
    const auto bytes = owned->bytes();
    return parse_capture({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path);
}

}  // namespace v0
}  // namespace surefoot
