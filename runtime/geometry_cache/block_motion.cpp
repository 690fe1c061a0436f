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

/// Unpacks eight residuals of `width` bits, which take `width` bytes. `uppers` may be null.
HWY_INLINE void unpack_wide(const std::uint8_t* from, unsigned width, const std::uint8_t* uppers, std::int32_t* out) {
  const std::uint64_t mask = (std::uint64_t{1} << width) - 1;
  for (unsigned i = 0; i < 8; ++i) {
    std::uint64_t bits;
    std::memcpy(&bits, from + i * width / 8, sizeof(bits));
    const std::uint64_t upper = uppers == nullptr ? 0 : std::uint64_t{uppers[i]} << width;
    out[i] = unzigzag(static_cast<std::uint32_t>((bits >> (i * width % 8) & mask) | upper));
  }
}

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE void unpack(const std::uint8_t* from, unsigned width, const std::uint8_t* uppers, std::int32_t* out) {
  for (std::size_t first = 0; first < kBlockPoints; first += 8, from += width)
    unpack_wide(from, width, uppers == nullptr ? nullptr : uppers + first, out + first);
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

/// Unpacks 64 residuals of up to 16 packed bits.
template <bool kCoded>
HWY_INLINE void unpack_narrow(const std::uint8_t* from, unsigned width, [[maybe_unused]] const std::uint8_t* uppers,
                              std::int32_t* out) {
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
      auto turned = hn::And(hn::Shr(words, hn::Load(d, table.drop + i)), mask);
      if constexpr (kCoded) {
        const hn::Rebind<std::uint8_t, decltype(d)> few;
        const auto upper = hn::PromoteTo(d, hn::LoadU(few, uppers + first + i));
        turned = hn::Or(turned, hn::ShiftLeftSame(upper, static_cast<int>(width)));
      }
      const auto sign = hn::Sub(hn::Zero(d), hn::And(turned, one));
      hn::Store(hn::BitCast(ints, hn::Xor(hn::ShiftRight<1>(turned), sign)), ints, out + first + i);
    }
  }
}

/// Unpacks 64 residuals. `uppers` is null if they have no code.
HWY_INLINE void unpack(const std::uint8_t* from, unsigned width, const std::uint8_t* uppers, std::int32_t* out) {
  if (HWY_UNLIKELY(width > kTableWidths)) {
    for (std::size_t first = 0; first < kBlockPoints; first += 8, from += width)
      unpack_wide(from, width, uppers == nullptr ? nullptr : uppers + first, out + first);
  } else if (uppers == nullptr) {
    unpack_narrow<false>(from, width, uppers, out);
  } else {
    unpack_narrow<true>(from, width, uppers, out);
  }
}

#endif  // HWY_TARGET

/// Adds residuals to a block that its motion has moved, point by point as they spread over the surface.
template <bool kCentred, bool kMeans>
HWY_INLINE void spread(const std::uint8_t* corners, const std::int32_t* residuals, std::int32_t* x) {
#if HWY_TARGET == HWY_SCALAR
  std::uint32_t r[3][kBlockPoints + 1];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    r[axis][kNoCorner] = 0;
    for (std::size_t i = 0; i < kBlockPoints; ++i) {
      const std::uint8_t* at = corners + 3 * i;
      const std::size_t place = axis * kBlockPoints + i;
      const std::uint32_t ra = r[axis][at[0]], rb = r[axis][kMeans && at[1] == kNoCorner ? at[0] : at[1]];
      const std::uint32_t from =
          kMeans ? static_cast<std::uint32_t>(static_cast<std::int32_t>(ra + rb) >> 1) : ra + rb - r[axis][at[2]];
      const auto moved = static_cast<std::uint32_t>(x[place]), residual = static_cast<std::uint32_t>(residuals[place]);
      const std::uint32_t p = moved + from;
      const std::uint32_t now =
          kCentred && axis > 0 ? p + ((p ^ static_cast<std::uint32_t>(x[i])) & 1u) + 2 * residual : p + residual;
      r[axis][i] = now - moved;
      x[place] = static_cast<std::int32_t>(now);
    }
  }
