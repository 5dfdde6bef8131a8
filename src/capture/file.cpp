#include <surefoot/capture.hpp>

#include "platform/atomic_file.hpp"
#include "platform/bytes.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

Expected<void> write_capture(const Capture& capture, const std::string& path) {
    const std::string text = capture_text(capture);
    auto file = AtomicFile::create(path);
    if (!file) return tl::unexpected(file.error());
    if (auto written = file->write(std::as_bytes(std::span(text))); !written) return written;
    return file->commit();
}

Expected<Capture> read_capture(const std::string& path) {
    const auto owned = OwnedBytes::read(path);
    if (!owned) return tl::unexpected(owned.error());
    const auto bytes = owned->bytes();
    return parse_capture({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path);
}

}  // namespace v0
}  // namespace surefoot
