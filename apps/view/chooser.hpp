/// A dialog that lets the user take one of several things.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace surefoot::view {

class Chooser {
public:
    using Chosen = std::function<void(const std::string& name)>;

    void open(std::string title, std::vector<std::string> names, Chosen chosen);
    void close();
    [[nodiscard]] bool is_open() const { return !names_.empty(); }

    /// The widgets; calls `chosen` when a name is.
    void draw();

private:
    std::string title_;
    std::vector<std::string> names_;
    std::string sought_;
    Chosen chosen_;
};

}  // namespace surefoot::view
