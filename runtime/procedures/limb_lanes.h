// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>

#include "runtime/procedures/two_bone_ik.h"

namespace sinew::ik {

/// Limbs of the common kind side by side, so that one instruction works on several. Internal to procedures/
/// A plain limb has two bones without joints in between, one scale for all axes at its root, and a full weight without
/// twist. All others, and degenerate poses and targets, are left to solve_general.

inline constexpr std::size_t kLimbLanes = 8;

struct LimbVectors {
  double x[kLimbLanes], y[kLimbLanes], z[kLimbLanes];
  void set(std::size_t i, const Vec3<double>& v) noexcept {
    x[i] = v.x;
    y[i] = v.y;
    z[i] = v.z;
  }
};

struct LimbRotations {
  double x[kLimbLanes], y[kLimbLanes], z[kLimbLanes], w[kLimbLanes];
};

/// One limb in each lane.
struct alignas(64) PlainLimbs {
  LimbVectors above[3];        ///< columns of the linear part of the parent's matrix
  LimbVectors target;          ///< from the parent's origin to the target, in model space
  LimbVectors pole;            ///< direction in model space; zero without a pole
  LimbVectors axis;            ///< of the hinge in the space of the middle joint; zero: the pose gives it
  LimbVectors place;           ///< of the root joint, in the space of the parent
  LimbVectors upper;           ///< upper bone in the space of the root joint, scaled
  LimbVectors lower;           ///< lower bone in the space of the middle joint, scaled by both joints
  LimbRotations root, middle;  ///< of the pose
  double pole_fade[kLimbLanes];
  double per_fade[kLimbLanes];                               ///< 1 / pole_fade; 0 without a fade
  double least_cosine[kLimbLanes], most_cosine[kLimbLanes];  ///< of the least and the most bend
  double free_share[kLimbLanes];  ///< share of the reach beyond which soft reach or stretch begin
};

/// Rotations on the hemisphere of the pose's, as the pose stores them. The last four are computed on request.
struct alignas(64) SolvedLimbs {
  LimbRotations root, middle;
  double is_solved[kLimbLanes];  ///< 0: the limb needs solve_general
  double metres_left[kLimbLanes], length[kLimbLanes], can_reach[kLimbLanes];
};

/// Reads a plain limb of full weight into lane `i`.
void read_plain(const TwoBoneIkJob& job, PlainLimbs& limbs, std::size_t i) noexcept;

/// eq   TwoBoneIkJob in closed form, by square roots and without trigonometry
/// in   count     lanes that are read; all of them have finite numbers
///      measures  computes the errors that are left, too
void solve_limbs(const PlainLimbs& limbs, std::size_t count, bool measures, SolvedLimbs& solved) noexcept;

/// Solves a limb of any kind, one joint after the other: the rule that solve_limbs follows where it can.
void solve_general(const TwoBoneIkJob& job) noexcept;

/// Model rotation of the tip in the pose; the identity if the tip follows.
Quat<double> tip_before(const TwoBoneIkJob& job) noexcept;

/// Rotates the tip as the goal asks, after the bones above it were turned.
void finish_limb(const TwoBoneIkJob& job, const Quat<double>& tip) noexcept;

/// Stores the result of a solved limb.
/// in   length  of the straight limb, in model space
void report(const TwoBoneIkJob& job, double metres, double length, bool can_reach) noexcept;

/// Solves limbs that share no joints, and the plain ones together.
void run_limbs(std::span<const TwoBoneIkJob> jobs) noexcept;

}  // namespace sinew::ik
