/// A place in a list of things that were done one after the other, which can play from the first to the last.
#pragma once

#include <cstddef>

namespace surefoot::playground {

class OrderCursor {
public:
    /// Another list: all of it is shown.
    void restart(std::size_t count);

    [[nodiscard]] std::size_t count() const { return count_; }

    /// How many of them are shown: the last of these is the one that is looked at; 0 before the first.
    [[nodiscard]] std::size_t shown() const { return shown_; }

    /// Shows so many, at most all, and plays no further.
    void show(std::size_t shown);

    /// From where it is, or from the beginning if all is shown.
    void play();
    void pause() { playing_ = false; }
    [[nodiscard]] bool is_playing() const { return playing_; }

    /// Lets `dt` seconds pass: at least six things a second, and never longer than ten seconds for all.
    bool advance(double dt);

private:
    std::size_t count_ = 0;
    std::size_t shown_ = 0;
    double owed_ = 0;  // of the next thing
    bool playing_ = false;
};

}  // namespace surefoot::playground
