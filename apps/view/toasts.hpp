/// Messages that appear at the lower edge and go by themselves.
#pragma once

#include <string>
#include <vector>

namespace surefoot::view {

class Toasts {
public:
    enum class Kind { news, warning };

    void say(std::string text, Kind kind = Kind::news);
    void warn(std::string text) { say(std::move(text), Kind::warning); }

    /// Lets `dt` seconds pass; true while there is anything to be seen.
    bool update(double dt);
    /// `free` at the lower edge is somebody else's [window units].
    void draw(double free = 0) const;

    /// Those that are shown, oldest first.
    [[nodiscard]] std::vector<std::string> texts() const;

private:
    struct Toast {
        std::string text;
        Kind kind;
        double age = 0;
        double life = 4;
    };
    std::vector<Toast> toasts_;
};

}  // namespace surefoot::view
