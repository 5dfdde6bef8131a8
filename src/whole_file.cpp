#include <surefoot/whole_file.hpp>

#include "platform/atomic_file.hpp"

namespace surefoot {
inline namespace v0 {

Expected<void> write_whole_file(const std::string& path, std::span<const std::byte> bytes) {
    auto file = internal::AtomicFile::create(path);
    if (!file) return tl::unexpected(file.error());
    if (auto written = file->write(bytes); !written) return written;
    return file->commit();
}

}  // namespace v0
}  // namespace surefoot
