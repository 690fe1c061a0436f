// SPDX-License-Identifier: MIT
#include "runtime/plan/evaluate/deform_primitive.h"

#include <algorithm>
#include <cassert>

#include "runtime/deform/flat_normals.h"
#include "runtime/deform/morph_tiles.h"
#include "runtime/deform/morph_vertices.h"
#include "runtime/deform/skin_center_of_rotation.h"
#include "runtime/deform/skin_dual_quaternion.h"
#include "runtime/deform/skin_linear.h"
#include "runtime/deform/skin_tiles.h"

namespace sinew {
namespace {

/// Number of morph displacements that this frame adds, to vertices and to colors.
struct ActiveDeltas {
  std::uint64_t shape = 0, colors = 0;
};

ActiveDeltas active_deltas(const MorphSet& morphs, std::span<const float> weights,
                           const PrimitivePlan& planned) noexcept {
  ActiveDeltas active;
  if (!planned.morph.any() && !planned.morph_colors) return active;
  for (std::size_t t = 0; t < morphs.targets.size(); ++t) {
    if (!is_active_weight(weights[t])) continue;
    const MorphTarget& target = morphs.targets[t];
    if (planned.morph.positions) active.shape += target.positions.vertices.size();
    if (planned.morph.normals) active.shape += target.normals.vertices.size();
    if (planned.morph.tangents) active.shape += target.tangents.vertices.size();
    if (planned.morph_colors) active.colors += target.colors.vertices.size();
  }
  return active;
}

/// Runs the stages of one primitive in order. `now` holds the state of its vertices after the stages run so far.
struct Deformation {
  const CompiledPlan& plan;
  const PrimitivePlan& planned;
  const PrimitiveSkinning& skinning;
  const VertexBlocks& blocks;
  const Primitive& primitive;
  FrameMemory memory;
  FrameWork& work;
  VertexInput now;
  TiledInput morphed = {};  ///< vertices in tiles that are morphed but not skinned yet

  void morph(std::span<const float> weights) noexcept {
    if (skinning.morphs != nullptr) return morph_tiles(weights);
    const std::size_t count = primitive.vertex_count();
    const bool in_between = planned.skin.any();
    const VertexOutput out = output_in(memory, planned.morph, in_between ? plan.layout.morphed : blocks, count);
    const MorphVerticesJob job{.morphs = &primitive.morphs,
                               .weights = weights,
                               .vertices = now,
                               .out = out,
                               .scratch = memory.of(plan.layout.morph_scratch.part(0, count)),
                               .normalise = !in_between};
    assert(check(job) == ErrorCode::ok);
    run_unchecked(job);
    work.vertices_morphed += count;
    replace(out);
    work.spent_on(Stage::morph);
  }

  void skin(bool uneven_root, bool past_caches) noexcept {
    const VertexOutput out = output_in(memory, planned.skin, blocks, primitive.vertex_count());
    switch (planned.skinning) {
      case Skinning::linear:
        skin_linear(out, planned.cofactors || (uneven_root && plan.needs.skin.normal_rule == NormalRule::cofactor),
                    past_caches);
        break;
      case Skinning::dual_quaternion: skin_dual_quaternion(out); break;
      case Skinning::center_of_rotation: skin_center_of_rotation(out); break;
    }
    replace(out);
  }

 private:
  void morph_tiles(std::span<const float> weights) noexcept {
    const TiledBlocks& tiled = plan.layout.morphed_tiles;
    const std::size_t count = skinning.tiles->tile_count();
    const TiledOutput out{.positions = memory.of(tiled.positions.part(0, planned.morph.positions ? 3 * count : 0)),
                          .normals = memory.of(tiled.normals.part(0, planned.morph.normals ? 3 * count : 0)),
                          .tangents = memory.of(tiled.tangents.part(0, planned.morph.tangents ? 4 * count : 0))};
    const MorphTilesJob job{
        .tiles = skinning.tiles.get(), .morphs = skinning.morphs.get(), .weights = weights, .out = out};
    run_counted(job, work.vertices_morphed, Stage::morph);
    morphed = {.positions = out.positions, .normals = out.normals, .tangents = out.tangents};
  }

  std::uint32_t skin_index() const noexcept { return plan.scene->instances[planned.instance].skin; }
  std::span<const JointMatrix> palette() const noexcept { return memory.of(plan.layout.palettes[skin_index()]); }
  std::span<const RigidStretch> split() const noexcept { return memory.of(plan.layout.splits[skin_index()]); }
  bool any_stretch() const noexcept { return memory.of(plan.layout.stretch)[skin_index()]; }

  template <class Job>
  void run_counted(const Job& job, std::uint64_t& counter, Stage stage) noexcept {
    assert(check(job) == ErrorCode::ok);
    run_unchecked(job);
    counter += primitive.vertex_count();
    work.spent_on(stage);
  }

