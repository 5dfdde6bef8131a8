#include "ply_header.hpp"

#include <fstream>

namespace surefoot::importer {

std::optional<Error> check_ply_header(const std::string& path) {
    std::string head(std::size_t{1} << 20, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file.gcount()));
    for (std::size_t at = head.find("end_header"); at != std::string::npos; at = head.find("end_header", at + 1)) {
        const std::size_t after = at + std::string_view("end_header").size();
        const bool begins_a_line = at > 0 && (head[at - 1] == '\n' || head[at - 1] == '\r');
        const bool ends_a_line = after < head.size() && (head[after] == '\n' || head[after] == '\r');
        if (begins_a_line && ends_a_line && after + 1 < head.size()) return std::nullopt;
    }
    return Error{.code = ErrorCode::unreadable,
                 .text = "its header has no end, or nothing comes after it: the file is cut short; export it again",
                 .file = {}};
}

}  // namespace surefoot::importer
