// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/clip/clip_tracks.h"
#include "runtime/model/scene.h"
#include "runtime/plan/needs.h"
#include "runtime/plan/plan_stages.h"

namespace sinew {

struct CompiledPlan;

/// Vertex attributes that a stage writes for one primitive.
struct AttributeSet {
  bool positions = false, normals = false, tangents = false;

  bool any() const noexcept { return positions || normals || tangents; }
};

/// The stages of a primitive of a mesh instance. In this order: morph, skin, vertices of a cache in place of both, flat
/// normals.
struct PrimitivePlan {
  std::uint32_t instance = 0, primitive = 0;
  AttributeSet morph, skin;
  AttributeSet cached;  ///< written in frames in which a source plays in the instance (FrameInput::geometry)
  bool morph_colors = false;
  bool flat_normals = false;  ///< recomputed from the deformed triangles
  bool cofactors = false;  ///< normals follow the cofactor matrix: the needs ask for it, and scale or blends are uneven
  bool lacks_centers = false;  ///< without centers of rotation, `skinning` is linear instead
  Skinning skinning = Skinning::linear;

  bool deformed() const noexcept { return morph.any() || skin.any() || cached.any() || morph_colors || flat_normals; }
};

/// The evaluation of one scene for given needs: which stages run, and what they do. Immutable. A plan is a handle:
/// copies share the compiled data, and a FrameBuffer keeps these data alive. All characters that show the scene share
/// one plan.
/// A plan keeps its scene alive, and so do its frame buffers and the job threads that run it. The scene of a plan must
/// not change, with one exception: the caller may add, move and remove clips and animations of a lent scene. The plan
/// shares the clips themselves. Frames refer to clips by the index that they had when the plan was compiled.
class SINEW_API Plan {
 public:
  /// An empty handle: run_plan returns no_plan for it, and every other function except is_compiled() breaks a contract.
  Plan() noexcept = default;
  explicit Plan(std::shared_ptr<const CompiledPlan> compiled) noexcept : compiled_(std::move(compiled)) {}

  /// False for a default plan.
  bool is_compiled() const noexcept { return compiled_ != nullptr; }

  const Scene& scene() const noexcept;
  const Needs& needs() const noexcept;

  /// True if any frame can run the stage.
  bool runs(Stage stage) const noexcept;

  /// All stages in the order in which they run, each with the reason why frames run it or leave it out.
  /// cost O(size of the scene's tables), allocates the texts
  std::vector<PlanStage> stages() const;

  /// Size of the memory of one frame, a multiple of 64.
  std::size_t frame_bytes() const noexcept;

  std::span<const PrimitivePlan> primitives() const noexcept;       ///< one per primitive of each mesh instance
  std::span<const std::uint32_t> first_primitive() const noexcept;  ///< [instances + 1] into `primitives`
  /// [clips] tracks that a sample of each clip evaluates
  std::span<const ClipTracks> clip_tracks() const noexcept;
  std::span<const std::uint32_t> moved_joints() const noexcept;  ///< indices into FrameResult::model: moved by some
                                                                 ///< clip, or below such joints

  /// Internal (compiled_plan.h).
  const std::shared_ptr<const CompiledPlan>& compiled() const noexcept { return compiled_; }

 private:
  const CompiledPlan& get() const noexcept;

  std::shared_ptr<const CompiledPlan> compiled_;
};

inline const Primitive& primitive_of(const Plan& plan, const PrimitivePlan& planned) noexcept {
  const Scene& scene = plan.scene();
  return scene.meshes[scene.instances[planned.instance].mesh].primitives[planned.primitive];
}

/// World matrix of any joint of the scene. A joint that Needs::out.skeleton_lod leaves out follows the nearest joint
/// above it that poses have.
/// in   model  FrameResult::model of a frame of the plan
SINEW_API Affine world_of(const Plan& plan, std::span<const Affine> model, std::uint32_t joint) noexcept;

/// Joints of the scene that poses of the plan have, rising: all but those that Needs::out.skeleton_lod leaves out.
/// cost O(J), allocates
SINEW_API std::vector<std::uint32_t> kept_joints(const Plan& plan);

/// The index in poses of a joint of the scene; kNone where Needs::out.skeleton_lod leaves it out. Without a SkeletonLod
/// it is the joint itself.     cost O(1)
SINEW_API std::uint32_t pose_joint(const Plan& plan, std::uint32_t joint) noexcept;

/// Compiles the plan of a scene. share(std::move(scene)) makes a scene that plans keep alive; with lend(scene) the
/// caller keeps it alive (model/scene.h).
/// in   scene   must have passed check(Scene). Indices out of range break a contract
/// in   needs   must have no fault (find_fault in check_needs.h). A fault breaks a contract, whose text names the rule
///      beside  another plan of the same scene, for example of a finer level of detail. Both plans share the tables of
///              meshes that both need
/// cost O(size of the scene), allocates the plan, with a sorted copy of the vertices of skinned meshes (VertexTiles).
///      If joints are left out, also reduced copies of skeleton, clips and skins
SINEW_API Plan compile_plan(std::shared_ptr<const Scene> scene, const Needs& needs, const Plan& beside = {});

/// Same, for a scene that only this plan uses.
inline Plan compile_plan(Scene&& scene, const Needs& needs) { return compile_plan(share(std::move(scene)), needs); }

/// Same, for clips of a library (library/clip_library.h) in place of the scene's own. Layers name them by index.
/// in   clips   of the scene's joints, morph weights and properties; the plan shares them, so the array may be
///      destroyed
SINEW_API Plan compile_plan(std::shared_ptr<const Scene> scene, std::span<const Clip> clips, const Needs& needs,
                            const Plan& beside = {});

}  // namespace sinew
