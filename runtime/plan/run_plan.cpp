// SPDX-License-Identifier: MIT
#include "runtime/plan/run_plan.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "runtime/base/same_bits.h"
#include "runtime/deform/grow_bounds.h"
#include "runtime/model/mesh_copies.h"
#include "runtime/plan/deform_primitive.h"
#include "runtime/plan/evaluate_pose.h"
#include "runtime/plan/find_hidden.h"
#include "runtime/plan/frame_tables.h"
#include "runtime/plan/interpolate_poses.h"
#include "runtime/plan/make_palettes.h"
#include "runtime/plan/plays_alone.h"
#include "runtime/pose/correct_pose.h"
#include "runtime/pose/local_to_model.h"

namespace sinew {
namespace {

ErrorCode check(const Plan& plan, std::span<const ClipLayer> layers) noexcept {
  std::size_t active = 0;
  double total_weight = 0.0;
  for (const ClipLayer& layer : layers) {
    if (layer.clip >= plan.scene->clips.size()) return ErrorCode::index_out_of_range;
    if (!std::isfinite(layer.time_s) || !std::isfinite(layer.weight)) return ErrorCode::not_finite;
    if (layer.mask != kNone && layer.mask >= plan.needs.masks.size()) return ErrorCode::index_out_of_range;
    const bool adds = layer.kind != LayerKind::blend;
    if (layer.weight < 0.0f || (adds && !plan.needs.additive)) return ErrorCode::unsupported;
    if (adds) continue;
    active += layer.weight != 0.0f;
    total_weight += static_cast<double>(layer.weight);
  }
  if (active > plan.needs.max_layers) return ErrorCode::size_mismatch;
  return plan.sample && !plan.blend && active > 0 && total_weight < 1.0 ? ErrorCode::unsupported : ErrorCode::ok;
}

ErrorCode check(const Plan& plan, const FrameInput& input) noexcept {
  if (!(input.interpolation_factor >= 0.0f && input.interpolation_factor <= 1.0f) ||
      (input.interpolation_factor != 0.0f && !plan.needs.between_updates))
    return ErrorCode::unsupported;
  for (const std::span<const ClipLayer> layers :
       {input.layers, input.interpolation_factor != 0.0f ? input.next_layers : std::span<const ClipLayer>{}})
    if (const ErrorCode error = check(plan, layers); error != ErrorCode::ok) return error;
  if (!input.weights.empty() && input.weights.size() != plan.rest_weights.size()) return ErrorCode::size_mismatch;
  if (!input.out_of_view.empty() && input.out_of_view.size() != plan.scene->instances.size())
    return ErrorCode::size_mismatch;
  for (const float weight : input.weights)
    if (!std::isfinite(weight)) return ErrorCode::not_finite;
  return ErrorCode::ok;
}

/// Adds to the frame's morph weights what its local pose calls for.
void correct_weights(const Plan& plan, const PoseSpan& local, FrameMemory memory, FrameWork& work) noexcept {
  if (!plan.correctives) return;
  for (const PoseCorrective& corrective : plan.rig.correctives) {
    const CorrectPoseJob job{.corrective = &corrective,
                             .pose = local,
                             .scratch = memory.array<double>(plan.corrective_scratch_at, plan.corrective_scratch_count),
                             .weights = memory.array<float>(plan.weights_at, plan.rest_weights.size())};
    assert(check(job) == ErrorCode::ok);
    run(job);
    work.poses_compared += corrective.samples.sample_count();
  }
  work.spent_on(Stage::correctives);
}

/// The pose with the rest pose, to the last bit, in joints that no clip moves: a mean of layers rounds them (P01). In
/// the frame's own pose, as others may be of an update that is kept.
PoseSpan with_unmoved_at_rest(const Plan& plan, const PoseSpan& local, FrameMemory memory) noexcept {
  const PoseSpan rest = memory.pose(plan.rest_pose_at, plan.rig.joint_count()),
                 own = memory.pose(plan.pose_at, plan.rig.joint_count());
  if (local.planes != own.planes) std::copy_n(local.planes, PoseSpan::floats_for(local.joint_count), own.planes);
  std::size_t next = 0;
  for (std::size_t j = 0; j < own.joint_count; ++j) {
    if (next < plan.moved_joints.size() && plan.moved_joints[next] == j)
      ++next;
    else
      own.set(j, rest.get(j));
  }
  return own;
}

/// World matrices of all joints, or nothing when the plan leaves them out. Those that are there already are not made
/// again (P01).
std::span<const Affine> compose(const Plan& plan, const PoseSpan& local, const Affine& root, const FrameStep& step,
                                FrameWork& work) noexcept {
  if (!plan.local_to_model) return {};
  const std::size_t joints = plan.rig.joint_count();
  const std::span<Affine> model = step.memory.array<Affine>(plan.model_at, joints);
  if (step.standing == StandingJoints::all) return model;
  LocalToModelJob job{.skeleton = plan.rig.skeleton, .local = local, .root = root, .model = model};
  if (step.standing == StandingJoints::unmoved)
    job.only = plan.moved_joints;
  else if (step.is_mean)
    job.local = with_unmoved_at_rest(plan, local, step.memory);
  assert(check(job) == ErrorCode::ok);
  run(job);
  work.joints_composed += job.only.empty() ? joints : job.only.size();
  work.spent_on(Stage::local_to_model);
  return model;
}

/// Joints that this frame does not show; empty when the plan hides nothing. What no clip decides was found once for all
/// frames.
std::span<const bool> hide(const Plan& plan, std::span<const float> properties, FrameMemory memory,
                           FrameWork& work) noexcept {
  if (!plan.hide) return {};
  const std::span<bool> hidden = memory.array<bool>(plan.hidden_at, plan.scene->skeleton.joint_count());
  if (plan.hide_per_frame && plan.properties) {
    find_hidden(*plan.scene, properties, hidden);
    work.spent_on(Stage::properties);
  }
  return hidden;
}

/// What this frame need not show.
struct Unseen {
  std::span<const bool> hidden;               // [joints], empty = none
  std::span<const std::uint8_t> out_of_view;  // [instances], empty = none

