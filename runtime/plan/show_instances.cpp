// SPDX-License-Identifier: MIT
#include "runtime/plan/show_instances.h"

#include <algorithm>

#include "runtime/base/same_bits.h"
#include "runtime/deform/grow_bounds.h"
#include "runtime/math/determinant_sign.h"
#include "runtime/model/mesh_copies.h"
#include "runtime/plan/deform_primitive.h"

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

/// The frame since which palette, weights and winding of a primitive are as they are now.
std::uint64_t since_of(const CompiledPlan& plan, const PrimitivePlan& planned, const FrameTables& tables) noexcept {
  std::uint64_t since = 0;
  const std::uint32_t i = planned.instance;
  if (planned.skin.any()) since = std::max(since, tables.palettes[plan.scene->instances[i].skin].since_frame);
  if (planned.morph.any() || planned.morph_colors) since = std::max(since, tables.weights_since[i]);
  if (planned.flat_normals) since = std::max(since, tables.winding_since[i]);
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

/// The vertices and the box of one instance, where they are not in the memory already.
void deform_instance(const CompiledPlan& plan, std::size_t i, InstanceResult placed, std::span<const float> weights,
                     bool uneven_root, const FrameStep& step, FrameWork& work) noexcept {
  const std::uint32_t first = plan.first_primitive[i], end = plan.first_primitive[i + 1];
  const std::span<DeformedPrimitive> shapes = step.tables.primitives;
  const auto is_current = [&](std::uint32_t p, std::uint64_t since) {
    return since != step.number && since == shapes[p].since_frame;
  };
  InstanceResult& last = step.tables.instances[i];
  bool box_is_current = plan.bounds && !last.bounds.empty() && same_bits(last.world_from_mesh, placed.world_from_mesh);
  for (std::uint32_t p = first; p < end && box_is_current; ++p)
    box_is_current = is_current(p, since_of(plan, plan.primitives[p], step.tables));
  if (box_is_current) placed.bounds = last.bounds;
  last = placed;
  for (std::uint32_t p = first; p < end; ++p) {
    const PrimitivePlan& planned = plan.primitives[p];
    const std::uint64_t since = since_of(plan, planned, step.tables);
    if (is_current(p, since) && (box_is_current || !plan.bounds)) continue;
    DeformedPrimitive& shape = shapes[p] =
        deform_primitive(plan, p, weights, placed.mirrored, uneven_root, step.memory, work);
    shape.since_frame = since;
    if (plan.bounds) bound(last, plan.scene->instances[i], primitive_of(plan, planned), shape, work);
    if (!plan.needs.positions) shape.positions = {};
  }
}

/// One instance of the frame.
void show_instance(const CompiledPlan& plan, std::size_t i, const EvaluatedPose& pose, const RootScale& root,
                   const FrameStep& step, FrameWork& work) noexcept {
  InstanceResult placed = place_instance(plan, i, pose.model, root, work);
  placed.visible = !pose.visibility.is_hidden(plan, i) && !pose.visibility.is_out_of_view(i);
  const std::uint32_t first = plan.scene->first_weight[i], end = plan.scene->first_weight[i + 1];
  const std::span<const float> weights = pose.weights.subspan(first, end - first);
  number_changes(plan, i, weights, placed, step);
  if (pose.visibility.is_deformed(plan, i)) return deform_instance(plan, i, placed, weights, root.uneven, step, work);
  step.tables.instances[i] = placed;
  deform_nothing(plan, i, step.tables.primitives);
}

}  // namespace

void deform_nothing(const CompiledPlan& plan, std::size_t instance, std::span<DeformedPrimitive> shapes) noexcept {
  for (std::uint32_t p = plan.first_primitive[instance]; p < plan.first_primitive[instance + 1]; ++p)
    shapes[p] = nothing_deformed(plan.primitives[p]);
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
  for (std::size_t p = 0; p < tables.primitives.size(); ++p)
    if (tables.primitives[p].since_frame != 0)
      tables.primitives[p].since_frame = since_of(plan, plan.primitives[p], tables);
}

}  // namespace sinew
