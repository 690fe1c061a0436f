// SPDX-License-Identifier: MIT
#include "runtime/geometry_cache/block_motion.h"

#include <algorithm>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/geometry_cache/block_motion.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "runtime/pose/simd/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

using Ints = hn::CappedTag<std::int32_t, 16>;
using IntLanes = hn::Vec<Ints>;
using Floats = hn::CappedTag<float, 16>;

constexpr std::size_t kLanes = hn::MaxLanes(Ints());

/// Unpacks eight residuals of `width` bits, which take `width` bytes.
HWY_INLINE void unpack_wide(const std::uint8_t* from, unsigned width, std::int32_t* out) {
  const std::uint64_t mask = (std::uint64_t{1} << width) - 1;
  for (unsigned i = 0; i < 8; ++i) {
    std::uint64_t bits;
    std::memcpy(&bits, from + i * width / 8, sizeof(bits));
    out[i] = unzigzag(static_cast<std::uint32_t>(bits >> (i * width % 8) & mask));
  }
}

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE void unpack(const std::uint8_t* from, unsigned width, std::int32_t* out) {
  for (std::size_t first = 0; first < kBlockPoints; first += 8, from += width) unpack_wide(from, width, out + first);
}

#else

/// Positions of eight values of up to 16 bits in 16 bytes: for each lane the four bytes to load and the bits to drop.
struct UnpackTable {
  alignas(32) std::uint8_t bytes[32];
  alignas(32) std::uint32_t drop[8];
};
constexpr unsigned kTableWidths = 16;
using UnpackTables = std::array<UnpackTable, kTableWidths + 1>;

constexpr UnpackTables make_tables() {
  UnpackTables tables{};
  for (unsigned width = 0; width <= kTableWidths; ++width)
    for (unsigned i = 0; i < 8; ++i) {
      tables[width].drop[i] = i * width % 8;
      for (unsigned b = 0; b < 4; ++b)  // bits of later bytes are masked off afterwards
        tables[width].bytes[4 * i + b] = static_cast<std::uint8_t>(std::min(i * width / 8 + b, 15u));
    }
  return tables;
}
constexpr UnpackTables kTables = make_tables();

/// Unpacks 64 residuals.
HWY_INLINE void unpack(const std::uint8_t* from, unsigned width, std::int32_t* out) {
  if (HWY_UNLIKELY(width > kTableWidths)) {
    for (std::size_t first = 0; first < kBlockPoints; first += 8, from += width) unpack_wide(from, width, out + first);
    return;
  }
  const hn::CappedTag<std::uint32_t, 8> d;
  const hn::Repartition<std::uint8_t, decltype(d)> bytes;
  const hn::RebindToSigned<decltype(d)> ints;
  constexpr std::size_t kStep = hn::MaxLanes(hn::CappedTag<std::uint32_t, 8>());
  const auto mask = hn::Set(d, (1u << width) - 1), one = hn::Set(d, 1u);
  const UnpackTable& table = kTables[width];
  for (std::size_t first = 0; first < kBlockPoints; first += 8, from += width) {
    const auto packed = hn::LoadDup128(bytes, from);
    for (std::size_t i = 0; i < 8; i += kStep) {
      const auto words = hn::BitCast(d, hn::TableLookupBytes(packed, hn::Load(bytes, table.bytes + 4 * i)));
      const auto turned = hn::And(hn::Shr(words, hn::Load(d, table.drop + i)), mask);
      const auto sign = hn::Sub(hn::Zero(d), hn::And(turned, one));
      hn::Store(hn::BitCast(ints, hn::Xor(hn::ShiftRight<1>(turned), sign)), ints, out + first + i);
    }
  }
}

#endif  // HWY_TARGET

