// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace sinew::viewer {

/// What a key does in the window.
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
  toggle_panel,
  toggle_plan,
  quit
};

/// One row of the key table. --help, the panel and the window read the same table.
struct KeyBinding {
  int key;  ///< GLFW key code: ASCII capital for letters
  Action action;
  std::string_view name;  ///< "space"
  std::string_view meaning;
};

std::span<const KeyBinding> key_bindings() noexcept;

/// The action of a key; nothing when the key has none.
std::optional<Action> action_of_key(int key) noexcept;

/// The key table and the mouse buttons as text for --help, one line each.
std::string describe_keys();

}  // namespace sinew::viewer
