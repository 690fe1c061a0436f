// SPDX-License-Identifier: MIT
// A build without assimp, of which this program links the one source.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "importer/formats/scene_file.h"

namespace sinew::formats {
namespace {

TEST(left_out, fbx_and_collada_are_refused_with_the_reason) {
  ModelDraft draft;
  ImportedFormat summary;
  for (const bool is_fbx : {false, true}) {
    const auto fault = add_scene_file({}, is_fbx, "in", {}, draft, summary);
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->rule, "no-assimp");
    EXPECT_THAT(fault->detail, testing::StartsWith(is_fbx ? "FBX is read by assimp" : "COLLADA is read by assimp"));
    EXPECT_THAT(fault->detail, testing::HasSubstr("libassimp-dev"));
  }
}

}  // namespace
}  // namespace sinew::formats
