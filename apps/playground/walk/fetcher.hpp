/// Offers levels that nobody here made: runs `levels/fetch`, which gets them from Debian's packages.
#pragma once

#include <optional>
#include <string>

namespace surefoot::playground {

class Fetcher {
public:
    Fetcher();

    /// Is there the script, and are OpenArena's maps not there yet?
    [[nodiscard]] bool offers() const;

    /// Are they there? The folder of the packages that were fetched.
    [[nodiscard]] std::optional<std::string> folder() const;

    /// At most one fetch runs, whichever room began it and even if that was left: while it does, this does nothing.
    void begin();
    [[nodiscard]] bool running() const;

    /// What to tell the user once it is done.
    [[nodiscard]] std::optional<std::string> update();

private:
    std::string script_;
    std::string cache_;
};

/// A file of the project's own, looked for in the working folder and those above it; empty if there is none.
[[nodiscard]] std::string find_in_project(const std::string& path);

}  // namespace surefoot::playground
