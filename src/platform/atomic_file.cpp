#include "platform/atomic_file.hpp"

#include <atomic>
#include <utility>

namespace surefoot::internal {

AtomicFile::AtomicFile(std::string path, std::string temporary, std::intptr_t handle) noexcept
    : path_(std::move(path)), temporary_(std::move(temporary)), handle_(handle) {}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::exchange(other.temporary_, {})),
      handle_(std::exchange(other.handle_, -1)) {}

std::string temporary_name(const std::string& path, std::uint64_t process) {
    static std::atomic<std::uint64_t> count{0};
    return path + "." + std::to_string(process) + "-" + std::to_string(count.fetch_add(1)) + ".part";
}

Error write_error(const std::string& path, const char* doing, const std::string& reason) {
    return {ErrorCode::write_failed,
            path + ": cannot be written (" + doing + ": " + reason +
                "): see that the folder is there, that you may write to it and that the disk has room; what was there "
                "before is still there",
            path, 0};
}

}  // namespace surefoot::internal
