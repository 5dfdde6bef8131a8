/// A .blend as Blender 2.49 wrote it, as small as it can be: blocks of raw structs, and at the end the description of
/// those structs ("DNA"), by which a reader of any version finds its way.
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace surefoot::test {

class BlendFile {
public:
    struct Field {
        std::string type;
        std::string name;  ///< "*next" is a pointer, "co[3]" an array
    };

    /// Describes a struct. Requires: the types of its fields are known.
    void describe(const std::string& type, const std::vector<Field>& fields) {
        std::size_t size = 0;
        std::string description;
        append(description, index_of(types_, type));
        append(description, static_cast<std::uint16_t>(fields.size()));
        for (const Field& field : fields) {
            append(description, index_of(types_, field.type));
            append(description, index_of(names_, field.name));
            size += size_of(field);
        }
        sizes_.resize(types_.size());
        sizes_[index_of(types_, type)] = static_cast<std::uint16_t>(size);
        structs_.push_back(type);
        descriptions_ += description;
    }

    /// A block of `count` structs, at the address `at` by which others point to it.
    void block(std::string_view code, std::uint64_t at, const std::string& type, std::uint32_t count,
               const std::string& bytes) {
        std::string head(code);
        head.resize(4);
        append(head, static_cast<std::uint32_t>(bytes.size()));
        append(head, at);
        append(head, static_cast<std::uint32_t>(index_of(structs_, type)));
        append(head, count);
        blocks_ += head + bytes;
    }

    [[nodiscard]] std::string finish() {
        std::string dna = "SDNANAME";
        append_texts(dna, names_);
        dna += "TYPE";
        append_texts(dna, types_);
        dna += "TLEN";
        for (const std::uint16_t size : sizes_) append(dna, size);
        dna.resize((dna.size() + 3) / 4 * 4);
        dna += "STRC";
        append(dna, static_cast<std::uint32_t>(structs_.size()));
        dna += descriptions_;
        structs_.emplace_back("DNA");
        block("DNA1", 0xd0a, "DNA", 1, dna);
        return "BLENDER-v249" + blocks_ + std::string("ENDB") + std::string(20, '\0');
    }

    template <typename T>
    static void append(std::string& bytes, const T& value) {
        const std::size_t old = bytes.size();
        bytes.resize(old + sizeof value);
        std::memcpy(bytes.data() + old, &value, sizeof value);
    }

private:
    static std::uint16_t index_of(std::vector<std::string>& list, const std::string& text) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (list[i] == text) return static_cast<std::uint16_t>(i);
        }
        list.push_back(text);
        return static_cast<std::uint16_t>(list.size() - 1);
    }

    [[nodiscard]] std::size_t size_of(const Field& field) {
        std::size_t size = field.name.starts_with('*') ? 8 : sizes_[index_of(types_, field.type)];
        for (std::size_t i = field.name.find('['); i != std::string::npos; i = field.name.find('[', i + 1)) {
            size *= static_cast<std::size_t>(std::atoi(field.name.c_str() + i + 1));
        }
        return size;
    }

    static void append_texts(std::string& bytes, const std::vector<std::string>& texts) {
        append(bytes, static_cast<std::uint32_t>(texts.size()));
        for (const std::string& text : texts) bytes += text + '\0';
        bytes.resize((bytes.size() + 3) / 4 * 4);
    }

    std::vector<std::string> names_;
    std::vector<std::string> types_{"char", "short", "int", "float", "void"};
    std::vector<std::uint16_t> sizes_{1, 2, 4, 4, 0};
    std::vector<std::string> structs_;
    std::string descriptions_;
    std::string blocks_;
};

/// A square floor of four corners, its material "wood", moved by (10, 20, 30) in Blender's axes; beside it an empty.
inline std::string old_blend() {
    BlendFile file;
    file.describe("Link", {{"Link", "*next"}, {"Link", "*prev"}});
    file.describe("ID", {{"char", "name[24]"}});
    file.describe("ListBase", {{"void", "*first"}, {"void", "*last"}});
    file.describe("Scene", {{"ID", "id"}, {"ListBase", "base"}});
    file.describe("Base", {{"Base", "*next"}, {"Base", "*prev"}, {"Object", "*object"}});
    file.describe("Object",
                  {{"ID", "id"}, {"int", "type"}, {"int", "pad"}, {"float", "obmat[4][4]"}, {"void", "*data"}});
    file.describe("Material", {{"ID", "id"}});
    file.describe("MVert", {{"float", "co[3]"}, {"short", "no[3]"}, {"short", "flag"}});
    file.describe("MFace",
                  {{"int", "v1"}, {"int", "v2"}, {"int", "v3"}, {"int", "v4"}, {"short", "mat_nr"}, {"short", "flag"}});
    file.describe("Mesh", {{"ID", "id"},
                           {"int", "totface"},
                           {"int", "totedge"},
                           {"int", "totvert"},
                           {"int", "pad"},
                           {"MFace", "*mface"},
                           {"MVert", "*mvert"},
                           {"Material", "**mat"}});

    const auto id = [](std::string name) {
        name.resize(24);
        return name;
    };
    const auto numbers = [](auto... values) {
        std::string bytes;
        (BlendFile::append(bytes, values), ...);
        return bytes;
    };
    const auto object = [&](const char* name, int type, std::uint64_t data) {
        std::string bytes = id(name) + numbers(type, 0);
        for (const float f : {1.f, 0.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 0.f, 1.f, 0.f, 10.f, 20.f, 30.f, 1.f}) {
            BlendFile::append(bytes, f);
        }
        return bytes + numbers(data);
    };
    constexpr std::uint64_t none = 0;
    constexpr std::uint64_t base_a = 0x100, base_b = 0x200, floor = 0x300, empty = 0x400, mesh = 0x500;
    constexpr std::uint64_t vertices = 0x600, faces = 0x700, materials = 0x800, wood = 0x900;
    constexpr short s = 0;

    file.block("SC", 0x50, "Scene", 1, id("SCscene") + numbers(base_a, base_b));
    file.block("DATA", base_a, "Base", 1, numbers(base_b, none, floor));
    file.block("DATA", base_b, "Base", 1, numbers(none, base_a, empty));
    file.block("OB", floor, "Object", 1, object("OBfloor", 1, mesh));
    file.block("OB", empty, "Object", 1, object("OBstart", 0, none));
    file.block("ME", mesh, "Mesh", 1, id("MEfloor") + numbers(1, 0, 4, 0, faces, vertices, materials));
    file.block("DATA", vertices, "MVert", 4,
               numbers(0.f, 0.f, 0.f, s, s, s, s, 4.f, 0.f, 0.f, s, s, s, s, 4.f, 3.f, 0.f, s, s, s, s, 0.f, 3.f, 0.5f,
                       s, s, s, s));
    file.block("DATA", faces, "MFace", 1, numbers(0, 1, 2, 3, s, s));
    file.block("DATA", materials, "Link", 1, numbers(wood));
    file.block("MA", wood, "Material", 1, id("MAwood"));
    return file.finish();
}

}  // namespace surefoot::test
