#include "assimp_reader.hpp"

#include <algorithm>
#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/scene.h>
#include <charconv>
#include <cmath>
#include <glm/ext/matrix_double4x4.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "format.hpp"
#include "gltf_nodes.hpp"
#include "level_builder.hpp"
#include "ply_header.hpp"
#include "pose.hpp"

namespace surefoot::importer {
namespace {

using internal::LevelBuilder;
using internal::Placement;
using MaybeError = std::optional<Error>;

std::string_view text_of(const aiString& s) {
    return {s.data, s.length};
}

glm::dmat4 matrix_of(const aiMatrix4x4& m) {
    // Assimp writes rows, GLM columns.
    return {m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4};
}

class SceneWalker {
public:
    SceneWalker(const aiScene& scene, const Placement& placement, const GltfExtras* gltf, std::uint64_t bytes)
        : scene_(scene), placement_(placement), gltf_(gltf), builder_(internal::ReadLimits{.bytes = bytes}) {}

    Expected<ImportedLevel> walk() {
        if (scene_.mRootNode != nullptr) {
            if (auto error = visit(*scene_.mRootNode, glm::dmat4(1))) return tl::unexpected(std::move(*error));
        }
        ImportedLevel level = builder_.take();
        if (gltf_ != nullptr) {
            level.markers = gltf_->markers;
        } else {
            level.markers = std::move(empties_);
        }
        if (level.indices.empty()) {
            return tl::unexpected(Error{.code = ErrorCode::invalid,
                                        .text = "it has no triangles (" + std::to_string(level.notes.points_skipped) +
                                                " points and " + std::to_string(level.notes.lines_skipped) +
                                                " lines were skipped); export the level's surfaces as polygons",
                                        .file = {}});
        }
        return level;
    }

private:
    MaybeError visit(const aiNode& node, const glm::dmat4& parent) {
        const glm::dmat4 pose = parent * matrix_of(node.mTransformation);
        if (node.mNumMeshes > 0) builder_.begin_part(text_of(node.mName));
        for (unsigned i = 0; i < node.mNumMeshes; ++i) {
            if (auto error = add_mesh(*scene_.mMeshes[node.mMeshes[i]], node, pose)) return error;
        }
        if (node.mNumMeshes == 0 && node.mNumChildren == 0 && &node != scene_.mRootNode) add_empty(node, pose);
        for (unsigned i = 0; i < node.mNumChildren; ++i) {
            if (auto error = visit(*node.mChildren[i], pose)) return error;
        }
        return std::nullopt;
    }

    MaybeError add_mesh(const aiMesh& mesh, const aiNode& node, const glm::dmat4& pose) {
        const std::size_t first = builder_.vertex_count();
        if (first + mesh.mNumVertices > 0xffffffffu) {
            return Error{
                .code = ErrorCode::limit, .text = "there are more than 2^32 vertices; split the level", .file = {}};
        }
        const bool moved = pose != glm::dmat4(1);
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            const aiVector3D& v = mesh.mVertices[i];
            const glm::dvec4 read(v.x, v.y, v.z, 1);
            const vec3 placed = placement_.vertex(dvec3(moved ? pose * read : read));
            if (!std::isfinite(placed.x) || !std::isfinite(placed.y) || !std::isfinite(placed.z)) {
                return not_finite(i, mesh, node);
            }
            builder_.add_vertex(placed);
        }
        name_surface(mesh);
        // A mirrored node turns its triangles inside out; their fronts must stay fronts.
        const bool mirrored = glm::determinant(glm::dmat3(pose)) < 0;
        for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
            const aiFace& face = mesh.mFaces[i];
            corners_.clear();
            for (unsigned k = 0; k < face.mNumIndices; ++k) {
                const unsigned index = face.mIndices[k];
                if (index >= mesh.mNumVertices) return bad_index(i, index, mesh, node);
                corners_.push_back(static_cast<std::uint32_t>(first + index));
            }
            if (mirrored && corners_.size() > 1) std::reverse(corners_.begin() + 1, corners_.end());
            if (auto error = builder_.add_face(corners_)) return error;
        }
        return std::nullopt;
    }

    void name_surface(const aiMesh& mesh) {
        aiString name;
        if (mesh.mMaterialIndex < scene_.mNumMaterials) {
            scene_.mMaterials[mesh.mMaterialIndex]->Get(AI_MATKEY_NAME, name);
        }
        std::string_view text = text_of(name);
        // What Assimp makes up for a mesh that has none.
        if (text == AI_DEFAULT_MATERIAL_NAME) text = {};
        std::string_view extras;
        if (gltf_ != nullptr) {
            const auto found = gltf_->materials.find(std::string(text));
            if (found != gltf_->materials.end()) extras = found->second;
        }
        builder_.set_surface(text, extras);
    }

