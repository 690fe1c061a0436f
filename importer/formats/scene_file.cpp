// SPDX-License-Identifier: MIT
#include "importer/formats/scene_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include "importer/formats/scene_draft.h"
#include "importer/issue_log.h"
#include "runtime/math/decompose.h"

namespace sinew::formats {
namespace {

constexpr const char* kViolation = "assimp does not expect this file: ";

}  // namespace
}  // namespace sinew::formats

namespace Assimp {

/// Takes the place of assimp's own function, which ends the process where a file breaks an assumption of assimp. An
/// exception makes it an error of this file.
void aiAssertViolation(const char* expression, const char* file, int line) {
  throw std::runtime_error(sinew::formats::kViolation + std::string(expression) + " in " + file + ':' +
                           std::to_string(line));
}

}  // namespace Assimp

namespace sinew::formats {
namespace {

const glm::dquat kYFromZ(std::numbers::sqrt2 / 2.0, -std::numbers::sqrt2 / 2.0, 0.0, 0.0);  // -90 degrees about x

/// Metres in a unit, and the rotation to y up.
struct Frame {
  double metres_per_unit = 1.0;
  glm::dquat y_up{1.0, 0.0, 0.0, 0.0};
};

/// A number of the scene's metadata, whatever its type.
double number(const aiScene& scene, const char* name, double without) {
  if (scene.mMetaData == nullptr) return without;
  double d = 0.0;
  float f = 0.0f;
  std::int32_t i = 0;
  if (scene.mMetaData->Get(name, i)) return i;
  if (scene.mMetaData->Get(name, d)) return d;
  return scene.mMetaData->Get(name, f) ? f : without;
}

/// Unit and axes that an FBX file names in its GlobalSettings.
/// eq    rows of the rotation: the file's axes that point right, up and to the front
Frame frame_of_fbx(const aiScene& scene, ImportedFormat& summary) {
  constexpr std::array<std::array<const char*, 2>, 3> kAxes{
      {{"CoordAxis", "CoordAxisSign"}, {"UpAxis", "UpAxisSign"}, {"FrontAxis", "FrontAxisSign"}}};
  Frame out;
  out.metres_per_unit = 0.01 * number(scene, "UnitScaleFactor", 1.0);
  glm::dmat3 rows(0.0);
  for (int row = 0; row < 3; ++row) {
    const double axis = number(scene, kAxes[static_cast<std::size_t>(row)][0], row);
    const double sign = number(scene, kAxes[static_cast<std::size_t>(row)][1], 1.0);
    if (axis == 0.0 || axis == 1.0 || axis == 2.0) rows[static_cast<int>(axis)][row] = sign < 0.0 ? -1.0 : 1.0;
  }
  if (glm::determinant(rows) == 1.0)
    out.y_up = glm::normalize(glm::quat_cast(rows));
  else
    summary.warnings.push_back({Severity::warning, "fbx-axes", "GlobalSettings",
                                "the axes are left-handed or no axes; y is taken for up (--up z takes z)"});
  return out;
}

/// Unit and axes that assimp has put into the root of a COLLADA scene.
Frame frame_of_collada(const aiScene& scene) {
  const Transformd root = decompose_trs(matrix_of(scene.mRootNode->mTransformation)).transform;
  return {root.scale.x, root.rotation};
}

/// True if several nodes have one name, so that bones and channels could not tell them apart.
bool has_equal_names(const aiNode& node, std::set<std::string>& seen) {
  if (!seen.insert(text_of(node.mName)).second) return true;
  for (unsigned i = 0; i < node.mNumChildren; ++i)
    if (has_equal_names(*node.mChildren[i], seen)) return true;
  return false;
}

const aiScene* read(Assimp::Importer& importer, std::span<const std::byte> bytes, bool is_fbx, bool names) {
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_OPTIMIZE_EMPTY_ANIMATION_CURVES, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, names);
  return importer.ReadFileFromMemory(bytes.data(), bytes.size(), aiProcess_Triangulate, is_fbx ? "fbx" : "dae");
}

/// The bytes of an FBX file whose takes do not say where they start and stop: all keys count then. The new names are as
/// long as the old ones, so that offsets of binary files stay right.
std::vector<std::byte> without_ranges(std::span<const std::byte> bytes) {
  std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  for (const char* name : {"LocalStart", "LocalStop"})
    for (std::size_t at = 0; (at = text.find(name, at)) != text.npos;) text[at] = '_';
  const auto out = std::as_bytes(std::span(text));
  return {out.begin(), out.end()};
}

/// Reads a scene; where assimp fails, also in another way.
const aiScene* read_scene(Assimp::Importer& importer, std::span<const std::byte> bytes, bool is_fbx,
                          ImportedFormat& out) {
  const aiScene* scene = read(importer, bytes, is_fbx, true);
  std::set<std::string> names;
  if (scene == nullptr && is_fbx && std::string_view(importer.GetErrorString()).starts_with(kViolation)) {
    scene = read(importer, without_ranges(bytes), is_fbx, true);
    if (scene != nullptr)
      out.warnings.push_back(
          {Severity::warning, "fbx-take-range", "",
           "assimp fails on takes in whose range a curve has no key; all keys of the takes are read"});
  } else if (scene != nullptr && !is_fbx && has_equal_names(*scene->mRootNode, names)) {
    scene = read(importer, bytes, is_fbx, false);
    out.warnings.push_back({Severity::warning, "equal-names", "", "several nodes have one name; ids took their place"});
  }
  return scene != nullptr && scene->mRootNode != nullptr ? scene : nullptr;
}

void note_left_out(const aiScene& scene, ImportedFormat& out) {
  const auto note = [&](unsigned count, const char* things) {
    if (count != 0) out.left_out.push_back(std::to_string(count) + ' ' + things);
  };
  note(scene.mNumCameras, "cameras");
  note(scene.mNumLights, "lights");
  note(scene.mNumTextures, "embedded images");
}

/// True if translation, rotation and scale give another matrix, beyond rounding of assimp's floats.
bool shears(const Affined& matrix, const Transformd& parts) {
  const glm::dmat3 exact = linear_part(matrix), made = linear_part(affine_from_transform(parts));
  double size = 0.0, off = 0.0;
  for (int c = 0; c < 3; ++c) {
    size = std::max(size, glm::length(exact[c]));
    off = std::max(off, glm::distance(exact[c], made[c]));
  }
  return off > 1e-4 * size;
}

void add_nodes(SceneDraft& scene, const glm::dquat& y_up) {
  scene.joints = fold_joints(*scene.scene.mRootNode);
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const FoldedJoint& joint = scene.joints[j];
    const Transformd local = decompose_trs(product_of(joint.links)).transform;
    Transformd rest = local;
    if (j == 0) rest = {rest.translation, y_up, glm::dvec3(1.0)};
    const int parent = joint.parent == FoldedJoint::kNoParent ? -1 : scene.node_of_joint[joint.parent];
    const std::string name = text_of(joint.node->mName);
    const int node =
        scene.draft.add_node(name, parent, rest.translation * scene.metres_per_unit, rest.rotation, rest.scale);
    scene.node_of_joint.push_back(node);
    scene.node_of_name.emplace(name, node);
    if (j != 0 && shears(product_of(joint.links), local))
      scene.out.warnings.push_back({Severity::warning, "sheared-node", "node " + in_quotes(name),
                                    "its matrix shears, which keys of glTF cannot say; the nearest rotation is taken"});
  }
}

