// SPDX-License-Identifier: MIT
#include "runtime/memory/array_bytes.h"
#include "runtime/memory/memory_of.h"
#include "runtime/plan/compiled_plan.h"

namespace sinew {
namespace {

template <class T>
std::size_t bytes_of_nested(const std::vector<std::vector<T>>& arrays) {
  return bytes_of(arrays, [](const std::vector<T>& array) { return bytes_of(array); });
}

std::size_t bytes_of_influences(const VertexInfluences& influences) {
  return bytes_of(influences.groups) + bytes_of(influences.joints) + bytes_of(influences.weights);
}

std::size_t bytes_of_combined(const std::vector<CombinedInfluences>& of_skin) {
  return bytes_of(of_skin, [](const CombinedInfluences& c) {
    return bytes_of_influences(c.combinations) + bytes_of_influences(c.vertices);
  });
}

std::size_t bytes_of_needs(const Needs& needs) {
  return bytes_of_nested(needs.in.masks) + bytes_of(needs.out.skeleton_lod.kept) +
         bytes_of(needs.out.skeleton_lod.held) + bytes_of(needs.in.cached_instances) +
         bytes_of(needs.skin.per_instance);
}

std::size_t bytes_of_sums(const MirroredSums& sums) {
  return bytes_of(sums.joints) + bytes_of(sums.sources) + bytes_of(sums.factors);
}

/// Bytes of the tables that each pose, primitive or skin has for itself. Tables that primitives share are counted
/// separately.
std::size_t bytes_of_tables(const CompiledPlan& plan) {
  const auto pairs = [](const PrimitiveSkinning& skinning) { return bytes_of(skinning.pairs); };
  return bytes_of(plan.clip_tracks) + bytes_of(plan.moved_joints) + bytes_of(plan.unmoved_joints) +
         bytes_of(plan.joint_scales) + bytes_of_nested(plan.mask_weights) + bytes_of(plan.masks) +
         bytes_of(plan.rest_weights) + bytes_of(plan.primitives) + bytes_of(plan.primitive_skinning, pairs) +
         bytes_of(plan.flat_faces) + bytes_of(plan.surface_faces) + bytes_of(plan.first_primitive) +
         bytes_of(plan.geometry_slot) + bytes_of(plan.instance_skinned) + bytes_of(plan.instance_scales) +
         bytes_of(plan.palette) + bytes_of(plan.split) + bytes_of(plan.combined, bytes_of_combined) +
         bytes_of_nested(plan.hemisphere_edges) + bytes_of(plan.layout.palettes) + bytes_of(plan.layout.splits) +
         bytes_of(plan.layout.primitives);
}

std::size_t bytes_of_mirror(const MirrorTables& tables) {
  return bytes_of(tables.copies) + bytes_of_sums(tables.translation) + bytes_of_sums(tables.rotation) +
         bytes_of_sums(tables.scale);
}

std::size_t bytes_of_map(const MirrorMap& map) {
  return sizeof map + bytes_of(map.joints) + bytes_of(map.unpaired) + bytes_of(map.weight_source);
}

std::size_t bytes_of_faces(const FlatFaces& faces) {
  return sizeof faces + bytes_of(faces.streams) + bytes_of(faces.corners) + bytes_of(faces.alone) +
         bytes_of(faces.at_rest);
}

std::size_t bytes_of_faces(const SurfaceFaces& faces) {
  return sizeof faces + bytes_of(faces.corners) + bytes_of(faces.point_of_vertex) + bytes_of(faces.tangents);
}

std::size_t bytes_of_tiles(const VertexTiles& tiles) {
  return sizeof tiles + bytes_of(tiles.runs) + bytes_of(tiles.joints) + bytes_of(tiles.positions) +
         bytes_of(tiles.weights) + bytes_of(tiles.normals) + bytes_of(tiles.tangents) + bytes_of(tiles.centers) +
         bytes_of(tiles.vertices) + bytes_of(tiles.fours);
}

std::size_t bytes_of_morphs(const TiledMorphs& morphs) {
  const auto of_deltas = [](const TiledDeltas& deltas) { return bytes_of(deltas.tiles) + bytes_of(deltas.planes); };
  return sizeof morphs + bytes_of(morphs.targets, [&](const TiledTarget& target) {
           return of_deltas(target.positions) + of_deltas(target.normals) + of_deltas(target.tangents);
         });
}

}  // namespace

MemoryCount& MemoryCount::add(const Plan& handle) {
  if (!is_new(handle.compiled().get())) return *this;
  const CompiledPlan& plan = *handle.compiled();
  const PlanAssets& assets = plan.assets;
  bytes_.plans +=
      sizeof plan + bytes_of_tables(plan) + bytes_of_needs(plan.needs) + bytes_of_mirror(plan.mirror_tables);
  bytes_.plans += bytes_of(assets.clips) + bytes_of(assets.skins) + bytes_of(assets.joint_map);
  for (const auto& map : {plan.needs.in.mirror, assets.mirror})
    if (is_new(map.get())) bytes_.plans += bytes_of_map(*map);
  for (const auto& faces : plan.flat_faces)
    if (is_new(faces.get())) bytes_.plans += bytes_of_faces(*faces);
  for (const auto& faces : plan.surface_faces)
    if (is_new(faces.get())) bytes_.plans += bytes_of_faces(*faces);
  for (const PrimitiveSkinning& skinning : plan.primitive_skinning) {
    if (is_new(skinning.tiles.get())) bytes_.plans += bytes_of_tiles(*skinning.tiles);
    if (is_new(skinning.morphs.get())) bytes_.plans += bytes_of_morphs(*skinning.morphs);
  }
  for (const Clip& clip : assets.clips) add(clip);
  if (!assets.leaves_out()) return *this;
  add(*assets.skeleton);  // reduced by the skeleton LOD
  for (const Skin* skin : assets.skins) bytes_.skins += bytes_of(skin->joints) + bytes_of(skin->inverse_bind);
  return *this;
}

MemoryCount& MemoryCount::add(const FrameBuffer& frame) {
  bytes_.frames += frame.owned_bytes();
  return *this;
}

}  // namespace sinew
