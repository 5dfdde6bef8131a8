/// Saving what a character did: a step, or all that is remembered, in a file that `surefoot replay` reads.
#pragma once

#include <string>

#include "playground/walk/walker.hpp"
#include "view/toasts.hpp"

namespace surefoot::playground {

class Keeping {
public:
    /// Where files go that nobody named; empty: nowhere.
    explicit Keeping(std::string folder) : folder_(std::move(folder)) {}

    /// The step that led to the state that `walker` looks at.
    void save_moment(const Walker& walker, view::Toasts& toasts);

    /// All that is remembered.
    void save_session(const Walker& walker, const std::string& level, view::Toasts& toasts);

    /// A field for the file's name, and both buttons.
    void ui(const Walker& walker, const std::string& level, view::Toasts& toasts);

private:
    [[nodiscard]] std::string file_for(const char* kind, view::Toasts& toasts);
    void tell(const Expected<void>& written, const std::string& file, const std::string& how, view::Toasts& toasts);

    std::string folder_;
    std::string file_;
};

}  // namespace surefoot::playground
