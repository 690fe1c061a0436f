// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/animation/bone_animation.h"
#include "runtime/animation/skeleton.h"
#include "runtime/base/api.h"
#include "runtime/base/shared_name.h"
#include "runtime/clip/clip.h"
#include "runtime/math/quaternion.h"
#include "runtime/math/transform.h"
#include "runtime/model/material.h"
#include "runtime/model/mesh.h"
#include "runtime/model/pose_corrective.h"
#include "runtime/model/skin.h"

namespace sinew {

/// A mesh attached to a joint, with or without a skin. Morph weights belong to the instance, not to the mesh.
struct MeshInstance {
  std::uint32_t joint = 0;
  std::uint32_t mesh = 0;
  std::uint32_t skin = kNone;
  std::vector<float> rest_weights;  ///< [T] node.weights, else mesh.weights, else zeros
  /// Transforms of copies of the mesh in the joint's space (EXT_mesh_gpu_instancing); empty = one copy at the joint.
  /// Always empty with a skin.
  std::vector<Transform> copies = {};
};

/// Calls `use(world_from_copy)` for every copy of an instance; once, with `world_from_mesh`, if it has no copies.
/// in   world_from_mesh   InstanceResult::world_from_mesh; products are computed in its precision T
template <class T, class Use>
void for_each_copy(const MeshInstance& instance, const AffineT<T>& world_from_mesh, Use&& use) {
  if (instance.copies.empty()) return use(world_from_mesh);
  for (const Transform& copy : instance.copies)
    use(world_from_mesh * affine_from_transform(TransformT<T>{Vec3<T>(copy.translation), quat_cast<T>(copy.rotation),
                                                              Vec3<T>(copy.scale)}));
}

/// A camera at a joint. If several nodes use one camera of the file, each of them gets a Camera of the same name.
struct Camera {
  SharedName name;
  std::uint32_t joint = kNone;  ///< kNone = no node uses it
  bool perspective = true;
  float fov_y_rad = 0.8f;                       ///< perspective cameras only
  float aspect = 0.0f;                          ///< 0 = use the window's
  float half_width = 1.0f, half_height = 1.0f;  ///< orthographic cameras only, metres
  float near_m = 0.1f;
  float far_m = 0.0f;  ///< 0 = infinite
};

/// A light at a joint (KHR_lights_punctual). If several nodes use one light of the file, each of them gets a Light of
/// the same name.
struct Light {
  enum class Kind : std::uint8_t { directional, point, spot };
  SharedName name;
  Kind kind = Kind::directional;
  std::uint32_t joint = kNone;
  glm::vec3 color{1.0f};
  float intensity = 1.0f;  ///< candela; lux for directional lights
  float range_m = 0.0f;    ///< 0 = infinite
  float inner_cone_rad = 0.0f, outer_cone_rad = 0.785398163f;
};

/// One of the scenes in a glTF file: the root joints that it shows.
struct SceneRoots {
  std::string name;
  std::vector<std::uint32_t> joints;
};

/// All assets of one file. They never change after import; the state of each character is in its FrameBuffer
/// (plan/frame_buffer.h).
struct Scene {
  Skeleton skeleton;
  std::vector<Animation> animations;  ///< authoring form, which compiled clips are compared with
  std::vector<Clip> clips;            ///< compiled, parallel to `animations`
  std::vector<Skin> skins;
  std::vector<Mesh> meshes;
  std::vector<MeshInstance> instances;
  std::vector<std::uint32_t> first_weight;   ///< [instances + 1] index of each instance's first weight in the scene's
                                             ///< flat array of morph weights
  std::vector<PoseCorrective> correctives;   ///< add to morph weights, depending on joint rotations
  PropertyTable properties;                  ///< all animated properties besides joints and weights
  std::vector<std::uint32_t> hidden_joints;  ///< hidden at rest, with all joints below them (KHR_node_visibility)
  std::vector<Material> materials;
  std::vector<std::string> variants;  ///< names of variants (KHR_materials_variants)
  std::vector<Texture> textures;
  std::vector<Image> images;
  std::vector<Camera> cameras;
  std::vector<Light> lights;
  std::vector<SceneRoots> scenes;
  std::uint32_t default_scene = kNone;  ///< the scene to show; kNone = all roots

  std::size_t weight_count() const noexcept { return first_weight.empty() ? 0 : first_weight.back(); }
};

/// Makes a scene for compile_plan that its plans own together. It is destroyed with the last plan, frame buffer or job
/// thread that uses it.
inline std::shared_ptr<const Scene> share(Scene scene) { return std::make_shared<const Scene>(std::move(scene)); }

/// Makes a scene for compile_plan that stays the caller's. The caller must neither move nor destroy it while a plan,
/// frame buffer or job thread uses it; nothing checks this.
inline std::shared_ptr<const Scene> lend(const Scene& scene) noexcept {
  return std::shared_ptr<const Scene>(std::shared_ptr<const void>(), &scene);
}
std::shared_ptr<const Scene> lend(const Scene&& scene) = delete;  // a temporary would be destroyed too soon

/// First clip of that name; nullopt if there is none.    cost O(clips)
SINEW_API std::optional<std::uint32_t> find_clip(const Scene& scene, std::string_view name) noexcept;

/// Rest morph weights of all mesh instances, one instance after another.
/// out  [W]     cost O(W), allocates
SINEW_API std::vector<float> rest_weights_of(const Scene& scene);

/// Fills `first_weight`, `properties` and missing bounds of primitives, and compiles every animation into `clips`.
/// Call it once, when everything else is complete.
SINEW_API void finish_scene(Scene& scene);

/// Checks once everything that jobs and plans rely on; they check only the sizes of buffers. Call it after
/// finish_scene for scenes that do not come from the importer. It checks:
///
///     numbers     all are finite; rest, key and copy rotations are unit (values of cubic keys are not zero);
///     indices     all are in range; morph displacements and variants are sorted; positions are within their bounds;
///     skeleton    parents come before children, levels are contiguous;
///     influences  groups cover the vertices in order without overlap; weights of a vertex fall and sum to 1;
///     tables      parallel arrays have equal lengths; clips, `first_weight` and `properties` fit the scene.
///
/// The inside of clips is checked when they are made (compile_clip, load_clips), and masks by compile_plan.
/// err  the first broken rule;  cost O(size of the scene), allocates O(meshes)
SINEW_API ErrorCode check(const Scene& scene);

/// Shows one of Scene::scenes. It adds a root joint of the skeleton to `hidden_joints`, unless the joint or one below
/// it is a root of that scene. Hidden joints are still evaluated, since skins may use them. Call it before plans are
/// compiled.
/// in   index  into Scene::scenes; kNone = all roots are shown, nothing changes
/// cost O(J)
SINEW_API void show_scene(Scene& scene, std::uint32_t index);

/// Checks animations that are not in the scene yet, by the same rules as check(Scene).
SINEW_API ErrorCode check_animations(std::span<const Animation> animations, const Scene& scene) noexcept;

}  // namespace sinew
