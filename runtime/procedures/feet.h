// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/animation/skeleton.h"
#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/pose_program/program_inputs.h"
#include "runtime/procedures/ik_result.h"

namespace sinew {

/// The ground below a place of the world.
struct GroundHit {
  double height_m = 0.0;               ///< y of the ground
  Vec3<double> normal{0.0, 1.0, 0.0};  ///< unit
};

/// How an engine tells where the ground is: by a ray cast, a height field, or from a buffer of hits. Called twice for
/// each foot and frame, on the thread that runs the frame: below the tip of the foot, then below its heel.
struct Ground {
  /// in   foot   index into FeetSetup::feet;   place  of the world
  /// out  false if there is no ground: the foot then keeps the height of its clip
  bool (*find)(void* context, std::size_t foot, const Vec3<double>& place, GroundHit& hit) = nullptr;
  void* context = nullptr;
};

/// Joints of a leg, and two points of its sole. Other joints may lie in between, as in the legs of spiders and horses:
/// only `hip`, `knee` and `ankle` turn.
struct FootSetup {
  std::uint32_t hip = 0, knee = 0, ankle = 0;
  std::uint32_t toes = kNone;         ///< joint at the ball of the foot; kNone = the foot has none
  Vec3<float> heel{0.0f}, tip{0.0f};  ///< in the space of `ankle`, and of `toes` or else `ankle`
};

/// A leg whose sole is where the rest pose stands: at y = 0 of model space, below ankle and toes.
/// in   joints  of the skeleton, each below the one before
SINEW_API FootSetup foot_on_rest_ground(const Skeleton& skeleton, std::uint32_t hip, std::uint32_t knee,
                                        std::uint32_t ankle, std::uint32_t toes = kNone);

inline constexpr std::size_t kMostFeet = 8;

struct FeetSetup {
  std::uint32_t pelvis = 0;          ///< joint above all legs, which comes down where the ground is low
  std::span<const FootSetup> feet;   ///< at most kMostFeet
  double lock_below_m_s = 0.3;       ///< a foot is locked if its tip is low in the clip, and slower than this
  double free_above_m_s = 1.0;       ///< a locked foot is released if its tip is faster in the clip
  double contact_height_m = 0.05;    ///< height of the tip in the clip below which it is low; twice this height
                                     ///< releases a locked foot
  double release_beyond_m = 0.2;     ///< a locked foot is released at this horizontal distance from its clip
  double half_life_s = 0.05;         ///< time in which the distance of a released foot from its clip halves
  double step_half_life_s = 0.045;   ///< time in which the offset of a foot halves after the ground below it jumped
  double pelvis_half_life_s = 0.08;  ///< time in which the distance of the pelvis from its goal halves
  double most_pelvis_m = 0.5;        ///< limit of the pelvis's offset, up and down
  double most_slope_rad = 0.9;       ///< limit of a sole's turn
};

/// Memory of one character's feet: plain numbers that can be copied, stored and rolled back.
struct FeetState {
  struct Foot {
    Vec3<double> clip_tip{0.0};   ///< place of the tip in the clip: x and z in the world, y above the root
    Vec3<double> shown_tip{0.0};  ///< place of the tip in the last frame: x and z in the world, y of the ground below
    Vec3<double> offset{0.0}, offset_rate{0.0};  ///< shown place minus clip, which fades after a lock
    double step = 0.0, step_rate = 0.0;          ///< height by which the ground jumped; fades to 0
    Vec3<double> normal{0.0, 1.0, 0.0};
    std::uint8_t is_locked = 0;
  };
  std::array<Foot, kMostFeet> feet;
  double pelvis = 0.0, pelvis_rate = 0.0;
  double pelvis_goal = 0.0;  ///< goal of the pelvis in the last run
  /// 0: the next run has no history. It places feet and pelvis at once, as after a teleport.
  std::uint8_t has_started = 0;
};

/// Outcome for one foot.
struct FootResult {
  IkResult ik;
  bool is_locked = false;
  float tip_above_ground_m = 0.0f, heel_above_ground_m = 0.0f;  ///< in the pose that was written
};

/// Puts feet on the ground, and keeps them in place while they stand: uphill, downhill and on stairs, with 1 to
/// kMostFeet legs. The clip itself plays on flat ground at the height of the root; y is up.
/// eq   tip    while it is locked, the place where it was locked; then the clip's place plus an offset that fades
///             critically damped, with the foot's velocity at the release: no pop in place or velocity
///      height the clip's height above its ground, plus the ground's height. Where the ground jumps (stairs), the jump
///             fades critically damped
///      sole   turned with the ground between heel and tip, less and less with the height of the tip
///      pelvis comes to the highest place at which no leg is straighter than in the clip. The offset from it fades
///             critically damped, so the pelvis does not lag on slopes
///      A foot in the air is never straighter than in the clip. A foot on the ground may be while the pelvis comes
///      down.
/// limits  A foot that passes the edge of a step less than 50 ms before it lands is still below or above the step then.
/// in   root   matrix from model space to the world: turns about y, one positive scale
///      dt_s   >= 0 since the last run; 0 = the same moment again: no lock or speed in `state` changes
/// io   local, state
/// out  results[feet] or empty
/// err  size_mismatch (pose, feet, results), index_out_of_range, unsupported (joints not in one line, a fixed matrix),
///      not_finite (a number of the setup, the root, dt), not_a_fraction (a half-life or limit below 0)
/// cost O(depth of the legs), two calls of `ground` a foot, no allocation
struct FeetJob {
  const Skeleton* skeleton = nullptr;
  PoseSpan local;
  const FeetSetup* setup = nullptr;
  Affined root;
  double dt_s = 0.0;
  Ground ground;
  FeetState* state = nullptr;
  float weight = 1.0f;  ///< [0, 1]; 0 keeps every bit of the pose, and remembers nothing
  std::span<FootResult> results = {};
};

SINEW_API ErrorCode check(const FeetJob& job) noexcept;
SINEW_API void run_unchecked(const FeetJob& job) noexcept;

/// Feet as a procedure of a pose program. Each character needs its own, which stays in place until the frame is done;
/// `root` and `dt_s` are those of the next frame.
struct Feet {
  FeetSetup setup;
  Ground ground;
  Affined root;
  double dt_s = 0.0;
  FeetState state;
  std::array<FootResult, kMostFeet> results;
  ErrorCode error = ErrorCode::ok;  ///< of the last run; if it is not ok, the pose is unchanged
};
/// out  version 0: feet run in each frame, since they follow the ground and the time
SINEW_API PoseProcedure as_procedure(Feet& feet) noexcept;

}  // namespace sinew
