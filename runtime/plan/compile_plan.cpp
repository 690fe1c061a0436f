// SPDX-License-Identifier: MIT
#include "runtime/plan/compile_plan.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "runtime/base/bit_hash.h"
#include "runtime/base/contract.h"
#include "runtime/base/same_bits.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/plan/find_hidden.h"
#include "runtime/plan/frame_tables.h"
#include "runtime/plan/frame_work.h"
#include "runtime/plan/plan_stages.h"
#include "runtime/pose/blend_poses.h"
#include "runtime/pose/correct_pose.h"
#include "runtime/pose/hemisphere_pairs.h"
#include "runtime/pose/joint_palette.h"
#include "runtime/pose/pose.h"

namespace sinew {
namespace {

/// Hands out places of one block, each on a cache line of its own.
class BlockLayout {
 public:
  std::size_t take(std::size_t bytes) noexcept {
    const std::size_t at = end_;
    end_ += (bytes + kAlignment - 1) / kAlignment * kAlignment;
    return at;
  }
  template <class T>
  std::size_t take_array(std::size_t count) noexcept {
    return take(count * sizeof(T));
  }
  std::size_t size() const noexcept { return end_; }

 private:
  static constexpr std::size_t kAlignment = 64;
  std::size_t end_ = 0;
};

/// Which attributes some target of the set moves.
struct MorphedAttributes {
  AttributeSet set;
  bool colors = false;
};

MorphedAttributes morphed_by(const MorphSet& morphs) noexcept {
  MorphedAttributes moved;
  for (const MorphTarget& target : morphs.targets) {
    moved.set.positions |= !target.positions.empty();
    moved.set.normals |= !target.normals.empty();
    moved.set.tangents |= !target.tangents.empty();
    moved.colors |= !target.colors.empty();
  }
  return moved;
}

/// Morph and skin touch an attribute only where it is, someone asks for it, and something moves it (P10, P11, P13).
PrimitivePlan plan_primitive(const Primitive& primitive, bool has_skin, Skinning skinning, const Needs& needs) {
  PrimitivePlan plan;
  plan.lacks_centers = skinning == Skinning::center_of_rotation && primitive.centers_of_rotation.empty();
  plan.skinning = plan.lacks_centers ? Skinning::linear : skinning;
  const MorphedAttributes moved = morphed_by(primitive.morphs);
  const bool skinned = has_skin && !primitive.influences.empty();
  plan.flat_normals = needs.normals && primitive.flat_normals && !primitive.normals.empty() &&
                      primitive.topology == Topology::triangles && (skinned || moved.set.positions);
  const AttributeSet wanted = {needs.positions || needs.bounds || plan.flat_normals,
                               needs.normals && !primitive.normals.empty() && !plan.flat_normals,
                               needs.tangents && !primitive.tangents.empty()};
  plan.morph = {wanted.positions && moved.set.positions, wanted.normals && moved.set.normals,
                wanted.tangents && moved.set.tangents};
  plan.morph.positions |= plan.morph.any();  // jobs always write positions
  plan.morph_colors = needs.vertices() && moved.colors && !primitive.colors.empty();
  if (skinned) plan.skin = wanted;
  plan.skin.positions |= plan.skin.any();
  return plan;
}

/// Joints that no clip of the plan ever shows.
class NeverShown {
 public:
  explicit NeverShown(const Plan& plan) : hidden_(new bool[plan.scene->skeleton.joint_count()]()) {
    if (!plan.hide || plan.needs.hidden_meshes) return;
    const Scene& scene = *plan.scene;
    std::vector<float> all_on = scene.properties.rest;
    for (const PropertyTable::Entry& entry : scene.properties.entries)
      if (entry.target.kind == PropertyKind::node_visible) all_on[entry.first] = 1.0f;
    find_hidden(scene, plan.hide_per_frame ? std::span<const float>(all_on) : std::span<const float>(),
                {hidden_.get(), scene.skeleton.joint_count()});
  }
  bool operator[](std::uint32_t joint) const noexcept { return hidden_[joint]; }

 private:
  std::unique_ptr<bool[]> hidden_;
};

/// Combines the influences of primitives, once for all instances of one skin.
class CombinationsOfPlan {
 public:
  explicit CombinationsOfPlan(Plan& plan) : plan_(plan) {}