std::optional<ImportIssue> add_scene(std::span<const std::byte> bytes, bool is_fbx, const FormatOptions& options,
                                     ModelDraft& draft, ImportedFormat& out) {
  Assimp::Importer importer;
  const aiScene* scene = read_scene(importer, bytes, is_fbx, out);
  if (scene == nullptr)
    return ImportIssue{Severity::error, "assimp", "",
                       std::string("assimp cannot read it: ") + importer.GetErrorString()};
  Frame frame = is_fbx ? frame_of_fbx(*scene, out) : frame_of_collada(*scene);
  frame.metres_per_unit = options.metres_per_unit.value_or(frame.metres_per_unit);
  if (options.z_up) frame.y_up = *options.z_up ? kYFromZ : glm::dquat(1.0, 0.0, 0.0, 0.0);
  SceneDraft draft_of{*scene, draft, out, is_fbx, frame.metres_per_unit, {}, {}, {}, {}, {}};
  add_nodes(draft_of, frame.y_up);
  add_meshes(draft_of);
  add_animations(draft_of);
  note_left_out(*scene, out);
  return std::nullopt;
}

}  // namespace

std::optional<ImportIssue> add_scene_file(std::span<const std::byte> bytes, bool is_fbx, const std::filesystem::path&,
                                          const FormatOptions& options, ModelDraft& draft, ImportedFormat& out) {
  try {
    return add_scene(bytes, is_fbx, options, draft, out);
  } catch (const std::exception& error) {  // assimp's own, as it catches most of them
    return ImportIssue{Severity::error, "assimp", "", std::string("assimp cannot read it: ") + error.what()};
  }
}

}  // namespace sinew::formats
