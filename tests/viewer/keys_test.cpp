// SPDX-License-Identifier: MIT
#include "viewer/app/keys.h"

#include <set>
#include <sstream>
#include <string>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace sinew::viewer {
namespace {

TEST(keys, codes_are_those_of_glfw) {
  EXPECT_EQ(action_of_key(GLFW_KEY_SPACE), Action::toggle_play);
  EXPECT_EQ(action_of_key(GLFW_KEY_LEFT), Action::step_back);
  EXPECT_EQ(action_of_key(GLFW_KEY_RIGHT), Action::step_forward);
  EXPECT_EQ(action_of_key(GLFW_KEY_UP), Action::faster);
  EXPECT_EQ(action_of_key(GLFW_KEY_DOWN), Action::slower);
  EXPECT_EQ(action_of_key(GLFW_KEY_TAB), Action::next_scene);
  EXPECT_EQ(action_of_key(GLFW_KEY_ESCAPE), Action::quit);
  EXPECT_EQ(action_of_key(GLFW_KEY_Q), Action::quit);
  EXPECT_EQ(action_of_key(GLFW_KEY_A), Action::toggle_ao);
  EXPECT_EQ(action_of_key(GLFW_KEY_G), Action::next_ground);
  EXPECT_EQ(action_of_key(GLFW_KEY_U), Action::next_updates);
  EXPECT_EQ(action_of_key(GLFW_KEY_Z), std::nullopt);
}

TEST(keys, no_key_does_two_things_and_every_key_is_described) {
  std::set<int> keys;
  std::set<std::string_view> names;
  const std::string text = describe_keys();
  for (const auto& binding : key_bindings()) {
    EXPECT_TRUE(keys.insert(binding.key).second) << binding.name;
    EXPECT_TRUE(names.insert(binding.name).second) << binding.name;
    EXPECT_NE(text.find(std::string(binding.name) + " "), std::string::npos);
    EXPECT_NE(text.find(binding.meaning), std::string::npos);
    EXPECT_LT(binding.name.size(), 10u);  // fits its column
  }
}

TEST(keys, are_described_in_two_columns) {
  std::istringstream lines(describe_keys());
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    ASSERT_GT(line.size(), 12u);
    EXPECT_EQ(line.substr(0, 2), "  ");
    EXPECT_NE(line[2], ' ') << line;
    EXPECT_EQ(line[11], ' ') << line;
    EXPECT_NE(line[12], ' ') << line;
  }
  EXPECT_EQ(count, key_bindings().size() + 2) << "and the mouse";
}

}  // namespace
}  // namespace sinew::viewer
