// SPDX-License-Identifier: MIT
#include "runtime/plan/show_instances.h"

#include <algorithm>

#include "runtime/base/same_bits.h"
#include "runtime/deform/grow_bounds.h"
#include "runtime/math/determinant_sign.h"
#include "runtime/model/scene.h"
#include "runtime/plan/play_geometry.h"

namespace sinew {
namespace {

/// What FrameInput::root does to the joints below it.
struct RootScale {
  int sign;     // of its determinant
  bool uneven;  // false where the normal rule does not ask

  RootScale(const CompiledPlan& plan, const Affine& root) noexcept
      : sign(determinant_sign(root)),
        uneven(plan.needs.normal_rule == NormalRule::cofactor && scale_kind(root) == ScaleKind::uneven) {}
};

/// Whether the matrix that places an instance mirrors it: by its own determinant where scale can change sign, else as
/// the plan knows.
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

/// Numbers of frames since which the instance's morph weights and winding hold, by comparison with the frame before.
void number_changes(const CompiledPlan& plan, std::size_t i, std::span<const float> weights,
                    const InstanceResult& placed, const FrameStep& step) noexcept {
  const auto number = [&](std::span<std::uint64_t> since, std::span<std::uint64_t> since_before, bool same) {
    since[i] = same && since_before[i] != 0 ? since_before[i] : step.number;
  };
  const std::size_t first = plan.scene->first_weight[i];
  const std::span<const float> before = step.tables_before.last_weights.subspan(first, weights.size());
  number(step.tables.weights_since, step.tables_before.weights_since, same_bits(weights, before));
  number(step.tables.winding_since, step.tables_before.winding_since,
         step.tables_before.instances[i].mirrored == placed.mirrored);
}

/// The frame since which palette, weights, winding and source of a primitive are as they are now.
std::uint64_t since_of(const CompiledPlan& plan, const PrimitivePlan& planned, const FrameTables& tables) noexcept {
  std::uint64_t since = 0;
  const std::uint32_t i = planned.instance;
  if (planned.flat_normals) since = std::max(since, tables.winding_since[i]);
  if (planned.cached.any()) {
    const std::uint32_t slot = geometry_slot_of(plan, i);
    since = std::max(since, tables.geometry_since[slot]);
    if (tables.played[slot].in_full()) return since;
  }
  if (planned.skin.any()) since = std::max(since, tables.palettes[plan.scene->instances[i].skin].since_frame);
  if (planned.morph.any() || planned.morph_colors) since = std::max(since, tables.weights_since[i]);
  return since;
}

/// Adds one primitive to the box of its instance: the moved rest box where it rests in this frame, else its vertices.
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

/// What one instance of a frame shows.
struct SeenInstance {
  std::size_t i;
  InstanceResult placed;
  InstancePose pose;
  const PlayedGeometry* played = nullptr;  ///< null: nothing plays
  const VertexSource* source = nullptr;
};

/// The box that a source knows.
void bound(InstanceResult& placed, const MeshInstance& instance, const Aabb& box, FrameWork& work) noexcept {
  for_each_copy(instance, placed.world_from_mesh,
                [&](const Affine& world_from_copy) { grow_bounds(placed.bounds, box, world_from_copy); });
  work.spent_on(Stage::bounds);
}

/// The vertices and the box of one instance, where they are not in the memory already.
void deform_instance(const CompiledPlan& plan, SeenInstance& seen, const FrameStep& step, FrameWork& work) noexcept {
  const std::uint32_t first = plan.first_primitive[seen.i], end = plan.first_primitive[seen.i + 1];
  const std::span<DeformedPrimitive> shapes = step.tables.primitives;
  const MeshInstance& instance = plan.scene->instances[seen.i];
  const auto is_current = [&](std::uint32_t p, std::uint64_t since) {
    return since != step.number && since == shapes[p].since_frame;
  };
  InstanceResult& last = step.tables.instances[seen.i];
  const bool box_is_known = plan.bounds && seen.played != nullptr && seen.played->in_full();
  bool box_is_current =
      plan.bounds && !last.bounds.empty() && same_bits(last.world_from_mesh, seen.placed.world_from_mesh);
  for (std::uint32_t p = first; p < end && box_is_current; ++p)
    box_is_current = is_current(p, since_of(plan, plan.primitives[p], step.tables));
  if (box_is_current) seen.placed.bounds = last.bounds;
  last = seen.placed;
  if (box_is_known && !box_is_current)
    bound(last, instance, step.tables.shown[geometry_slot_of(plan, seen.i)].bounds, work);
  for (std::uint32_t p = first; p < end; ++p) {
    const PrimitivePlan& planned = plan.primitives[p];
    const std::uint64_t since = since_of(plan, planned, step.tables);
    if (is_current(p, since) && (box_is_current || box_is_known || !plan.bounds)) continue;
    DeformedPrimitive& shape = shapes[p];
    shape = seen.played != nullptr && planned.cached.any()
                ? play_primitive(plan, p, *seen.source, *seen.played, seen.pose, step.memory, work)
                : deform_primitive(plan, p, seen.pose, true, step.memory, work);
    shape.since_frame = since;
    if (plan.bounds && !box_is_known) bound(last, instance, primitive_of(plan, planned), shape, work);
    if (!plan.needs.positions) shape.positions = {};
  }
}

/// Finds out what an instance plays, and numbers it.
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
  number_geometry(slot, played, step);
  if (played.weight > 0.0f) seen.played = &step.tables.played[slot];
}

/// One instance of the frame.
void show_instance(const CompiledPlan& plan, std::size_t i, const EvaluatedPose& pose, const RootScale& root,
                   const FrameStep& step, FrameWork& work) noexcept {
  SeenInstance seen{.i = i, .placed = place_instance(plan, i, pose.model, root, work), .pose = {}};
  seen.placed.visible = !pose.visibility.is_hidden(plan, i) && !pose.visibility.is_out_of_view(i);
  const std::uint32_t first = plan.scene->first_weight[i], end = plan.scene->first_weight[i + 1];
  seen.pose = {pose.weights.subspan(first, end - first), seen.placed.mirrored, root.uneven,
               step.past_caches && !plan.bounds};
  const bool is_deformed = pose.visibility.is_deformed(plan, i);
  if (is_deformed) play(plan, pose, root, seen, step);
  number_changes(plan, i, seen.pose.weights, seen.placed, step);
  if (is_deformed) return deform_instance(plan, seen, step, work);
  step.tables.instances[i] = seen.placed;
  deform_nothing(plan, i, step.tables);
}

}  // namespace

