#include "file/container.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace surefoot::internal {
namespace {

std::string full_name(const Section& section) {
    std::string text(section.owner);
    text += '/';
    return text.append(section.name);
}

/// The text in a field that is padded with zeros; empty if it is not printable ASCII without spaces, or not padded so.
template <std::size_t Size>
std::string_view text_of(const std::byte* field) {
    const auto* const text = reinterpret_cast<const char*>(field);
    std::size_t length = 0;
    while (length < Size && text[length] > ' ' && text[length] <= '~') ++length;
    for (std::size_t i = length; i < Size; ++i)
        if (text[i] != '\0') return {};
    return {text, length};
}

}  // namespace

Error file_error(ErrorCode code, const std::string& file, std::uint64_t byte, const std::string& what) {
    const std::string name = file.empty() ? "these bytes" : file;
    return {code,
            name + ": " + what + " (at byte " + std::to_string(byte) + "): cook it again with `surefoot cook IN -o " +
                (file.empty() ? "OUT.surefoot" : file) + "`",
            file, byte};
}

Container::Container(std::span<const std::byte> bytes, std::string file) noexcept
    : bytes_(bytes), file_(std::move(file)) {}

Expected<Container> Container::parse(std::span<const std::byte> bytes, std::string file) {
    Container container(bytes, std::move(file));
    const auto fail = [&](ErrorCode code, std::uint64_t byte, const std::string& what) {
        return tl::unexpected(file_error(code, container.file_, byte, what));
    };
    if (!machine_fits)
        return fail(ErrorCode::unsupported, 0, "is little-endian, which this machine cannot use where it lies");
    FileHeader header;
    if (bytes.empty()) return fail(ErrorCode::unreadable, 0, "is empty");
    if (std::memcmp(bytes.data(), magic.data(), std::min(bytes.size(), magic.size())) != 0)
        return fail(ErrorCode::unreadable, 0, "is not a .surefoot file, or was transferred as text");
    if (bytes.size() < sizeof(header)) return fail(ErrorCode::unreadable, bytes.size(), "ends within its header");
    std::memcpy(&header, bytes.data(), sizeof(header));
    if (header.byte_order != byte_order_mark) {
        return fail(ErrorCode::unreadable, offsetof(FileHeader, byte_order),
                    "has its bytes in another order than little-endian, or is damaged");
    }
    if (header.version != format_version) {
        return fail(ErrorCode::unsupported, offsetof(FileHeader, version),
                    "has format " + std::to_string(header.version) + ", and this Surefoot reads format " +
                        std::to_string(format_version));
    }
    if (header.file_size != bytes.size()) {
        return fail(ErrorCode::unreadable, std::min<std::uint64_t>(header.file_size, bytes.size()),
                    "should have " + std::to_string(header.file_size) + " bytes but has " +
                        std::to_string(bytes.size()) + ": it was cut short or damaged");
    }
    if (header.section_count > most_sections ||
        sizeof(header) + header.section_count * sizeof(FileSection) > bytes.size()) {
        return fail(ErrorCode::unreadable, offsetof(FileHeader, section_count),
                    "says that it has " + std::to_string(header.section_count) + " sections");
    }
    const std::uint64_t table_end = sizeof(header) + header.section_count * sizeof(FileSection);
    constexpr std::uint64_t summed_from = offsetof(FileHeader, byte_order);
    if (hash_bytes(bytes.subspan(summed_from, table_end - summed_from)) != header.checksum)
        return fail(ErrorCode::unreadable, offsetof(FileHeader, checksum), "has a header that is damaged");

    container.made_from_ = header.made_from;
    container.sections_.reserve(header.section_count);
    std::uint64_t end = table_end;
    for (std::uint32_t i = 0; i < header.section_count; ++i) {
        const std::uint64_t at = sizeof(header) + i * sizeof(FileSection);
        FileSection entry;
        std::memcpy(&entry, bytes.data() + at, sizeof(entry));
        // A checksum is no lock: whoever wants to harm can compute one. So nothing below is taken on trust.
        const std::string_view owner = text_of<sizeof(entry.owner)>(bytes.data() + at + offsetof(FileSection, owner));
        const std::string_view name = text_of<sizeof(entry.name)>(bytes.data() + at + offsetof(FileSection, name));
        if (owner.empty() || name.empty()) return fail(ErrorCode::unreadable, at, "has a section without a name");
        if (container.find(owner, name) != nullptr) return fail(ErrorCode::unreadable, at, "has a section twice");
        if (entry.offset % section_alignment != 0 || entry.offset < end || entry.offset > bytes.size() ||
            entry.size > bytes.size() - entry.offset) {
            return fail(ErrorCode::unreadable, at + offsetof(FileSection, offset),
                        "has a section that lies outside of the file or over another one");
        }
        end = entry.offset + entry.size;
        container.sections_.push_back(
            {owner, name, entry.version, entry.made_from,
             bytes.subspan(static_cast<std::size_t>(entry.offset), static_cast<std::size_t>(entry.size))});
    }
    return container;
}

const Section* Container::find(std::string_view owner, std::string_view name) const noexcept {
    const auto found = std::find_if(sections_.begin(), sections_.end(), [&](const Section& section) {
        return section.owner == owner && section.name == name;
    });
    return found == sections_.end() ? nullptr : &*found;
}

std::uint64_t Container::offset_of(const Section& section) const noexcept {
    return static_cast<std::uint64_t>(section.bytes.data() - bytes_.data());
}

Expected<void> Container::check_sum(const Section& section) const {
    const auto index = static_cast<std::size_t>(&section - sections_.data());
    FileSection entry;
    std::memcpy(&entry, bytes_.data() + sizeof(FileHeader) + index * sizeof(FileSection), sizeof(entry));
    if (hash_bytes(section.bytes) == entry.checksum) return {};
    return tl::unexpected(
        file_error(ErrorCode::unreadable, file_, offset_of(section), "has a damaged section, " + full_name(section)));
}

Expected<void> Container::check_sums() const {
    std::uint64_t end = sizeof(FileHeader) + sections_.size() * sizeof(FileSection);
    const auto is_zero = [&](std::uint64_t from, std::uint64_t to) {
        const auto gap = bytes_.subspan(static_cast<std::size_t>(from), static_cast<std::size_t>(to - from));
        return std::all_of(gap.begin(), gap.end(), [](std::byte byte) { return byte == std::byte{0}; });
    };
    for (const Section& section : sections_) {
        const std::uint64_t offset = offset_of(section);
        if (auto sum = check_sum(section); !sum) return sum;
        if (!is_zero(end, offset)) {
            return tl::unexpected(file_error(ErrorCode::unreadable, file_, end, "has something between its sections"));
        }
        end = offset + section.bytes.size();
    }
    if (!is_zero(end, bytes_.size()))
        return tl::unexpected(file_error(ErrorCode::unreadable, file_, end, "has something behind its sections"));
    return {};
}

}  // namespace surefoot::internal
