// SPDX-License-Identifier: MIT
// What `sinew cost` refuses before it measures anything.
#include <gtest/gtest.h>

#include <string>

#include "tests/importer/tool_model.h"

namespace sinew::test {
namespace {

TEST(cost_command, refuses_a_clip_of_what_has_none) {
  const ToolModelFile model;
  const std::string cache = model.beside("talk.sgeo"), folder = model.beside("costs");
  EXPECT_EQ(run_tool({"cost", "-o", folder, "--clip", "0"}).err,
            "sinew: --clip: names a clip of FILE, and there is no FILE\n");
  ASSERT_EQ(run_tool({"bake", model.path(), "--clip", "talk", "-o", cache}).status, 0);
  const CommandOutcome outcome = run_tool({"cost", cache, "-o", folder, "--clip", "0"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "sinew: --clip: names a clip of a glTF file, and FILE is none\n");
}

}  // namespace
}  // namespace sinew::test
