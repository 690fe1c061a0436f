// SPDX-License-Identifier: MIT
#include "runtime/pose/local_to_model.h"

#include <algorithm>
#include <cstring>
#include <iterator>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/pose/local_to_model.cpp"
#include <hwy/foreach_target.h>

#include "runtime/pose/simd/affine_lanes-inl.h"
#include "runtime/pose/simd/dispatch.h"
#include "runtime/pose/simd/transpose-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

/// The stride of a pose is a multiple of 16 joints, so that no vector reaches past its planes.
using Floats = hn::CappedTag<float, 16>;
using Lanes = hn::Vec<Floats>;

/// Joints are composed in chunks; one bit per joint of a chunk says whether to compose it.
constexpr std::size_t kChunk = 64;
using Chosen = std::uint64_t;

/// Local matrices of a chunk, in the order in which transposing within blocks leaves them.
struct LocalMatrices {
  HWY_ALIGN float rows[3][kChunk * 4];

  /// place(i + k) = place(i) + place(k) for i a multiple of 4 and k < 4; with 16 lanes, of 8 and k < 8 as well.
  static constexpr std::size_t place(std::size_t joint) {
    constexpr std::size_t kLanes = hn::MaxLanes(Floats());
    return kLanes < 4 ? 4 * joint : joint / kLanes * kLanes * 4 + joint % 4 * kLanes + joint % kLanes / 4 * 4;
  }
  RowsAt at(std::size_t place) const { return {rows[0] + place, rows[1] + place, rows[2] + place}; }
};

/// One row of every joint, from its components.
HWY_INLINE void store_row(Lanes x, Lanes y, Lanes z, Lanes w, float* row) {
  const Floats d;
#if HWY_TARGET == HWY_SCALAR
  hn::StoreInterleaved4(x, y, z, w, d, row);
#else
  const std::size_t lanes = hn::Lanes(d);
  const FourVectors<Lanes> joints = transpose_blocks(d, x, y, z, w);
  hn::Store(joints.x, d, row);
  hn::Store(joints.y, d, row + lanes);
  hn::Store(joints.z, d, row + 2 * lanes);
  hn::Store(joints.w, d, row + 3 * lanes);
#endif
}

/// eq   T * R * S as affine_from_transform, one joint per lane, in single multiplications and additions (N27, N28);
///      doubled factors give the same bits as doubled products
HWY_INLINE void store_matrices(const float* translations, std::size_t stride, float* x_row) {
  const Floats d;
  const auto plane = [&](std::size_t p) HWY_ATTR { return hn::LoadU(d, translations + p * stride); };
  using P = PoseSpan;
  const Lanes x = plane(P::rx), y = plane(P::ry), z = plane(P::rz), w = plane(P::rw);
  const Lanes x2 = hn::Add(x, x), y2 = hn::Add(y, y), z2 = hn::Add(z, z), one = hn::Set(d, 1.0f);
  const Lanes xx = hn::Mul(x, x2), yy = hn::Mul(y, y2), zz = hn::Mul(z, z2);
  const Lanes xy = hn::Mul(x, y2), xz = hn::Mul(x, z2), yz = hn::Mul(y, z2);
  const Lanes wx = hn::Mul(w, x2), wy = hn::Mul(w, y2), wz = hn::Mul(w, z2);
  const Lanes sx = plane(P::sx), sy = plane(P::sy), sz = plane(P::sz);
  store_row(hn::Mul(hn::Sub(one, hn::Add(yy, zz)), sx), hn::Mul(hn::Sub(xy, wz), sy), hn::Mul(hn::Add(xz, wy), sz),
            plane(P::tx), x_row);
  store_row(hn::Mul(hn::Add(xy, wz), sx), hn::Mul(hn::Sub(one, hn::Add(xx, zz)), sy), hn::Mul(hn::Sub(yz, wx), sz),
            plane(P::ty), x_row + 4 * kChunk);
  store_row(hn::Mul(hn::Sub(xz, wy), sx), hn::Mul(hn::Add(yz, wx), sy), hn::Mul(hn::Sub(one, hn::Add(xx, yy)), sz),
            plane(P::tz), x_row + 8 * kChunk);
}