  bool is_hidden(const Plan& plan, std::size_t instance) const noexcept {
    return !hidden.empty() && hidden[plan.scene->instances[instance].joint];
  }
  bool is_out_of_view(std::size_t instance) const noexcept {
    return !out_of_view.empty() && out_of_view[instance] != 0;
  }
  bool is_deformed(const Plan& plan, std::size_t instance) const noexcept {
    return !is_out_of_view(instance) && (plan.needs.hidden_meshes || !is_hidden(plan, instance));
  }
};

/// Skins that some instance of this frame needs; empty = as the plan says.
std::span<const bool> wanted_palettes(const Plan& plan, const Unseen& unseen, FrameMemory memory) noexcept {
  if (!plan.hide_per_frame && unseen.out_of_view.empty()) return {};
  const std::span<bool> wanted = memory.array<bool>(plan.palette_wanted_at, plan.palette.size());
  std::fill(wanted.begin(), wanted.end(), false);
  for (std::size_t i = 0; i < plan.scene->instances.size(); ++i)
    if (const std::uint32_t skin = plan.scene->instances[i].skin; skin != kNone)
      wanted[skin] = wanted[skin] || unseen.is_deformed(plan, i);
  return wanted;
}

/// What the root that is placed above all joints does to them.
struct RootScale {
  int sign;     // of its determinant
  bool uneven;  // looked at where some normals follow cofactors only then

