// SPDX-License-Identifier: MIT
// Samples of compiled clips whose tracks begin late, end early or are missing.
#include "runtime/pose/sample_clip.h"
#include "tests/ozz_numbers/tally.h"
#include "tests/support/tiny_assets.h"

namespace sinew::ozz {
namespace {

constexpr const char* kHalfTurn = "sinew takes the way between two keys that the signs of the file say";

/// Counts all ten numbers of a joint.
void compare_joint(const Transform& found, const Transform& expected, Tally& tally, const char* rule = nullptr) {
  for (int c = 0; c < 3; ++c) {
    compare(double(found.translation[c]), double(expected.translation[c]), kTolerance, tally);
    compare(double(found.scale[c]), double(expected.scale[c]), kTolerance, tally);
  }
  compare_rotation(found.rotation, expected.rotation, tally, rule);
}

/// Counts the numbers of the joints of a clip at a time.
void compare_sample(const Clip& clip, double time_s, std::span<const Transform> expected, Tally& tally,
                    const char* rule = nullptr) {
  test::PoseBuffer pose(expected.size());
  EXPECT_EQ(run(SampleClipJob{.clip = &clip, .time_s = time_s, .pose = pose.span(), .weights = {}}), ErrorCode::ok);
  for (std::size_t j = 0; j < expected.size(); ++j) compare_joint(pose.span().get(j), expected[j], tally, rule);
}

Transform at(float x, float y, float z) { return {.translation = {x, y, z}}; }

BoneAnimation along_x(std::uint32_t joint, std::vector<float> times_s, const std::vector<float>& x) {
  BoneAnimation bone;
  bone.joint = joint;
  bone.translation.times_s = std::move(times_s);
  for (const float number : x) bone.translation.values.emplace_back(number, 0.0f, 0.0f);
  return bone;
}

}  // namespace

Tally sampling_group() {
  const Skeleton skeleton = test::skeleton_of({kNone, kNone, kNone, kNone});
  const Clip clip = test::clip_of(
      test::animation_of({along_x(0, {0.2f}, {-1}), along_x(2, {0, 0.2f, 0.4f, 0.6f, 1}, {2, 6, 8, 10, 11}),
                          along_x(3, {0.2f, 0.6f}, {7, 9})}),
      skeleton);
  const struct {
    double time_s;
    float third, fourth;  ///< x of these joints; the first stands at -1 and the second at 0
  } cases[] = {{-0.2, 2, 7},       {0, 2, 7},          {0.0000001, 2, 7}, {0.1, 4, 7},       {0.2, 6, 7},
               {0.3, 7, 7.5f},     {0.4, 8, 8},        {0.3999999, 8, 8}, {0.4000001, 8, 8}, {0.5, 9, 8.5f},
               {0.6, 10, 9},       {0.9999999, 11, 9}, {1, 11, 9},        {1.000001, 11, 9}, {0.5, 9, 8.5f},
               {0.9999999, 11, 9}, {0.0000001, 2, 7}};
  Tally tally;
  for (const auto& c : cases) {
    const Transform expected[] = {at(-1, 0, 0), {}, at(c.third, 0, 0), at(c.fourth, 0, 0)};
    compare_sample(clip, c.time_s, expected, tally);
  }
  return tally;
}

Tally sampling_few_keys_group() {
  const Skeleton one = test::skeleton_of({kNone}), four = test::skeleton_of({kNone, kNone, kNone, kNone});
  BoneAnimation key, keys;
  key.translation = {Interpolation::linear, {0.3f}, {{1, -1, 5}}};
  keys.translation = {Interpolation::linear, {0.5f, 0.8f}, {{1, 2, 4}, {2, 4, 8}}};
  const Clip none = test::clip_of(test::animation_of({}), one), single = test::clip_of(test::animation_of({key}), one),
             pair = test::clip_of(test::animation_of({keys}), one);
  Tally tally;
  const Transform rest[] = {{}}, held[] = {at(1, -1, 5)}, start[] = {at(1, 2, 4)}, end[] = {at(2, 4, 8)},
                  between[] = {at(1.5f, 3, 6)};
  for (int i = -2; i < 12; ++i) {
    compare_sample(none, 4.6 * i, rest, tally);
    compare_sample(single, 4.6 * i, held, tally);
  }
  compare_sample(pair, 0.0, start, tally);
  compare_sample(pair, 0.5, start, tally);
  compare_sample(pair, 0.8, end, tally);
  compare_sample(pair, 46.0, end, tally);
  compare_sample(pair, 0.65, between, tally);

  BoneAnimation turn, scale, last;
  turn.joint = 1;
  turn.rotation = {
      Interpolation::linear, {0.0f, 1.0f}, {quat_xyzw(0.f, 0.f, 0.f, -1.f), quat_xyzw(0.f, 1.f, 0.f, 0.f)}};
  scale.joint = 2;
  scale.scale = {Interpolation::linear, {0.5f, 0.8f}, {glm::vec3(0), glm::vec3(-1)}};
  last.joint = 3;
  last.translation = {Interpolation::linear, {0.0f, 1.0f}, {{-1, -2, -4}, {-2, -4, -8}}};
  const Clip all = test::clip_of(test::animation_of({keys, turn, scale, last}), four);
  const Transform flat{.scale = glm::vec3(0)}, mirrored{.scale = glm::vec3(-1)};
  const auto turned = [](float y, float w) { return Transform{.rotation = quat_xyzw(0.0f, y, 0.0f, w)}; };
  const Transform at_start[] = {at(1, 2, 4), {}, flat, at(-1, -2, -4)},
                  at_half[] = {at(1, 2, 4), turned(0.7071067f, 0.7071067f), flat, at(-1.5f, -3, -6)},
                  at_end[] = {at(2, 4, 8), turned(1, 0), mirrored, at(-2, -4, -8)};
  compare_sample(all, 0.0, at_start, tally);
  compare_sample(all, 0.5, at_half, tally, kHalfTurn);
  compare_sample(all, 1.0, at_end, tally);
  return tally;
}

}  // namespace sinew::ozz