/// Replaces T * R * S by the matrices that the file gives (G50). A row is written with one store, since it is loaded
/// back at once.
HWY_NOINLINE void use_fixed_matrices(const Skeleton& skeleton, std::size_t begin, LocalMatrices& locals) {
  const hn::RebindToUnsigned<Floats> whole;
  const std::uint32_t* fixed = skeleton.fixed_matrix_of.data() + begin;
  const std::size_t count = HWY_MIN(kChunk, skeleton.joint_count() - begin), lanes = hn::Lanes(whole);
  for (std::size_t first = 0; first < count; first += lanes) {
    const std::size_t end = HWY_MIN(first + lanes, count);
    if (end == first + lanes && hn::AllTrue(whole, hn::Eq(hn::LoadU(whole, fixed + first), hn::Set(whole, kNone))))
      continue;
    for (std::size_t i = first; i < end; ++i)
      for (int r = 0; r < 3 && fixed[i] != kNone; ++r)
        std::memcpy(locals.rows[r] + LocalMatrices::place(i), &skeleton.fixed_matrices[fixed[i]].row[r],
                    sizeof(glm::vec4));
  }
}

/// Local matrices of a chunk. Not inlined: within another function some of its vectors would be spilled.
HWY_NOINLINE void fill(const LocalToModelJob& job, std::size_t begin, Chosen chosen, LocalMatrices& locals) {
  const std::size_t lanes = hn::Lanes(Floats());
  const Chosen of_vector = (Chosen{2} << (lanes - 1)) - 1;
  const std::size_t stride = job.local.stride;  // copied: the stores might be to `job` for all that compilers know
  const float* translations = job.local.planes + begin;
  float* row = locals.rows[0];
  for (std::size_t i = 0; i < kChunk && chosen != 0; i += lanes, translations += lanes, row += 4 * lanes) {
    if (chosen & of_vector) store_matrices(translations, stride, row);
    chosen = chosen >> (lanes - 1) >> 1;
  }
  if (!job.skeleton->fixed_matrices.empty()) use_fixed_matrices(*job.skeleton, begin, locals);
}

#if HWY_TARGET == HWY_SCALAR || HWY_MAX_BYTES < 64

/// Composes joints chunk by chunk, parents first.
template <bool kSome>
class Composer {
 public:
  explicit Composer(const LocalToModelJob& job)
      : root_(job.root), model_(job.model.data()), parents_(job.skeleton->parents.data()) {}

  HWY_INLINE void compose(const LocalMatrices& locals, std::size_t begin, Chosen chosen) const {
    constexpr std::size_t kStep = HWY_MAX(4, hn::MaxLanes(Floats()));
    constexpr Chosen kAll = (Chosen{1} << kStep) - 1;
    const float* x_row = locals.rows[0];
    std::size_t joint = begin;
    for (; (chosen & kAll) == kAll; chosen >>= kStep, joint += kStep, x_row += 4 * kStep)
      compose_step<kStep, false>(x_row, joint, chosen);
    for (std::size_t i = 0; chosen != 0; i += 4, chosen >>= 4)
      compose_step<4, true>(x_row + LocalMatrices::place(i), joint + i, chosen);
  }

 private:
  template <std::size_t kStep, bool kTested>
  HWY_INLINE void compose_step(const float* x_row, std::size_t joint, Chosen chosen) const {
    HWY_UNROLL(8)
    for (std::size_t k = 0; k < kStep; ++k) {
      if (kTested && (chosen >> k & 1) == 0) continue;
      const float* x = x_row + LocalMatrices::place(k);
      const RowsAt local{x, x + 4 * kChunk, x + 8 * kChunk};
      const std::uint32_t parent = parents_[joint + k];
      if (HWY_UNLIKELY(parent == kNone))
        store_rows(product(root_, local), model_[joint + k]);
      else
        store_rows(product(model_[parent], local), model_[joint + k]);
    }
  }

  const Affine& root_;
  Affine* model_;
  const std::uint32_t* parents_;
};

#else

/// Composes joints chunk by chunk, parents first. The last eight matrices stay in registers and are selected by a
/// predicted jump: reloading the matrix of the parent from memory would take nearly as long as the product.
template <bool kSome>
class Composer {
 public:
  HWY_INLINE explicit Composer(const LocalToModelJob& job)
      : parents_(job.skeleton->parents.data()),
        model_(job.model.data()),
        root_(load_rows(job.root)),
        last_{root_, root_, root_, root_, root_, root_, root_, root_} {}  // the parent kNone is one step before joint 0

  HWY_INLINE void compose(const LocalMatrices& locals, std::size_t begin, Chosen chosen) {
    Chosen composed = (before_ & ~Chosen{0xff}) | (chosen & 0xff);
    before_ = chosen;
    for (std::size_t i = 0; i < kChunk && chosen >> i != 0; i += 8, composed = chosen)
      compose_eight(locals.at(LocalMatrices::place(i)), begin + i, static_cast<std::uint32_t>(chosen >> i), composed);
  }