  RootScale(const Plan& plan, const Affine& root) noexcept
      : sign(determinant_sign(affine_cast<double>(root))),
        uneven(plan.needs.normal_rule == NormalRule::cofactor && scale_kind(root) == ScaleKind::uneven) {}
};

/// Whether the matrix that places an instance mirrors it: by its own determinant where scale can change sign, else as
/// planned (P09).
bool is_mirrored(const Plan& plan, std::size_t instance, std::span<const Affine> model, const RootScale& root,
                 FrameWork& work) noexcept {
  const JointScale& scale = plan.instance_scales[instance];
  if (!scale.may_change) return scale.sign * root.sign < 0;
  work.windings_tested += 1;
  const MeshInstance& mesh = plan.scene->instances[instance];
  if (!plan.instance_skinned[instance])
    return determinant_sign(affine_cast<double>(world_of(plan.rig, model, mesh.joint))) < 0;
  const Skin& skin = *plan.rig.skins[mesh.skin];
  return determinant_sign(affine_cast<double>(model[skin.joints[0]]) * affine_cast<double>(skin.inverse_bind[0])) < 0;
}

/// Where an instance stands, and whether it is mirrored (G48).
InstanceResult place_instance(const Plan& plan, std::size_t instance, std::span<const Affine> model,
                              const RootScale& root, FrameWork& work) noexcept {
  InstanceResult placed;
  placed.first_primitive = plan.first_primitive[instance];
  if (model.empty()) return placed;
  if (!plan.instance_skinned[instance])
    placed.world_from_mesh = world_of(plan.rig, model, plan.scene->instances[instance].joint);
  placed.mirrored = is_mirrored(plan, instance, model, root, work);
  if (plan.instance_scales[instance].may_change) work.spent_on(Stage::winding);
  return placed;
}

/// Stamps of the instance's morph weights and winding, by comparison with the frame before.
void stamp_instance(const Plan& plan, std::size_t i, std::span<const float> weights, const InstanceResult& placed,
                    const FrameStep& step) noexcept {
  const auto stamp = [&](std::span<std::uint64_t> since, std::span<std::uint64_t> since_before, bool same) {
    since[i] = same && since_before[i] != 0 ? since_before[i] : step.number;
  };
  const std::size_t first = plan.scene->first_weight[i];
  const std::span<const float> before = step.tables_before.last_weights.subspan(first, weights.size());
  stamp(step.tables.weights_since, step.tables_before.weights_since, same_bits(weights, before));
  stamp(step.tables.winding_since, step.tables_before.winding_since,
        step.tables_before.instances[i].mirrored == placed.mirrored);
}

/// Since when all that a primitive's vertices come from is as it is now.
std::uint64_t since_of(const Plan& plan, const PrimitivePlan& planned, const FrameTables& tables) noexcept {
  std::uint64_t since = 0;
  const std::uint32_t i = planned.instance;
  if (planned.skin.any()) since = std::max(since, tables.palettes[plan.scene->instances[i].skin].since_frame);
  if (planned.morph.any() || planned.morph_colors) since = std::max(since, tables.weights_since[i]);
  if (planned.flat_normals) since = std::max(since, tables.winding_since[i]);
  return since;
}

/// An instance that nobody sees deforms nothing.
void leave_out(const Plan& plan, std::size_t instance, std::span<DeformedPrimitive> shapes) noexcept {
  for (std::uint32_t p = plan.first_primitive[instance]; p < plan.first_primitive[instance + 1]; ++p)
    shapes[p] = nothing_deformed(plan.primitives[p]);
}

/// A primitive that rests this frame moves the box of its rest pose, a deformed one looks at its vertices.
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

/// The vertices and the box of one instance, as far as they are not in the memory already.
void deform_instance(const Plan& plan, std::size_t i, InstanceResult placed, std::span<const float> weights,
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
        deform_primitive(plan, planned, weights, placed.mirrored, uneven_root, step.memory, work);
    shape.since_frame = since;
    if (plan.bounds) bound(last, plan.scene->instances[i], primitive_of(plan, planned), shape, work);
    if (!plan.needs.positions) shape.positions = {};
  }
}

void show_instance(const Plan& plan, std::size_t i, std::span<const Affine> model, const RootScale& root,
                   const Unseen& unseen, const FrameStep& step, FrameWork& work) noexcept {
  InstanceResult placed = place_instance(plan, i, model, root, work);
  placed.visible = !unseen.is_hidden(plan, i) && !unseen.is_out_of_view(i);
  const std::uint32_t first = plan.scene->first_weight[i], end = plan.scene->first_weight[i + 1];
  const auto weights =
      step.memory.array<const float>(plan.weights_at, plan.rest_weights.size()).subspan(first, end - first);
  stamp_instance(plan, i, weights, placed, step);
  if (unseen.is_deformed(plan, i)) return deform_instance(plan, i, placed, weights, root.uneven, step, work);
  step.tables.instances[i] = placed;
  leave_out(plan, i, step.tables.primitives);
}

/// The memory has the result already, under stamps of another frame. Those of the frame before hold if it had this
/// input too.
void restamp(bool same_before, const FrameStep& step) noexcept {
  const auto take = [&](std::uint64_t& since, std::uint64_t since_before) {
    if (since != 0) since = same_before ? since_before : step.number;
  };
  const FrameTables &now = step.tables, &before = step.tables_before;
  for (std::size_t s = 0; s < now.palettes.size(); ++s)
    take(now.palettes[s].since_frame, before.palettes[s].since_frame);
  for (std::size_t i = 0; i < now.instances.size(); ++i) {
    take(now.weights_since[i], before.weights_since[i]);
    take(now.winding_since[i], before.winding_since[i]);
  }
  for (std::size_t p = 0; p < now.primitives.size(); ++p)
    take(now.primitives[p].since_frame, before.primitives[p].since_frame);
}

/// Where the tables of a frame are.
void show_tables(const Plan& plan, const FrameTables& tables, FrameResult& result) noexcept {
  if (plan.needs.palettes) result.palettes = tables.palettes;
  result.instances = tables.instances;
  result.primitives = tables.primitives;
  result.stage_ns = tables.stage_ns;
}

/// A character that sleeps: tables of nothing, so that whatever comes next is new.
void sleep(const Plan& plan, const FrameStep& step, FrameResult& result) noexcept {
  const FrameTables& tables = step.tables;
  std::fill(tables.palettes.begin(), tables.palettes.end(), SkinPalette{});
  std::fill(tables.weights_since.begin(), tables.weights_since.end(), 0);
  std::fill(tables.winding_since.begin(), tables.winding_since.end(), 0);
  for (std::size_t i = 0; i < tables.instances.size(); ++i) {
    tables.instances[i] = {
        .world_from_mesh = {}, .first_primitive = plan.first_primitive[i], .visible = false, .bounds = {}};
    leave_out(plan, i, tables.primitives);
  }
  result.model = {}, result.weights = {}, result.properties = {}, result.hidden = {};
  show_tables(plan, tables, result);
  result.work = FrameWork(tables.stage_ns).counters();
}

/// Everything from the input to the result, but for its numbers of frames.
void evaluate(const Plan& plan, const FrameInput& input, const FrameStep& step, FrameResult& result) noexcept {
  const FrameMemory memory = step.memory;
  FrameWork work(step.tables.stage_ns);
  const PoseSpan local = plan.interpolate
                             ? interpolate_poses(plan, input, step, work)
                             : evaluate_pose(plan, input, memory, step.tables.blend_layers, step.holds_clip, work);
  correct_weights(plan, local, memory, work);
  const std::span<const float> weights = memory.array<const float>(plan.weights_at, plan.rest_weights.size());
  const std::span<const Affine> model = compose(plan, local, input.root, step, work);
  const std::span<const float> properties =
      memory.array<const float>(plan.properties_at, plan.properties ? plan.scene->properties.rest.size() : 0);
  const std::span<const bool> hidden = hide(plan, properties, memory, work);
  const Unseen unseen{hidden, input.out_of_view};
  make_palettes(plan, model, wanted_palettes(plan, unseen, memory), step, work);
  const RootScale root(plan, input.root);
  for (std::size_t i = 0; i < step.tables.instances.size(); ++i)
    show_instance(plan, i, model, root, unseen, step, work);
  std::copy(weights.begin(), weights.end(), step.tables.last_weights.begin());
  if (plan.needs.joints) result.model = model;
  result.weights = weights;
  if (plan.needs.properties) result.properties = properties;
  result.hidden = hidden;
  show_tables(plan, step.tables, result);
  result.work = work.counters();
}

}  // namespace