#else
  const hn::FixedTag<std::int32_t, 4> d;
  using Point = hn::Vec<decltype(d)>;
  alignas(16) std::int32_t moved[4 * kBlockPoints], added[4 * kBlockPoints], r[4 * (kBlockPoints + 1)];
  hn::Store(hn::Zero(d), d, r + 4 * std::size_t{kNoCorner});
  for (std::size_t i = 0; i < kBlockPoints; i += 4) {
    const auto axis = [&](const std::int32_t* of, std::size_t a) { return hn::LoadU(d, of + a * kBlockPoints + i); };
    const auto twice = [](Point v) { return kCentred ? hn::Add(v, v) : v; };
    if constexpr (kCentred) hn::StoreInterleaved4(axis(x, 0), axis(x, 1), axis(x, 2), hn::Zero(d), d, moved + 4 * i);
    hn::StoreInterleaved4(axis(residuals, 0), twice(axis(residuals, 1)), twice(axis(residuals, 2)), hn::Zero(d), d,
                          added + 4 * i);
  }
  alignas(16) constexpr std::int32_t kParity[4] = {0, 1, 1, 0};
  [[maybe_unused]] const Point parity = hn::Load(d, kParity);
  for (std::size_t i = 0; i < kBlockPoints; ++i) {
    const std::uint8_t* at = corners + 3 * i;
    const auto from = [&](std::uint8_t corner) { return hn::Load(d, r + 4 * std::size_t{corner}); };
    Point around;
    if constexpr (kMeans)
      around = hn::ShiftRight<1>(hn::Add(from(at[0]), from(at[1] == kNoCorner ? at[0] : at[1])));
    else
      around = hn::Add(from(at[0]), hn::Sub(from(at[1]), from(at[2])));
    Point missed = hn::Add(around, hn::Load(d, added + 4 * i));
    if constexpr (kCentred) {
      const Point motion = hn::Load(d, moved + 4 * i), p = hn::Add(around, motion);
      missed = hn::Add(missed, hn::And(hn::Xor(p, hn::Broadcast<0>(hn::Add(missed, motion))), parity));
    }
    hn::Store(missed, d, r + 4 * i);
  }
  for (std::size_t i = 0; i < kBlockPoints; i += 4) {
    Point rx, ry, rz, none;
    hn::LoadInterleaved4(d, r + 4 * i, rx, ry, rz, none);
    hn::StoreU(hn::Add(hn::LoadU(d, x + i), rx), d, x + i);
    hn::StoreU(hn::Add(hn::LoadU(d, x + kBlockPoints + i), ry), d, x + kBlockPoints + i);
    hn::StoreU(hn::Add(hn::LoadU(d, x + 2 * kBlockPoints + i), rz), d, x + 2 * kBlockPoints + i);
  }
#endif
}

HWY_INLINE void spread(const MoveBlocksJob& job, std::size_t block, const std::int32_t* residuals, std::int32_t* x) {
  const std::uint8_t* corners = job.corners.data() + block * kBlockNumbers;
  const bool means = job.blocks[block].means;
  if (job.centred)
    means ? spread<true, true>(corners, residuals, x) : spread<true, false>(corners, residuals, x);
  else
    means ? spread<false, true>(corners, residuals, x) : spread<false, false>(corners, residuals, x);
}

/// Key frame: only the offset; its residuals always spread.
HWY_INLINE void move_in_space(const BlockMotion& motion, std::int32_t* x) {
  const Ints d;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const IntLanes offset = hn::Set(d, motion.offset[axis]);
    for (std::size_t i = axis * kBlockPoints; i < (axis + 1) * kBlockPoints; i += kLanes) hn::StoreU(offset, d, x + i);
  }
}

