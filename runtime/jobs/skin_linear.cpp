// SPDX-License-Identifier: MIT
#include "runtime/jobs/skin_linear.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/jobs/skin_linear.cpp"
#include <hwy/foreach_target.h>

#include "runtime/jobs/blend_columns-inl.h"
#include "runtime/jobs/blend_matrix.h"
#include "runtime/jobs/one_matrix-inl.h"
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

template <int kCount, bool kNormals, bool kTangents>
struct SkinTile {
  const SkinLinearJob& job;
  const TileInfluences<kCount>& joints;

#if HWY_TARGET == HWY_SCALAR

  void run(const TileInput& in, const TileOutput& out) const {
    const OneMatrix m = blend_one_matrix(job.palette.data(), joints);
    store3(transform_points(m, load3(in.positions)), out.positions);
    if constexpr (kNormals) {
      Lanes3 n = moved_normals(m, load3(in.normals), cofactor_rule());
      const auto sound = normalise(n);
      store3(n, out.normals);
      for_each_lane_not_in(sound, [&](std::size_t v) { write_careful_normal(in, out, v); });
    }
    if constexpr (kTangents) {
      const Lanes4 tangent = load4(in.tangents);
      Lanes3 t = transform_vectors(m, {tangent.x, tangent.y, tangent.z});
      const auto sound = normalise(t);
      store4({t.x, t.y, t.z, tangent.w}, out.tangents);
      for_each_lane_not_in(sound, [&](std::size_t v) { write_careful_tangent(in, out, v); });
    }
  }

#else

  HWY_INLINE void run(const TileInput& in, const TileOutput& out) const {
    Wide positions[4], normals[4], tangents[4];
    for_each_quarter([&](auto q) HWY_ATTR {
      constexpr std::size_t at = q * kBlocks;
      const Columns m = blend_columns(job.palette.data(), joints, q);
      positions[q] = transform_points(m, load_spread(in.positions + at));
      if constexpr (kNormals) normals[q] = moved_normals(m, load_spread(in.normals + at), cofactor_rule());
      if constexpr (kTangents) tangents[q] = transform_vectors(m, spread(hn::LoadU(TileTag(), &in.tangents[at].x)));
    });
    if constexpr (kNormals) write_normals(normals, in, out);
    if constexpr (kTangents) write_tangents(tangents, in, out);
    store_packed(positions, out.positions);
  }

#endif

 private:
  bool cofactor_rule() const { return job.normal_rule == NormalRule::cofactor; }

  void write_careful_normal(const TileInput& in, const TileOutput& out, std::size_t v) const {
    out.normals[v] = careful_normal(job.palette, joints.at(v), in.normals[v], cofactor_rule());
  }
  void write_careful_tangent(const TileInput& in, const TileOutput& out, std::size_t v) const {
    const glm::vec4 tangent = in.tangents[v];
    out.tangents[v] = glm::vec4(careful_normal(job.palette, joints.at(v), glm::vec3(tangent), false), tangent.w);
  }

#if HWY_TARGET != HWY_SCALAR

  HWY_INLINE void write_normals(Wide (&normals)[4], const TileInput& in, const TileOutput& out) const {
    normalise_tile(normals, [&]() HWY_ATTR { store_packed(normals, out.normals); }, [&](std::size_t v) { write_careful_normal(in, out, v); });
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
    normalise_tile(tangents, store, [&](std::size_t v) { write_careful_tangent(in, out, v); });
  }

#endif
};

void skin_linear(const SkinLinearJob& job) {
  with_attributes(present(job.vertices, job.out), [&](auto normals, auto tangents) {
    for_each_group(job.influences, [&](const InfluenceGroup& group, auto count) {
      for_each_tile<count>(job.influences, group, job.vertices, job.out,
                           [&](const TilePlace&, const TileInfluences<count>& joints, const TileInput& in, const TileOutput& out)
                               HWY_ATTR { SkinTile<count, normals, tangents>{job, joints}.run(in, out); });
    });
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