    static std::string place(const aiMesh& mesh, const aiNode& node) {
        std::string text = " of mesh \"" + std::string(text_of(mesh.mName)) + "\"";
        if (node.mName.length > 0) text += " in node \"" + std::string(text_of(node.mName)) + "\"";
        return text;
    }

    static Error not_finite(unsigned vertex, const aiMesh& mesh, const aiNode& node) {
        return {.code = ErrorCode::invalid,
                .text = "vertex " + std::to_string(vertex) + place(mesh, node) +
                        " is not finite; correct it, or use a smaller ImportOptions::scale if it is merely far away",
                .file = {}};
    }

    static Error bad_index(unsigned face, unsigned index, const aiMesh& mesh, const aiNode& node) {
        return {.code = ErrorCode::invalid,
                .text = "face " + std::to_string(face) + place(mesh, node) + " uses vertex " + std::to_string(index) +
                        " of " + std::to_string(mesh.mNumVertices) + "; export the level again",
                .file = {}};
    }

    bool is_camera_or_light(const aiNode& node) const {
        for (unsigned i = 0; i < scene_.mNumCameras; ++i) {
            if (scene_.mCameras[i]->mName == node.mName) return true;
        }
        for (unsigned i = 0; i < scene_.mNumLights; ++i) {
            if (scene_.mLights[i]->mName == node.mName) return true;
        }
        return false;
    }

    void add_empty(const aiNode& node, const glm::dmat4& pose) {
        if (node.mName.length == 0 || is_camera_or_light(node)) return;
        if (auto marker = marker_at(pose, placement_)) {
            marker->name = text_of(node.mName);
            empties_.push_back(std::move(*marker));
        }
    }

    const aiScene& scene_;
    Placement placement_;
    const GltfExtras* gltf_;
    LevelBuilder builder_;
    std::vector<std::uint32_t> corners_;
    std::vector<ImportedMarker> empties_;
};

/// glTF names its buffers by URI, in which a space is %20; Assimp asks for them as they are written.
class UriFiles : public Assimp::DefaultIOSystem {
public:
    bool Exists(const char* name) const override {
        return DefaultIOSystem::Exists(name) || DefaultIOSystem::Exists(decoded(name).c_str());
    }

    Assimp::IOStream* Open(const char* name, const char* mode) override {
        if (DefaultIOSystem::Exists(name)) return DefaultIOSystem::Open(name, mode);
        return DefaultIOSystem::Open(decoded(name).c_str(), mode);
    }

private:
    static std::string decoded(std::string_view uri) {
        std::string name;
        for (std::size_t i = 0; i < uri.size(); ++i) {
            unsigned char byte = 0;
            const char* const digits = uri.data() + i + 1;
            if (uri[i] == '%' && i + 2 < uri.size() &&
                std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
                name += static_cast<char>(byte);
                i += 2;
            } else {
                name += uri[i];
            }
        }
        return name;
    }
};

}  // namespace

Expected<ImportedLevel> read_with_assimp(const std::string& path, const Placement& placement, std::uint64_t bytes) {
    const auto format = internal::format_of(path);
    if (!format) return tl::unexpected(format.error());
    if (*format == internal::Format::ply) {
        if (auto error = check_ply_header(path)) return tl::unexpected(std::move(*error));
    }
    std::optional<GltfExtras> gltf;
    if (*format == internal::Format::gltf || *format == internal::Format::glb) {
        auto extras = read_gltf_extras(path, placement);
        if (!extras) return tl::unexpected(extras.error());
        gltf = std::move(*extras);
    }
    // No step of Assimp's post-processing: each of them merges, moves, drops or sorts something.
    Assimp::Importer importer;
    importer.SetIOHandler(new UriFiles);  // the importer deletes it
    const aiScene* const scene = importer.ReadFile(path, 0);
    if (scene == nullptr) {
        return tl::unexpected(Error{.code = ErrorCode::unreadable,
                                    .text = std::string("Assimp says \"") + importer.GetErrorString() +
                                            "\"; open the file in the program that made it and export it as .glb",
                                    .file = {}});
    }
    return SceneWalker(*scene, placement, gltf ? &*gltf : nullptr, bytes).walk();
}

}  // namespace surefoot::importer
