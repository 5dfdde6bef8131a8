/// The answer in words and numbers, why it is so, and what to keep of it.
#pragma once

#include <cstdint>
#include <string>

#include "playground/debugger_room/investigation.hpp"
#include "view/display.hpp"
#include "view/toasts.hpp"

namespace surefoot::playground {

/// "HIT at t = 0.4711, after 3.97 m: an edge of triangle 0."
[[nodiscard]] std::string answer_in_a_line(const Investigation& asked);

class AnswerPanel {
public:
    /// Where moments are saved until the user says otherwise; empty for nowhere.
    explicit AnswerPanel(std::string folder) : folder_(std::move(folder)) {}

    void ui(Investigation& asked, view::Display& display, view::Toasts& toasts);

    /// Writes the moment to where the field says, and tells where.
    void save(const Investigation& asked, view::Toasts& toasts);

private:
    void numbers(Investigation& asked) const;
    void keeping(const Investigation& asked, view::Display& display, view::Toasts& toasts);

    std::string folder_;
    std::string file_;
    std::string why_;
    std::uint64_t why_is_ = 0;  // of which version
};

}  // namespace surefoot::playground
