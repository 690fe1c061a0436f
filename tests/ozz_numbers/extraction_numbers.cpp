// SPDX-License-Identifier: MIT
// Root motion taken out of a joint, and the joint without it. In ozz's Euler angles the pitch is about z and the roll
// about x.
#include "runtime/math/axis_angle.h"
#include "runtime/playback/root_track.h"
#include "tests/ozz_numbers/axes.h"
#include "tests/ozz_numbers/tally.h"

namespace sinew::ozz {
namespace {

Quat<double> euler(double yaw, double pitch, double roll) {
  return quat_from_axis_angle(V(0, 1, 0), yaw) * quat_from_axis_angle(V(0, 0, 1), pitch) *
         quat_from_axis_angle(V(1, 0, 0), roll);
}

const double kPitches[] = {kPi / 3, 1.1 * kPi / 3, 1.2 * kPi / 3};
constexpr double kPlaceTimes[] = {0.5, 5.0}, kTurnTimes[] = {1.0, 12.0, 46.0};

BoneAnimation walking_root() {
  BoneAnimation root;
  root.translation = {Interpolation::linear, {0.5f, 5.0f}, {{1, 2, 3}, {4, 5, 6}}};
  root.rotation = {Interpolation::linear, {1.0f, 12.0f, 46.0f}, {}};
  for (const double pitch : kPitches) root.rotation.values.push_back(quat_cast<float>(euler(kPi / 2, pitch, kPi / 4)));
  return root;
}

void compare_place(const V& found, const V& expected, Tally& tally) {
  for (int c = 0; c < 3; ++c) compare(found[c], expected[c], kTolerance, tally);
}

struct Extraction {
  RootMotionParts parts;
  V places[2];
  Quat<double> turns[3];
  V left_places[2];  ///< of the joint without the motion
  Quat<double> left_turns[3];
};

}  // namespace

Tally extraction_group() {
  const BoneAnimation root = walking_root();
  const Quat<double> none = quat_identity<double>(), yaw = euler(kPi / 2, 0, 0);
  Quat<double> full[3], tilt[3];
  for (int i = 0; i < 3; ++i) {
    full[i] = euler(kPi / 2, kPitches[i], kPi / 4);
    tilt[i] = euler(0, kPitches[i], kPi / 4);
  }
  const V first(1, 2, 3), second(4, 5, 6), zero(0.0);
  const Extraction cases[] = {{{false, false, false, RootTurn::none},
                               {zero, zero},
                               {none, none, none},
                               {first, second},
                               {full[0], full[1], full[2]}},
                              {{true, true, true, RootTurn::full},
                               {first, second},
                               {full[0], full[1], full[2]},
                               {zero, zero},
                               {none, none, none}},
                              {{false, true, false, RootTurn::none},
                               {V(0, 2, 0), V(0, 5, 0)},
                               {none, none, none},
                               {V(1, 0, 3), V(4, 0, 6)},
                               {full[0], full[1], full[2]}},
                              {{true, false, false, RootTurn::heading_euler},
                               {V(1, 0, 0), V(4, 0, 0)},
                               {yaw, yaw, yaw},
                               {V(-3, 2, 0), V(-6, 5, 0)},
                               {tilt[0], tilt[1], tilt[2]}}};
  Tally tally;
  for (const Extraction& c : cases) {
    SCOPED_TRACE(&c - cases);
    const RootTrack track = RootTrack::make(root, {}, c.parts, 1e-6);
    const BoneAnimation left = bake_out_root(root, {}, track, 1e-6);
    const auto left_at = [&](double time_s) { return left.interpolate<double>(time_s, {}); };
    for (int i = 0; i < 2; ++i) {
      compare_place(translation_of(root_place(root, {}, c.parts, kPlaceTimes[i])), c.places[i], tally);
      compare_place(left_at(kPlaceTimes[i]).translation, c.left_places[i], tally);
    }
    for (int i = 0; i < 3; ++i) {
      compare_rotation(root_place(root, {}, c.parts, kTurnTimes[i]).real, c.turns[i], tally);
      compare_rotation(left_at(kTurnTimes[i]).rotation, c.left_turns[i], tally);
    }
  }
  return tally;
}

}  // namespace sinew::ozz
