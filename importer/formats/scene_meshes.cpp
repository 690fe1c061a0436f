// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>

#include <assimp/mesh.h>

#include "importer/formats/merge_corners.h"
#include "importer/formats/scene_draft.h"
#include "runtime/math/decompose.h"

namespace sinew::formats {
namespace {

glm::vec3 narrow_vec3(const aiVector3D& v) { return {v.x, v.y, v.z}; }

glm::vec3 unit_of(const aiVector3D& v) {
  const glm::dvec3 wide(v.x, v.y, v.z);
  const double length = glm::length(wide);
  return length > 0.0 && std::isfinite(length) ? glm::vec3(wide / length) : glm::vec3(0.0f, 1.0f, 0.0f);
}

bool is_finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// The joints of a mesh, and the influences of its vertices.
struct MeshSkin {
  std::vector<int> nodes;
  std::vector<Affine> inverse_bind;
  std::vector<std::vector<std::pair<double, std::uint16_t>>> influences;  ///< [vertices] weight and joint
};

/// Vertices without weights follow the node of the mesh, as they do without a skin.
MeshSkin skin_of(const aiMesh& mesh, const MergedCorners& corners, int mesh_node, const SceneDraft& scene) {
  MeshSkin out;
  out.influences.resize(corners.corner.size());
  for (unsigned b = 0; b < mesh.mNumBones; ++b) {
    const aiBone& bone = *mesh.mBones[b];
    const auto node = scene.node_of_name.find(text_of(bone.mName));
    if (node == scene.node_of_name.end() || out.nodes.size() > 0xfffe) continue;
    Affined inverse_bind = matrix_of(bone.mOffsetMatrix);
    for (auto& row : inverse_bind.row) row.w *= scene.metres_per_unit;
    out.nodes.push_back(node->second);
    out.inverse_bind.push_back(affine_cast<float>(inverse_bind));
    for (unsigned i = 0; i < bone.mNumWeights; ++i) {
      const aiVertexWeight& weight = bone.mWeights[i];
      if (weight.mVertexId >= mesh.mNumVertices || !(weight.mWeight > 0.0f) || !std::isfinite(weight.mWeight)) continue;
      const std::uint32_t vertex = corners.vertex_of_corner[weight.mVertexId];
      if (corners.corner[vertex] == weight.mVertexId)
        out.influences[vertex].emplace_back(weight.mWeight, static_cast<std::uint16_t>(out.nodes.size() - 1));
    }
  }
  const auto rests = [](const auto& influences) { return influences.empty(); };
  if (std::any_of(out.influences.begin(), out.influences.end(), rests)) {
    const auto own = static_cast<std::uint16_t>(out.nodes.size());
    out.nodes.push_back(mesh_node);
    out.inverse_bind.emplace_back();
    for (auto& influences : out.influences)
      if (influences.empty()) influences.emplace_back(1.0, own);
  }
  return out;
}

/// Adds JOINTS_n and WEIGHTS_n, four influences a set, the largest first.
void add_influences(MeshSkin& skin, ModelDraft& draft, tinygltf::Primitive& out) {
  std::size_t most = 0;
  for (auto& influences : skin.influences) {
    std::sort(influences.begin(), influences.end(), std::greater<>());
    double sum = 0.0;
    for (const auto& [weight, joint] : influences) sum += weight;
    for (auto& [weight, joint] : influences) weight /= sum;
    most = std::max(most, influences.size());
  }
  for (std::size_t set = 0; set * 4 < most; ++set) {
    std::vector<std::uint16_t> joints(4 * skin.influences.size(), 0);
    std::vector<glm::vec4> weights(skin.influences.size(), glm::vec4(0.0f));
    for (std::size_t v = 0; v < skin.influences.size(); ++v)
      for (std::size_t i = set * 4; i < std::min(skin.influences[v].size(), set * 4 + 4); ++i) {
        weights[v][static_cast<int>(i % 4)] = static_cast<float>(skin.influences[v][i].first);
        joints[4 * v + i % 4] = skin.influences[v][i].second;
      }
    out.attributes["JOINTS_" + std::to_string(set)] = draft.buffer.add_joints(joints);
    out.attributes["WEIGHTS_" + std::to_string(set)] = draft.buffer.add(std::span<const glm::vec4>(weights));
  }
}

/// Displacements from `base` to `moved`, times `scale`.
SparseDeltas<glm::vec3> deltas_of(const aiVector3D* base, const aiVector3D* moved, const MergedCorners& corners,
                                  double scale) {
  SparseDeltas<glm::vec3> out;
  for (std::uint32_t v = 0; v < corners.corner.size(); ++v) {
    const unsigned c = corners.corner[v];
    const glm::vec3 delta((glm::dvec3(narrow_vec3(moved[c])) - glm::dvec3(narrow_vec3(base[c]))) * scale);
    if (delta == glm::vec3(0.0f)) continue;
    out.vertices.push_back(v);
    out.deltas.push_back(delta);
  }
  return out;
}

/// Rest weights of FBX are 0 where assimp says 1: it says so of every channel with one shape, whatever the file's
/// DeformPercent is.
void add_targets(const aiMesh& mesh, const MergedCorners& corners, SceneDraft& scene, tinygltf::Mesh& out_mesh,
                 tinygltf::Primitive& out) {
  const std::size_t count = corners.corner.size();
  write::GlbBuffer& buffer = scene.draft.buffer;
  tinygltf::Value::Array names;
  for (unsigned t = 0; t < mesh.mNumAnimMeshes; ++t) {
    const aiAnimMesh& target = *mesh.mAnimMeshes[t];
    std::map<std::string, int> attributes;
    const bool fits = target.mNumVertices == mesh.mNumVertices;
    const auto positions = fits && target.HasPositions()
                               ? deltas_of(mesh.mVertices, target.mVertices, corners, scene.metres_per_unit)
                               : SparseDeltas<glm::vec3>();
    attributes["POSITION"] = buffer.add_deltas(positions, count, true);
    if (fits && target.HasNormals() && mesh.HasNormals())
      attributes["NORMAL"] = buffer.add_deltas(deltas_of(mesh.mNormals, target.mNormals, corners, 1.0), count);
    out.targets.push_back(std::move(attributes));
    out_mesh.weights.push_back(scene.is_fbx && target.mWeight == 1.0f ? 0.0 : double{target.mWeight});
    names.emplace_back(text_of(target.mName));
  }
  if (!names.empty())
    out_mesh.extras = tinygltf::Value(tinygltf::Value::Object{{"targetNames", tinygltf::Value(std::move(names))}});
}

void add_texcoords(const aiMesh& mesh, const MergedCorners& corners, ModelDraft& draft, tinygltf::Primitive& out) {
  int set = 0;
  for (unsigned n = 0; n < AI_MAX_NUMBER_OF_TEXTURECOORDS; ++n) {
    if (!mesh.HasTextureCoords(n)) continue;
    std::vector<glm::vec2> values;
    for (const unsigned v : corners.corner)  // rows of glTF's images begin at the top
      values.emplace_back(mesh.mTextureCoords[n][v].x, 1.0f - mesh.mTextureCoords[n][v].y);
    out.attributes["TEXCOORD_" + std::to_string(set++)] = draft.buffer.add(std::span<const glm::vec2>(values));
  }
}

void add_colors(const aiMesh& mesh, const MergedCorners& corners, ModelDraft& draft, tinygltf::Primitive& out) {
  if (!mesh.HasVertexColors(0)) return;
  std::vector<glm::vec4> values;
  for (const unsigned v : corners.corner) {
    const aiColor4D& c = mesh.mColors[0][v];
    values.push_back(glm::clamp(glm::vec4(c.r, c.g, c.b, c.a), 0.0f, 1.0f));
  }
  out.attributes["COLOR_0"] = draft.buffer.add(std::span<const glm::vec4>(values));
}

/// Adds what a mesh looks like without its skin.
/// out   false: there is no triangle
bool add_surface(const aiMesh& mesh, const MergedCorners& corners, SceneDraft& scene, tinygltf::Mesh& out_mesh,
                 tinygltf::Primitive& out) {
  std::vector<std::uint32_t> indices;
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    const bool is_triangle = face.mNumIndices == 3 && std::all_of(face.mIndices, face.mIndices + 3,
                                                                  [&](unsigned v) { return v < mesh.mNumVertices; });
    for (unsigned i = 0; is_triangle && i < 3; ++i) indices.push_back(corners.vertex_of_corner[face.mIndices[i]]);
  }
  if (const std::size_t others = mesh.mNumFaces - indices.size() / 3; others != 0)
    scene.out.left_out.push_back(std::to_string(others) + " points and lines of the mesh '" + text_of(mesh.mName) +
                                 "'");
  std::vector<glm::vec3> positions, normals;
  for (const unsigned v : corners.corner)
    positions.emplace_back(glm::dvec3(narrow_vec3(mesh.mVertices[v])) * scene.metres_per_unit);
  if (indices.empty() || !std::all_of(positions.begin(), positions.end(), is_finite)) return false;
  ModelDraft& draft = scene.draft;
  out.mode = TINYGLTF_MODE_TRIANGLES;
  out.material = material_of(mesh.mMaterialIndex, scene);
  out.indices = draft.buffer.add_indices(indices);
  out.attributes["POSITION"] = draft.buffer.add(std::span<const glm::vec3>(positions), true);
  if (mesh.HasNormals()) {
    for (const unsigned v : corners.corner) normals.push_back(unit_of(mesh.mNormals[v]));
    out.attributes["NORMAL"] = draft.buffer.add(std::span<const glm::vec3>(normals));
  }
  add_texcoords(mesh, corners, draft, out);
  add_colors(mesh, corners, draft, out);
  add_targets(mesh, corners, scene, out_mesh, out);
  return true;
}

/// Adds a mesh, and its skin, to a node that has none yet.
void add_mesh(unsigned index, std::size_t joint, int node, SceneDraft& scene) {
  const aiMesh& mesh = *scene.scene.mMeshes[index];
  ModelDraft& draft = scene.draft;
  tinygltf::Mesh out;
  tinygltf::Primitive primitive;
  out.name = text_of(mesh.mName);
  const MergedCorners corners = merge_corners(mesh);
  if (!add_surface(mesh, corners, scene, out, primitive)) return;
  if (mesh.HasBones()) {
    MeshSkin skin = skin_of(mesh, corners, node, scene);
    add_influences(skin, draft, primitive);
    tinygltf::Skin to;
    to.name = out.name;
    to.joints = skin.nodes;
    to.inverseBindMatrices = draft.buffer.add_matrices(skin.inverse_bind);
    draft.model.nodes[static_cast<std::size_t>(node)].skin = static_cast<int>(draft.model.skins.size());
    draft.model.skins.push_back(std::move(to));
  }
  if (mesh.mNumAnimMeshes != 0) scene.morphed.push_back({node, index, joint});
  out.primitives.push_back(std::move(primitive));
  draft.model.nodes[static_cast<std::size_t>(node)].mesh = static_cast<int>(draft.model.meshes.size());
  draft.model.meshes.push_back(std::move(out));
}

}  // namespace

void add_meshes(SceneDraft& scene) {
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const FoldedJoint& joint = scene.joints[j];
    const Transformd place = decompose_trs(product_of(joint.mesh_links)).transform;
    for (unsigned i = 0; i < joint.node->mNumMeshes; ++i) {
      const unsigned mesh = joint.node->mMeshes[i];
      int node = scene.node_of_joint[j];
      if (i != 0 || !joint.mesh_links.empty())  // glTF has one mesh a node
        node = scene.draft.add_node(text_of(scene.scene.mMeshes[mesh]->mName), node,
                                    place.translation * scene.metres_per_unit, place.rotation, place.scale);
      add_mesh(mesh, j, node, scene);
    }
  }
}

}  // namespace sinew::formats