  /// The primitive's place in Plan::combined of the skin, or kNone where its vertices blend for themselves.
  std::uint32_t of(const Primitive& primitive, std::uint32_t skin) {
    std::vector<CombinedInfluences>& all = plan_.combined[skin];
    const auto [at, is_new] = known_.try_emplace({&primitive, skin}, static_cast<std::uint32_t>(all.size()));
    if (is_new) all.push_back(combine_influences(primitive.influences, matrix_count(plan_, skin)));
    return all[at->second].used() ? at->second : kNone;
  }

 private:
  Plan& plan_;
  std::map<std::pair<const Primitive*, std::uint32_t>, std::uint32_t> known_;
};

/// Cofactors turn normals another way than the matrix does only where that is uneven: by scale, or as a blend of
/// joints.
bool has_uneven_normals(const Plan& plan, const Primitive& primitive, const Skin& skin) {
  const auto uneven_joint = [&](std::uint32_t joint) { return plan.joint_scales[joint].kind == ScaleKind::uneven; };
  const auto uneven_bind = [](const Affine& bind) { return scale_kind(bind) == ScaleKind::uneven; };
  const auto blends = [](const InfluenceGroup& group) { return group.influence_count > 1; };
  const std::vector<InfluenceGroup>& groups = primitive.influences.groups;
  return std::any_of(groups.begin(), groups.end(), blends) ||
         std::any_of(skin.joints.begin(), skin.joints.end(), uneven_joint) ||
         std::any_of(skin.inverse_bind.begin(), skin.inverse_bind.end(), uneven_bind);
}

/// The scale of the matrix whose determinant tells how faces wind: of the joint, or of the first skinning matrix.
JointScale scale_of_instance(const Plan& plan, std::size_t i) {
  const MeshInstance& instance = plan.scene->instances[i];
  if (!plan.instance_skinned[i]) {
    const JointPlace& place = plan.rig.places[instance.joint];
    JointScale scale = plan.joint_scales[place.at];
    scale.sign *= determinant_sign(place.from_joint);
    return scale;
  }
  const Skin& skin = *plan.rig.skins[instance.skin];
  if (skin.joints.empty()) return {.sign = 0};
  JointScale scale = plan.joint_scales[skin.joints[0]];
  scale.sign *= determinant_sign(affine_cast<double>(skin.inverse_bind[0]));
  return scale;
}

void plan_primitives(Plan& plan) {
  const Scene& scene = *plan.scene;
  const NeverShown never_shown(plan);
  const Needs nothing = {.joints = false, .positions = false, .normals = false, .tangents = false};
  CombinationsOfPlan combinations(plan);
  plan.first_primitive.push_back(0);
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const MeshInstance& instance = scene.instances[i];
    const auto& primitives = scene.meshes[instance.mesh].primitives;
    bool skinned = false;
    for (std::uint32_t p = 0; p < primitives.size(); ++p) {
      PrimitivePlan planned = plan_primitive(primitives[p], instance.skin != kNone, plan.needs.skinning_of(i),
                                             never_shown[instance.joint] ? nothing : plan.needs);
      planned.instance = i, planned.primitive = p;
      skinned |= instance.skin != kNone && !primitives[p].influences.empty();
      if (planned.skin.any()) {
        plan.palette[instance.skin] = true;
        if (planned.skinning != Skinning::linear) {
          plan.split[instance.skin] = true;
          planned.pairs = sharing_pairs(primitives[p].influences, scene.skins[instance.skin].joints.size());
        } else {
          planned.combined = combinations.of(primitives[p], instance.skin);
          planned.cofactors = plan.needs.normal_rule == NormalRule::cofactor && planned.skin.normals &&
                              has_uneven_normals(plan, primitives[p], *plan.rig.skins[instance.skin]);
        }
      }
      plan.primitives.push_back(planned);
    }
    if (skinned && plan.needs.palettes && !never_shown[instance.joint]) plan.palette[instance.skin] = true;
    plan.instance_skinned.push_back(skinned);
    plan.instance_scales.push_back(scale_of_instance(plan, i));
    plan.first_primitive.push_back(static_cast<std::uint32_t>(plan.primitives.size()));
  }
}

void place_primitives(Plan& plan, BlockLayout& block) {
  std::size_t morphed_positions = 0, morphed_normals = 0, morphed_tangents = 0, scratch = 0;
  for (PrimitivePlan& p : plan.primitives) {
    const std::size_t count = primitive_of(plan, p).vertex_count();
    const auto needed_between = [&](bool morph, bool skin) { return morph && skin ? count : 0; };
    if (p.morph.positions || p.skin.positions) p.positions_at = block.take_array<glm::vec3>(count);
    if (p.morph.normals || p.skin.normals || p.flat_normals) p.normals_at = block.take_array<glm::vec3>(count);
    if (p.morph.tangents || p.skin.tangents) p.tangents_at = block.take_array<glm::vec4>(count);
    if (p.morph_colors) p.colors_at = block.take_array<glm::vec4>(count);
    morphed_positions = std::max(morphed_positions, needed_between(p.morph.positions, p.skin.any()));
    morphed_normals = std::max(morphed_normals, needed_between(p.morph.normals, p.skin.any()));
    morphed_tangents = std::max(morphed_tangents, needed_between(p.morph.tangents, p.skin.any()));
    if (p.morph.any()) scratch = std::max(scratch, count);
  }
  // Primitives run one after another: what lies between morph and skin is shared by all of them.
  plan.morphed_positions_at = block.take_array<glm::vec3>(morphed_positions);
  plan.morphed_normals_at = block.take_array<glm::vec3>(morphed_normals);
  plan.morphed_tangents_at = block.take_array<glm::vec4>(morphed_tangents);
  plan.scratch_at = block.take_array<glm::vec3>(scratch);
}

bool is_mask(const std::vector<float>& mask, std::size_t joint_count) {
  return mask.size() == joint_count &&
         std::all_of(mask.begin(), mask.end(), [](float w) { return std::isfinite(w) && w >= 0.0f; });
}

/// Room for that many layers that add: frames with more are evaluated even where nothing changes.
constexpr std::size_t kKeptAddingLayers = 8;

void place_tables(Plan& plan, BlockLayout& block) {
  const Scene& scene = *plan.scene;
  TablePlaces& tables = plan.tables;
  tables.instances_at = block.take_array<InstanceResult>(scene.instances.size());
  tables.primitives_at = block.take_array<DeformedPrimitive>(plan.primitives.size());
  tables.blend_layers_at = block.take_array<BlendLayer>(plan.needs.max_layers);
  tables.palettes_at = block.take_array<SkinPalette>(plan.palette.size());
  tables.weights_since_at = block.take_array<std::uint64_t>(scene.instances.size());
  tables.winding_since_at = block.take_array<std::uint64_t>(scene.instances.size());
  tables.last_weights_at = block.take_array<float>(scene.weight_count());
  tables.input_weights_at = block.take_array<float>(scene.weight_count());
  tables.input_out_of_view_at = block.take_array<std::uint8_t>(scene.instances.size());
  tables.input_layer_count = plan.needs.max_layers + (plan.needs.additive ? kKeptAddingLayers : 0);
  tables.stage_ns_at = block.take_array<std::uint64_t>(plan.needs.stage_times ? kStageCount : 0);
  tables.input_layers_at = block.take_array<ClipLayer>(tables.input_layer_count);
  if (!plan.interpolate) return;
  tables.input_ahead_at = block.take_array<ClipLayer>(tables.input_layer_count);
  tables.ends_at = block.take_array<UpdateEnd>(2);
  for (std::size_t& at : tables.end_layers_at) at = block.take_array<ClipLayer>(tables.input_layer_count);
}

/// What frames of one clip touch before vertices.
void place_front(Plan& plan, std::size_t pose_bytes, std::size_t number_count, BlockLayout& block) {
  const Scene& scene = *plan.scene;
  place_tables(plan, block);
  plan.pose_at = block.take(plan.sample ? pose_bytes : 0);
  plan.weights_at = block.take_array<float>(scene.weight_count());
  plan.properties_at = block.take_array<float>(number_count);
  plan.hidden_at = block.take_array<bool>(plan.hide ? scene.skeleton.joint_count() : 0);
  plan.palette_wanted_at = block.take_array<bool>(scene.skins.size());
  plan.model_at = block.take_array<Affine>(plan.local_to_model ? plan.rig.joint_count() : 0);
  std::size_t largest_palette = 0;
  for (std::size_t s = 0; s < scene.skins.size(); ++s) {
    const std::size_t joints = scene.skins[s].joints.size();
    plan.palette_at.push_back(block.take_array<JointMatrix>(plan.palette[s] ? matrix_count(plan, s) : 0));
    plan.split_at.push_back(block.take_array<RigidStretch>(plan.split[s] ? joints : 0));
    if (plan.palette[s]) largest_palette = std::max(largest_palette, joints);
  }
  plan.new_palette_at = block.take_array<JointMatrix>(largest_palette);
  plan.stretch_at = block.take_array<bool>(scene.skins.size());
  plan.front_bytes = block.size();
}

void place(Plan& plan) {
  const Scene& scene = *plan.scene;
  const std::size_t pose_bytes = sizeof(float) * PoseSpan::floats_for(plan.rig.joint_count());
  const std::size_t extra_layers = plan.blend ? plan.needs.max_layers - 1 : 0;
  const std::size_t numbers = plan.properties ? scene.properties.rest.size() : 0;
  BlockLayout block;
  place_front(plan, pose_bytes, numbers, block);
  plan.rest_pose_at = block.take(pose_bytes);
  if (!plan.sample) plan.pose_at = plan.rest_pose_at;
  plan.layer_poses_at = block.take(extra_layers * pose_bytes);
  plan.layer_weights_at = block.take_array<float>(extra_layers * scene.weight_count());
  plan.layer_properties_at = block.take_array<float>(extra_layers * numbers);
  if (plan.correctives)
    for (const PoseCorrective& corrective : plan.rig.correctives)
      plan.corrective_scratch_count = std::max(plan.corrective_scratch_count, scratch_size(corrective));
  plan.corrective_scratch_at = block.take_array<double>(plan.corrective_scratch_count);
  plan.added_pose_at = block.take(plan.add ? pose_bytes : 0);
  plan.reference_pose_at = block.take(plan.add ? pose_bytes : 0);
  plan.added_weights_at = block.take_array<float>(plan.add ? scene.weight_count() : 0);
  plan.reference_weights_at = block.take_array<float>(plan.add ? scene.weight_count() : 0);
  if (plan.interpolate)
    for (PosePlaces& end : plan.ends)
      end = {block.take(pose_bytes), block.take_array<float>(scene.weight_count()), block.take_array<float>(numbers)};
  place_primitives(plan, block);
  plan.frame_bytes = block.size();
}

std::uint64_t fingerprint_of(const Needs& needs) {
  std::vector<std::uint32_t> numbers;
  for (const bool flag :
       {needs.joints, needs.positions, needs.normals, needs.tangents, needs.weights, needs.bounds, needs.properties,
        needs.hidden_meshes, needs.additive, needs.palettes, needs.stage_times, needs.between_updates})
    numbers.push_back(flag);
  numbers.push_back(needs.max_layers);
  numbers.push_back(static_cast<std::uint32_t>(needs.skinning));
  numbers.push_back(static_cast<std::uint32_t>(needs.normal_rule));
  for (const Skinning skinning : needs.instance_skinning) numbers.push_back(static_cast<std::uint32_t>(skinning));
  BitHash hash;
  hash.add(std::span<const std::uint32_t>(numbers));
  for (const std::vector<float>& mask : needs.masks) hash.add(std::span<const float>(mask));
  const SkeletonLod& detail = needs.skeleton_lod;
  const std::vector<std::uint32_t> kept(detail.kept.begin(), detail.kept.end());
  hash.add(std::span<const std::uint32_t>(kept)).add(std::span<const Transform>(detail.held));
  return hash.value();
}

/// Joints that some clip moves, by tracks or by a constant other than the rest pose, and all below them.
std::vector<std::uint32_t> moved_joints(const Rig& rig) {
  std::vector<bool> moved(rig.joint_count());
  const BasePose rest(rig.skeleton->rest);
  for (const Clip* clip : rig.clips) {
    const ClipLayout& layout = clip->layout();
    for (std::size_t i = 0; i < rest.planes.size(); ++i)
      if (!same_bits(layout.base_pose.planes[i], rest.planes[i])) moved[i % rest.stride] = true;
    for (const TimeGroup& group : layout.groups)
      for (const TrackBlock& block : group.blocks)
        if (block.property != Property::weight && block.property != Property::number)
          for (std::uint32_t i = 0; i < block.lane_count; ++i) moved[block.targets[i]] = true;
  }
  std::vector<std::uint32_t> joints;
  for (std::uint32_t j = 0; j < moved.size(); ++j) {
    const std::uint32_t parent = rig.skeleton->parents[j];
    moved[j] = moved[j] || (parent != kNone && moved[parent]);
    if (moved[j]) joints.push_back(j);
  }
  return joints;
}

/// The weights of the rig's joints.
std::vector<float> mask_of(const Rig& rig, const std::vector<float>& mask) {
  std::vector<float> kept;
  for (std::size_t j = 0; j < mask.size(); ++j)
    if (rig.places[j].is_kept) kept.push_back(mask[j]);
  return kept;
}

bool any_morphs(const Plan& plan) noexcept {
  return std::any_of(plan.primitives.begin(), plan.primitives.end(),
                     [](const PrimitivePlan& p) { return p.morph.any() || p.morph_colors; });
}

}  // namespace

