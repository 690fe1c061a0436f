// SPDX-License-Identifier: MIT
#include "runtime/plan/run_plan.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <new>

#include "runtime/assets/mesh_copies.h"
#include "runtime/jobs/correct_pose.h"
#include "runtime/jobs/joint_palette.h"
#include "runtime/jobs/local_to_model.h"
#include "runtime/plan/deform_primitive.h"
#include "runtime/plan/evaluate_pose.h"
#include "runtime/plan/find_hidden.h"
#include "runtime/plan/grow_bounds.h"

namespace sinew {
namespace {

constexpr std::align_val_t kBlockAlignment{64};

ErrorCode check(const Plan& plan, const FrameInput& input) noexcept {
  std::size_t active = 0;
  double total_weight = 0.0;
  for (const ClipLayer& layer : input.layers) {
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
  if (plan.sample && !plan.blend && active > 0 && total_weight < 1.0) return ErrorCode::unsupported;
  if (!input.weights.empty() && input.weights.size() != plan.rest_weights.size()) return ErrorCode::size_mismatch;
  for (const float weight : input.weights)
    if (!std::isfinite(weight)) return ErrorCode::not_finite;
  return ErrorCode::ok;
}

/// Adds to the frame's morph weights what its local pose calls for.
void correct_weights(const Plan& plan, const PoseSpan& local, FrameMemory memory, WorkCounters& work) noexcept {
  if (!plan.correctives) return;
  for (const PoseCorrective& corrective : plan.scene->correctives) {
    const CorrectPoseJob job{
        .corrective = &corrective,
        .pose = local,
        .scratch = memory.array<double>(plan.corrective_scratch_at, plan.corrective_scratch_count),
        .weights = memory.array<float>(plan.weights_at, plan.rest_weights.size())};
    assert(check(job) == ErrorCode::ok);
    run(job);
    work.poses_compared += corrective.samples.sample_count();
  }
}

/// World matrices of all joints, or nothing when the plan leaves them out.
std::span<const Affine> compose(const Plan& plan, const PoseSpan& local, const Affine& root, FrameMemory memory,
                                WorkCounters& work) noexcept {
  if (!plan.local_to_model) return {};
  const std::size_t joints = plan.scene->skeleton.joint_count();
  const std::span<Affine> model = memory.array<Affine>(plan.model_at, joints);
  const LocalToModelJob job{.skeleton = &plan.scene->skeleton, .local = local, .root = root, .model = model};
  assert(check(job) == ErrorCode::ok);
  run(job);
  work.joints_composed += joints;
  return model;
}

/// Joints that this frame does not show; empty when the plan hides nothing. What no clip decides was found once for all
/// frames.
std::span<const bool> hide(const Plan& plan, std::span<const float> properties, FrameMemory memory) noexcept {
  if (!plan.hide) return {};
  const std::span<bool> hidden = memory.array<bool>(plan.hidden_at, plan.scene->skeleton.joint_count());
  if (plan.hide_per_frame && plan.properties) find_hidden(*plan.scene, properties, hidden);
  return hidden;
}

bool is_shown(const Plan& plan, std::size_t instance, std::span<const bool> hidden) noexcept {
  return hidden.empty() || !hidden[plan.scene->instances[instance].joint];
}

bool is_deformed(const Plan& plan, std::size_t instance, std::span<const bool> hidden) noexcept {
  return plan.needs.hidden_meshes || is_shown(plan, instance, hidden);
}

/// Skins that some instance of this frame needs; empty = as the plan says.
std::span<const bool> wanted_palettes(const Plan& plan, std::span<const bool> hidden, FrameMemory memory) noexcept {
  if (!plan.hide_per_frame) return {};
  const std::span<bool> wanted = memory.array<bool>(plan.palette_wanted_at, plan.palette.size());
  std::fill(wanted.begin(), wanted.end(), false);
  for (std::size_t i = 0; i < plan.scene->instances.size(); ++i)
    if (const std::uint32_t skin = plan.scene->instances[i].skin; skin != kNone)
      wanted[skin] = wanted[skin] || is_deformed(plan, i, hidden);
  return wanted;
}

void make_palettes(const Plan& plan, std::span<const Affine> model, std::span<const bool> wanted, FrameMemory memory,
                   WorkCounters& work) noexcept {
  for (std::size_t s = 0; s < plan.palette.size(); ++s) {
    if (!plan.palette[s] || (!wanted.empty() && !wanted[s])) continue;
    const Skin& skin = plan.scene->skins[s];
    const std::span<JointMatrix> palette = memory.array<JointMatrix>(plan.palette_at[s], skin.joints.size());
    const JointPaletteJob job{.skin = &skin, .model = model, .palette = palette};
    assert(check(job) == ErrorCode::ok);
    run(job);
    work.palette_entries += palette.size();
    if (!plan.split[s]) continue;
    const SplitPaletteJob split{.palette = palette,
                                .split = memory.array<RigidStretch>(plan.split_at[s], palette.size()),
                                .any_stretch = &memory.array<bool>(plan.stretch_at, plan.split.size())[s],
                                .follow = plan.sign_edges[s]};
    assert(check(split) == ErrorCode::ok);
    run(split);
    work.palette_entries_split += palette.size();
  }
}

/// Where an instance stands, and whether it is mirrored (G48). In double: the product of three small scales must not
/// vanish.
InstanceResult place_instance(const Plan& plan, std::size_t instance, std::span<const Affine> model) noexcept {
  InstanceResult placed;
  placed.first_primitive = plan.first_primitive[instance];
  if (model.empty()) return placed;
  const MeshInstance& mesh = plan.scene->instances[instance];
  if (!plan.instance_skinned[instance]) {
    placed.world_from_mesh = model[mesh.joint];
    placed.mirrored = determinant(affine_cast<double>(placed.world_from_mesh)) < 0.0;
  } else if (const Skin& skin = plan.scene->skins[mesh.skin]; !skin.joints.empty()) {
    const Affined world_from_joint = affine_cast<double>(model[skin.joints[0]]);
    placed.mirrored = determinant(world_from_joint * affine_cast<double>(skin.inverse_bind[0])) < 0.0;
  }
  return placed;
}

/// A hidden instance deforms nothing.
void leave_out(const Plan& plan, std::size_t instance, std::span<DeformedPrimitive> shapes) noexcept {
  for (std::uint32_t p = plan.first_primitive[instance]; p < plan.first_primitive[instance + 1]; ++p)
    shapes[p] = {.instance = plan.primitives[p].instance,
                 .primitive = plan.primitives[p].primitive,
                 .positions = {},
                 .normals = {},
                 .tangents = {},
                 .colors = {}};
}

/// A primitive that rests this frame moves the box of its rest pose, a deformed one looks at its vertices.
void bound(InstanceResult& placed, const MeshInstance& instance, const Primitive& primitive, const DeformedPrimitive& shape,
           WorkCounters& work) noexcept {
  const bool rests = shape.positions.empty() || shape.positions.data() == primitive.positions.data();
  for_each_copy(instance, placed.world_from_mesh, [&](const Affine& world_from_copy) {
    if (rests) return grow_bounds(placed.bounds, primitive.bounds, world_from_copy);
    grow_bounds(placed.bounds, shape.positions, world_from_copy);
    work.bounds_vertices += shape.positions.size();
  });
}

}  // namespace

void FrameBuffer::FreeAligned::operator()(std::byte* p) const noexcept { ::operator delete(p, kBlockAlignment); }

FrameBuffer::FrameBuffer(const Plan& plan)
    : scene_(plan.scene),
      byte_count_(plan.frame_bytes),
      memory_(static_cast<std::byte*>(::operator new(std::max<std::size_t>(plan.frame_bytes, 1), kBlockAlignment))),
      instances_(plan.scene->instances.size()),
      primitives_(plan.primitives.size()),
      layers_(plan.needs.max_layers) {
  std::memset(memory_.get(), 0, byte_count_);
  const Skeleton& skeleton = plan.scene->skeleton;
  const PoseSpan rest = FrameMemory{memory_.get()}.pose(plan.rest_pose_at, skeleton.joint_count());
  for (std::size_t j = 0; j < rest.stride; ++j) rest.set(j, j < rest.joint_count ? skeleton.rest[j] : Transform{});
  if (plan.hide)
    find_hidden(*plan.scene, {}, FrameMemory{memory_.get()}.array<bool>(plan.hidden_at, skeleton.joint_count()));
}

ErrorCode run_plan(const Plan& plan, const FrameInput& input, FrameBuffer& frame) noexcept {
  if (frame.scene_ != plan.scene || frame.byte_count_ != plan.frame_bytes ||
      frame.primitives_.size() != plan.primitives.size() || frame.layers_.size() != plan.needs.max_layers)
    return ErrorCode::size_mismatch;
  if (const ErrorCode error = check(plan, input); error != ErrorCode::ok) return error;

  const FrameMemory memory{frame.memory_.get()};
  WorkCounters work;
  const PoseSpan local = evaluate_pose(plan, input, memory, frame.layers_, work);
  correct_weights(plan, local, memory, work);
  const std::span<const float> weights = memory.array<const float>(plan.weights_at, plan.rest_weights.size());
  const std::span<const Affine> model = compose(plan, local, input.root, memory, work);
  const std::span<const float> properties =
      memory.array<const float>(plan.properties_at, plan.properties ? plan.scene->properties.rest.size() : 0);
  const std::span<const bool> hidden = hide(plan, properties, memory);
  make_palettes(plan, model, wanted_palettes(plan, hidden, memory), memory, work);

  for (std::size_t i = 0; i < frame.instances_.size(); ++i) {
    InstanceResult& placed = frame.instances_[i] = place_instance(plan, i, model);
    placed.visible = is_shown(plan, i, hidden);
    if (!is_deformed(plan, i, hidden)) {
      leave_out(plan, i, frame.primitives_);
      continue;
    }
    const std::uint32_t first_weight = plan.scene->first_weight[i];
    const auto own_weights = weights.subspan(first_weight, plan.scene->first_weight[i + 1] - first_weight);
    for (std::uint32_t p = plan.first_primitive[i]; p < plan.first_primitive[i + 1]; ++p) {
      DeformedPrimitive& shape = frame.primitives_[p] =
          deform_primitive(plan, plan.primitives[p], own_weights, placed.mirrored, memory, work);
      if (plan.bounds) bound(placed, plan.scene->instances[i], primitive_of(plan, plan.primitives[p]), shape, work);
      if (!plan.needs.positions) shape.positions = {};
    }
  }
  frame.result_ = {.frame = frame.result_.frame + 1,
                   .model = plan.needs.joints ? model : std::span<const Affine>{},
                   .weights = weights,
                   .properties = plan.needs.properties ? properties : std::span<const float>{},
                   .hidden = hidden,
                   .instances = frame.instances_,
                   .primitives = frame.primitives_,
                   .work = work};
  return ErrorCode::ok;
}

}  // namespace sinew
