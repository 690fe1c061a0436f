// SPDX-License-Identifier: MIT
#include "runtime/plan/evaluate/show_instances.h"

#include <algorithm>

#include "runtime/deform/grow_bounds.h"
#include "runtime/math/determinant_sign.h"
#include "runtime/model/scene.h"
#include "runtime/plan/evaluate/play_geometry.h"

namespace sinew {
namespace {

/// How FrameInput::root scales the joints below it.
struct RootScale {
  int sign;     // of its determinant
  bool uneven;  // always false if the plan's normal rule does not depend on it

  RootScale(const CompiledPlan& plan, const Affine& root) noexcept
      : sign(determinant_sign(root)),
        uneven(plan.needs.skin.normal_rule == NormalRule::cofactor && scale_kind(root) == ScaleKind::uneven) {}
};

/// True if the matrix that places an instance mirrors it. The determinant is computed only if a scale can change its
/// sign; otherwise the plan knows the sign.
bool is_mirrored(const CompiledPlan& plan, std::size_t instance, std::span<const Affine> model, const RootScale& root,
                 FrameWork& work) noexcept {
  const JointScale& scale = plan.instance_scales[instance];
  if (!scale.may_change) return scale.sign * root.sign < 0;
  work.windings_tested += 1;
  const MeshInstance& mesh = plan.scene->instances[instance];
  if (!plan.instance_skinned[instance]) return determinant_sign(world_of(plan.assets, model, mesh.joint)) < 0;
  const Skin& skin = *plan.assets.skins[mesh.skin];
  return determinant_sign(model[skin.joints[0]]) * determinant_sign(skin.inverse_bind[0]) < 0;
}

/// The world matrix of an instance, and whether it is mirrored.
InstanceResult place_instance(const CompiledPlan& plan, std::size_t instance, std::span<const Affine> model,
                              const RootScale& root, FrameWork& work) noexcept {
  InstanceResult placed;
  placed.first_primitive = plan.first_primitive[instance];
  if (model.empty()) return placed;
  if (!plan.instance_skinned[instance])
    placed.world_from_mesh = world_of(plan.assets, model, plan.scene->instances[instance].joint);
  placed.mirrored = is_mirrored(plan, instance, model, root, work);
  if (plan.instance_scales[instance].may_change) work.spent_on(Stage::winding);
  return placed;
}

/// Adds one primitive to the box of its instance: its rest box, moved, if it is at rest in this frame, else its
/// vertices.
void bound(InstanceResult& placed, const MeshInstance& instance, const Primitive& primitive,
           const DeformedPrimitive& shape, FrameWork& work) noexcept {
  const bool rests = shape.positions.empty() || shape.positions.data() == primitive.positions.data();
  for_each_copy(instance, placed.world_from_mesh, [&](const Affine& world_from_copy) {
    if (rests) return grow_bounds(placed.bounds, primitive.bounds, world_from_copy);
    grow_bounds(placed.bounds, shape.positions, world_from_copy);
    work.bounds_vertices += shape.positions.size();
  });
  work.spent_on(Stage::bounds);
}

/// A visible instance of a frame.
struct SeenInstance {
  std::size_t i;
  InstanceResult placed;
  InstancePose pose;
  const PlayedGeometry* played = nullptr;  ///< null: nothing plays
  const VertexSource* source = nullptr;
};

/// Sets the box of an instance from the box that its source provides.
void bound(InstanceResult& placed, const MeshInstance& instance, const Aabb& box, FrameWork& work) noexcept {
  for_each_copy(instance, placed.world_from_mesh,
                [&](const Affine& world_from_copy) { grow_bounds(placed.bounds, box, world_from_copy); });
  work.spent_on(Stage::bounds);
}

/// Computes the vertices and the box of one instance, except parts that are still valid in the memory.
void deform_instance(const CompiledPlan& plan, SeenInstance& seen, const FrameStep& step, FrameWork& work) noexcept {
  const std::uint32_t first = plan.first_primitive[seen.i], end = plan.first_primitive[seen.i + 1];
  const std::span<DeformedPrimitive> shapes = step.tables.primitives;
  const MeshInstance& instance = plan.scene->instances[seen.i];
  InstanceResult& last = step.tables.instances[seen.i];
  const bool box_is_known = plan.bounds && seen.played != nullptr && seen.played->in_full();
  const bool box_stands = plan.bounds && step.reuse.box_stands(seen.i, seen.placed.world_from_mesh);
  if (box_stands) seen.placed.bounds = last.bounds;
  last = seen.placed;
  if (box_is_known && !box_stands)
    bound(last, instance, step.tables.shown[geometry_slot_of(plan, seen.i)].bounds, work);
  for (std::uint32_t p = first; p < end; ++p) {
    const PrimitivePlan& planned = plan.primitives[p];
    const std::uint64_t since = step.reuse.vertices_since(planned);
    if (step.reuse.vertices_stand(p, since) && (box_stands || box_is_known || !plan.bounds)) continue;
    DeformedPrimitive& shape = shapes[p];
    shape = seen.played != nullptr && planned.cached.any()
                ? play_primitive(plan, p, *seen.source, *seen.played, seen.pose, step.memory, work)
                : deform_primitive(plan, p, seen.pose, true, step.memory, work);
    shape.since_frame = since;
    if (plan.bounds && !box_is_known) bound(last, instance, primitive_of(plan, planned), shape, work);
    if (!plan.needs.out.positions) shape.positions = {};
  }
}

/// Finds the geometry that an instance plays.
void play(const CompiledPlan& plan, const EvaluatedPose& pose, const RootScale& root, SeenInstance& seen,
          const FrameStep& step) noexcept {
  const std::uint32_t slot = geometry_slot_of(plan, seen.i);
  if (slot == kNone) return;
  PlayedGeometry played;
  if (!pose.geometry.empty()) {
    seen.source = &pose.geometry[slot].source;
    played = place_geometry(plan, seen.i, pose.geometry[slot], step.tables.shown[slot],
                            world_of(plan.assets, pose.model, plan.scene->instances[seen.i].joint), pose.root,
                            root.sign, seen.placed);
  }
  step.reuse.add_geometry(slot, played);
  if (played.weight > 0.0f) seen.played = &step.tables.played[slot];
}

/// Leaves the primitives of an invisible instance undeformed.
void deform_nothing(const CompiledPlan& plan, std::size_t instance, const FrameTables& tables) noexcept {
  for (std::uint32_t p = plan.first_primitive[instance]; p < plan.first_primitive[instance + 1]; ++p)
    tables.primitives[p] = nothing_deformed(plan.primitives[p]);
}

void show_instance(const CompiledPlan& plan, std::size_t i, const EvaluatedPose& pose, const RootScale& root,
                   const FrameStep& step, FrameWork& work) noexcept {
  SeenInstance seen{.i = i, .placed = place_instance(plan, i, pose.model, root, work), .pose = {}};
  seen.placed.visible = !pose.visibility.is_hidden(plan, i) && !pose.visibility.is_out_of_view(i);
  const std::uint32_t first = plan.scene->first_weight[i], end = plan.scene->first_weight[i + 1];
  seen.pose = {pose.weights.subspan(first, end - first), seen.placed.mirrored, root.uneven,
               step.past_caches && !plan.bounds};
  const bool is_deformed = pose.visibility.is_deformed(plan, i);
  if (is_deformed) play(plan, pose, root, seen, step);
  step.reuse.add_instance(i, seen.pose.weights, seen.placed.mirrored);
  if (is_deformed) return deform_instance(plan, seen, step, work);
  step.tables.instances[i] = seen.placed;
  deform_nothing(plan, i, step.tables);
  if (const std::uint32_t slot = geometry_slot_of(plan, i); slot != kNone) step.reuse.forget_geometry(slot);
}

}  // namespace

void show_instances(const CompiledPlan& plan, const EvaluatedPose& pose, const FrameStep& step,
                    FrameWork& work) noexcept {
  const RootScale root(plan, pose.root);
  for (std::size_t i = 0; i < step.tables.instances.size(); ++i) show_instance(plan, i, pose, root, step, work);
  step.reuse.add_weights(pose.weights);
}

void hide_instances(const CompiledPlan& plan, const FrameTables& tables) noexcept {
  for (std::size_t i = 0; i < tables.instances.size(); ++i) {
    tables.instances[i] = {
        .world_from_mesh = {}, .first_primitive = plan.first_primitive[i], .visible = false, .bounds = {}};
    deform_nothing(plan, i, tables);
  }
}

}  // namespace sinew
