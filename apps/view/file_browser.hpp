/// A dialog of our own for opening a file: folders, files of certain kinds, a path that can be typed.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace surefoot::view {

class FileBrowser {
public:
    using Chosen = std::function<void(const std::string& path)>;

    /// Opens in `folder`, or where it was left if that is empty; shows files whose names end so (lower case, with the
    /// dot).
    void open(std::string title, std::vector<std::string> endings, Chosen chosen, const std::string& folder = {});
    void close() {
        is_open_ = false;
        chosen_ = nullptr;
    }
    [[nodiscard]] bool is_open() const { return is_open_; }

    /// The widgets; calls `chosen` when a file is.
    void draw();

    struct Entry {
        std::string name;
        bool is_folder = false;
        std::uintmax_t size = 0;
    };
    /// Folders before files, each by name; hidden ones are left out.
    [[nodiscard]] static std::vector<Entry> list(const std::string& folder, const std::vector<std::string>& endings);

private:
    void go_to(const std::string& folder);

    bool is_open_ = false;
    std::string title_;
    std::vector<std::string> endings_;
    Chosen chosen_;
    std::string folder_;
    std::string typed_;
    std::vector<Entry> entries_;
};

}  // namespace surefoot::view
