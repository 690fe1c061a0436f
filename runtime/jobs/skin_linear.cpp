// SPDX-License-Identifier: MIT
#include "runtime/jobs/skin_linear.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/jobs/skin_linear.cpp"
#include <hwy/foreach_target.h>

#include "runtime/jobs/blend_columns-inl.h"
#include "runtime/jobs/blend_matrix.h"
#include "runtime/jobs/vertex_checks.h"
#include "runtime/math/normal_transform.h"

#ifndef SINEW_SKIN_LINEAR_ONCE
#define SINEW_SKIN_LINEAR_ONCE
namespace sinew {
namespace {

/// The normal of one vertex where squares leave float's range, or the blend has none.
template <int kCount>
glm::vec3 careful_normal(std::span<const JointMatrix> palette, const VertexJoints<kCount>& vertex, const glm::vec3& n, bool cofactor) noexcept {
  const Affine m = blend_matrix(palette, vertex);
  return cofactor ? transform_normal_outward(linear_part(m), n) : normalised_or(transform_vector(m, n), n);
}

}  // namespace
}  // namespace sinew
#endif

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR

template <int kCount, bool kNormals, bool kTangents>
void skin_group(const SkinLinearJob& job, const InfluenceGroup& group) {
  for (std::size_t i = 0; i < group.vertex_count; ++i) {
    const std::size_t v = group.first_vertex + i;
    const auto joints = joints_of<kCount>(*job.influences, group, i);
    const glm::vec3 p = transform_point(blend_matrix(job.palette, joints), job.vertices.positions[v]);
    if constexpr (kNormals)
      job.out.normals[v] = careful_normal(job.palette, joints, job.vertices.normals[v], job.normal_rule == NormalRule::cofactor);
    if constexpr (kTangents) {
      const glm::vec4 t = job.vertices.tangents[v];
      job.out.tangents[v] = glm::vec4(careful_normal(job.palette, joints, glm::vec3(t), false), t.w);
    }
    job.out.positions[v] = p;
  }
}

#else

template <int kCount, bool kNormals, bool kTangents>
struct SkinTile {
  const SkinLinearJob& job;
  const TileInfluences<kCount>& joints;

  HWY_INLINE void run(const TileInput& in, const TileOutput& out) const {
    const bool cofactor_rule = kNormals && job.normal_rule == NormalRule::cofactor;
    Wide positions[4], normals[4], tangents[4];
    for_each_quarter([&](auto q) HWY_ATTR {
      constexpr std::size_t at = q * kBlocks;
      const Columns m = blend_columns(job.palette.data(), joints, q);
      positions[q] = transform_points(m, load_spread(in.positions + at));
      if constexpr (kNormals) normals[q] = moved_normals(m, load_spread(in.normals + at), cofactor_rule);
      if constexpr (kTangents) tangents[q] = transform_vectors(m, spread(hn::LoadU(TileTag(), &in.tangents[at].x)));
    });
    if constexpr (kNormals) write_normals(normals, cofactor_rule, in, out);
    if constexpr (kTangents) write_tangents(tangents, in, out);
    store_packed(positions, out.positions);
  }

 private:
  HWY_INLINE void write_normals(Wide (&normals)[4], bool cofactor_rule, const TileInput& in, const TileOutput& out) const {
    normalise_tile(
        normals, [&]() HWY_ATTR { store_packed(normals, out.normals); },
        [&](std::size_t v) { out.normals[v] = careful_normal(job.palette, joints.at(v), in.normals[v], cofactor_rule); });
  }

  HWY_INLINE void write_tangents(Wide (&tangents)[4], const TileInput& in, const TileOutput& out) const {
    const TileTag d;
    static constexpr LaneTable kHandedness([](std::size_t i) { return i % 4 == 3 ? -1 : 0; });
    const auto handedness = hn::MaskFromVec(hn::BitCast(d, hn::Load(hn::RebindToSigned<TileTag>(), kHandedness.lanes)));
    const auto store = [&]() HWY_ATTR {
      for_each_quarter([&](auto q) HWY_ATTR {
        const Wide source = hn::LoadU(d, &in.tangents[q * kBlocks].x);
        hn::StoreU(hn::IfThenElse(handedness, source, tangents[q]), d, &out.tangents[q * kBlocks].x);
      });
    };
    normalise_tile(tangents, store, [&](std::size_t v) {
      const glm::vec4 tangent = in.tangents[v];
      out.tangents[v] = glm::vec4(careful_normal(job.palette, joints.at(v), glm::vec3(tangent), false), tangent.w);
    });
  }
};

template <int kCount, bool kNormals, bool kTangents>
void skin_group(const SkinLinearJob& job, const InfluenceGroup& group) {
  for_each_tile<kCount, kNormals, kTangents>(
      *job.influences, group, job.vertices, job.out, [&](const TilePlace&, const TileInfluences<kCount>& joints, const TileInput& in, const TileOutput& out)
                                                         HWY_ATTR { SkinTile<kCount, kNormals, kTangents>{job, joints}.run(in, out); });
}

#endif  // HWY_TARGET

void skin_linear(const SkinLinearJob& job) {
  for_each_group(*job.influences, present(job.vertices, job.out), [&](const InfluenceGroup& group, auto count, auto normals, auto tangents) {
    skin_group<count, normals, tangents>(job, group);
  });
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {
HWY_EXPORT(skin_linear);
}  // namespace

ErrorCode check(const SkinLinearJob& job) noexcept {
  return check_skinning(job.influences, job.vertices, job.out, job.palette.size());
}

void run(const SkinLinearJob& job) noexcept { HWY_DYNAMIC_DISPATCH(skin_linear)(job); }

}  // namespace sinew
#endif
