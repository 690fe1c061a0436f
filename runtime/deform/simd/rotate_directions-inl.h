// SPDX-License-Identifier: MIT
// Stretches and rotates normals and tangents of a tile. Shared by dual-quaternion and center-of-rotation skinning.
#if defined(SINEW_ROTATE_DIRECTIONS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_ROTATE_DIRECTIONS_INL_H_
#undef SINEW_ROTATE_DIRECTIONS_INL_H_
#else
#define SINEW_ROTATE_DIRECTIONS_INL_H_
#endif

#include "runtime/deform/simd/blend_dual_quaternions-inl.h"
#include "runtime/deform/simd/blend_stretch_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Writes the attributes that `out` has room for. Returns the lanes whose directions keep their digits. All other lanes
/// need the scalar path (scalar_blend.h). Directions are normalised before they are rotated, so that the square root
/// does not wait for the blend.
template <bool kStretch>
HWY_INLINE hn::Mask<TileTag> rotate_directions(const DualQuatLanes& motion, const StretchLanes& stretch,
                                               const TileInput& in, const TileOutput& out) {
  auto sound = motion.sound;
  if (out.normals) {
    Lanes3 n = load3(in.normals);
    if constexpr (kStretch) n = apply_to_normal(stretch, n, sound);
    sound = hn::And(sound, normalise(n));
    store3(rotate(motion, n), out.normals);
  }
  if (out.tangents) {
    const Lanes4 tangent = load4(in.tangents);
    Lanes3 t{tangent.x, tangent.y, tangent.z};
    if constexpr (kStretch) t = apply(stretch, t);
    sound = hn::And(sound, normalise(t));
    t = rotate(motion, t);
    store4({t.x, t.y, t.z, tangent.w}, out.tangents);
  }
  return sound;
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