/// eq   r[i] = residual[i] + r[a] + r[b] - r[c], for x, y and z of a point at once
HWY_INLINE void spread(const std::uint8_t* corners, std::int32_t* residuals) {
#if HWY_TARGET == HWY_SCALAR
  for (std::size_t axis = 0; axis < 3; ++axis, residuals += kBlockPoints) {
    std::uint32_t r[kBlockPoints + 1];
    r[kNoCorner] = 0;
    for (std::size_t i = 0; i < kBlockPoints; ++i) {
      const std::uint8_t* at = corners + 3 * i;
      r[i] = static_cast<std::uint32_t>(residuals[i]) + r[at[0]] + r[at[1]] - r[at[2]];
      residuals[i] = static_cast<std::int32_t>(r[i]);
    }
  }
#else
  const hn::FixedTag<std::int32_t, 4> d;
  alignas(16) std::int32_t r[4 * (kBlockPoints + 1)];
  hn::Store(hn::Zero(d), d, r + 4 * std::size_t{kNoCorner});
  for (std::size_t i = 0; i < kBlockPoints; i += 4)
    hn::StoreInterleaved4(hn::Load(d, residuals + i), hn::Load(d, residuals + kBlockPoints + i),
                          hn::Load(d, residuals + 2 * kBlockPoints + i), hn::Zero(d), d, r + 4 * i);
  for (std::size_t i = 0; i < kBlockPoints; ++i) {
    const auto from = [&](std::size_t k) { return hn::Load(d, r + 4 * std::size_t{corners[3 * i + k]}); };
    hn::Store(hn::Add(hn::Load(d, r + 4 * i), hn::Add(from(0), hn::Sub(from(1), from(2)))), d, r + 4 * i);
  }
  for (std::size_t i = 0; i < kBlockPoints; i += 4) {
    hn::Vec<decltype(d)> x, y, z, none;
    hn::LoadInterleaved4(d, r + 4 * i, x, y, z, none);
    hn::Store(x, d, residuals + i);
    hn::Store(y, d, residuals + kBlockPoints + i);
    hn::Store(z, d, residuals + 2 * kBlockPoints + i);
  }
#endif
}

/// Key frame: only offset and residuals.
HWY_INLINE void move_in_space(const BlockMotion& motion, const std::int32_t* residuals, std::int32_t* x) {
  const Ints d;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const IntLanes offset = hn::Set(d, motion.offset[axis]);
    for (std::size_t i = axis * kBlockPoints; i < (axis + 1) * kBlockPoints; i += kLanes)
      hn::StoreU(hn::Add(offset, hn::Load(d, residuals + i)), d, x + i);
  }
}

/// The prediction for one axis.
template <BlockBase kBase>
HWY_INLINE IntLanes base_of(IntLanes x1, const std::int32_t* x2) {
  if constexpr (kBase == BlockBase::last) return x1;
  const IntLanes moved = hn::Sub(x1, hn::LoadU(Ints(), x2));
  return hn::Add(x1, kBase == BlockBase::linear ? moved : hn::ShiftRight<1>(moved));
}

/// eq   (M (x1 - first) + 2^(shift-1)) >> shift
struct Turn {
  IntLanes matrix[9], first[3], half;
  int shift;

  HWY_INLINE Turn(const BlockMotion& motion, const std::int32_t* x1) : shift(motion.shift) {
    const Ints d;
    for (std::size_t k = 0; k < 9; ++k) matrix[k] = hn::Set(d, std::int32_t{motion.matrix[k]});
    for (std::size_t axis = 0; axis < 3; ++axis) first[axis] = hn::Set(d, x1[axis * kBlockPoints]);
    half = hn::Set(d, motion.shift > 0 ? std::int32_t{1} << (motion.shift - 1) : 0);
  }

  HWY_INLINE void add_to(const IntLanes (&x1)[3], IntLanes (&x)[3]) const {
    const IntLanes a = hn::Sub(x1[0], first[0]), b = hn::Sub(x1[1], first[1]), c = hn::Sub(x1[2], first[2]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const IntLanes sum = hn::Add(hn::Add(hn::Mul(matrix[axis], a), hn::Mul(matrix[3 + axis], b)),
                                   hn::Add(hn::Mul(matrix[6 + axis], c), half));
      x[axis] = hn::Add(x[axis], hn::ShiftRightSame(sum, shift));
    }
  }
};

template <BlockBase kBase, bool kTurns>
HWY_INLINE void move_in_time(const BlockMotion& motion, const std::int32_t* residuals, const std::int32_t* x1,
                             const std::int32_t* x2, std::int32_t* x) {
  const Ints d;
  const Turn turn(motion, x1);
  IntLanes offset[3];
  for (std::size_t axis = 0; axis < 3; ++axis) offset[axis] = hn::Set(d, motion.offset[axis]);
  for (std::size_t i = 0; i < kBlockPoints; i += kLanes) {
    IntLanes before[3], now[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t at = axis * kBlockPoints + i;
      before[axis] = hn::LoadU(d, x1 + at);
      now[axis] = hn::Add(base_of<kBase>(before[axis], x2 + at), hn::Add(offset[axis], hn::Load(d, residuals + at)));
    }
    if constexpr (kTurns) turn.add_to(before, now);
    for (std::size_t axis = 0; axis < 3; ++axis) hn::StoreU(now[axis], d, x + axis * kBlockPoints + i);
  }
}

