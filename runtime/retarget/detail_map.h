// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/animation/skeleton.h"
#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/pose/pose.h"

namespace sinew {

/// Maps poses between two skeletons of one body in different detail. The coarse one has the bodies of a ragdoll, which
/// a physics engine moves; the fine one is the character that is drawn. Both have the same size and the same neutral
/// pose, but their joints may have other axes and places. For bodies of different shape see skeleton_map.h.
struct DetailMap {
  /// A joint that both skeletons have. eq   M_fine = M_coarse fine_in_coarse,  M_coarse = M_fine coarse_in_fine
  struct Pair {
    std::uint32_t coarse = 0, fine = 0;
    Affined fine_in_coarse, coarse_in_fine;
  };
  /// Joints of the fine skeleton between two joints that are placed: spine joints between a pelvis and a chest body.
  struct Chain {
    std::uint32_t start = 0, end = 0;   ///< the joint above the first one, and the mapped joint below the last one
    std::vector<std::uint32_t> joints;  ///< from start to end
  };

  std::vector<Pair> pairs;                                  ///< rising fine joints
  std::vector<Chain> chains;                                ///< no joint is in two of them
  std::vector<std::uint32_t> pair_of_fine, pair_of_coarse;  ///< [joints] index into `pairs`, or kNone
  std::vector<std::uint32_t> chain_of_fine;                 ///< [joints] index into `chains`, or kNone
  std::vector<Affined> coarse_rest;  ///< [coarse joints] neutral local matrices, for joints that have no pair
};

struct DetailMapOptions {
  std::vector<std::array<std::uint32_t, 2>> pairs;  ///< {coarse, fine}; empty = joints of equal names.
  /// [joints] Model matrices of the pose in which both skeletons fit each other; empty = the rest pose
  std::span<const Affined> coarse_neutral = {}, fine_neutral = {};
};

/// err  index_out_of_range (a joint), unsupported (a joint in two pairs, or a paired joint whose neutral matrix has no
///      inverse, or one of the fine skeleton with a fixed matrix), size_mismatch (neutral poses), not_finite
/// cost O(J^2), allocates
SINEW_API Result<DetailMap> make_detail_map(const Skeleton& coarse, const Skeleton& fine,
                                            const DetailMapOptions& options = {});

/// Model matrices of the coarse skeleton for a pose of the fine one: where animation wants the bodies to be. A joint
/// without a pair stays in its neutral place relative to its parent.
/// in   fine_model[fine joints]      out  coarse_model[coarse joints]
/// err  size_mismatch     cost O(coarse joints), no allocation
SINEW_API ErrorCode coarse_from_fine(const DetailMap& map, const Skeleton& coarse, std::span<const Affine> fine_model,
                                     std::span<Affine> coarse_model) noexcept;

/// Parts of a pose that fine_from_coarse takes over from the bodies.
enum class BodyPlaces : std::uint8_t {
  exact,        ///< mapped joints stand exactly where their bodies are: bones stretch where bodies drift apart
  keep_lengths  ///< rotations alone, and the places of joints that have no mapped joint above: bones keep their lengths
};

/// Moves a pose of the fine skeleton to where the bodies are.
/// eq   mapped joints    M_fine = M_coarse fine_in_coarse, with the scale of the pose
///      chains           the pose between start and end, carried along by the start; joint i of n is turned by the
///                       share i / (n + 1) of the rotation that the end still lacks, then all of them about the first
///                       one, so that the end lies in the direction of its place
///      other joints     keep their local transforms: fingers go on playing their clip
/// in   coarse_model[coarse joints]  finite, in the space above the roots of the pose
///      scratch[2 * fine joints]
/// io   local  the animated pose
/// err  size_mismatch, not_finite (the bodies; the pose is unchanged then)     cost O(fine joints), no allocation
SINEW_API ErrorCode fine_from_coarse(const DetailMap& map, const Skeleton& fine, std::span<const Affine> coarse_model,
                                     const PoseSpan& local, std::span<Affined> scratch,
                                     BodyPlaces places = BodyPlaces::exact) noexcept;

}  // namespace sinew
