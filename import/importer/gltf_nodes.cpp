// Khronos, "glTF 2.0 specification": the binary container in 4, scenes and nodes in 3.5.
#include "gltf_nodes.hpp"

#include <array>
#include <cstring>
#include <fstream>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "format.hpp"
#include "pose.hpp"

namespace surefoot::importer {
namespace {

using Json = nlohmann::ordered_json;

Error unreadable(const std::string& what) {
    return {.code = ErrorCode::unreadable, .text = what + "; export the level again", .file = {}};
}

/// The JSON text: the whole of a .gltf, the first chunk of a .glb.
Expected<std::string> json_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    if (!bytes.starts_with("glTF")) return bytes;
    std::array<std::uint32_t, 5> head{};  // "glTF", version, length, length of the chunk, kind of the chunk
    if (bytes.size() < sizeof head) return tl::unexpected(unreadable("the file is cut short within its header"));
    std::memcpy(head.data(), bytes.data(), sizeof head);
    if (head[1] != 2) return tl::unexpected(unreadable("it is glTF " + std::to_string(head[1]) + " and not glTF 2"));
    if (head[2] > bytes.size() || head[3] > bytes.size() - sizeof head) {
        return tl::unexpected(unreadable("the file is cut short: it says that it has " + std::to_string(head[2]) +
                                         " bytes, and has " + std::to_string(bytes.size())));
    }
    return bytes.substr(sizeof head, head[3]);
}

/// A member of an object, or null. Never throws, whatever the types are.
const Json& member(const Json& object, const char* name) {
    static const Json nothing;
    if (!object.is_object()) return nothing;
    const auto found = object.find(name);
    return found != object.end() ? *found : nothing;
}

std::string text_member(const Json& object, const char* name) {
    const Json& value = member(object, name);
    return value.is_string() ? value.get<std::string>() : std::string();
}

const Json& element(const Json& array, const Json& index) {
    static const Json nothing;
    if (!array.is_array() || !index.is_number_unsigned() || index.get<std::size_t>() >= array.size()) return nothing;
    return array[index.get<std::size_t>()];
}

template <std::size_t n>
std::array<double, n> numbers(const Json& value, const std::array<double, n>& otherwise) {
    if (!value.is_array() || value.size() != n) return otherwise;
    std::array<double, n> read{};
    for (std::size_t i = 0; i < n; ++i) {
        if (!value[i].is_number()) return otherwise;
        read[i] = value[i].get<double>();
    }
    return read;
}

glm::dmat4 local_matrix(const Json& node) {
    if (const Json& matrix = member(node, "matrix"); matrix.is_array()) {
        const auto m = numbers<16>(matrix, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
        glm::dmat4 result(1);
        for (int i = 0; i < 16; ++i) result[i / 4][i % 4] = m[static_cast<std::size_t>(i)];
        return result;
    }
    const auto t = numbers<3>(member(node, "translation"), {0, 0, 0});
    const auto r = numbers<4>(member(node, "rotation"), {0, 0, 0, 1});
    const auto s = numbers<3>(member(node, "scale"), {1, 1, 1});
    glm::dmat4 result = glm::mat4_cast(glm::normalize(dquat(r[3], r[0], r[1], r[2])));
    for (int column = 0; column < 3; ++column) result[column] *= s[static_cast<std::size_t>(column)];
    result[3] = {t[0], t[1], t[2], 1};
    return result;
}

class Walker {
public:
    Walker(const Json& root, const internal::Placement& placement) : root_(root), placement_(placement) {
        for (const Json& skin : member(root, "skins")) {
            for (const Json& joint : member(skin, "joints")) {
                if (joint.is_number_unsigned()) joints_.insert(joint.get<std::size_t>());
            }
        }
    }

    std::vector<ImportedMarker> walk() {
        const Json& scenes = member(root_, "scenes");
        const Json& chosen = member(root_, "scene");
        const Json& scene = element(scenes, chosen.is_null() ? Json(0u) : chosen);
        for (const Json& index : member(scene, "nodes")) visit(index, glm::dmat4(1), 0);
        return std::move(markers_);
    }

private:
    void visit(const Json& index, const glm::dmat4& parent, std::size_t depth) {
        const Json& nodes = member(root_, "nodes");
        const Json& node = element(nodes, index);
        // In a tree no node is deeper than there are nodes; one that is its own ancestor would be.
        if (!node.is_object() || depth > nodes.size()) return;
        const glm::dmat4 pose = parent * local_matrix(node);
        if (is_marker(node, index.get<std::size_t>())) add(node, pose);
        for (const Json& child : member(node, "children")) visit(child, pose, depth + 1);
    }

    bool is_marker(const Json& node, std::size_t index) const {
        if (member(node, "extras").is_object()) return true;
        const bool empty = member(node, "mesh").is_null() && member(node, "camera").is_null() &&
                           member(node, "children").empty() && member(node, "extensions").empty();
        return empty && !text_member(node, "name").empty() && !joints_.contains(index);
    }

    void add(const Json& node, const glm::dmat4& pose) {
        auto marker = marker_at(pose, placement_);
        if (!marker) return;
        const Json& extras = member(node, "extras");
        marker->name = text_member(node, "name");
        marker->kind = text_member(member(extras, "surefoot"), "kind");
        if (marker->kind.empty()) marker->kind = text_member(extras, "kind");
        if (extras.is_object()) marker->extras = extras.dump(-1, ' ', false, Json::error_handler_t::replace);
        markers_.push_back(std::move(*marker));
    }

    const Json& root_;
    internal::Placement placement_;
    std::set<std::size_t> joints_;
    std::vector<ImportedMarker> markers_;
};

/// Extensions that may be required and change nothing that collision sees, or that Assimp reads.
bool is_harmless(const std::string& extension) {
    return extension.starts_with("KHR_materials_") || extension == "KHR_texture_transform" ||
           extension == "KHR_lights_punctual" || extension == "KHR_texture_basisu" || extension == "EXT_texture_webp" ||
           extension == "KHR_xmp_json_ld";
}

Error unread(const Json& extension) {
    return {.code = ErrorCode::unsupported,
            .text = "it needs the glTF extension " + extension.dump(-1, ' ', true, Json::error_handler_t::replace) +
                    ", which is not read here; export it without compression and extensions",
            .file = {}};
}

}  // namespace

Expected<GltfExtras> read_gltf_extras(const std::string& path, const internal::Placement& placement) {
    const auto text = json_text(path);
    if (!text) return tl::unexpected(text.error());
    const Json root = Json::parse(*text, nullptr, false);
    if (root.is_discarded() || !root.is_object()) return tl::unexpected(unreadable("its JSON is damaged or cut short"));
    if (!text_member(member(root, "asset"), "version").starts_with("2")) {
        return tl::unexpected(unreadable("it does not say that it is glTF 2"));
    }
    for (const Json& extension : member(root, "extensionsRequired")) {
        if (!extension.is_string() || !is_harmless(extension.get<std::string>()))
            return tl::unexpected(unread(extension));
    }
    // Allowed to be merely used, and then whole forests would be missing.
    for (const Json& extension : member(root, "extensionsUsed")) {
        if (extension == "EXT_mesh_gpu_instancing") return tl::unexpected(unread(extension));
    }
    GltfExtras extras;
    extras.markers = Walker(root, placement).walk();
    for (const Json& material : member(root, "materials")) {
        const Json& own = member(material, "extras");
        if (own.is_object()) {
            extras.materials.emplace(text_member(material, "name"),
                                     own.dump(-1, ' ', false, Json::error_handler_t::replace));
        }
    }
    return extras;
}

}  // namespace surefoot::importer
