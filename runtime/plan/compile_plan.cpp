// SPDX-License-Identifier: MIT
#include "runtime/plan/compile_plan.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <numeric>
#include <utility>

#include "runtime/animation/mirror_animation.h"
#include "runtime/base/contract.h"
#include "runtime/base/same_bits.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/plan/check_needs.h"
#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/plan_primitives.h"
#include "runtime/plan/pose_operations.h"
#include "runtime/plan/scene_indices.h"
#include "runtime/pose/hemisphere_pairs.h"
#include "runtime/pose/simd/choose_instruction_set.h"

namespace sinew {
namespace {

/// Adds joints that a mirrored layer moves: the partners of those that clips move, and those that the mirror moves at
/// rest.
void add_mirrored_joints(const MirrorMap& map, const Skeleton& skeleton, std::vector<bool>& moved) {
  const std::vector<bool> by_clips = moved;
  for (std::uint32_t j = 0; j < moved.size(); ++j)
    moved[j] = by_clips[j] || by_clips[map.joints[j].source] || is_moved_at_rest(map, skeleton, j);
}

/// Joints that some clip moves, by tracks or by a constant other than the rest pose, and all below them.
std::vector<std::uint32_t> moved_joints(const PlanAssets& assets) {
  std::vector<bool> moved(assets.joint_count());
  const BasePose rest(assets.skeleton->rest);
  const auto compare = [&](std::size_t at, float number) {
    if (!same_bits(number, rest.planes[at])) moved[at % rest.stride] = true;
  };
  const RestNumbers* compared = nullptr;  // of the clip before; most clips share rest values, so they are compared once
  for (const Clip& clip : assets.clips) {
    const ClipLayout& layout = clip.layout();
    const RestNumbers& shared = layout.base_pose.rest();
    for (std::size_t i = 0; i < rest.planes.size() && (compared == nullptr || *compared != shared); ++i)
      compare(i, (*shared)[i]);
    compared = &shared;
    for (const BaseNumbers::Override& value : layout.base_pose.overrides()) compare(value.at, value.value);
    for (const TimeGroup& group : layout.groups)
      for (const TrackBlock& block : group.blocks)
        if (block.property != Property::weight && block.property != Property::number)
          for (std::uint32_t i = 0; i < block.lane_count; ++i) moved[block.targets[i]] = true;
  }
  if (assets.mirror != nullptr) add_mirrored_joints(*assets.mirror, *assets.skeleton, moved);
  std::vector<std::uint32_t> joints;
  for (std::uint32_t j = 0; j < moved.size(); ++j) {
    const std::uint32_t parent = assets.skeleton->parents[j];
    moved[j] = moved[j] || (parent != kNone && moved[parent]);
    if (moved[j]) joints.push_back(j);
  }
  return joints;
}

/// True if the caller may move any joint.
bool places_joints(const Inputs& in) {
  return in.cut || in.program.externals > 0 || in.program.overrides > 0 || in.program.procedures > 0;
}

std::vector<std::uint32_t> all_joints(const PlanAssets& assets) {
  std::vector<std::uint32_t> joints(assets.joint_count());
  std::iota(joints.begin(), joints.end(), 0u);
  return joints;
}

/// The joints of poses that are not in the list.     in  joints  rising
std::vector<std::uint32_t> other_joints(const PlanAssets& assets, std::span<const std::uint32_t> joints) {
  std::vector<std::uint32_t> others;
  const std::vector<std::uint32_t> all = all_joints(assets);
  std::set_difference(all.begin(), all.end(), joints.begin(), joints.end(), std::back_inserter(others));
  return others;
}

std::vector<JointScale> any_scales(const PlanAssets& assets) {
  return std::vector<JointScale>(assets.joint_count(), {ScaleKind::uneven, 0, true});
}

/// True if the plan can add poses: by additive layers, or by operations of a program.
bool adds(const CompiledPlan& plan) { return plan.add || plan.needs.in.program.ops > 0; }

std::vector<ClipTracks> tracks_of(std::span<const Clip> clips) {
  std::vector<ClipTracks> tracks;
  for (const Clip& clip : clips) {
    const Clip::Counts counts = clip.counts();
    const std::uint32_t of_joints = counts.translations + counts.rotations + counts.scales;
    tracks.push_back({of_joints, counts.weights, counts.properties, of_joints + counts.folded > 0});
  }
  return tracks;
}

/// The weights of the joints that poses have.
std::vector<float> mask_of_poses(const PlanAssets& assets, const std::vector<float>& mask) {
  std::vector<float> kept;
  for (std::size_t j = 0; j < mask.size(); ++j)
    if (assets.joint_map[j].is_kept) kept.push_back(mask[j]);
  return kept;
}

bool has_animated_visibility(const PropertyTable& properties) {
  return std::any_of(properties.entries.begin(), properties.entries.end(),
                     [](const PropertyTable::Entry& entry) { return entry.target.kind == PropertyKind::node_visible; });
}

/// Stages that do not depend on primitives.
void choose_pose_stages(CompiledPlan& plan) {
  const Scene& scene = *plan.scene;
  const Needs& needs = plan.needs;
  const bool has_clips = !plan.assets.clips.empty();
  plan.local_to_model =
      scene.skeleton.joint_count() > 0 &&
      (needs.out.joints || ((needs.out.vertices() || needs.out.palettes) && !scene.instances.empty()));
  plan.hide_per_frame =
      has_animated_visibility(scene.properties) && (needs.out.properties || needs.out.vertices() || needs.out.palettes);
  plan.hide = plan.hide_per_frame || !scene.hidden_joints.empty();
  const bool has_programs = needs.in.program.ops > 0 || needs.in.cut;
  plan.properties = (has_clips || has_programs) &&
                    ((needs.out.properties && !scene.properties.entries.empty()) || plan.hide_per_frame);
  const bool shows_local = needs.out.local_pose && scene.skeleton.joint_count() > 0;
  plan.poses = (has_clips || has_programs) &&
               (plan.local_to_model || shows_local || scene.weight_count() > 0 || plan.properties);
  plan.sample = plan.poses && has_clips;
  plan.blend = plan.sample && (needs.in.max_layers > 1 || !needs.in.masks.empty() || needs.in.program.masks > 0);
  plan.mirror = plan.poses && needs.in.mirror != nullptr;
  plan.add = plan.sample && needs.in.additive;
  plan.interpolate = plan.sample && needs.in.between_updates;
  plan.bounds = needs.out.bounds && !scene.instances.empty();
}

/// All stages that run. Called after the primitives are planned.
std::bitset<kStageCount> chosen_stages(const CompiledPlan& plan) {
  std::bitset<kStageCount> stages;
  const auto runs = [&](Stage stage, bool does) { stages[static_cast<std::size_t>(stage)] = does; };
  const auto any = [](const auto& all, const auto& is) { return std::any_of(all.begin(), all.end(), is); };
  const auto is_true = [](bool used) { return used; };
  const auto skinned = [&](Skinning kind) {
    return any(plan.primitives, [=](const PrimitivePlan& p) { return p.skin.any() && p.skinning == kind; });
  };
  runs(Stage::sample, plan.sample);
  runs(Stage::mirror, plan.mirror);
  runs(Stage::blend, plan.blend);
  runs(Stage::add, plan.add);
  runs(Stage::pose_program, plan.poses && plan.needs.in.program.ops > 0);
  runs(Stage::interpolate, plan.interpolate);
  runs(Stage::correctives, plan.correctives);
  runs(Stage::properties, plan.properties);
  runs(Stage::local_to_model, plan.local_to_model);
  runs(Stage::palette, any(plan.palette, is_true));
  runs(Stage::split_palette, any(plan.split, is_true));
  runs(Stage::combinations, any(plan.combined, [&](const std::vector<CombinedInfluences>& of_skin) {
         return any(of_skin, [](const CombinedInfluences& c) { return c.used(); });
       }));
  runs(Stage::winding,
       plan.local_to_model && any(plan.instance_scales, [](const JointScale& s) { return s.may_change; }));
  runs(Stage::morph, any(plan.primitives, [](const PrimitivePlan& p) { return p.morph.any() || p.morph_colors; }));
  runs(Stage::skin_linear, skinned(Skinning::linear));
  runs(Stage::skin_dual_quaternion, skinned(Skinning::dual_quaternion));
  runs(Stage::skin_center_of_rotation, skinned(Skinning::center_of_rotation));
  runs(Stage::geometry_cache, any(plan.primitives, [](const PrimitivePlan& p) { return p.cached.any(); }));
  runs(Stage::flat_normals, any(plan.primitives, [](const PrimitivePlan& p) { return p.flat_normals; }));
  runs(Stage::bounds, plan.bounds);
  return stages;
}

}  // namespace

Plan compile_plan(std::shared_ptr<const Scene> scene, const Needs& needs, const Plan& beside) {
  CONTRACT(scene != nullptr && "a plan needs a scene");
  const std::span<const Clip> clips = scene->clips;
  return compile_plan(std::move(scene), clips, needs, beside);
}

Plan compile_plan(std::shared_ptr<const Scene> shared, std::span<const Clip> clips, const Needs& needs,
                  const Plan& beside) {
  CONTRACT(shared != nullptr && "a plan needs a scene");
  const Scene& scene = *shared;
  CONTRACT(has_valid_indices(scene) && "a scene has passed check(Scene) before it is compiled");
  CONTRACT((!beside.is_compiled() || &beside.scene() == &scene) && "plans share tables of one scene");
  CONTRACT(std::all_of(clips.begin(), clips.end(), [&](const Clip& clip) { return fits(clip, scene); }));
  if (const Refusal fault = find_fault(needs, scene); fault.error != ErrorCode::ok)
    detail::contract_failed(text_of(fault).c_str(), __FILE__, __LINE__);
  choose_instruction_set();
  const auto made = std::make_shared<CompiledPlan>();
  CompiledPlan& plan = *made;
  plan.scene = std::move(shared);
  plan.needs = needs;
  plan.assets = make_assets(scene, clips, needs.out.skeleton_lod, needs.in.mirror);
  plan.rest_weights = rest_weights_of(scene);
  plan.clip_tracks = tracks_of(plan.assets.clips);
  plan.moved_joints = places_joints(needs.in) ? all_joints(plan.assets) : moved_joints(plan.assets);
  plan.unmoved_joints = other_joints(plan.assets, plan.moved_joints);
  for (const std::vector<float>& mask : needs.in.masks) plan.mask_weights.push_back(mask_of_poses(plan.assets, mask));
  plan.masks.assign(plan.mask_weights.begin(), plan.mask_weights.end());
  choose_pose_stages(plan);
  if (plan.mirror) plan.mirror_tables = make_mirror_tables(plan.assets.mirror->joints);
  plan.joint_scales = places_joints(needs.in) ? any_scales(plan.assets) : joint_scales(plan.assets, adds(plan));
  plan_primitives(plan, beside.compiled().get());
  const bool morphs = std::any_of(plan.primitives.begin(), plan.primitives.end(),
                                  [](const PrimitivePlan& p) { return p.morph.any() || p.morph_colors; });
  plan.correctives = !scene.correctives.empty() && (needs.out.weights || morphs);
  for (std::size_t s = 0; s < scene.skins.size(); ++s)
    plan.hemisphere_edges.push_back(plan.split[s] ? hemisphere_edges(scene.skeleton, scene.skins[s])
                                                  : std::vector<JointPair>{});
  plan.stages = chosen_stages(plan);
  plan.pose_assets = pose_assets(plan);
  lay_out_frame(plan);
  return Plan(made);
}

const CompiledPlan& Plan::get() const noexcept {
  CONTRACT(is_compiled() && "a default plan has no content: compile_plan makes plans");
  return *compiled_;
}

const Scene& Plan::scene() const noexcept { return *get().scene; }
const Needs& Plan::needs() const noexcept { return get().needs; }
bool Plan::runs(Stage stage) const noexcept { return get().stages[static_cast<std::size_t>(stage)]; }
std::vector<PlanStage> Plan::stages() const { return describe_stages(get()); }
std::size_t Plan::frame_bytes() const noexcept { return get().layout.frame_bytes; }
std::span<const PrimitivePlan> Plan::primitives() const noexcept { return get().primitives; }
std::span<const std::uint32_t> Plan::first_primitive() const noexcept { return get().first_primitive; }
std::span<const ClipTracks> Plan::clip_tracks() const noexcept { return get().clip_tracks; }
std::span<const std::uint32_t> Plan::moved_joints() const noexcept { return get().moved_joints; }

std::vector<std::uint32_t> kept_joints(const Plan& plan) {
  CONTRACT(plan.is_compiled() && "a default plan has no joints");
  return kept_joints(plan.compiled()->assets.joint_map);
}

std::uint32_t pose_joint(const Plan& plan, std::uint32_t joint) noexcept {
  CONTRACT(plan.is_compiled() && "a default plan has no joints");
  const JointMapping& mapped = plan.compiled()->assets.joint_map[joint];
  return mapped.is_kept ? mapped.pose_index : kNone;
}

Affine world_of(const Plan& plan, std::span<const Affine> model, std::uint32_t joint) noexcept {
  return world_of(plan.compiled()->assets, model, joint);
}

}  // namespace sinew
