// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/animation/bone_animation.h"
#include "runtime/animation/skeleton.h"
#include "runtime/base/shared_name.h"
#include "runtime/clip/clip.h"
#include "runtime/model/material.h"
#include "runtime/model/mesh.h"
#include "runtime/model/pose_corrective.h"
#include "runtime/model/skin.h"

namespace sinew {

/// A mesh on a joint, with or without a skin. Morph weights belong to the instance, not to the mesh (G43).
struct MeshInstance {
  std::uint32_t joint = 0;
  std::uint32_t mesh = 0;
  std::uint32_t skin = kNone;
  std::vector<float> rest_weights;  ///< [T] node.weights, else mesh.weights, else zeros
  /// Places of copies of the mesh in the joint's space; empty = one, at the joint itself. Never with a skin
  /// (EXT_mesh_gpu_instancing).
  std::vector<Transform> copies = {};
};

/// One of them for each node that places a camera of the file, with the name of that camera.
struct Camera {
  SharedName name;
  std::uint32_t joint = kNone;  ///< kNone = no node places it
  bool perspective = true;
  float fov_y_rad = 0.8f;                       ///< perspective
  float aspect = 0.0f;                          ///< 0 = use the window's
  float half_width = 1.0f, half_height = 1.0f;  ///< orthographic
  float near_m = 0.1f;
  float far_m = 0.0f;  ///< 0 = infinite
};

/// KHR_lights_punctual. One of them for each node that places a light of the file, with the name of that light.
struct Light {
  enum class Kind : std::uint8_t { directional, point, spot };
  SharedName name;
  Kind kind = Kind::directional;
  std::uint32_t joint = kNone;
  glm::vec3 color{1.0f};
  float intensity = 1.0f;
  float range_m = 0.0f;  ///< 0 = infinite
  float inner_cone_rad = 0.0f, outer_cone_rad = 0.785398163f;
};

/// One of the file's scenes: the root joints that it shows.
struct SceneRoots {
  std::string name;
  std::vector<std::uint32_t> joints;
};

/// Everything of one file. Assets are immutable after import; each character's state lies in its FrameBuffer
/// (plan/frame_buffer.h).
struct Scene {
  Skeleton skeleton;
  std::vector<Animation> animations;  ///< authoring form, the truth
  std::vector<Clip> clips;            ///< compiled, parallel to `animations`
  std::vector<Skin> skins;
  std::vector<Mesh> meshes;
  std::vector<MeshInstance> instances;
  std::vector<std::uint32_t> first_weight;   ///< [instances + 1] into the scene's flat array of morph weights
  std::vector<PoseCorrective> correctives;   ///< add to morph weights what joint rotations call for
  PropertyTable properties;                  ///< what clips move beside joints and weights
  std::vector<std::uint32_t> hidden_joints;  ///< not shown at rest, with all below them (KHR_node_visibility)
  std::vector<Material> materials;
  std::vector<std::string> variants;  ///< names; each may give a primitive another material (KHR_materials_variants)
  std::vector<Texture> textures;
  std::vector<Image> images;
  std::vector<Camera> cameras;
  std::vector<Light> lights;
  std::vector<SceneRoots> scenes;
  std::uint32_t default_scene = kNone;  ///< the scene to show; kNone = all roots (G56)

  std::size_t weight_count() const noexcept { return first_weight.empty() ? 0 : first_weight.back(); }
};

/// A scene for compile_plan that all its plans share. It lives as long as the last of them, and as their frame buffers
/// and job threads.
inline std::shared_ptr<const Scene> share(Scene scene) { return std::make_shared<const Scene>(std::move(scene)); }

/// A scene for compile_plan that the caller keeps: in its place, until no plan, frame buffer or job thread uses it. For
/// scenes that lie beside their plan; nothing checks the promise.
inline std::shared_ptr<const Scene> lend(const Scene& scene) noexcept {
  return std::shared_ptr<const Scene>(std::shared_ptr<const void>(), &scene);
}
std::shared_ptr<const Scene> lend(const Scene&& scene) = delete;  // it would be gone already

/// First clip of that name; nothing when there is none.    cost O(clips)
std::optional<std::uint32_t> find_clip(const Scene& scene, std::string_view name) noexcept;

/// Morph weights of all mesh instances at rest, one instance after another.
/// out  [W]     cost O(W), allocates
std::vector<float> rest_weights_of(const Scene& scene);

/// Fills `first_weight`, `properties` and the bounds of primitives that have none, and compiles every animation into
/// `clips`. Call once when the rest of the scene is complete.
void finish_scene(Scene& scene);

/// Proves once what jobs and plans rely on; they check the shapes of buffers only. Call it for scenes that are not from
/// the importer, after finish_scene. What it proves:
///   numbers     all are finite; rest, key and copy rotations are unit (values of cubic keys have a length);
///   indices     all are in range, morph displacements and variants rise, positions are within their bounds;
///   skeleton    parents come before children, levels are contiguous;
///   influences  groups cover the vertices in order and share no entry; weights of a vertex fall and sum to 1;
///   tables      parallel arrays are of one length; clips, `first_weight` and `properties` fit the rest of the scene.
/// What a clip holds inside is proven where clips are made (compile_clip, load_clips), what masks hold by compile_plan.
/// err  the first broken rule;  cost O(size of the scene), allocates O(meshes)
ErrorCode check(const Scene& scene);

}  // namespace sinew
