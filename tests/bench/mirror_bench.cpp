// SPDX-License-Identifier: MIT
#include <algorithm>

#include "runtime/animation/mirror_map.h"
#include "runtime/pose/mirror_pose.h"
#include "runtime/pose/sample_clip.h"
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
    run(SampleClipJob{.clip = &c->clip, .time_s = 0.4 * c->animation.duration_s, .pose = pose.span(), .weights = {}});
  }
  void mirror() { run(MirrorPoseJob{&tables, pose.span(), out.span()}); }
  void copy() { std::copy_n(pose.span().planes, PoseSpan::floats_for(of->joint_count()), out.span().planes); }
};

}  // namespace

void add_mirrors() {
  for (const auto& c : characters()) {
    const auto room = std::make_shared<Room>(c);
    add("mirror_pose/sinew/" + c->name, c->joint_count(), [room] { room->mirror(); });
    add("mirror_pose/copy/" + c->name, c->joint_count(), [room] { room->copy(); });
  }
}

}  // namespace sinew::bench