/// Adds the residuals of some points, which do not spread.
template <bool kCentred>
HWY_INLINE void add_residuals(const std::int32_t* residuals, std::size_t i, IntLanes (&x)[3]) {
  const Ints d;
  x[0] = hn::Add(x[0], hn::Load(d, residuals + i));
  for (std::size_t axis = 1; axis < 3; ++axis) {
    const IntLanes residual = hn::Load(d, residuals + axis * kBlockPoints + i);
    if constexpr (kCentred)
      x[axis] = hn::Add(hn::Add(x[axis], hn::And(hn::Xor(x[axis], x[0]), hn::Set(d, 1))), hn::Add(residual, residual));
    else
      x[axis] = hn::Add(x[axis], residual);
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

/// Residuals that are added to points as they move; those that spread come afterwards.
enum class Residuals : std::uint8_t { later, plain, centred };

template <BlockBase kBase, bool kTurns, Residuals kResiduals>
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
      now[axis] = hn::Add(base_of<kBase>(before[axis], x2 + at), offset[axis]);
    }
    if constexpr (kTurns) turn.add_to(before, now);
    if constexpr (kResiduals != Residuals::later) add_residuals<kResiduals == Residuals::centred>(residuals, i, now);
    for (std::size_t axis = 0; axis < 3; ++axis) hn::StoreU(now[axis], d, x + axis * kBlockPoints + i);
  }
}

template <BlockBase kBase, bool kTurns>
HWY_INLINE void move_in_time(const BlockMotion& motion, bool centred, const std::int32_t* residuals,
                             const std::int32_t* x1, const std::int32_t* x2, std::int32_t* x) {
  if (motion.spreads)
    move_in_time<kBase, kTurns, Residuals::later>(motion, residuals, x1, x2, x);
  else if (centred)
    move_in_time<kBase, kTurns, Residuals::centred>(motion, residuals, x1, x2, x);
  else
    move_in_time<kBase, kTurns, Residuals::plain>(motion, residuals, x1, x2, x);
}

template <BlockBase kBase>
HWY_INLINE void move_in_time(const BlockMotion& motion, bool centred, const std::int32_t* residuals,
                             const std::int32_t* x1, const std::int32_t* x2, std::int32_t* x) {
  if (motion.turns)
    move_in_time<kBase, true>(motion, centred, residuals, x1, x2, x);
  else
    move_in_time<kBase, false>(motion, centred, residuals, x1, x2, x);
}

void move_blocks(const MoveBlocksJob& job) {
  const std::uint8_t* from = job.payload.data();
  alignas(64) std::int32_t residuals[kBlockNumbers];
  for (std::size_t b = 0; b < job.blocks.size(); ++b) {
    const BlockMotion& motion = job.blocks[b];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t first = b * kBlockNumbers + axis * kBlockPoints;
      const std::uint8_t* uppers = motion.code[axis] == 0 ? nullptr : job.uppers.data() + first;
      unpack(from, motion.width[axis], uppers, residuals + axis * kBlockPoints);
      from += std::size_t{8} * motion.width[axis];
    }
    const std::size_t at = b * kBlockNumbers;
    const std::int32_t *x1 = job.x1.data() + at, *x2 = job.x2.data() + at;
    std::int32_t* x = job.x.data() + at;
    switch (motion.base) {
      case BlockBase::space: move_in_space(motion, x); break;
      case BlockBase::last: move_in_time<BlockBase::last>(motion, job.centred, residuals, x1, x2, x); break;
      case BlockBase::linear: move_in_time<BlockBase::linear>(motion, job.centred, residuals, x1, x2, x); break;
      case BlockBase::slower: move_in_time<BlockBase::slower>(motion, job.centred, residuals, x1, x2, x); break;
    }
    if (motion.spreads || motion.base == BlockBase::space) spread(job, b, residuals, x);
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
  if (!job.uppers.empty() && job.uppers.size() != numbers) return ErrorCode::size_mismatch;
  if (!have_memory(job.blocks, job.payload, job.uppers, job.corners, job.x1, job.x2, job.x))
    return ErrorCode::size_mismatch;
  std::size_t bytes = kPayloadPadding;
  for (const BlockMotion& block : job.blocks)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::uint8_t width = block.width[axis], code = block.code[axis];
      if (code > kResidualCodes || width > (code == 0 ? kMaxWidth : kMaxCodedWidth))
        return ErrorCode::index_out_of_range;
      if (code > 0 && job.uppers.empty()) return ErrorCode::size_mismatch;
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
