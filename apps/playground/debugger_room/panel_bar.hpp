/// The bar of panels: toggles, of which at most one is on, and the panel that is open beneath them.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "playground/debugger_room/panel.hpp"

namespace surefoot::playground {

class PanelBar {
public:
    explicit PanelBar(std::vector<std::unique_ptr<Panel>> panels);

    void enter(Stage& stage);

    /// The question or the answer is another. Panels that are closed are told when they open.
    void changed(const Inquiry& inquiry);

    /// The one that is open, or null.
    [[nodiscard]] Panel* open() const {
        return open_ < 0 ? nullptr : panels_[static_cast<std::size_t>(open_)].panel.get();
    }
    void close() { open_ = -1; }
    /// Opens the panel of this name; nothing happens if there is none.
    void show(std::string_view name, const Inquiry& inquiry);

    /// How wide it is in this window, without its margin [window units].
    [[nodiscard]] double width() const;

    /// True if another panel is open than before. `below` is how much is kept free beneath, in window units.
    bool ui(Inquiry& inquiry, double below);

private:
    struct Entry {
        std::unique_ptr<Panel> panel;
        bool knows = false;  // the question as it is now
    };
    void toggle(int index, const Inquiry& inquiry);

    std::vector<Entry> panels_;
    int open_ = -1;
};

}  // namespace surefoot::playground
