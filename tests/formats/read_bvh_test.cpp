// SPDX-License-Identifier: MIT
#include "importer/formats/bvh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace sinew::formats {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kFile = R"(HIERARCHY
ROOT Hips
{
  OFFSET 0 1 -2.5e-1
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Bip01 L Thigh {
    OFFSET 1 0 0 CHANNELS 2 Yrotation Yposition
    End Site
    { OFFSET 0 -1 0 } }
  JOINT mixamorig:Spine
  {
    OFFSET 0 1 0
    CHANNELS 3 Zrotation Xrotation Zrotation
  }
}
ROOT prop
{
  OFFSET 5 5 5
}
MOTION
Frames: 2
Frame Time: 0.5
1 2 3 4 5 6 7 8 9 10 11
1 2 3 4 5 6 +7 8. 9 1e1 -1.1E+1
)";

std::string with(const std::string& old_text, const std::string& new_text) {
  std::string out = kFile;
  const std::size_t at = out.find(old_text);
  EXPECT_NE(at, out.npos) << old_text;
  return out.replace(at, old_text.size(), new_text);
}

TEST(read_bvh, joints_channels_and_frames_are_those_of_the_file) {
  const auto bvh = read_bvh(kFile);
  ASSERT_TRUE(bvh) << bvh.error().detail;
  std::vector<std::string> names;
  std::vector<std::uint32_t> parents;
  for (const BvhJoint& joint : bvh->joints) {
    names.push_back(joint.name);
    parents.push_back(joint.parent);
  }
  EXPECT_THAT(names, ElementsAre("Hips", "Bip01 L Thigh", "Bip01 L Thigh_end", "mixamorig:Spine", "prop"));
  EXPECT_THAT(parents, ElementsAre(kNone, 0u, 1u, 0u, kNone));
  EXPECT_EQ(bvh->joints[0].offset, glm::dvec3(0, 1, -0.25));
  EXPECT_TRUE(bvh->joints[2].is_end_site);
  EXPECT_THAT(bvh->joints[1].channels, ElementsAre(BvhChannel{true, 1}, BvhChannel{false, 1}));
  EXPECT_EQ(bvh->joints[3].first_channel, 8u);
  EXPECT_EQ(bvh->frame_time_s, 0.5);
  EXPECT_EQ(bvh->values.size(), 22u);
  EXPECT_EQ(bvh->values[21], -11.0);
  EXPECT_TRUE(bvh->warnings.empty());
}

TEST(read_bvh, keywords_may_be_in_any_case_and_lines_end_in_any_way) {
  EXPECT_TRUE(
      read_bvh("\xEF\xBB\xBFhierarchy\r\nroot a\r\n{\r\noffset 0 0 0\r\nchannels 1 XROTATION\r\nEND SITE\r\n"
               "{\r\nOFFSET 0 1 0\r\n}\r\n}\r\nmotion\r\nFRAMES:1\r\nframe time:.1\r\n45\r\n"));
  EXPECT_TRUE(read_bvh("HIERARCHY ROOT a { OFFSET 0 0 0 } MOTION Frames: 0 Frame Time: 0"));
}

TEST(read_bvh, faults_name_their_line_and_rule) {
  const struct {
    std::string text;
    const char *rule, *place, *detail;
  } cases[] = {
      {"", "bvh-hierarchy", "line 1", "end of the file"},
      {with("HIERARCHY", "HIERARCHIE"), "bvh-hierarchy", "line 1", "HIERARCHIE"},
      {with("ROOT Hips", "JOINT Hips"), "bvh-hierarchy", "line 2", "expected ROOT"},
      {with("OFFSET 0 1 -2.5e-1", "OFFSET 0 1"), "bvh-number", "line 5", "CHANNELS"},
      {with("-2.5e-1", "-2,5"), "bvh-number", "line 4", "-2,5"},
      {with("-2.5e-1", "nan"), "bvh-number", "line 4", "nan"},
      {with("-2.5e-1", "1e999"), "bvh-number", "line 4", "1e999"},
      {with("OFFSET 5", "5"), "bvh-hierarchy", "line 18", "OFFSET"},
      {with("CHANNELS 6", "CHANNELS 7"), "bvh-channels", "line 6", "number 7 is \"JOINT\""},
      {with("CHANNELS 6", "CHANNELS -6"), "bvh-channels", "line 5", "-6"},
      {with("Xposition", "Wposition"), "bvh-channels", "line 5", "Wposition"},
      {with("Yposition", "Xposition"), "bvh-channels", "line 5", "twice"},
      {with("{ OFFSET 0 -1 0 }", "{ OFFSET 0 -1 0 JOINT c {"), "bvh-hierarchy", "line 9", "end site"},
      {with("MOTION", "}"), "bvh-motion", "line 20", "MOTION"},
      {with("Frames: 2", "Frames: 2.5"), "bvh-frames", "line 21", "2.5"},
      {with("Frames: 2", "Frames: 3"), "bvh-frames", "line 25", "frame 3 of 3; with `Frames: 2`"},
      {with("Frames: 2", "Frames: 900000000000000"), "bvh-frame-time", "line 22", "32 bits"},
      {with("Time: 0.5", "Time: 0"), "bvh-frame-time", "line 22", "more than 0"},
      {with("Time: 0.5", "Time: -1"), "bvh-frame-time", "line 22", "more than 0"},
      {with("8.", "8.x"), "bvh-number", "line 24", "8.x"},
      {with("Hips", std::string(256, 'a')), "bvh-hierarchy", "line 2", "255 bytes"},
      {"HIERARCHY ROOT a { OFFSET 0 0 0 } MOTION Frames: 9 Frame Time: 1", "bvh-frames", "line 1", "no joint"},
  };
  for (const auto& c : cases) {
    const auto bvh = read_bvh(c.text);
    ASSERT_FALSE(bvh) << c.rule << ' ' << c.place;
    EXPECT_EQ(bvh.error().rule, c.rule) << c.detail << ": " << bvh.error().detail;
    EXPECT_EQ(bvh.error().json_pointer, c.place) << c.detail;
    EXPECT_THAT(bvh.error().detail, HasSubstr(c.detail));
  }
}

TEST(read_bvh, numbers_behind_the_last_frame_are_left_out_with_a_warning) {
  const auto bvh = read_bvh(with("Frames: 2", "Frames: 1"));
  ASSERT_TRUE(bvh);
  EXPECT_EQ(bvh->values.size(), 11u);
  ASSERT_EQ(bvh->warnings.size(), 1u);
  EXPECT_EQ(bvh->warnings[0].json_pointer, "line 24");
}

TEST(read_bvh, every_prefix_of_a_file_is_refused_or_read) {
  const std::string whole = kFile;
  std::size_t read = 0;
  for (std::size_t size = 0; size <= whole.size(); ++size) read += read_bvh(whole.substr(0, size)).has_value();
  EXPECT_THAT(read, testing::AllOf(testing::Ge(2u), testing::Le(8u))) << "those that end in the last number";
}

}  // namespace
}  // namespace sinew::formats
