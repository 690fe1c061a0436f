// SPDX-License-Identifier: MIT
// Limits of the options that take numbers: each limit is accepted, the next number beyond it is refused.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/importer/tool_model.h"

namespace sinew::test {
namespace {

using Words = std::vector<std::string>;

/// An option of a command line whose file is missing: 1 says that the option was taken, 2 that it was not.
struct Limits {
  Words command;
  const char* option;
  Words taken, refused;
};

TEST(tool_limits, numbers_are_taken_up_to_their_limits_and_not_beyond) {
  const ToolModelFile model;
  const std::string missing = model.beside("missing.glb"), out = model.beside("out");
  const std::vector<Limits> table = {
      {{"bake", missing, "-o", out}, "--fps", {"0.001", "1000000"}, {"0.0009", "1000001", "0", "-1", "x"}},
      {{"bake", missing, "-o", out}, "--segment", {"1", "10000"}, {"0", "10001", "1.5"}},
      {{"bake", missing, "-o", out},
       "--normals",
       {"45deg", "45", "0.001deg"},
       {"45.01deg", "0deg", "-1deg", "1degg", "1 rad", "inf", "nan", "deg"}},
      {{"bake", missing, "-o", out}, "--colors", {"1e-9", "2"}, {"0", "-0.1", "inf", "0.1deg", "x"}},
      {{"compile", missing, "-o", out}, "--page", {"0.1", "3600"}, {"0.09", "3601"}},
      {{"compile", missing, "-o", out}, "--zstd", {"1", "19"}, {"0", "20"}},
      {{"convert", missing, out + ".glb"}, "--fps", {"0.001", "1000000"}, {"0.0009", "1000001"}},
      {{"plan", missing}, "--layers", {"1", "64"}, {"0", "65"}},
      {{"plan", missing}, "--jobs", {"1", "256"}, {"0", "257"}},
      {{"sample", missing}, "--fps", {"0.001", "1000"}, {"0", "-1"}},
      {{"sample", missing}, "--vertices", {"0", "1", "all"}, {"-1", "some", "1.5", "1x"}}};
  for (const Limits& limits : table) {
    const auto status = [&](const std::string& value) {
      Words arguments = limits.command;
      arguments.push_back(limits.option + ("=" + value));
      return run_tool(arguments).status;
    };
    for (const std::string& value : limits.taken)
      EXPECT_EQ(status(value), 1) << limits.command[0] << limits.option << value;
    for (const std::string& value : limits.refused)
      EXPECT_EQ(status(value), 2) << limits.command[0] << limits.option << value;
  }
}

TEST(tool_limits, commands_take_as_many_arguments_as_they_name) {
  const ToolModelFile model;
  const std::string missing = model.beside("missing.glb"), out = model.beside("out.glb");
  for (const char* command : {"info", "check", "plan"}) {
    EXPECT_EQ(run_tool({command, missing}).status, 1) << command;
    EXPECT_EQ(run_tool({command, missing, missing, missing}).status, 1) << command;
  }
  EXPECT_EQ(run_tool({"convert", missing, out}).status, 1);
  EXPECT_EQ(run_tool({"convert", missing}).status, 2);
  EXPECT_EQ(run_tool({"verify", missing, out}).status, 4);
  EXPECT_EQ(run_tool({"bake", missing, missing, "-o", out}).status, 2);
  EXPECT_EQ(run_tool({"bake", missing}).status, 2);
}

}  // namespace
}  // namespace sinew::test
