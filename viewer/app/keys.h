// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace sinew::viewer {

/// What a key of the window does.
enum class Action {
  toggle_play,
  step_back,
  step_forward,
  faster,
  slower,
  next_clip,
  previous_clip,
  next_scene,
  toggle_ao,
  toggle_ao_only,
  next_show,
  toggle_skeleton,
  next_skinning,
  next_updates,
  toggle_loop,
  frame_all,
  toggle_panel,
  toggle_plan,
  quit
};

/// One row of the key table, which --help, the panel and the window all read.
struct KeyBinding {
  int key;  ///< GLFW key code: ASCII capital for letters
  Action action;
  std::string_view name;  ///< "space"
  std::string_view meaning;
};

std::span<const KeyBinding> key_bindings() noexcept;

/// The action of a key, nothing when it has none.
std::optional<Action> action_of_key(int key) noexcept;

/// The key table and the mouse as text, one line each, for --help.
std::string describe_keys();

}  // namespace sinew::viewer