 private:
  /// in   composed  bit j % kChunk of joint j, of these joints and of the eight before
  HWY_INLINE void compose_eight(const RowsAt& local, std::size_t joint, std::uint32_t chosen, Chosen composed) {
    const std::uint32_t* parents = parents_ + joint;
    Affine* model = model_ + joint;
    HWY_UNROLL(8)
    for (std::size_t k = 0; k < 8; ++k) {
      if ((chosen >> k & 1) == 0) continue;
      const float* x_row = local.x + LocalMatrices::place(k);
      const std::uint32_t parent = parents[k], steps = static_cast<std::uint32_t>(joint + k) - parent;
      const bool has_passed = !kSome || (composed >> parent % kChunk & 1) != 0;
      last_[k] = product(has_passed ? rows_before(k, steps, parent) : stored_rows(parent),
                         {x_row, x_row + 4 * kChunk, x_row + 8 * kChunk});
      store_rows(last_[k], model[k]);
    }
  }

  HWY_INLINE Rows rows_before(std::size_t k, std::uint32_t steps, std::uint32_t parent) const {
    switch (steps) {
      case 1: return last_[(k + 7) % 8];
      case 2: return last_[(k + 6) % 8];
      case 3: return last_[(k + 5) % 8];
      case 4: return last_[(k + 4) % 8];
      case 5: return last_[(k + 3) % 8];
      case 6: return last_[(k + 2) % 8];
      case 7: return last_[(k + 1) % 8];
      case 8: return last_[k];
      default: return stored_rows(parent);
    }
  }
  HWY_INLINE Rows stored_rows(std::uint32_t parent) const {
    return parent == kNone ? root_ : load_rows(model_[parent]);
  }

  const std::uint32_t* parents_;
  Affine* model_;
  Rows root_, last_[8];  // last_[j % 8] of joint j
  Chosen before_ = 0;    // what was chosen of the chunk before
};

#endif

/// Bits of the joints of `only` from `next` on and below `end`, all of one chunk; `next` moves past them.
Chosen chosen_joints(std::span<const std::uint32_t> only, std::size_t end, std::size_t& next) {
  const auto last = only.back() < end
                        ? only.end()
                        : std::lower_bound(only.begin() + static_cast<std::ptrdiff_t>(next), only.end(), end);
  Chosen chosen = 0;
  for (const auto passed = static_cast<std::size_t>(last - only.begin()); next < passed; ++next)
    chosen |= Chosen{1} << only[next] % kChunk;
  return chosen;
}

/// Local matrices are made one chunk ahead of the chains of joints, which wait for the products of their parents.
template <bool kSome>
HWY_NOINLINE void compose_joints(const LocalToModelJob& job) {
  LocalMatrices locals;
  Composer<kSome> composer(job);
  std::size_t next = 0;
  const std::size_t joints = kSome ? job.only.back() + std::size_t{1} : job.skeleton->joint_count();
  for (std::size_t begin = 0; begin < joints; begin += kChunk) {
    const std::size_t count = HWY_MIN(kChunk, joints - begin);
    const Chosen chosen = kSome ? chosen_joints(job.only, begin + count, next) : ~Chosen{0} >> (kChunk - count);
    fill(job, begin, chosen, locals);
    composer.compose(locals, begin, chosen);
  }
}

void model_matrices(const LocalToModelJob& job) {
  return job.only.empty() ? compose_joints<false>(job) : compose_joints<true>(job);
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
ErrorCode check(const LocalToModelJob& job) noexcept {
  if (!job.skeleton) return ErrorCode::size_mismatch;
  const std::size_t count = job.skeleton->joint_count();
  if (job.local.joint_count < count || job.model.size() < count) return ErrorCode::size_mismatch;
  if (!is_pose_of(job.local, job.local.joint_count) || !have_memory(job.model, job.only))
    return ErrorCode::size_mismatch;
  if (!job.only.empty() && job.only.back() >= count) return ErrorCode::index_out_of_range;
  const auto* pose_begin = reinterpret_cast<const std::byte*>(job.local.planes);
  const auto* pose_end = pose_begin + PoseSpan::plane_count * job.local.stride * sizeof(float);
  const auto out = std::as_bytes(job.model);
  if (out.data() < pose_end && pose_begin < out.data() + out.size()) return ErrorCode::overlapping_buffers;
  return ErrorCode::ok;
}

SINEW_DISPATCH_RUN(LocalToModelJob, model_matrices)

}  // namespace sinew
#endif  // HWY_ONCE