Plan compile_plan(const Scene& scene, const Needs& needs) {
  CONTRACT(needs.max_layers > 0);
  CONTRACT(std::all_of(needs.masks.begin(), needs.masks.end(),
                       [&](const auto& mask) { return is_mask(mask, scene.skeleton.joint_count()); }));
  CONTRACT(needs.instance_skinning.empty() || needs.instance_skinning.size() == scene.instances.size());
  Plan plan;
  plan.scene = &scene;
  plan.needs = needs;
  plan.rig = make_rig(scene, needs.skeleton_lod);
  for (const std::vector<float>& mask : needs.masks) plan.masks.push_back(mask_of(plan.rig, mask));
  plan.palette.resize(scene.skins.size());
  plan.split.resize(scene.skins.size());
  plan.combined.resize(scene.skins.size());
  for (const MeshInstance& instance : scene.instances)
    plan.rest_weights.insert(plan.rest_weights.end(), instance.rest_weights.begin(), instance.rest_weights.end());
  for (const Clip* clip : plan.rig.clips) {
    const Clip::Counts counts = clip->counts();
    const std::uint32_t joint_tracks = counts.translations + counts.rotations + counts.scales;
    plan.clip_tracks.push_back({joint_tracks, counts.weights, counts.properties, joint_tracks + counts.folded > 0});
  }
  plan.local_to_model = scene.skeleton.joint_count() > 0 &&
                        (needs.joints || ((needs.vertices() || needs.palettes) && !scene.instances.empty()));
  plan.moved_joints = moved_joints(plan.rig);
  const auto& entries = scene.properties.entries;
  const bool flags = std::any_of(entries.begin(), entries.end(), [](const PropertyTable::Entry& entry) {
    return entry.target.kind == PropertyKind::node_visible;
  });
  plan.hide_per_frame = flags && (needs.properties || needs.vertices() || needs.palettes);
  plan.hide = plan.hide_per_frame || !scene.hidden_joints.empty();
  plan.properties = !scene.clips.empty() && ((needs.properties && !entries.empty()) || plan.hide_per_frame);
  plan.sample = !scene.clips.empty() && (plan.local_to_model || scene.weight_count() > 0 || plan.properties);
  plan.blend = plan.sample && (needs.max_layers > 1 || !needs.masks.empty());
  plan.add = plan.sample && needs.additive;
  plan.interpolate = plan.sample && needs.between_updates;
  plan.bounds = needs.bounds && !scene.instances.empty();
  plan.joint_scales = joint_scales(plan.rig, plan.add);
  plan_primitives(plan);
  plan.correctives = !scene.correctives.empty() && (needs.weights || any_morphs(plan));
  for (std::size_t s = 0; s < scene.skins.size(); ++s)
    plan.hemisphere_edges.push_back(plan.split[s] ? hemisphere_edges(scene.skeleton, scene.skins[s])
                                                  : std::vector<JointPair>{});
  place(plan);
  plan.fingerprint = fingerprint_of(needs);
  plan.stages = describe_stages(plan);
  CONTRACT(plan.stages.size() == kStageCount);
  return plan;
}

}  // namespace sinew