template <BlockBase kBase>
HWY_INLINE void move_in_time(const BlockMotion& motion, const std::int32_t* residuals, const std::int32_t* x1,
                             const std::int32_t* x2, std::int32_t* x) {
  if (motion.turns)
    move_in_time<kBase, true>(motion, residuals, x1, x2, x);
  else
    move_in_time<kBase, false>(motion, residuals, x1, x2, x);
}

void move_blocks(const MoveBlocksJob& job) {
  const std::uint8_t* from = job.payload.data();
  alignas(64) std::int32_t residuals[kBlockNumbers];
  for (std::size_t b = 0; b < job.blocks.size(); ++b) {
    const BlockMotion& motion = job.blocks[b];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      unpack(from, motion.width[axis], residuals + axis * kBlockPoints);
      from += std::size_t{8} * motion.width[axis];
    }
    const std::size_t at = b * kBlockNumbers;
    if (motion.spreads || motion.base == BlockBase::space) spread(job.corners.data() + at, residuals);
    const std::int32_t *x1 = job.x1.data() + at, *x2 = job.x2.data() + at;
    std::int32_t* x = job.x.data() + at;
    switch (motion.base) {
      case BlockBase::space: move_in_space(motion, residuals, x); break;
      case BlockBase::last: move_in_time<BlockBase::last>(motion, residuals, x1, x2, x); break;
      case BlockBase::linear: move_in_time<BlockBase::linear>(motion, residuals, x1, x2, x); break;
      case BlockBase::slower: move_in_time<BlockBase::slower>(motion, residuals, x1, x2, x); break;
    }
  }
}

HWY_INLINE hn::Vec<Floats> metres(const std::int32_t* numbers, hn::Vec<Floats> scale) {
  return hn::Mul(hn::ConvertTo(Floats(), hn::LoadU(Ints(), numbers)), scale);
}

/// Converts the points of one block.
HWY_INLINE void emit_block(const EmitPointsJob& job, std::size_t block, glm::vec3* out) {
  const Floats d;
  const auto step = hn::Set(d, job.step), part = hn::Set(d, job.part), rest = hn::Set(d, 1.0f - job.part);
  for (std::size_t i = 0; i < kBlockPoints; i += kLanes) {
    hn::Vec<Floats> p[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t at = block * kBlockNumbers + axis * kBlockPoints + i;
      p[axis] = metres(job.to.data() + at, step);
      if (job.part != 1.0f)
        p[axis] = hn::Add(hn::Mul(metres(job.from.data() + at, step), rest), hn::Mul(p[axis], part));
    }
    hn::StoreInterleaved3(p[0], p[1], p[2], d, &out[i].x);
  }
}

void emit_points(const EmitPointsJob& job) {
  const std::size_t whole = job.out.size() / kBlockPoints, left = job.out.size() % kBlockPoints;
  for (std::size_t b = 0; b < whole; ++b) emit_block(job, b, job.out.data() + b * kBlockPoints);
  if (left == 0) return;
  glm::vec3 last[kBlockPoints];
  emit_block(job, whole, last);
  std::copy(last, last + left, job.out.data() + whole * kBlockPoints);
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {

ErrorCode check(const MoveBlocksJob& job) noexcept {
  const std::size_t numbers = job.blocks.size() * kBlockNumbers;
  if (job.x1.size() != numbers || job.x2.size() != numbers || job.x.size() != numbers || job.corners.size() != numbers)
    return ErrorCode::size_mismatch;
  if (!have_memory(job.blocks, job.payload, job.corners, job.x1, job.x2, job.x)) return ErrorCode::size_mismatch;
  std::size_t bytes = kPayloadPadding;
  for (const BlockMotion& block : job.blocks)
    for (const std::uint8_t width : block.width) {
      if (width > kMaxWidth) return ErrorCode::index_out_of_range;
      bytes += kBlockPoints / 8 * std::size_t{width};
    }
  return job.payload.size() < bytes ? ErrorCode::size_mismatch : ErrorCode::ok;
}

ErrorCode check(const EmitPointsJob& job) noexcept {
  const std::size_t blocks = job.from.size() / kBlockNumbers;
  const bool whole = job.from.size() == blocks * kBlockNumbers && job.to.size() == job.from.size();
  const bool fits = whole && job.out.size() <= blocks * kBlockPoints && have_memory(job.from, job.to, job.out);
  return fits ? ErrorCode::ok : ErrorCode::size_mismatch;
}

SINEW_DISPATCH_RUN(MoveBlocksJob, move_blocks)
SINEW_DISPATCH_RUN(EmitPointsJob, emit_points)

}  // namespace sinew
#endif  // HWY_ONCE
