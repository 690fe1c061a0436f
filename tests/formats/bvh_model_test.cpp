// SPDX-License-Identifier: MIT
#include "importer/formats/bvh_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>

#include "importer/import_gltf.h"
#include "tests/formats/bvh_truth.h"
#include "tests/formats/world_pose.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew::formats {
namespace {

using test::FixedRandom;

/// Writes a random hierarchy with channels in random order, some joints with position channels and some without any.
class RandomBvh {
 public:
  explicit RandomBvh(std::uint64_t seed) : random_(seed) {
    text_ << "HIERARCHY\n";
    for (int root = 0; root < 1 + static_cast<int>(seed % 2); ++root) joint("ROOT", 0);
    constexpr int kFrames = 7;
    text_ << "MOTION\nFrames: " << kFrames << "\nFrame Time: 0.0083333\n";
    for (int frame = 0; frame < kFrames; ++frame, text_ << '\n')
      for (int c = 0; c < channels_; ++c) text_ << number(-400.0, 400.0) << ' ';
  }

  std::string text() const { return text_.str(); }

 private:
  double number(double low, double high) { return random_.in(low, high); }

  void joint(const char* keyword, int depth) {
    text_ << keyword << " j" << joints_++ << "\n{\nOFFSET " << number(-9, 9) << ' ' << number(-9, 9) << ' '
          << number(-9, 9) << '\n';
    std::array<const char*, 6> names{"Xposition", "Yposition", "Zposition", "Xrotation", "Yrotation", "Zrotation"};
    for (std::size_t i = names.size(); i-- > 1;)
      std::swap(names[i], names[static_cast<std::size_t>(number(0.0, static_cast<double>(i) + 0.999))]);
    const int count = static_cast<int>(number(0.0, 6.999));
    if (count != 0) text_ << "CHANNELS " << count;
    for (int i = 0; i < count; ++i) text_ << ' ' << names[static_cast<std::size_t>(i)];
    text_ << '\n';
    channels_ += count;
    if (depth < 6)
      for (int child = static_cast<int>(number(0.5, 2.999)); child-- > 0;) joint("JOINT", depth + 1);
    else
      text_ << "End Site\n{\nOFFSET 1 2 3\n}\n";
    text_ << "}\n";
  }

  FixedRandom random_;
  std::ostringstream text_;
  int joints_ = 0, channels_ = 0;
};

Scene scene_of(const std::string& text, const BvhMeaning& meaning) {
  const auto bvh = read_bvh(text);
  EXPECT_TRUE(bvh) << bvh.error().json_pointer << ' ' << bvh.error().detail;
  ModelDraft draft;
  add_bvh(*bvh, meaning, "clip", draft);
  std::vector<ImportIssue> warnings;
  const auto bytes = draft.finish("test", warnings);
  EXPECT_TRUE(bytes) << describe("test", bytes.error().issue);
  EXPECT_TRUE(warnings.empty());
  ImportOptions options;
  options.thorough = true;
  auto file = import_gltf(*bytes, "test", options);
  EXPECT_TRUE(file);
  EXPECT_TRUE(file->warnings.empty());
  return std::move(file->scene);
}

TEST(bvh_model, all_joints_of_all_frames_are_where_an_independent_reading_puts_them) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const bool adds : {false, true}) {
      const std::string text = RandomBvh(seed).text();
      const test::BvhTruth truth(text, adds);
      const Scene scene = scene_of(text, {1.0, false, true, adds});
      double size = 0.0, worst = 0.0;
      for (std::size_t frame = 0; frame < truth.positions.size(); ++frame) {
        const double time_s = static_cast<float>(static_cast<double>(frame) * truth.frame_time_s());
        const auto world = test::world_pose(scene, 0, time_s);
        ASSERT_EQ(world.size(), truth.positions[frame].size());
        for (std::size_t j = 0; j < world.size(); ++j) {
          size = std::max(size, glm::length(truth.positions[frame][j]));
          worst = std::max(worst, test::distance(translation_of(world[j]), truth.positions[frame][j]));
        }
      }
      EXPECT_LE(worst, 1e-6 * size) << seed;
    }
}

constexpr const char* kArm = R"(HIERARCHY
ROOT arm
{
  OFFSET 0 0 100
  CHANNELS 4 Xposition Zrotation Xrotation Yrotation
  End Site
  {
    OFFSET 0 0 50
  }
}
MOTION
Frames: 2
Frame Time: 0.25
10 0 90 0
20 0 0 0
)";

glm::dvec3 position(const Scene& scene, std::size_t node, double time_s) {
  return translation_of(test::world_pose(scene, 0, time_s)[node]);
}

TEST(bvh_model, lengths_are_in_metres_and_missing_position_channels_keep_their_offset) {
  const Scene scene = scene_of(kArm, {});
  EXPECT_TRUE(test::is_near(position(scene, 0, 0.0), glm::dvec3(0.1, 0.0, 1.0), 1e-7));
  EXPECT_TRUE(test::is_near(position(scene, 1, 0.0), glm::dvec3(0.1, -0.5, 1.0), 1e-7));
  EXPECT_TRUE(test::is_near(position(scene, 0, 0.25), glm::dvec3(0.2, 0.0, 1.0), 1e-7));
  EXPECT_EQ(scene.animations[0].name, "clip");
  EXPECT_EQ(scene.animations[0].duration_s, 0.25);
}

TEST(bvh_model, z_up_becomes_y_up) {
  const Scene scene = scene_of(kArm, {0.01, true, true, false});
  EXPECT_TRUE(test::is_near(position(scene, 1, 0.25), glm::dvec3(0.2, 1.0, 0.0), 1e-7));
  EXPECT_TRUE(test::is_near(position(scene, 2, 0.25), glm::dvec3(0.2, 1.5, 0.0), 1e-7));
}

TEST(bvh_model, end_sites_can_be_left_out) {
  EXPECT_EQ(scene_of(kArm, {}).skeleton.names[1], "arm_end");
  EXPECT_EQ(scene_of(kArm, {0.01, false, false, false}).skeleton.joint_count(), 1u);
}

TEST(bvh_model, neighbouring_keys_of_a_full_turn_are_on_one_hemisphere) {
  std::string text = "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 1 Yrotation } MOTION Frames: 73 Frame Time: 0.1 ";
  for (int i = 0; i < 73; ++i) text += std::to_string(10 * i) + ' ';
  const Scene scene = scene_of(text, {});
  const auto& keys = scene.animations[0].bones[0].rotation.values;
  ASSERT_EQ(keys.size(), 73u);
  for (std::size_t k = 1; k < keys.size(); ++k) EXPECT_GT(glm::dot(keys[k - 1], keys[k]), 0.9f);
}

TEST(bvh_model, a_file_without_frames_has_no_clip) {
  EXPECT_TRUE(scene_of("HIERARCHY ROOT a { OFFSET 1 0 0 } MOTION Frames: 0 Frame Time: 0.1", {}).animations.empty());
}

}  // namespace
}  // namespace sinew::formats
