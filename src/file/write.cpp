#include <algorithm>
#include <cstring>

#include "file/container.hpp"
#include "platform/atomic_file.hpp"

namespace surefoot::internal {
namespace {

bool is_name(std::string_view text, std::size_t longest) {
    return !text.empty() && text.size() <= longest &&
           std::all_of(text.begin(), text.end(), [](char c) { return c > ' ' && c <= '~'; });
}

std::span<const std::byte> zeros_up_to_alignment(std::uint64_t size) {
    static constexpr std::byte zeros[section_alignment]{};
    return std::span(zeros).first(static_cast<std::size_t>(aligned(size) - size));
}

tl::unexpected<Error> refused(ErrorCode code, std::string text) {
    return tl::unexpected(Error{code, std::move(text), {}, 0});
}

}  // namespace

Expected<std::vector<std::byte>> lay_out(std::span<const Section> sections, std::uint64_t made_from) {
    if (sections.size() > most_sections)
        return refused(ErrorCode::limit,
                       "a file holds at most " + std::to_string(most_sections) + " sections: merge some");
    std::vector<FileSection> table(sections.size());
    std::uint64_t end = aligned(sizeof(FileHeader) + sections.size() * sizeof(FileSection));
    std::vector<std::byte> out(static_cast<std::size_t>(end));
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const Section& section = sections[i];
        FileSection& entry = table[i];
        if (!is_name(section.owner, entry.owner.size()) || !is_name(section.name, entry.name.size())) {
            return refused(ErrorCode::invalid, "a section cannot be called '" + std::string(section.owner) + "/" +
                                                   std::string(section.name) +
                                                   "': give it an owner of 1 to 16 and a name of 1 to 24 characters of "
                                                   "ASCII, without spaces");
        }
        for (std::size_t k = 0; k < i; ++k) {
            if (sections[k].owner == section.owner && sections[k].name == section.name) {
                return refused(ErrorCode::invalid, "there are two sections '" + std::string(section.owner) + "/" +
                                                       std::string(section.name) + "': give each a name of its own");
            }
        }
        std::copy(section.owner.begin(), section.owner.end(), entry.owner.begin());
        std::copy(section.name.begin(), section.name.end(), entry.name.begin());
        entry.version = section.version;
        entry.offset = end;
        entry.size = section.bytes.size();
        entry.made_from = section.made_from;
        entry.checksum = hash_bytes(section.bytes);
        end = aligned(end + entry.size);
    }
    FileHeader header{.magic = magic,
                      .file_size = end,
                      .section_count = static_cast<std::uint32_t>(sections.size()),
                      .made_from = made_from};
    std::memcpy(out.data(), &header, sizeof(header));
    if (!table.empty()) std::memcpy(out.data() + sizeof(header), table.data(), table.size() * sizeof(FileSection));
    constexpr std::size_t summed_from = offsetof(FileHeader, byte_order);
    header.checksum = hash_bytes(
        std::span(out).subspan(summed_from, sizeof(header) + table.size() * sizeof(FileSection) - summed_from));
    std::memcpy(out.data(), &header, sizeof(header));
    return out;
}

Expected<void> write_file(const std::string& path, std::span<const Section> sections, std::uint64_t made_from) {
    if (!machine_fits)
        return refused(ErrorCode::unsupported, ".surefoot files are little-endian: write them on another machine");
    const auto begin = lay_out(sections, made_from);
    if (!begin) return tl::unexpected(begin.error());
    auto file = AtomicFile::create(path);
    if (!file) return tl::unexpected(file.error());
    auto done = file->write(*begin);
    for (const Section& section : sections) {
        if (done) done = file->write(section.bytes);
        if (done) done = file->write(zeros_up_to_alignment(section.bytes.size()));
    }
    return done ? file->commit() : done;
}

}  // namespace surefoot::internal