void deform_nothing(const CompiledPlan& plan, std::size_t instance, const FrameTables& tables) noexcept {
  for (std::uint32_t p = plan.first_primitive[instance]; p < plan.first_primitive[instance + 1]; ++p)
    tables.primitives[p] = nothing_deformed(plan.primitives[p]);
  if (const std::uint32_t slot = geometry_slot_of(plan, instance); slot != kNone) tables.geometry_since[slot] = 0;
}

void show_instances(const CompiledPlan& plan, const EvaluatedPose& pose, const FrameStep& step,
                    FrameWork& work) noexcept {
  const RootScale root(plan, pose.root);
  for (std::size_t i = 0; i < step.tables.instances.size(); ++i) show_instance(plan, i, pose, root, step, work);
  std::copy(pose.weights.begin(), pose.weights.end(), step.tables.last_weights.begin());
}

void number_kept_instances(const CompiledPlan& plan, const FrameStep& step) noexcept {
  const FrameTables& tables = step.tables;
  for (std::size_t i = 0; i < tables.instances.size(); ++i) {
    const std::uint32_t first = plan.scene->first_weight[i], end = plan.scene->first_weight[i + 1];
    if (tables.weights_since[i] != 0)  // else the character sleeps
      number_changes(plan, i, tables.last_weights.subspan(first, end - first), tables.instances[i], step);
  }
  for (std::size_t slot = 0; slot < tables.geometry_since.size(); ++slot)
    if (tables.geometry_since[slot] != 0) number_geometry(slot, PlayedGeometry(tables.played[slot]), step);
  for (std::size_t p = 0; p < tables.primitives.size(); ++p)
    if (tables.primitives[p].since_frame != 0)
      tables.primitives[p].since_frame = since_of(plan, plan.primitives[p], tables);
}

}  // namespace sinew