  void skin_linear(const VertexOutput& out, bool cofactors, bool past_caches) noexcept {
    const NormalRule rule = cofactors ? NormalRule::cofactor : NormalRule::linear;
    if (cofactors && !out.normals.empty()) work.normals_by_cofactors += primitive.vertex_count();
    if (skinning.tiles != nullptr) {
      work.vertices_skinned_in_tiles += primitive.vertex_count();
      const SkinTilesJob job{.tiles = skinning.tiles.get(),
                             .palette = palette(),
                             .out = out,
                             .normal_rule = rule,
                             .past_caches = past_caches,
                             .morphed = morphed};
      return run_counted(job, work.vertices_skinned_linear, Stage::skin_linear);
    }
    const bool combined = skinning.combined != kNone;
    const SkinLinearJob job{
        .influences = combined ? &plan.combined[skin_index()][skinning.combined].vertices : &primitive.influences,
        .palette = palette(),
        .vertices = now,
        .out = out,
        .normal_rule = rule,
        .past_caches = past_caches};
    run_counted(job, work.vertices_skinned_linear, Stage::skin_linear);
  }

  void skin_dual_quaternion(const VertexOutput& out) noexcept {
    const SkinDualQuaternionJob job{.influences = &primitive.influences,
                                    .split = split(),
                                    .any_stretch = any_stretch(),
                                    .vertices = now,
                                    .out = out,
                                    .pairs = skinning.pairs,
                                    .palette = palette(),
                                    .tiles = skinning.tiles.get()};
    run_counted(job, work.vertices_skinned_dual_quaternion, Stage::skin_dual_quaternion);
  }

  void skin_center_of_rotation(const VertexOutput& out) noexcept {
    const SkinCenterOfRotationJob job{.influences = &primitive.influences,
                                      .palette = palette(),
                                      .split = split(),
                                      .any_stretch = any_stretch(),
                                      .centers = primitive.centers_of_rotation,
                                      .vertices = now,
                                      .out = out,
                                      .pairs = skinning.pairs,
                                      .tiles = skinning.tiles.get()};
    run_counted(job, work.vertices_skinned_center_of_rotation, Stage::skin_center_of_rotation);
  }

  void replace(const VertexOutput& written) noexcept {
    if (!written.positions.empty()) now.positions = written.positions;
    if (!written.normals.empty()) now.normals = written.normals;
    if (!written.tangents.empty()) now.tangents = written.tangents;
  }
};

}  // namespace

VertexOutput output_in(FrameMemory memory, const AttributeSet& set, const VertexBlocks& blocks,
                       std::size_t count) noexcept {
  return {.positions = memory.of(blocks.positions.part(0, set.positions ? count : 0)),
          .normals = memory.of(blocks.normals.part(0, set.normals ? count : 0)),
          .tangents = memory.of(blocks.tangents.part(0, set.tangents ? count : 0))};
}

std::span<const glm::vec3> flatten_primitive(const CompiledPlan& plan, std::size_t p,
                                             std::span<const glm::vec3> positions, bool turned, FrameMemory memory,
                                             FrameWork& work) noexcept {
  const Primitive& primitive = primitive_of(plan, plan.primitives[p]);
  const FlatFaces& faces = *plan.flat_faces[p];
  const std::span<glm::vec3> normals = memory.of(plan.layout.primitives[p].normals);
  run_unchecked(FlatNormalsJob{.faces = &faces,
                               .positions = positions,
                               .rest_normals = primitive.normals,
                               .turned = turned,
                               .normals = normals});
  work.flat_triangles += faces.count;
  work.spent_on(Stage::flat_normals);
  return normals;
}

DeformedPrimitive deform_primitive(const CompiledPlan& plan, std::size_t p, const InstancePose& pose, bool flattens,
                                   FrameMemory memory, FrameWork& work) noexcept {
  const PrimitivePlan& planned = plan.primitives[p];
  const VertexBlocks& blocks = plan.layout.primitives[p];
  const Primitive& primitive = primitive_of(plan, planned);
  const bool skins = planned.skin.any();
  const AttributeSet deformed = {
      planned.morph.positions || planned.skin.positions || planned.cached.positions,
      planned.morph.normals || planned.skin.normals || planned.cached.normals || planned.flat_normals,
      planned.morph.tangents || planned.skin.tangents || planned.cached.tangents};
  Deformation stages{plan,
                     planned,
                     plan.primitive_skinning[p],
                     blocks,
                     primitive,
                     memory,
                     work,
                     {.positions = primitive.positions, .normals = {}, .tangents = {}}};
  if (deformed.normals) stages.now.normals = primitive.normals;
  if (deformed.tangents) stages.now.tangents = primitive.tangents;

  const ActiveDeltas active = active_deltas(primitive.morphs, pose.weights, planned);
  work.morph_deltas += active.shape + active.colors;
  if (active.shape > 0) stages.morph(pose.weights);
  if (skins) stages.skin(pose.uneven_root, pose.past_caches && flattens && !planned.flat_normals);
  if (flattens && planned.flat_normals && (active.shape > 0 || skins))
    stages.now.normals = flatten_primitive(plan, p, stages.now.positions, pose.mirrored && skins, memory, work);

  DeformedPrimitive result{.instance = planned.instance,
                           .primitive = planned.primitive,
                           .positions = {},
                           .normals = {},
                           .tangents = {},
                           .colors = {}};
  if (deformed.positions) result.positions = stages.now.positions;
  if (deformed.normals) result.normals = stages.now.normals;
  if (deformed.tangents) result.tangents = stages.now.tangents;
  if (planned.morph_colors && active.colors == 0) result.colors = primitive.colors;
  if (active.colors > 0) {
    const std::span<glm::vec4> colors = memory.of(blocks.colors);
    morph_colors(primitive.morphs, pose.weights, primitive.colors, colors);
    result.colors = colors;
    work.spent_on(Stage::morph);
  }
  return result;
}

}  // namespace sinew
