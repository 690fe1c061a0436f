// SPDX-License-Identifier: MIT
#include "runtime/plan/plan_primitives.h"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "runtime/math/determinant_sign.h"
#include "runtime/plan/evaluate/visibility.h"
#include "runtime/pose/hemisphere_pairs.h"

namespace sinew {
namespace {

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

/// True if a material of the primitive, in any variant, reads tangents. True without a material: the consumer may light
/// such primitives with its own normal map.
bool shows_tangents(const Scene& scene, const Primitive& primitive) noexcept {
  const auto reads_tangents = [&](std::uint32_t material) {
    return material != kNone && scene.materials[material].reads_tangents();
  };
  const auto& others = primitive.variant_materials;
  return (primitive.material == kNone && others.empty()) || reads_tangents(primitive.material) ||
         std::any_of(others.begin(), others.end(),
                     [&](const VariantMaterial& v) { return reads_tangents(v.material); });
}

/// Plans morph and skin for each attribute that the primitive has, that the needs ask for, and that something moves.
PrimitivePlan plan_primitive(const Scene& scene, const Primitive& primitive, bool has_skin, bool may_play,
                             Skinning skinning, const Needs& needs) {
  PrimitivePlan plan;
  plan.lacks_centers = skinning == Skinning::center_of_rotation && primitive.centers_of_rotation.empty();
  plan.skinning = plan.lacks_centers ? Skinning::linear : skinning;
  const MorphedAttributes moved = morphed_by(primitive.morphs);
  const bool skinned = has_skin && !primitive.influences.empty();
  plan.flat_normals = needs.out.normals && primitive.flat_normals && !primitive.normals.empty() &&
                      primitive.topology == Topology::triangles && (skinned || moved.set.positions || may_play);
  const AttributeSet wanted = {needs.out.positions || needs.out.bounds || plan.flat_normals,
                               needs.out.normals && !primitive.normals.empty() && !plan.flat_normals,
                               needs.out.tangents && !primitive.tangents.empty() &&
                                   (needs.out.tangents_of_all || shows_tangents(scene, primitive))};
  plan.morph = {wanted.positions && moved.set.positions, wanted.normals && moved.set.normals,
                wanted.tangents && moved.set.tangents};
  plan.morph.positions |= plan.morph.any();  // jobs always write positions
  plan.morph_colors = needs.out.vertices() && moved.colors && !primitive.colors.empty();
  if (skinned) plan.skin = wanted;
  plan.skin.positions |= plan.skin.any();
  if (may_play) plan.cached = wanted;
  plan.cached.positions |= plan.cached.any();
  return plan;
}

/// Joints that no clip of the plan ever shows.
class NeverShown {
 public:
  explicit NeverShown(const CompiledPlan& plan) : hidden_(new bool[plan.scene->skeleton.joint_count()]()) {
    if (!plan.hide || plan.needs.out.hidden_meshes) return;
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

/// Calls `body(primitive, index)` for all primitives of a plan; null has none.
template <class Body>
void for_each_primitive(const CompiledPlan* plan, const Body& body) {
  for (std::size_t p = 0; plan != nullptr && p < plan->primitives.size(); ++p)
    body(primitive_of(*plan, plan->primitives[p]), p);
}

/// Chooses once for all instances of one skin how the vertices of a primitive follow their joints: in tiles, with
/// combined influences, both or neither. Only linear skinning combines influences. All instances of a primitive want
/// the same attributes.
class SkinningOfPlan {
 public:
  /// Vertices in tiles, and morph targets in their order if something is morphed. Null = jobs without tiles are faster.
  struct Tiled {
    std::shared_ptr<const VertexTiles> tiles;
    std::shared_ptr<const TiledMorphs> morphs;
  };

  SkinningOfPlan(CompiledPlan& plan, const CompiledPlan* beside) : plan_(plan) {
    for_each_primitive(beside, [&](const Primitive& primitive, std::size_t p) {
      const PrimitiveSkinning& skinning = beside->primitive_skinning[p];
      if (skinning.tiles != nullptr && skinning.combined == kNone)
        beside_[&primitive] = {skinning.tiles, skinning.morphs};
    });
  }

  const PrimitiveSkinning& linear(const Primitive& primitive, std::uint32_t skin, const PrimitivePlan& planned) {
    const auto [at, is_new] = known_.try_emplace({&primitive, skin});
    if (is_new) at->second = choose(primitive, skin, planned);
    return at->second;
  }

  /// The tiles of a primitive, which skins share.
  Tiled tiles_of(const Primitive& primitive, const PrimitivePlan& planned) {
    if (planned.morph.any() && planned.skinning != Skinning::linear) return {};  // these jobs also read packed vertices
    const bool with_centers = planned.skinning == Skinning::center_of_rotation;
    const auto [at, is_new] = tiles_.try_emplace({&primitive, with_centers});
    if (!is_new) return at->second;
    const auto made = beside_.find(&primitive);
    const bool serves = made != beside_.end() && (!planned.morph.any() || made->second.morphs != nullptr) &&
                        (!planned.skin.normals || !made->second.tiles->normals.empty()) &&
                        (!planned.skin.tangents || !made->second.tiles->tangents.empty()) &&
                        (!with_centers || !made->second.tiles->centers.empty());
    at->second = serves ? made->second : make_tiles(primitive.influences, primitive, planned);
    return at->second;
  }

 private:
  PrimitiveSkinning choose(const Primitive& primitive, std::uint32_t skin, const PrimitivePlan& planned) {
    PrimitiveSkinning chosen;
    Tiled tiled = tiles_of(primitive, planned);
    CombinedInfluences combined = combine_influences(primitive.influences, matrix_count(plan_, skin));
    if (combined.used()) {
      // A vector takes less time with one matrix a vertex, so combinations win if they need no more vectors.
      Tiled other = make_tiles(combined.vertices, primitive, planned);
      if (other.tiles != nullptr &&
          (tiled.tiles == nullptr || other.tiles->relative_cost() <= tiled.tiles->relative_cost()))
        tiled = std::move(other);
      else if (tiled.tiles != nullptr)
        combined.combinations = combined.vertices = {};
    }
    if (combined.used()) chosen.combined = static_cast<std::uint32_t>(plan_.combined[skin].size());
    plan_.combined[skin].push_back(std::move(combined));
    chosen.tiles = std::move(tiled.tiles);
    chosen.morphs = std::move(tiled.morphs);
    return chosen;
  }

  static Tiled make_tiles(const VertexInfluences& influences, const Primitive& primitive,
                          const PrimitivePlan& planned) {
    VertexInput in{.positions = primitive.positions, .normals = {}, .tangents = {}};
    if (planned.skin.normals) in.normals = primitive.normals;
    if (planned.skin.tangents) in.tangents = primitive.tangents;
    std::span<const glm::vec3> centers;
    if (planned.skinning == Skinning::center_of_rotation) centers = primitive.centers_of_rotation;
    VertexTiles tiles = tile_vertices(influences, in, centers);
    if (tiles.relative_cost() > VertexTiles::kMostCost) return {};
    std::shared_ptr<const TiledMorphs> morphs;
    if (planned.morph.any()) {
      morphs = std::make_shared<const TiledMorphs>(tile_morphs(primitive.morphs, tiles));
      if (morphs->relative_memory > TiledMorphs::kMostMemory) return {};
    }
    return {std::make_shared<const VertexTiles>(std::move(tiles)), std::move(morphs)};
  }

  CompiledPlan& plan_;
  std::map<std::pair<const Primitive*, std::uint32_t>, PrimitiveSkinning> known_;
  std::map<std::pair<const Primitive*, bool>, Tiled> tiles_;  ///< of a primitive, with or without centers of rotation
  std::map<const Primitive*, Tiled> beside_;
};

/// Sorts the triangles of primitives with flat normals, once for all instances of a mesh.
class FlatFacesOfPlan {
 public:
  explicit FlatFacesOfPlan(const CompiledPlan* beside) {
    for_each_primitive(beside, [&](const Primitive& primitive, std::size_t p) {
      if (beside->flat_faces[p] != nullptr) known_[&primitive] = beside->flat_faces[p];
    });
  }
  std::shared_ptr<const FlatFaces> of(const Primitive& primitive) {
    std::shared_ptr<const FlatFaces>& faces = known_[&primitive];
    if (!faces) faces = std::make_shared<const FlatFaces>(sort_flat_faces(primitive.indices, primitive.vertex_count()));
    return faces;
  }

 private:
  std::map<const Primitive*, std::shared_ptr<const FlatFaces>> known_;
};

/// Joins the triangles of primitives that a source may play, once for all instances of a mesh.
class SurfacesOfPlan {
 public:
  explicit SurfacesOfPlan(const CompiledPlan* beside) {
    for_each_primitive(beside, [&](const Primitive& primitive, std::size_t p) {
      if (beside->surface_faces[p] != nullptr) known_[&primitive] = beside->surface_faces[p];
    });
  }
  std::shared_ptr<const SurfaceFaces> of(const Primitive& primitive, bool with_tangents) {
    std::shared_ptr<const SurfaceFaces>& faces = known_[&primitive];
    if (!faces || (with_tangents && faces->tangents.empty()))
      faces = std::make_shared<const SurfaceFaces>(join_surface(primitive, with_tangents));
    return faces;
  }

 private:
  std::map<const Primitive*, std::shared_ptr<const SurfaceFaces>> known_;
};

/// True if frames may derive normals or tangents of the primitive from its triangles.
bool has_surface(const PrimitivePlan& planned, const Primitive& primitive) {
  return (planned.cached.normals || planned.cached.tangents) && primitive.topology == Topology::triangles;
}

/// True if cofactors turn normals another way than the matrix does. That needs an uneven matrix: by scale, or as a
/// blend of joints.
bool has_uneven_normals(const CompiledPlan& plan, const Primitive& primitive, const Skin& skin) {
  const auto uneven_joint = [&](std::uint32_t joint) { return plan.joint_scales[joint].kind == ScaleKind::uneven; };
  const auto uneven_bind = [](const Affine& bind) { return scale_kind(bind) == ScaleKind::uneven; };
  const auto blends = [](const InfluenceGroup& group) { return group.influence_count > 1; };
  const std::vector<InfluenceGroup>& groups = primitive.influences.groups;
  return std::any_of(groups.begin(), groups.end(), blends) ||
         std::any_of(skin.joints.begin(), skin.joints.end(), uneven_joint) ||
         std::any_of(skin.inverse_bind.begin(), skin.inverse_bind.end(), uneven_bind);
}

/// The scale of the matrix whose determinant tells how faces wind: of the joint, or of the first skinning matrix.
JointScale scale_of_instance(const CompiledPlan& plan, std::size_t i) {
  const MeshInstance& instance = plan.scene->instances[i];
  if (!plan.instance_skinned[i]) {
    const JointMapping& mapped = plan.assets.joint_map[instance.joint];
    JointScale scale = plan.joint_scales[mapped.pose_index];
    scale.sign *= determinant_sign(mapped.kept_from_joint);
    return scale;
  }
  const Skin& skin = *plan.assets.skins[instance.skin];
  if (skin.joints.empty()) return {.sign = 0};
  JointScale scale = plan.joint_scales[skin.joints[0]];
  scale.sign *= determinant_sign(skin.inverse_bind[0]);
  return scale;
}

/// Plans the matrices that a skinned primitive needs of its skin.
void plan_skinning(CompiledPlan& plan, const Primitive& primitive, std::uint32_t skin, SkinningOfPlan& of_plan,
                   PrimitivePlan& planned, PrimitiveSkinning& skinning) {
  plan.palette[skin] = true;
  if (planned.skinning != Skinning::linear) {
    plan.split[skin] = true;
    skinning.pairs = joint_pairs_of_vertices(primitive.influences, plan.scene->skins[skin].joints.size());
    skinning.tiles = of_plan.tiles_of(primitive, planned).tiles;
    return;
  }
  skinning = of_plan.linear(primitive, skin, planned);
  planned.cofactors = plan.needs.skin.normal_rule == NormalRule::cofactor && planned.skin.normals &&
                      has_uneven_normals(plan, primitive, *plan.assets.skins[skin]);
}

}  // namespace

void plan_primitives(CompiledPlan& plan, const CompiledPlan* beside) {
  const Scene& scene = *plan.scene;
  plan.palette.resize(scene.skins.size());
  plan.split.resize(scene.skins.size());
  plan.combined.resize(scene.skins.size());
  const NeverShown never_shown(plan);
  const Needs nothing = {.out = {.positions = false, .normals = false, .tangents = false}};
  SkinningOfPlan skinning_of_plan(plan, beside);
  FlatFacesOfPlan flat_faces(beside);
  SurfacesOfPlan surfaces(beside);
  plan.first_primitive.push_back(0);
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const MeshInstance& instance = scene.instances[i];
    const auto& primitives = scene.meshes[instance.mesh].primitives;
    const auto slot = std::lower_bound(plan.needs.in.cached_instances.begin(), plan.needs.in.cached_instances.end(), i);
    const bool may_play = slot != plan.needs.in.cached_instances.end() && *slot == i;
    bool skinned = false, plays = false;
    for (std::uint32_t p = 0; p < primitives.size(); ++p) {
      PrimitivePlan planned =
          plan_primitive(scene, primitives[p], instance.skin != kNone, may_play, plan.needs.skin.kind_of(i),
                         never_shown[instance.joint] ? nothing : plan.needs);
      planned.instance = i;
      planned.primitive = p;
      skinned |= instance.skin != kNone && !primitives[p].influences.empty();
      PrimitiveSkinning skinning;
      if (planned.skin.any()) plan_skinning(plan, primitives[p], instance.skin, skinning_of_plan, planned, skinning);
      plan.flat_faces.push_back(planned.flat_normals ? flat_faces.of(primitives[p]) : nullptr);
      plan.surface_faces.push_back(
          has_surface(planned, primitives[p]) ? surfaces.of(primitives[p], planned.cached.tangents) : nullptr);
      plays |= planned.cached.any();
      plan.primitives.push_back(planned);
      plan.primitive_skinning.push_back(std::move(skinning));
    }
    if (skinned && plan.needs.out.palettes && !never_shown[instance.joint]) plan.palette[instance.skin] = true;
    if (may_play) plan.geometry_slot.resize(scene.instances.size(), kNone);
    if (plays) plan.geometry_slot[i] = static_cast<std::uint32_t>(slot - plan.needs.in.cached_instances.begin());
    plan.instance_skinned.push_back(skinned);
    plan.instance_scales.push_back(scale_of_instance(plan, i));
    plan.first_primitive.push_back(static_cast<std::uint32_t>(plan.primitives.size()));
  }
}

}  // namespace sinew
