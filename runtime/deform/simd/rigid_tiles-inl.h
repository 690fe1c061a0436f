// SPDX-License-Identifier: MIT
// Skinning by rigid motions in tiles (vertex_tiles.h): the parts that dual quaternions and centers of rotation share.
#if defined(SINEW_RIGID_TILES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_RIGID_TILES_INL_H_
#undef SINEW_RIGID_TILES_INL_H_
#else
#define SINEW_RIGID_TILES_INL_H_
#endif

#include <algorithm>

#include "runtime/deform/simd/spread_motions-inl.h"
#include "runtime/deform/simd/tile_runs-inl.h"
#include "runtime/deform/simd/widened_influences-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// True if tiles may skin the vertices of a job: no joint stretches, and the tiles have all attributes.
template <class Job>
bool may_use_tiles(const Job& job, AttributesPresent wanted) {
  return job.tiles != nullptr && !job.any_stretch && (!wanted.normals || !job.tiles->normals.empty()) &&
         (!wanted.tangents || !job.tiles->tangents.empty());
}

/// Rotates the normals and tangents of one vector. Returns the lanes whose directions keep their digits. Directions are
/// normalised first, so that the square root does not wait for the blend.
HWY_INLINE hn::Mask<TileTag> rotate_directions(const DualQuatLanes& motion, AttributesPresent wanted,
                                               const TileInputs& tile, std::size_t lane, const LaneOutputs& out) {
  auto sound = motion.sound;
  if (wanted.normals) {
    Lanes3 n = load_planes3(tile.normals, lane);
    sound = hn::And(sound, normalise(n));
    pack(rotate(motion, n), out.normals);
  }
  if (wanted.tangents) {
    Lanes3 t = load_planes3(tile.tangents, lane);
    sound = hn::And(sound, normalise(t));
    t = rotate(motion, t);
    pack(Lanes4{t.x, t.y, t.z, load_plane(tile.tangents[3], lane)}, out.tangents);
  }
  return sound;
}

/// The influences of vertex `v` of all groups.
inline VertexJoints<0> influences_of(const InfluenceStreams& influences, std::size_t v, WidenedInfluences& widened) {
  const auto holds = [&](const InfluenceGroup& group) {
    return v < group.first_vertex + std::size_t{group.vertex_count};
  };
  const InfluenceGroup& group = *std::find_if(influences.groups.begin(), influences.groups.end(), holds);
  const std::size_t count = group.influence_count;
  return widened.of(influences, group.first_influence + (v - group.first_vertex) * count, 1, count);
}

/// Pointers to a job's arrays, for the scalar path.
template <class Job>
TileInput inputs_of(const Job& job) {
  return {job.vertices.positions.data(), job.vertices.normals.data(), job.vertices.tangents.data()};
}
template <class Job>
TileOutput outputs_of(const Job& job, AttributesPresent wanted) {
  return {job.out.positions.data(), wanted.normals ? job.out.normals.data() : nullptr,
          wanted.tangents ? job.out.tangents.data() : nullptr};
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