ErrorCode run_plan(const Plan& plan, const FrameInput& input, FrameBuffer& frame) noexcept {
  if (frame.scene_ != plan.scene || frame.fingerprint_ != plan.fingerprint) return ErrorCode::size_mismatch;
  if (const ErrorCode error = check(plan, input); error != ErrorCode::ok) return error;

  const FrameBuffer* other = std::exchange(frame.before_, nullptr);
  const FrameBuffer& before = other != nullptr && other->result_.since_frame != 0 ? *other : frame;
  const FrameMemory memory{frame.block_.get()}, memory_before{before.block_.get()};
  const FrameTables tables(plan, memory);
  const FrameStep step{memory,
                       tables,
                       memory_before,
                       &before == &frame ? tables : FrameTables(plan, memory_before),
                       frame.result_.frame + 1,
                       frame.standing(plan, tables, input),
                       plan.sample && (input.interpolation_factor != 0.0f || !plays_alone(input.layers)),
                       frame.holds_clip(tables, input)};
  const bool same = frame.holds_result_of(tables, input);
  const bool same_before = &before == &frame ? same : before.holds_result_of(step.tables_before, input);
  const std::uint64_t since = same_before ? before.result_.since_frame : step.number;
  if (same) {
    if (&before != &frame) restamp(same_before, step);
    frame.result_.work = FrameWork(step.tables.stage_ns).counters();  // no stage ran
  } else {
    if (input.asleep)
      sleep(plan, step, frame.result_);
    else
      evaluate(plan, input, step, frame.result_);
    frame.keep(tables, input);
  }
  frame.result_.frame = step.number, frame.result_.since_frame = since;
  return ErrorCode::ok;
}

}  // namespace sinew
