// SPDX-License-Identifier: MIT
#include <algorithm>

#include "runtime/animation/mirror_map.h"
#include "runtime/pose/mirror_pose.h"
#include "runtime/pose/sample_clip.h"
#include "runtime/retarget/hold_feet.h"
#include "runtime/retarget/retarget_pose.h"
#include "tests/bench/clip_characters.h"
#include "tests/bench/measure.h"
#include "tests/support/tiny_assets.h"

namespace sinew::bench {
namespace {

/// A pose in the middle of a clip, and where it is mirrored or copied to.
struct Room {
  std::shared_ptr<const Character> of;
  MirrorTables tables;
  test::PoseBuffer pose, out;

  explicit Room(const std::shared_ptr<const Character>& c)
      : of(c),
        tables(make_mirror_tables(make_mirror_map(c->skeleton).joints)),
        pose(c->joint_count()),
        out(c->joint_count()) {
    run_unchecked(
        SampleClipJob{.clip = &c->clip, .time_s = 0.4 * c->animation.duration_s, .pose = pose.span(), .weights = {}});
  }
  void mirror() { run_unchecked(MirrorPoseJob{&tables, pose.span(), out.span()}); }
  void copy() { std::copy_n(pose.span().planes, PoseSpan::floats_for(of->joint_count()), out.span().planes); }
};

/// The skeleton with other axes at every joint.
Skeleton with_other_axes(Skeleton skeleton) {
  for (Transform& rest : skeleton.rest) rest.rotation = rest.rotation * quat_xyzw(0.6f, 0.0f, 0.0f, 0.8f);
  return skeleton;
}

/// A pose on the same body with other axes.
struct Retargeted {
  Room room;
  Skeleton target;
  SkeletonMap map;
  RetargetTables tables;

  explicit Retargeted(const std::shared_ptr<const Character>& c)
      : room(c),
        target(with_other_axes(c->skeleton)),
        map(make_skeleton_map(c->skeleton, target)),
        tables(make_retarget_tables(map, c->skeleton, target)) {}
  void run_job() {
    run_unchecked(RetargetPoseJob{.tables = &tables, .pose = room.pose.span(), .retargeted = room.out.span()});
  }
};

/// The feet of a pose on the same body with other axes, held again and again.
struct HeldFeet {
  Retargeted on;
  FeetMap feet;

  explicit HeldFeet(const std::shared_ptr<const Character>& c)
      : on(c), feet(make_feet_map(on.map, c->skeleton, on.target)) {
    on.run_job();
  }
  void run_job() {
    run_unchecked(HoldFeetJob{.feet = &feet, .ground = 0.0f, .pose = on.room.pose.span(), .held = on.room.out.span()});
  }
};

}  // namespace

void add_mirrors() {
  for (const auto& c : characters()) {
    const auto room = std::make_shared<Room>(c);
    add("mirror_pose/sinew/" + c->name, c->joint_count(), [room] { room->mirror(); });
    add("mirror_pose/copy/" + c->name, c->joint_count(), [room] { room->copy(); });
    if (!c->skeleton.fixed_matrices.empty()) continue;  // these need a scratch pose
    const auto retargeted = std::make_shared<Retargeted>(c);
    add("retarget_pose/sinew/" + c->name, c->joint_count(), [retargeted] { retargeted->run_job(); });
    add("retarget_pose/copy/" + c->name, c->joint_count(), [retargeted] { retargeted->room.copy(); });
    const auto held = std::make_shared<HeldFeet>(c);
    if (!held->feet.legs.empty())
      add("hold_feet/sinew/" + c->name, held->feet.legs.size(), [held] { held->run_job(); });
  }
}

}  // namespace sinew::bench
