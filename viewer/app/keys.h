// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace sinew::viewer {

/// An action that a key triggers in the window.
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
  next_ground,
  toggle_skeleton,
  next_skinning,
  next_updates,
  toggle_loop,
  frame_all,
  screenshot,
  toggle_panel,
  toggle_plan,
  toggle_keys,
  toggle_inside,
  quit
};

/// One row of the key table, which --help, the panel and the window share.
struct KeyBinding {
  int key;  ///< GLFW key code: the ASCII capital for letters
  Action action;
  std::string_view name;  ///< as shown in help, such as "space"
  std::string_view meaning;
};

std::span<const KeyBinding> key_bindings() noexcept;

/// The action bound to a key; empty if there is none.
std::optional<Action> action_of_key(int key) noexcept;

/// The key table and the mouse buttons as text for --help, one line each.
std::string describe_keys();

}  // namespace sinew::viewer
