#include <surefoot/capture.hpp>
#include <surefoot/whole_file.hpp>

#include "platform/bytes.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

Expected<void> write_capture(const Capture& capture, const std::string& path) {
    const std::string text = capture_text(capture);
    return write_whole_file(path, std::as_bytes(std::span(text)));
}

Expected<Capture> read_capture(const std::string& path) {
    const auto owned = OwnedBytes::read(path);
    if (!owned) return tl::unexpected(owned.error());
    const auto bytes = owned->bytes();
    return parse_capture({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path);
}

}  // namespace v0
}  // namespace surefoot
