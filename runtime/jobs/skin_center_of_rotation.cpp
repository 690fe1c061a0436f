// SPDX-License-Identifier: MIT
#include "runtime/jobs/skin_center_of_rotation.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/jobs/skin_center_of_rotation.cpp"
#include <hwy/foreach_target.h>

#include "runtime/jobs/blend_columns-inl.h"
#include "runtime/jobs/blend_matrix.h"
#include "runtime/jobs/blend_motion.h"
#include "runtime/jobs/blend_motion_lanes-inl.h"
#include "runtime/jobs/vertex_checks.h"

#ifndef SINEW_SKIN_CENTER_OF_ROTATION_ONCE
#define SINEW_SKIN_CENTER_OF_ROTATION_ONCE
namespace sinew {
namespace {

/// One vertex, with every degenerate case: the only way of the scalar target, and the way out of the lanes.
template <int kCount, bool kStretch, bool kNormals, bool kTangents, class In, class Out>
void skin_vertex(const SkinCenterOfRotationJob& job, const VertexJoints<kCount>& joints, const glm::vec3& center, const In& in, const Out& out,
                 std::size_t v) noexcept {
  const Quat<float> rotation = blend_motion(job.split, joints).real;
  const glm::vec3 moved_center = transform_point(blend_matrix(job.palette, joints), center);
  glm::vec3 arm = in.positions[v] - center;
  Mat3<float> stretch(1.0f);
  if constexpr (kStretch) stretch = blend_stretch(job.split, joints), arm = stretch * arm;
  if constexpr (kNormals) {
    glm::vec3 n = in.normals[v];
    if constexpr (kStretch) n = transform_normal_outward(stretch, n);
    out.normals[v] = normalised_or(rotate_vector(rotation, n), n);
  }
  if constexpr (kTangents) {
    const glm::vec4 tangent = in.tangents[v];
    glm::vec3 t(tangent);
    if constexpr (kStretch) t = stretch * t;
    out.tangents[v] = glm::vec4(normalised_or(rotate_vector(rotation, t), glm::vec3(tangent)), tangent.w);
  }
  out.positions[v] = rotate_vector(rotation, arm) + moved_center;
}

}  // namespace
}  // namespace sinew
#endif

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR

template <int kCount, bool kStretch, bool kNormals, bool kTangents>
void skin_group(const SkinCenterOfRotationJob& job, const InfluenceGroup& group) {
  for (std::size_t i = 0; i < group.vertex_count; ++i) {
    const std::size_t v = group.first_vertex + i;
    skin_vertex<kCount, kStretch, kNormals, kTangents>(job, joints_of<kCount>(*job.influences, group, i), job.centers[v], job.vertices, job.out, v);
  }
}

#else

/// eq   M c of a tile, M the blended matrices
template <int kCount>
HWY_INLINE Lanes3 moved_centers(const JointMatrix* palette, const TileInfluences<kCount>& joints, const glm::vec3* centers) {
  Wide quarters[4];
  for_each_quarter([&](auto q) HWY_ATTR { quarters[q] = transform_points(blend_columns(palette, joints, q), load_spread(centers + q * kBlocks)); });
  HWY_ALIGN float packed[3 * kTileSize];
  glm::vec3* moved = reinterpret_cast<glm::vec3*>(packed);
  store_packed(quarters, moved);
  return load3(moved);
}

/// Skins a tile. Vertices whose blend cancels, or whose directions leave float's range, are done again the careful way.
template <int kCount, bool kStretch, bool kNormals, bool kTangents>
HWY_INLINE void skin_tile(const SkinCenterOfRotationJob& job, const glm::vec3* centers, const TileInfluences<kCount>& joints, const TileInput& in,
                          const TileOutput& out) {
  const MotionLanes motion = blend_motions(job.split.data(), joints, false);
  const Lanes3 moved = moved_centers(job.palette.data(), joints, centers);
  StretchLanes stretch{};
  if constexpr (kStretch) stretch = blend_stretches(job.split.data(), joints);
  auto sound = motion.sound;
  Lanes3 arm = minus(load3(in.positions), load3(centers));
  if constexpr (kStretch) arm = apply(stretch, arm);
  if constexpr (kNormals) {
    Lanes3 n = load3(in.normals);
    if constexpr (kStretch) n = apply_to_normal(stretch, n);
    n = rotate(motion.real, n);
    sound = hn::And(sound, normalise(n));
    store3(n, out.normals);
  }
  if constexpr (kTangents) {
    const Lanes4 tangent = load4(in.tangents);
    Lanes3 t{tangent.x, tangent.y, tangent.z};
    if constexpr (kStretch) t = apply(stretch, t);
    t = rotate(motion.real, t);
    sound = hn::And(sound, normalise(t));
    store4({t.x, t.y, t.z, tangent.w}, out.tangents);
  }
  store3(plus(rotate(motion.real, arm), moved), out.positions);
  for_each_lane_not_in(sound, [&](std::size_t v) { skin_vertex<kCount, kStretch, kNormals, kTangents>(job, joints.at(v), centers[v], in, out, v); });
}

/// The centers of a tile that is not full, filled up as its vertices are.
struct CenterCopies {
  glm::vec3 centers[kTileSize + 2];

  const glm::vec3* load(const glm::vec3* from, std::size_t count) {
    for (std::size_t k = 0; k < kTileSize + 2; ++k) centers[k] = from[std::min(k, count - 1)];
    return centers;
  }
};

template <int kCount, bool kStretch, bool kNormals, bool kTangents>
void skin_group(const SkinCenterOfRotationJob& job, const InfluenceGroup& group) {
  CenterCopies copies;
  for_each_tile<kCount, kNormals, kTangents>(
      *job.influences, group, job.vertices, job.out,
      [&](const TilePlace& place, const TileInfluences<kCount>& joints, const TileInput& in, const TileOutput& out) HWY_ATTR {
        const glm::vec3* centers = job.centers.data() + place.first_vertex;
        if (HWY_UNLIKELY(!place.whole)) centers = copies.load(centers, place.count);
        skin_tile<kCount, kStretch, kNormals, kTangents>(job, centers, joints, in, out);
      });
}

#endif  // HWY_TARGET

void skin_center_of_rotation(const SkinCenterOfRotationJob& job) {
  for_each_group(*job.influences, present(job.vertices, job.out), [&](const InfluenceGroup& group, auto count, auto normals, auto tangents) {
    if (job.any_stretch) skin_group<count, true, normals, tangents>(job, group);
    else skin_group<count, false, normals, tangents>(job, group);
  });
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {
HWY_EXPORT(skin_center_of_rotation);
}  // namespace

ErrorCode check(const SkinCenterOfRotationJob& job) noexcept {
  const std::size_t count = job.vertices.positions.size();
  if (job.centers.size() != count || job.palette.size() != job.split.size()) return ErrorCode::size_mismatch;
  return check_skinning(job.influences, job.vertices, job.out, job.palette.size());
}

void run(const SkinCenterOfRotationJob& job) noexcept { HWY_DYNAMIC_DISPATCH(skin_center_of_rotation)(job); }

}  // namespace sinew
#endif
