// SPDX-License-Identifier: MIT
#include "runtime/plan/plan_stages.h"

#include <algorithm>

#include "runtime/clip/clip_layout.h"
#include "runtime/plan/compiled_plan.h"
#include "runtime/pose/joint_palette.h"
#include "runtime/pose/pose.h"

namespace sinew {
namespace {

std::string counted(std::uint64_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string primitives(std::uint64_t count) { return counted(count, "primitive", "primitives"); }

std::uint64_t pose_bytes(const CompiledPlan& plan) {
  return sizeof(float) * (PoseSpan::floats_for(plan.assets.joint_count()) + plan.scene->weight_count());
}

/// Says how many tracks of a clip use each kind of interpolation. Kinds that no track uses are left out.
std::string describe_tracks(const Clip& clip) {
  std::uint32_t steps = 0, lerps = 0, slerps = 0, cubics = 0, squads = 0;
  for (const TimeGroup& group : clip.layout().groups)
    for (const TrackBlock& block : group.blocks) {
      if (block.property == Property::number) continue;
      switch (block.interpolation) {
        case Interpolation::step: steps += block.lane_count; break;
        case Interpolation::linear: (block.property == Property::rotation ? slerps : lerps) += block.lane_count; break;
        case Interpolation::cubic_spline: cubics += block.lane_count; break;
        case Interpolation::squad: squads += block.lane_count; break;
      }
    }
  std::string text;
  const auto add = [&](std::uint32_t count, const char* kind) {
    if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + kind;
  };
  add(steps, "step");
  add(lerps, "linear");
  add(slerps, "slerp");
  add(cubics, "cubic");
  add(squads, "squad");
  return text.empty() ? "none that moves" : text;
}

PlanStage describe_sample(const CompiledPlan& plan) {
  const std::size_t clips = plan.assets.clips.size();
  if (clips == 0) return {"sample", false, "no clips: the rest pose is written once", 0, 0};
  if (!plan.sample) return {"sample", false, "no joints, local pose, vertices or morph weights are asked for", 0, 0};
  const auto tracks_of = [](const ClipTracks& clip) { return clip.joints + clip.weights; };
  const auto most =
      std::max_element(plan.clip_tracks.begin(), plan.clip_tracks.end(),
                       [&](const ClipTracks& a, const ClipTracks& b) { return tracks_of(a) < tracks_of(b); });
  const Clip& clip = plan.assets.clips[static_cast<std::size_t>(most - plan.clip_tracks.begin())];
  return {"sample", true, counted(clips, "clip", "clips") + "; the one with most tracks has " + describe_tracks(clip),
          tracks_of(*most), pose_bytes(plan)};
}

PlanStage describe_mirror(const CompiledPlan& plan) {
  if (!plan.sample) return {"mirror", false, "nothing is sampled", 0, 0};
  if (!plan.mirror) return {"mirror", false, "no mirrored layers are asked for", 0, 0};
  const std::size_t pairs = paired_joints(*plan.assets.mirror);
  return {"mirror", true,
          "layers may play the other side; " + counted(pairs, "joint has a partner", "joints have partners"),
          plan.assets.joint_count(), pose_bytes(plan)};
}

PlanStage describe_blend(const CompiledPlan& plan) {
  const std::uint64_t layers = plan.needs.in.max_layers;
  if (!plan.sample) return {"blend", false, "nothing is sampled", 0, 0};
  if (!plan.blend) return {"blend", false, "at most one layer is asked for", 0, 0};
  const std::string limit =
      layers == 1 ? "one layer, which a mask may limit" : "up to " + std::to_string(layers) + " layers";
  return {"blend", true, limit + "; a single one of full weight skips the stage", plan.assets.joint_count(),
          pose_bytes(plan) * std::max<std::uint64_t>(layers - 1, 1)};
}

PlanStage describe_add(const CompiledPlan& plan) {
  if (!plan.sample) return {"add", false, "nothing is sampled", 0, 0};
  if (!plan.add) return {"add", false, "no layers that add are asked for", 0, 0};
  return {"add", true, "layers that add are asked for, one after another", plan.assets.joint_count(),
          2 * pose_bytes(plan)};
}

/// Describes programs: poses of the caller, overlays, placed joints, procedures.
PlanStage describe_programs(const CompiledPlan& plan) {
  const PoseProgramRoom& room = plan.needs.in.program;
  if (room.ops == 0) return {"pose_program", false, "no pose programs are asked for", 0, 0};
  if (!plan.poses)
    return {"pose_program", false, "no joints, local pose, vertices or morph weights are asked for", 0, 0};
  std::string reason = "programs of up to " + counted(room.ops, "operation", "operations") + " on " +
                       counted(room.slots, "pose", "poses") + " at once are asked for";
  const auto add = [&](std::uint32_t count, const char* one, const char* many) {
    if (count > 0) reason += ", with " + counted(count, one, many);
  };
  add(room.externals, "pose of the caller", "poses of the caller");
  add(room.overridden_joints, "joint that the caller places", "joints that the caller places");
  add(room.procedures, "procedure", "procedures");
  return {"pose_program", true, std::move(reason), room.ops, plan.layout.pose_program.count};
}

PlanStage describe_interpolate(const CompiledPlan& plan) {
  if (!plan.sample) return {"interpolate", false, "nothing is sampled", 0, 0};
  if (!plan.interpolate) return {"interpolate", false, "no frames between updates are asked for", 0, 0};
  return {"interpolate", true, "frames between updates are asked for; both poses are kept", plan.assets.joint_count(),
          2 * pose_bytes(plan)};
}

PlanStage describe_correctives(const CompiledPlan& plan) {
  const std::span<const PoseCorrective> correctives = plan.assets.correctives;
  if (correctives.empty()) return {"correctives", false, "the scene has no corrective shapes", 0, 0};
  if (!plan.correctives)
    return {"correctives", false, "neither morph weights nor morphed vertices are asked for", 0, 0};
  std::uint64_t samples = 0;
  for (const PoseCorrective& corrective : correctives) samples += corrective.samples.sample_count();
  return {"correctives", true, counted(correctives.size(), "corrective adds", "correctives add") + " to morph weights",
          samples, plan.layout.corrective_scratch.count * sizeof(double)};
}

PlanStage describe_properties(const CompiledPlan& plan) {
  const PropertyTable& table = plan.scene->properties;
  if (table.entries.empty())
    return {"properties", false, "no clip moves a material, a light, a camera or a flag", 0, 0};
  if (!plan.properties) return {"properties", false, "properties are not asked for", 0, 0};
  return {"properties", true,
          counted(table.entries.size(), "property is", "properties are") + " moved by clips" +
              (plan.hide_per_frame ? ", some of them hide nodes" : ""),
          table.rest.size(), table.rest.size() * sizeof(float)};
}

/// Names the largest kind of scale that reaches joints.
std::string describe_scale(const CompiledPlan& plan) {
  const auto of_kind = [&](ScaleKind kind) {
    return std::count_if(plan.joint_scales.begin(), plan.joint_scales.end(),
                         [&](const JointScale& s) { return s.kind == kind; });
  };
  if (const auto uneven = of_kind(ScaleKind::uneven); uneven > 0)
    return "uneven scale can reach " + counted(static_cast<std::uint64_t>(uneven), "joint", "joints");
  return of_kind(ScaleKind::even) > 0 ? "scale is even" : "no scale";
}

PlanStage describe_local_to_model(const CompiledPlan& plan) {
  const std::size_t joints = plan.assets.joint_count(), left_out = plan.assets.joint_map.size() - joints;
  if (joints == 0) return {"local_to_model", false, "the scene has no nodes", 0, 0};
  if (!plan.local_to_model) return {"local_to_model", false, "neither joints nor vertices are asked for", 0, 0};
  const std::size_t moved = plan.moved_joints.size();
  std::string reason = plan.needs.out.joints ? "joints are asked for" : "mesh instances hang on joints";
  if (left_out > 0)
    reason += "; " + std::to_string(left_out) + " of " + counted(joints + left_out, "joint is", "joints are") +
              " left out as asked, they follow the joints above";
  if (moved == 0)
    reason += "; no clip moves any, they are composed once";
  else if (moved < joints)
    reason += "; " + std::to_string(joints - moved) + " of " + std::to_string(joints) +
              " are moved by no clip: composed once";
  reason += "; " + describe_scale(plan);
  return {"local_to_model", true, std::move(reason), joints, joints * sizeof(Affine)};
}

/// Describes palettes, or their split, for the skins with `used[skin]`; `entry_bytes` is the size for each joint.
PlanStage describe_skins(const CompiledPlan& plan, std::string stage, const std::vector<bool>& used,
                         std::size_t entry_bytes, std::string why_not) {
  std::uint64_t skins = 0, entries = 0;
  for (std::size_t s = 0; s < used.size(); ++s) {
    if (!used[s]) continue;
    ++skins;
    entries += plan.scene->skins[s].joints.size();
  }
  if (skins == 0) return {std::move(stage), false, std::move(why_not), 0, 0};
  return {std::move(stage), true,
          std::to_string(skins) + " of " + counted(used.size(), "skin", "skins") + " called for by mesh instances",
          entries, entries * entry_bytes};
}

/// Describes matrices that vertices share, of the distinct primitives of each skin.
PlanStage describe_combinations(const CompiledPlan& plan) {
  struct Sum {
    std::uint64_t primitives = 0, combinations = 0, vertices = 0;

    void add(const CombinedInfluences& combined) {
      ++primitives;
      combinations += combined.combination_count;
      vertices += combined.blended_vertices;
    }
    std::string text() const {
      return counted(combinations, "combination", "combinations") + " of joints and weights for " +
             counted(vertices, "vertex", "vertices");
    }
  };
  Sum used, unused;
  for (const std::vector<CombinedInfluences>& of_skin : plan.combined)
    for (const CombinedInfluences& combined : of_skin)
      if (combined.used() || combined.blended_vertices > 0) (combined.used() ? used : unused).add(combined);
  const std::string left_out = "sharing does not pay in " + primitives(unused.primitives) + ": " + unused.text();
  if (used.primitives == 0)
    return {"combinations", false, unused.primitives > 0 ? left_out : "no vertex blends the matrices of several joints",
            0, 0};
  std::string reason = primitives(used.primitives) + " with " + used.text() + ": each is blended once";
  if (unused.primitives > 0) reason += "; " + left_out;
  return {"combinations", true, std::move(reason), used.combinations, used.combinations * sizeof(JointMatrix)};
}

/// Describes the winding of faces. It is known before any frame unless scale can change its sign.
PlanStage describe_winding(const CompiledPlan& plan) {
  const std::size_t instances = plan.instance_scales.size();
  if (instances == 0) return {"winding", false, "the scene shows no meshes", 0, 0};
  if (!plan.local_to_model) return {"winding", false, "neither joints nor vertices are asked for", 0, 0};
  const auto tested = std::count_if(plan.instance_scales.begin(), plan.instance_scales.end(),
                                    [](const JointScale& s) { return s.may_change; });
  if (tested == 0) return {"winding", false, "no scale can change its sign: known beforehand", 0, 0};
  const auto count = static_cast<std::uint64_t>(tested);
  return {"winding", true,
          "of " + std::to_string(count) + " of " + counted(instances, "mesh instance", "mesh instances") +
              ", whose scale can change its sign",
          count, count * sizeof(bool)};
}

std::string why_no_skinning(const CompiledPlan& plan) {
  if (!plan.needs.out.vertices()) return "no vertices are asked for";
  const bool any =
      std::find(plan.instance_skinned.begin(), plan.instance_skinned.end(), true) != plan.instance_skinned.end();
  return any ? "no attribute that is asked for is skinned" : "no mesh instance is skinned";
}

std::uint64_t attribute_bytes(const AttributeSet& set, std::uint64_t vertices) {
  return vertices * ((set.positions ? sizeof(glm::vec3) : 0) + (set.normals ? sizeof(glm::vec3) : 0) +
                     (set.tangents ? sizeof(glm::vec4) : 0));
}

PlanStage describe_morph(const CompiledPlan& plan) {
  PlanStage stage{"morph", false, "", 0, 0};
  std::uint64_t morphed = 0;
  bool targets = false;
  for (const PrimitivePlan& p : plan.primitives) {
    const std::uint64_t vertices = primitive_of(plan, p).vertex_count();
    targets |= !primitive_of(plan, p).morphs.empty();
    if (!p.morph.any() && !p.morph_colors) continue;
    ++morphed;
    stage.count += vertices;
    stage.bytes += attribute_bytes(p.morph, vertices) + (p.morph_colors ? vertices * sizeof(glm::vec4) : 0);
  }
  stage.runs = morphed > 0;
  if (stage.runs)
    stage.reason = primitives(morphed) + " with targets that move something; targets of weight 0 cost nothing";
  else if (!targets)
    stage.reason = "no mesh instance has morph targets";
  else if (!plan.needs.out.vertices())
    stage.reason = "no vertices are asked for";
  else
    stage.reason = "no target moves an attribute that is asked for";
  return stage;
}

/// Number of primitives that ask for center-of-rotation skinning and have no centers.
std::uint64_t without_centers(const CompiledPlan& plan) {
  std::uint64_t count = 0;
  for (const PrimitivePlan& p : plan.primitives) count += p.skin.any() && p.lacks_centers;
  return count;
}

std::string why_other_skinning(const CompiledPlan& plan, Skinning kind) {
  const std::uint64_t fallen_back = kind == Skinning::center_of_rotation ? without_centers(plan) : 0;
  if (fallen_back == 0) return "all skinned primitives use another kind of skinning";
  return primitives(fallen_back) + " without centers of rotation: skinned linearly";
}

/// Says which normals follow the cofactor matrix if the needs ask for it.
std::string describe_cofactors(const CompiledPlan& plan) {
  std::uint64_t by_cofactors = 0, by_matrices = 0;
  for (const PrimitivePlan& p : plan.primitives)
    if (p.skinning == Skinning::linear && p.skin.normals) ++(p.cofactors ? by_cofactors : by_matrices);
  std::string text;
  if (by_cofactors > 0) text += "; normals of " + primitives(by_cofactors) + " by cofactors";
  if (by_matrices > 0)
    text += "; normals of " + primitives(by_matrices) + " without: neither scale nor blends are uneven";
  return text;
}

PlanStage describe_skin(const CompiledPlan& plan, std::string name, Skinning kind) {
  PlanStage stage{std::move(name), false, "", 0, 0};
  std::uint64_t skinned = 0, skinned_otherwise = 0, in_tiles = 0;
  for (std::size_t i = 0; i < plan.primitives.size(); ++i) {
    const PrimitivePlan& p = plan.primitives[i];
    if (!p.skin.any()) continue;
    if (p.skinning != kind) {
      ++skinned_otherwise;
      continue;
    }
    ++skinned;
    in_tiles += plan.primitive_skinning[i].tiles != nullptr;
    stage.count += primitive_of(plan, p).vertex_count();
    stage.bytes += attribute_bytes(p.skin, primitive_of(plan, p).vertex_count());
  }
  stage.runs = skinned > 0;
  if (stage.runs)
    stage.reason = primitives(skinned) + " with joints and weights" +
                   (in_tiles > 0 ? "; vertices of " + std::to_string(in_tiles) + " sorted by joints" : "");
  else if (skinned_otherwise > 0)
    stage.reason = why_other_skinning(plan, kind);
  else
    stage.reason = why_no_skinning(plan);
  if (stage.runs && kind == Skinning::linear && plan.needs.skin.normal_rule == NormalRule::cofactor)
    stage.reason += describe_cofactors(plan);
  if (const std::uint64_t lacking = without_centers(plan); stage.runs && kind == Skinning::linear && lacking > 0)
    stage.reason += "; " + std::to_string(lacking) + " for want of centers of rotation";
  return stage;
}

/// Describes primitives that may take their vertices from a geometry cache, and the frame memory for these vertices.
PlanStage describe_geometry_cache(const CompiledPlan& plan) {
  PlanStage stage{"geometry_cache", false, "", 0, 0};
  std::uint64_t played = 0, with_surface = 0;
  for (std::size_t p = 0; p < plan.primitives.size(); ++p) {
    const PrimitivePlan& planned = plan.primitives[p];
    if (!planned.cached.any()) continue;
    ++played;
    with_surface += plan.surface_faces[p] != nullptr;
    stage.count += primitive_of(plan, planned).vertex_count();
    stage.bytes += attribute_bytes(planned.cached, primitive_of(plan, planned).vertex_count());
  }
  stage.runs = played > 0;
  if (stage.runs)
    stage.reason = primitives(played) + " may play from a cache, in place of morph and skin" +
                   (with_surface > 0 ? "; normals that it lacks follow the triangles" : "");
  else if (plan.needs.in.cached_instances.empty())
    stage.reason = "no mesh instance is asked to play from a cache";
  else
    stage.reason = "no attribute that is asked for can play";
  return stage;
}

PlanStage describe_flat_normals(const CompiledPlan& plan) {
  PlanStage stage{"flat_normals", false, "", 0, 0};
  std::uint64_t flat = 0;
  for (const PrimitivePlan& p : plan.primitives) {
    if (!p.flat_normals) continue;
    ++flat;
    stage.count += primitive_of(plan, p).indices.size() / 3;
    stage.bytes += primitive_of(plan, p).vertex_count() * sizeof(glm::vec3);
  }
  stage.runs = flat > 0;
  if (stage.runs)
    stage.reason = primitives(flat) + " without normals in the file, deformed: faces stay flat";
  else
    stage.reason =
        plan.needs.out.normals ? "no deformed primitive lacks normals in the file" : "normals are not asked for";
  return stage;
}

PlanStage describe_bounds(const CompiledPlan& plan) {
  if (!plan.needs.out.bounds) return {"bounds", false, "boxes are not asked for", 0, 0};
  if (!plan.bounds) return {"bounds", false, "the scene shows no meshes", 0, 0};
  std::uint64_t vertices = 0;
  for (const PrimitivePlan& p : plan.primitives)
    if (p.morph.positions || p.skin.positions || p.cached.positions) vertices += primitive_of(plan, p).vertex_count();
  return {"bounds", true, "boxes are asked for; rigid meshes move the box of their rest pose", vertices,
          plan.scene->instances.size() * sizeof(Aabb)};
}

}  // namespace

std::vector<PlanStage> describe_stages(const CompiledPlan& plan) {
  const std::string no_split = "no primitive is skinned with dual quaternions or about centers of rotation";
  return {describe_sample(plan),
          describe_mirror(plan),
          describe_blend(plan),
          describe_add(plan),
          describe_programs(plan),
          describe_interpolate(plan),
          describe_correctives(plan),
          describe_properties(plan),
          describe_local_to_model(plan),
          describe_skins(
              plan, "palette", plan.palette, sizeof(JointMatrix),
              plan.needs.out.palettes ? "no mesh instance that is ever shown is skinned" : why_no_skinning(plan)),
          describe_skins(plan, "split_palette", plan.split, sizeof(RigidStretch), no_split),
          describe_combinations(plan),
          describe_winding(plan),
          describe_morph(plan),
          describe_skin(plan, "skin_linear", Skinning::linear),
          describe_skin(plan, "skin_dual_quaternion", Skinning::dual_quaternion),
          describe_skin(plan, "skin_center_of_rotation", Skinning::center_of_rotation),
          describe_geometry_cache(plan),
          describe_flat_normals(plan),
          describe_bounds(plan)};
}

}  // namespace sinew
