/// One program at a time at a file that several of them read, change and write.
#pragma once

#include <string>

namespace surefoot::game {

/// Held while it lives. Waits for whoever holds it, but not for ever: one that a program left behind when it was killed
/// is taken away, and where none can be made (a folder that may not be written to) there is none.
class FileLock {
public:
    explicit FileLock(const std::string& path);
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

    [[nodiscard]] bool is_held() const { return held_; }

private:
    std::string lock_;
    bool held_ = false;
};

}  // namespace surefoot::game
