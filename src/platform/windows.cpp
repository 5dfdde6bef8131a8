// The platform on Windows. Paths are UTF-8 outside and UTF-16 inside.
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <string>
#include <utility>
#include <windows.h>

#include "platform/atomic_file.hpp"
#include "platform/bytes.hpp"
#include "platform/folders.hpp"
#include "platform/memory.hpp"

namespace surefoot::internal {
namespace {

std::wstring wide(const std::string& text) {
    const int size = MultiByteToWideChar(CP_UTF8, 0, text.data(), static_cast<int>(text.size()), nullptr, 0);
    std::wstring out(static_cast<std::size_t>(size), L'\0');
    MultiByteToWideChar(CP_UTF8, 0, text.data(), static_cast<int>(text.size()), out.data(), size);
    return out;
}

std::string narrow(const std::wstring& text) {
    const int length = static_cast<int>(text.size());
    const int size = WideCharToMultiByte(CP_UTF8, 0, text.data(), length, nullptr, 0, nullptr, nullptr);
    std::string out(static_cast<std::size_t>(size), '\0');
    WideCharToMultiByte(CP_UTF8, 0, text.data(), length, out.data(), size, nullptr, nullptr);
    return out;
}

std::string reason_of(DWORD system_error) {
    wchar_t text[256];
    DWORD length = FormatMessageW(FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS, nullptr, system_error, 0,
                                  text, 256, nullptr);
    while (length > 0 && (text[length - 1] == L'\n' || text[length - 1] == L'\r' || text[length - 1] == L'.')) --length;
    return length > 0 ? narrow({text, length}) : "system error " + std::to_string(system_error);
}

class Handle {
public:
    explicit Handle(HANDLE handle) noexcept : handle_(handle) {}
    ~Handle() {
        if (is_open()) CloseHandle(handle_);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    Handle(Handle&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    Handle& operator=(Handle&&) = delete;
    [[nodiscard]] HANDLE get() const noexcept { return handle_; }
    [[nodiscard]] bool is_open() const noexcept { return handle_ != nullptr && handle_ != INVALID_HANDLE_VALUE; }

private:
    HANDLE handle_;
};

struct OpenFile {
    Handle handle;
    std::size_t size;
};

Error read_error(ErrorCode code, const std::string& path, const std::string& why) {
    return {code, path + ": " + why, path, 0};
}

Expected<OpenFile> open_to_read(const std::string& path) {
    Handle handle(CreateFileW(wide(path).c_str(), GENERIC_READ, FILE_SHARE_READ | FILE_SHARE_DELETE, nullptr,
                              OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr));
    if (!handle.is_open()) {
        return tl::unexpected(read_error(ErrorCode::not_found, path, "cannot be read: " + reason_of(GetLastError())));
    }
    LARGE_INTEGER size{};
    if (GetFileType(handle.get()) != FILE_TYPE_DISK || GetFileSizeEx(handle.get(), &size) == 0)
        return tl::unexpected(read_error(ErrorCode::unreadable, path, "is not a plain file: name one"));
    if (size.QuadPart <= 0) {
        return tl::unexpected(
            read_error(ErrorCode::unreadable, path, "is empty: whatever wrote it did not finish, so make it again"));
    }
    return OpenFile{std::move(handle), static_cast<std::size_t>(size.QuadPart)};
}

Expected<std::span<const std::byte>> map(const std::string& path, DWORD protection, DWORD access) {
    const auto file = open_to_read(path);
    if (!file) return tl::unexpected(file.error());
    const Handle mapping(CreateFileMappingW(file->handle.get(), nullptr, protection, 0, 0, nullptr));
    const void* const memory = mapping.is_open() ? MapViewOfFile(mapping.get(), access, 0, 0, 0) : nullptr;
    if (memory == nullptr) {
        return tl::unexpected(
            read_error(ErrorCode::unreadable, path, "cannot be mapped: " + reason_of(GetLastError())));
    }
    return std::span{static_cast<const std::byte*>(memory), file->size};
}

bool is_folder(const std::string& path) {
    const DWORD attributes = GetFileAttributesW(wide(path).c_str());
    return attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
}

HANDLE handle_from(std::intptr_t number) {
    return reinterpret_cast<HANDLE>(number);
}

}  // namespace

Expected<MappedFile> MappedFile::open(const std::string& path) {
    auto memory = map(path, PAGE_READONLY, FILE_MAP_READ);
    if (!memory) return tl::unexpected(std::move(memory.error()));
    return MappedFile(*memory);
}

Expected<MappedFile> MappedFile::open_private(const std::string& path) {
    auto memory = map(path, PAGE_WRITECOPY, FILE_MAP_COPY);
    if (!memory) return tl::unexpected(std::move(memory.error()));
    return MappedFile(*memory);
}

void unmap(std::span<const std::byte> bytes) noexcept {
    UnmapViewOfFile(bytes.data());
}

// Large pages need a privilege here that games do not have.
void advise_huge_pages(void*, std::size_t) noexcept {}

Expected<OwnedBytes> OwnedBytes::read(const std::string& path) {
    const auto file = open_to_read(path);
    if (!file) return tl::unexpected(file.error());
    OwnedBytes owned = allocate(file->size);
    if (owned.bytes().empty()) {
        return tl::unexpected(read_error(ErrorCode::out_of_memory, path,
                                         "does not fit into memory: map it (Mesh::open) instead of reading it"));
    }
    std::span<std::byte> rest = owned.writable();
    constexpr std::size_t most_at_once = std::size_t{1} << 30U;
    while (!rest.empty()) {
        DWORD count = 0;
        const auto want = static_cast<DWORD>(rest.size() < most_at_once ? rest.size() : most_at_once);
        if (ReadFile(file->handle.get(), rest.data(), want, &count, nullptr) == 0 || count == 0) {
            Error error = read_error(ErrorCode::unreadable, path, "cannot be read: " + reason_of(GetLastError()));
            error.byte = file->size - rest.size();
            return tl::unexpected(std::move(error));
        }
        rest = rest.subspan(count);
    }
    return owned;
}

Expected<AtomicFile> AtomicFile::create(const std::string& path) {
    if (is_folder(path)) return tl::unexpected(write_error(path, "replacing it", "it is a folder"));
    constexpr int attempts = 100;
    DWORD system_error = 0;
    for (int i = 0; i < attempts; ++i) {
        std::string temporary = temporary_name(path, GetCurrentProcessId());
        HANDLE handle =
            CreateFileW(wide(temporary).c_str(), GENERIC_WRITE, 0, nullptr, CREATE_NEW, FILE_ATTRIBUTE_NORMAL, nullptr);
        if (handle != INVALID_HANDLE_VALUE)
            return AtomicFile(path, std::move(temporary), reinterpret_cast<std::intptr_t>(handle));
        system_error = GetLastError();
        if (system_error != ERROR_FILE_EXISTS) break;
    }
    return tl::unexpected(write_error(path, "making a file beside it", reason_of(system_error)));
}

AtomicFile::~AtomicFile() {
    close();
    if (!temporary_.empty()) DeleteFileW(wide(temporary_).c_str());
}

void AtomicFile::close() noexcept {
    if (handle_ != -1) CloseHandle(handle_from(std::exchange(handle_, -1)));
}

tl::unexpected<Error> AtomicFile::failure(const char* doing, int system_error) const {
    return tl::unexpected(write_error(path_, doing, reason_of(static_cast<DWORD>(system_error))));
}

Expected<void> AtomicFile::write(std::span<const std::byte> bytes) {
    constexpr std::size_t most_at_once = std::size_t{1} << 30U;
    while (!bytes.empty()) {
        DWORD count = 0;
        const auto want = static_cast<DWORD>(bytes.size() < most_at_once ? bytes.size() : most_at_once);
        if (WriteFile(handle_from(handle_), bytes.data(), want, &count, nullptr) == 0)
            return failure("writing", static_cast<int>(GetLastError()));
        bytes = bytes.subspan(count);
    }
    return {};
}

Expected<void> AtomicFile::commit() {
    if (FlushFileBuffers(handle_from(handle_)) == 0)
        return failure("bringing it to the disk", static_cast<int>(GetLastError()));
    close();
    if (MoveFileExW(wide(temporary_).c_str(), wide(path_).c_str(),
                    MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) == 0)
        return failure("renaming", static_cast<int>(GetLastError()));
    temporary_.clear();
    return {};
}

std::string cache_folder() {
    wchar_t folder[MAX_PATH];
    const DWORD length = GetEnvironmentVariableW(L"LOCALAPPDATA", folder, MAX_PATH);
    if (length == 0 || length >= MAX_PATH) return {};
    return narrow({folder, length}) + "\\surefoot";
}

Expected<void> make_folders(const std::string& path) {
    for (std::size_t end = path.find_first_of("/\\", 3);; end = path.find_first_of("/\\", end + 1)) {
        const std::string folder = path.substr(0, end);
        if (CreateDirectoryW(wide(folder).c_str(), nullptr) == 0) {
            const DWORD system_error = GetLastError();
            if (!is_folder(folder))
                return tl::unexpected(write_error(path, "making the folder", reason_of(system_error)));
        }
        if (end == std::string::npos) return {};
    }
}

}  // namespace surefoot::internal
