// The platform on Linux, macOS and other POSIX systems.
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

#include "platform/atomic_file.hpp"
#include "platform/bytes.hpp"
#include "platform/folders.hpp"
#include "platform/memory.hpp"

namespace surefoot::internal {
namespace {

class Descriptor {
public:
    explicit Descriptor(int number) noexcept : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&&) = delete;
    [[nodiscard]] int get() const noexcept { return number_; }

private:
    int number_;
};

struct OpenFile {
    Descriptor descriptor;
    std::size_t size;
};

Error read_error(ErrorCode code, const std::string& path, const std::string& why) {
    return {code, path + ": " + why, path, 0};
}

Expected<OpenFile> open_to_read(const std::string& path) {
    // Without O_NONBLOCK, opening a pipe would wait for a writer.
    Descriptor descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (descriptor.get() < 0) {
        return tl::unexpected(
            read_error(ErrorCode::not_found, path, std::string("cannot be read: ") + std::strerror(errno)));
    }
    struct stat status {};
    if (::fstat(descriptor.get(), &status) != 0 || !S_ISREG(status.st_mode))
        return tl::unexpected(read_error(ErrorCode::unreadable, path, "is not a plain file: name one"));
    if (status.st_size <= 0) {
        return tl::unexpected(
            read_error(ErrorCode::unreadable, path, "is empty: whatever wrote it did not finish, so make it again"));
    }
    return OpenFile{std::move(descriptor), static_cast<std::size_t>(status.st_size)};
}

Expected<std::span<const std::byte>> map(const std::string& path, int protection, int sharing) {
    const auto file = open_to_read(path);
    if (!file) return tl::unexpected(file.error());
    void* const memory = ::mmap(nullptr, file->size, protection, sharing, file->descriptor.get(), 0);
    if (memory == MAP_FAILED) {
        return tl::unexpected(
            read_error(ErrorCode::unreadable, path, std::string("cannot be mapped: ") + std::strerror(errno)));
    }
    return std::span{static_cast<const std::byte*>(memory), file->size};
}

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    if (slash == std::string::npos) return ".";
    return slash == 0 ? "/" : path.substr(0, slash);
}

bool is_absolute(const char* path) {
    return path != nullptr && path[0] == '/';
}

}  // namespace

Expected<MappedFile> MappedFile::open(const std::string& path) {
    auto memory = map(path, PROT_READ, MAP_SHARED);
    if (!memory) return tl::unexpected(std::move(memory.error()));
    return MappedFile(*memory);
}

Expected<MappedFile> MappedFile::open_private(const std::string& path) {
    auto memory = map(path, PROT_READ | PROT_WRITE, MAP_PRIVATE);
    if (!memory) return tl::unexpected(std::move(memory.error()));
    return MappedFile(*memory);
}

void unmap(std::span<const std::byte> bytes) noexcept {
    ::munmap(const_cast<std::byte*>(bytes.data()), bytes.size());
}

void advise_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t size) noexcept {
#ifdef MADV_HUGEPAGE
    if (alignment_for(size) > OwnedBytes::alignment) ::madvise(memory, size, MADV_HUGEPAGE);
#endif
}

Expected<OwnedBytes> OwnedBytes::read(const std::string& path) {
    const auto file = open_to_read(path);
    if (!file) return tl::unexpected(file.error());
    OwnedBytes owned = allocate(file->size);
    if (owned.bytes().empty()) {
        return tl::unexpected(read_error(ErrorCode::out_of_memory, path,
                                         "does not fit into memory: map it (Mesh::open) instead of reading it"));
    }
    std::span<std::byte> rest = owned.writable();
    while (!rest.empty()) {
        const ssize_t count = ::read(file->descriptor.get(), rest.data(), rest.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) {
            Error error = read_error(ErrorCode::unreadable, path,
                                     count == 0 ? std::string("was cut short while it was read: read it again")
                                                : std::string("cannot be read: ") + std::strerror(errno));
            error.byte = file->size - rest.size();
            return tl::unexpected(std::move(error));
        }
        rest = rest.subspan(static_cast<std::size_t>(count));
    }
    return owned;
}

Expected<AtomicFile> AtomicFile::create(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
        return tl::unexpected(write_error(path, "replacing it", "it is not a plain file"));
    constexpr int attempts = 100;
    constexpr mode_t everyone_may_read_and_write = 0666;  // less what the user's umask takes away
    int system_error = 0;
    for (int i = 0; i < attempts; ++i) {
        std::string temporary = temporary_name(path, static_cast<std::uint64_t>(::getpid()));
        const int handle =
            ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, everyone_may_read_and_write);
        if (handle >= 0) return AtomicFile(path, std::move(temporary), handle);
        system_error = errno;
        if (system_error != EEXIST) break;
    }
    return tl::unexpected(write_error(path, "making a file beside it", std::strerror(system_error)));
}

AtomicFile::~AtomicFile() {
    close();
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::close() noexcept {
    if (handle_ >= 0) ::close(static_cast<int>(std::exchange(handle_, -1)));
}

tl::unexpected<Error> AtomicFile::failure(const char* doing, int system_error) const {
    return tl::unexpected(write_error(path_, doing, std::strerror(system_error)));
}

Expected<void> AtomicFile::write(std::span<const std::byte> bytes) {
    constexpr std::size_t most_at_once = std::size_t{1} << 30U;  // some systems take no more in one call
    while (!bytes.empty()) {
        const ssize_t count =
            ::write(static_cast<int>(handle_), bytes.data(), bytes.size() < most_at_once ? bytes.size() : most_at_once);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return failure("writing", count < 0 ? errno : ENOSPC);
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return {};
}

Expected<void> AtomicFile::commit() {
    // The bytes first, then the name: after a power cut the name must not lead to a file without its bytes.
    if (::fsync(static_cast<int>(handle_)) != 0) return failure("bringing it to the disk", errno);
    if (::close(static_cast<int>(std::exchange(handle_, -1))) != 0) return failure("closing", errno);
    if (::rename(temporary_.c_str(), path_.c_str()) != 0) return failure("renaming", errno);
    temporary_.clear();
    // Not every file system can do this, and the file is already there, whole: so its result decides nothing.
    const Descriptor folder(::open(folder_of(path_).c_str(), O_RDONLY | O_CLOEXEC));
    if (folder.get() >= 0) ::fsync(folder.get());
    return {};
}

std::string cache_folder() {
    // The XDG base directory specification: relative paths in the variable are to be ignored.
    if (const char* const cache = std::getenv("XDG_CACHE_HOME"); is_absolute(cache))
        return std::string(cache) + "/surefoot";
    if (const char* const home = std::getenv("HOME"); is_absolute(home)) return std::string(home) + "/.cache/surefoot";
    return {};
}

Expected<void> make_folders(const std::string& path) {
    constexpr mode_t only_the_user = 0700;  // as the XDG base directory specification asks
    for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
        const std::string folder = path.substr(0, end);
        if (::mkdir(folder.c_str(), only_the_user) != 0 && errno != EEXIST) {
            const int system_error = errno;
            // A folder above, in which nothing may be made, is fine as long as it is there.
            struct stat status {};
            if (::stat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode))
                return tl::unexpected(write_error(path, "making the folder", std::strerror(system_error)));
        }
        if (end == std::string::npos) return {};
    }
}

}  // namespace surefoot::internal
