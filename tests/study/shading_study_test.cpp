// SPDX-License-Identifier: MIT
#include "tests/study/shading_study.h"

#include <algorithm>

#include "tests/viewer/device_fixture.h"

namespace sinew::viewer {
namespace {

class shading_study : public DeviceTest {};

const FilterTrial& trial(const ShadingStudy& study, const char* name) {
  return *std::find_if(study.filters.begin(), study.filters.end(),
                       [&](const FilterTrial& t) { return t.name == name; });
}

TEST_F(shading_study, levels_that_fit_the_footprint_are_nearer_to_supersampling) {
  const ShadingStudy study = study_shading(*test_device(), {.width = 96, .height = 64, .samples = 8, .repetitions = 1});
  const FilterTrial &nearest = trial(study, "nearest"), &bilinear = trial(study, "bilinear"),
                    &trilinear = trial(study, "trilinear"), &many = trial(study, "anisotropic=16"),
                    &rip = trial(study, "ripmap");
  EXPECT_GT(nearest.error, bilinear.error);
  EXPECT_GT(bilinear.error, 1.5 * rip.error);
  EXPECT_GT(trilinear.error, 1.2 * rip.error);
  EXPECT_GT(rip.error_turned, 1.05 * rip.error) << "the footprint lies along neither axis";
  EXPECT_LT(many.error, 0.5 * bilinear.error) << "how far below is the device's";
  EXPECT_GT(rip.error, 0.001) << "the truth is not the picture itself";
  constexpr std::uint64_t image = 4 * 256 * 256;
  EXPECT_GE(rip.texel_bytes, 4 * image);
  EXPECT_LT(trilinear.texel_bytes, image * 3 / 2);
  ASSERT_EQ(study.normals.size(), 2u);
  EXPECT_EQ(trilinear.milliseconds.size(), 1u) << "the first picture compiles shaders and does not count";
  for (const NormalTrial& normals : study.normals) {
    EXPECT_EQ(normals.milliseconds.size(), 1u);
    EXPECT_EQ(normals.milliseconds_mapped.size(), 1u);
  }
}

}  // namespace
}  // namespace sinew::viewer
