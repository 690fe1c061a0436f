// SPDX-License-Identifier: MIT
#include "viewer/app/keys.h"

#include <iterator>
#include <set>
#include <sstream>
#include <string>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace sinew::viewer {
namespace {

struct Bound {
  int key;
  Action action;
  std::string_view name, meaning;  ///< a word of its meaning
};

constexpr Bound kBound[] = {{GLFW_KEY_SPACE, Action::toggle_play, "space", "play"},
                            {GLFW_KEY_LEFT, Action::step_back, "left", "back"},
                            {GLFW_KEY_RIGHT, Action::step_forward, "right", "forward"},
                            {GLFW_KEY_UP, Action::faster, "up", "faster"},
                            {GLFW_KEY_DOWN, Action::slower, "down", "slower"},
                            {GLFW_KEY_L, Action::toggle_loop, "l", "loop"},
                            {GLFW_KEY_N, Action::next_clip, "n", "next clip"},
                            {GLFW_KEY_P, Action::previous_clip, "p", "previous clip"},
                            {GLFW_KEY_D, Action::next_skinning, "d", "skinning"},
                            {GLFW_KEY_U, Action::next_updates, "u", "between updates"},
                            {GLFW_KEY_A, Action::toggle_ao, "a", "ambient occlusion on"},
                            {GLFW_KEY_O, Action::toggle_ao_only, "o", "ambient occlusion only"},
                            {GLFW_KEY_V, Action::next_show, "v", "show color"},
                            {GLFW_KEY_G, Action::next_ground, "g", "ground"},
                            {GLFW_KEY_S, Action::toggle_skeleton, "s", "skeleton"},
                            {GLFW_KEY_F, Action::frame_all, "f", "frame everything"},
                            {GLFW_KEY_C, Action::screenshot, "c", "sinew-0001.png"},
                            {GLFW_KEY_TAB, Action::next_scene, "tab", "next showcase scene"},
                            {GLFW_KEY_E, Action::toggle_plan, "e", "live plan"},
                            {GLFW_KEY_T, Action::toggle_keys, "t", "timeline"},
                            {GLFW_KEY_I, Action::toggle_inside, "i", "look inside"},
                            {GLFW_KEY_H, Action::toggle_panel, "h", "panel"},
                            {GLFW_KEY_ESCAPE, Action::quit, "esc", "close"},
                            {GLFW_KEY_Q, Action::quit, "q", "close"}};

TEST(keys, codes_are_those_of_glfw_and_each_does_what_is_said_of_it) {
  ASSERT_EQ(key_bindings().size(), std::size(kBound));
  for (std::size_t i = 0; i < std::size(kBound); ++i) {
    const KeyBinding& binding = key_bindings()[i];
    EXPECT_EQ(action_of_key(kBound[i].key), kBound[i].action) << binding.name;
    EXPECT_EQ(binding.key, kBound[i].key) << binding.name;
    EXPECT_EQ(binding.name, kBound[i].name);
    EXPECT_NE(binding.meaning.find(kBound[i].meaning), std::string_view::npos) << binding.name;
  }
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
