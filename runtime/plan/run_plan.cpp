// SPDX-License-Identifier: MIT
#include "runtime/plan/run_plan.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "runtime/base/all_finite.h"
#include "runtime/base/same_bits.h"
#include "runtime/plan/evaluate_pose.h"
#include "runtime/plan/frame_changes.h"
#include "runtime/plan/interpolate_poses.h"
#include "runtime/plan/make_palettes.h"
#include "runtime/plan/play_geometry.h"
#include "runtime/plan/show_instances.h"
#include "runtime/plan/visibility.h"
#include "runtime/pose/correct_pose.h"
#include "runtime/pose/local_to_model.h"

namespace sinew {
namespace {

/// Without a branch per number: zero times an infinity or NaN is NaN, and stays so in sums.
bool is_finite(const Affine& m) noexcept {
  const glm::vec4 zero = 0.0f * m.row[0] + 0.0f * m.row[1] + 0.0f * m.row[2];
  return zero.x + zero.y + zero.z + zero.w == 0.0f;
}

/// A page of another clip with as many targets is the caller's mistake, which no frame looks for.
bool has_size_of(const Clip& page, const Clip& clip) noexcept {
  return page.joint_count() == clip.joint_count() && page.weight_count() == clip.weight_count() &&
         page.property_count() == clip.property_count();
}

ErrorCode check(const CompiledPlan& plan, std::span<const ClipLayer> layers) noexcept {
  std::size_t active = 0;
  double total_weight = 0.0;
  for (const ClipLayer& layer : layers) {
    if (layer.clip >= plan.assets.clips.size()) return ErrorCode::index_out_of_range;
    if (layer.page != nullptr && !has_size_of(*layer.page, plan.assets.clips[layer.clip]))
      return ErrorCode::size_mismatch;
    if (!std::isfinite(layer.time_s) || !std::isfinite(layer.weight)) return ErrorCode::not_finite;
    if (layer.mask != kNone && layer.mask >= plan.needs.masks.size()) return ErrorCode::index_out_of_range;
    const bool adds = layer.kind != LayerKind::blend;
    if (layer.weight < 0.0f || (adds && !plan.needs.additive)) return ErrorCode::unsupported;
    if (layer.mirrored && plan.needs.mirror == nullptr) return ErrorCode::unsupported;
    if (adds) continue;
    active += layer.weight != 0.0f;
    total_weight += static_cast<double>(layer.weight);
  }
  if (active > plan.needs.max_layers) return ErrorCode::size_mismatch;
  return plan.sample && !plan.blend && active > 0 && total_weight < 1.0 ? ErrorCode::unsupported : ErrorCode::ok;
}

/// A source is at one time in a frame: an earlier instance that plays from it has another one.
bool has_two_times(std::span<const GeometryInput> geometry, std::size_t slot) noexcept {
  for (std::size_t s = slot; s-- > 0;)
    if (geometry[s].plays() && geometry[s].source.context == geometry[slot].source.context)
      return !same_bits(geometry[s].time_s, geometry[slot].time_s);
  return false;
}

ErrorCode check_geometry(const CompiledPlan& plan, std::span<const GeometryInput> geometry) noexcept {
  if (geometry.empty()) return ErrorCode::ok;
  if (geometry.size() != plan.needs.cached_instances.size()) return ErrorCode::size_mismatch;
  for (std::size_t slot = 0; slot < geometry.size(); ++slot) {
    const GeometryInput& input = geometry[slot];
    if (!input.source.is_there()) continue;
    if (!std::isfinite(input.time_s) || !std::isfinite(input.weight)) return ErrorCode::not_finite;
    if (input.weight < 0.0f || input.weight > 1.0f) return ErrorCode::unsupported;
    if (!input.plays()) continue;
    const std::uint32_t instance = plan.needs.cached_instances[slot];
    if (!input.source.has(input.source.context, instance)) return ErrorCode::index_out_of_range;
    const bool has_copies = !plan.scene->instances[instance].copies.empty();
    if ((has_copies && input.source.space == VertexSpace::scene) || has_two_times(geometry, slot))
      return ErrorCode::unsupported;
  }
  return ErrorCode::ok;
}

ErrorCode check(const CompiledPlan& plan, const FrameInput& input) noexcept {
  if (!(input.interpolation_factor >= 0.0f && input.interpolation_factor <= 1.0f) ||
      (input.interpolation_factor != 0.0f && !plan.needs.between_updates))
    return ErrorCode::unsupported;
  for (const std::span<const ClipLayer> layers :
       {input.layers, input.interpolation_factor != 0.0f ? input.next_layers : std::span<const ClipLayer>{}})
    if (const ErrorCode error = check(plan, layers); error != ErrorCode::ok) return error;
  if (!input.weights.empty() && input.weights.size() != plan.rest_weights.size()) return ErrorCode::size_mismatch;
  if (!input.out_of_view.empty() && input.out_of_view.size() != plan.scene->instances.size())
    return ErrorCode::size_mismatch;
  if (!all_finite(input.weights) || !is_finite(input.root)) return ErrorCode::not_finite;
  return check_geometry(plan, input.geometry);
}

/// Adds to the frame's morph weights what its local pose calls for.
/// out  [W] the weights of the frame
std::span<const float> correct_weights(const CompiledPlan& plan, const PoseSpan& local, FrameMemory memory,
                                       FrameWork& work) noexcept {
  const std::span<float> weights = memory.array<float>(plan.layout.weights_at, plan.rest_weights.size());
  if (!plan.correctives) return weights;
  for (const PoseCorrective& corrective : plan.assets.correctives) {
    const CorrectPoseJob job{
        .corrective = &corrective,
        .pose = local,
        .scratch = memory.array<double>(plan.layout.corrective_scratch_at, plan.layout.corrective_scratch_count),
        .weights = weights};
    assert(check(job) == ErrorCode::ok);
    run_unchecked(job);
    work.poses_compared += corrective.samples.sample_count();
  }
  work.spent_on(Stage::correctives);
  return weights;
}

/// Sets joints that no clip moves to the rest pose, to the last bit, since a mean of layers rounds them. In the frame's
/// own pose: `local` may be a pose that is kept for later frames.
PoseSpan with_unmoved_at_rest(const CompiledPlan& plan, const PoseSpan& local, FrameMemory memory) noexcept {
  const PoseSpan rest = memory.pose(plan.layout.rest_pose_at, plan.assets.joint_count()),
                 own = memory.pose(plan.layout.pose_at, plan.assets.joint_count());
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

/// World matrices of all joints, or nothing when the plan leaves them out. Matrices that are there already stay.
std::span<const Affine> compose(const CompiledPlan& plan, const PoseSpan& local, const Affine& root,
                                const FrameStep& step, FrameWork& work) noexcept {
  if (!plan.local_to_model) return {};
  const std::size_t joints = plan.assets.joint_count();
  const std::span<Affine> model = step.memory.array<Affine>(plan.layout.model_at, joints);
  if (step.changes.current_matrices == CurrentMatrices::all) return model;
  LocalToModelJob job{.skeleton = plan.assets.skeleton, .local = local, .root = root, .model = model};
  if (step.changes.current_matrices == CurrentMatrices::of_unmoved_joints)
    job.only = plan.moved_joints;
  else if (step.changes.mixes_poses)
    job.local = with_unmoved_at_rest(plan, local, step.memory);
  assert(check(job) == ErrorCode::ok);
  run_unchecked(job);
  work.joints_composed += job.only.empty() ? joints : job.only.size();
  work.spent_on(Stage::local_to_model);
  return model;
}

/// Joints that this frame does not show; empty when the plan hides nothing. Without animated flags the frame buffer
/// found them once for all frames.
std::span<const bool> hide(const CompiledPlan& plan, std::span<const float> properties, FrameMemory memory,
                           FrameWork& work) noexcept {
  if (!plan.hide) return {};
  const std::span<bool> hidden = memory.array<bool>(plan.layout.hidden_at, plan.scene->skeleton.joint_count());
  if (plan.hide_per_frame && plan.properties) {
    find_hidden(*plan.scene, properties, hidden);
    work.spent_on(Stage::properties);
  }
  return hidden;
}

/// Points the result at the tables of the frame.
void show_tables(const CompiledPlan& plan, const FrameTables& tables, FrameResult& result) noexcept {
  if (plan.needs.palettes) result.palettes = tables.palettes;
  result.instances = tables.instances;
  result.primitives = tables.primitives;
  result.stage_ns = tables.stage_ns;
}

/// A character that sleeps: its tables are empty, so that every stage of the next frame is new.
void sleep(const CompiledPlan& plan, const FrameTables& tables, FrameResult& result) noexcept {
  std::fill(tables.palettes.begin(), tables.palettes.end(), SkinPalette{});
  std::fill(tables.weights_since.begin(), tables.weights_since.end(), 0);
  std::fill(tables.winding_since.begin(), tables.winding_since.end(), 0);
  for (std::size_t i = 0; i < tables.instances.size(); ++i) {
    tables.instances[i] = {
        .world_from_mesh = {}, .first_primitive = plan.first_primitive[i], .visible = false, .bounds = {}};
    deform_nothing(plan, i, tables);
  }
  result.model = {};
  result.weights = {};
  result.properties = {};
  result.hidden = {};
  show_tables(plan, tables, result);
  result.work = FrameWork(tables.stage_ns).counters();
}

/// A frame of the same input as the last one in this memory: no stage runs.
void keep_result(const CompiledPlan& plan, const FrameStep& step, bool before_is_other, FrameResult& result) noexcept {
  if (before_is_other) {
    number_kept_palettes(plan, step);
    number_kept_instances(plan, step);
  }
  result.work = FrameWork(step.tables.stage_ns).counters();
}

/// The stages in the order of the plan, from the input to the result, but for its numbers of frames.
void run_stages(const CompiledPlan& plan, const FrameInput& input, const FrameStep& step,
                FrameResult& result) noexcept {
  const FrameMemory memory = step.memory;
  FrameWork work(step.tables.stage_ns);
  const PoseSpan local = plan.interpolate ? interpolate_poses(plan, input, step, work)
                                          : evaluate_pose(plan, input.layers, input.weights, memory,
                                                          step.tables.blend_layers, step.changes.same_clip, work);
  const std::span<const float> weights = correct_weights(plan, local, memory, work);
  const std::span<const Affine> model = compose(plan, local, input.root, step, work);
  const std::span<const float> properties =
      memory.array<const float>(plan.layout.properties_at, plan.properties ? plan.scene->properties.rest.size() : 0);
  const Visibility visibility{hide(plan, properties, memory, work), input.out_of_view};
  show_sources(plan, input.geometry, visibility, step.tables, work);
  const bool all_wanted = !plan.hide_per_frame && input.out_of_view.empty() && input.geometry.empty();
  const std::span<const bool> wanted =
      all_wanted ? std::span<const bool>{}
                 : wanted_palettes(plan, visibility, input.geometry, step.tables.shown, memory);
  make_palettes(plan, model, wanted, step, work);
  show_instances(plan, {model, weights, input.root, visibility, input.geometry}, step, work);
  result.model = plan.needs.joints ? model : std::span<const Affine>{};
  result.weights = weights;
  result.properties = plan.needs.properties ? properties : std::span<const float>{};
  result.hidden = visibility.hidden;
  show_tables(plan, step.tables, result);
  result.work = work.counters();
}

}  // namespace

ErrorCode run_plan(const Plan& plan, const FrameInput& input, FrameBuffer& frame) noexcept {
  // 1. Check the input.
  const CompiledPlan* const compiled = plan.compiled().get();
  const FrameBuffer* const other = std::exchange(frame.before_, nullptr);
  if (compiled == nullptr || frame.plan_.get() != compiled) return ErrorCode::size_mismatch;
  if (other != nullptr && other->plan_.get() != compiled) return ErrorCode::size_mismatch;
  if (const ErrorCode error = check(*compiled, input); error != ErrorCode::ok) return error;

  // 2. What changed, from this input, the last frame in this memory and the frame before of the character.
  const FrameBuffer& before = other != nullptr && other->result_.since_frame != 0 ? *other : frame;
  const FrameMemory memory{frame.block_.get()}, memory_before{before.block_.get()};
  const FrameTables tables(*compiled, memory);
  const auto run_after = [&](const FrameTables& tables_before) noexcept {
    const FrameChanges changes = find_changes(*compiled, input, {frame.last_, tables}, {before.last_, tables_before});
    const FrameStep step{
        memory, tables, memory_before, tables_before, frame.result_.frame + 1, changes, frame.past_caches_};
    frame.result_.since_frame = changes.nothing_since_before ? before.result_.since_frame : step.number;
    frame.result_.frame = step.number;

    // 3. Run the stages.
    if (changes.nothing) return keep_result(*compiled, step, &before != &frame, frame.result_);
    if (input.asleep)
      sleep(*compiled, tables, frame.result_);
    else
      run_stages(*compiled, input, step, frame.result_);
    remember(input, tables, frame.last_);
  };
  if (&before == &frame)
    run_after(tables);
  else
    run_after(FrameTables(*compiled, memory_before));
  return ErrorCode::ok;
}

bool holds_result_of(const FrameBuffer& frame, const FrameInput& input) noexcept {
  if (frame.plan_ == nullptr) return false;
  return had_same_input({frame.last_, FrameTables(*frame.plan_, FrameMemory{frame.block_.get()})}, input);
}

}  // namespace sinew
