// SPDX-License-Identifier: MIT
#include "viewer/app/keys.h"

#include <array>

namespace sinew::viewer {
namespace {

// Key codes of GLFW 3, repeated because only window.cpp and panel_backend.cpp may include glfw3.h.
constexpr int kSpace = 32, kEscape = 256, kRight = 262, kLeft = 263, kDown = 264, kUp = 265;

constexpr std::array kBindings{
    KeyBinding{kSpace, Action::toggle_play, "space", "play / pause"},
    KeyBinding{kLeft, Action::step_back, "left", "one frame back (pauses)"},
    KeyBinding{kRight, Action::step_forward, "right", "one frame forward (pauses)"},
    KeyBinding{kUp, Action::faster, "up", "faster"},
    KeyBinding{kDown, Action::slower, "down", "slower"},
    KeyBinding{'L', Action::toggle_loop, "l", "loop: repeat, there and back, once, all clips in turn"},
    KeyBinding{'N', Action::next_clip, "n", "next clip"},
    KeyBinding{'P', Action::previous_clip, "p", "previous clip"},
    KeyBinding{'D', Action::next_skinning, "d", "skinning: linear / dual quaternion / center of rotation"},
    KeyBinding{'U', Action::next_updates, "u", "what is small: every frame / interpolated / held between updates"},
    KeyBinding{'A', Action::toggle_ao, "a", "ambient occlusion on / off"},
    KeyBinding{'O', Action::toggle_ao_only, "o", "show ambient occlusion only"},
    KeyBinding{'V', Action::next_show, "v", "show color, ao, normals, depth, level in turn"},
    KeyBinding{'G', Action::next_ground, "g", "ground: none / shadows / grid"},
    KeyBinding{'S', Action::toggle_skeleton, "s", "skeleton on / off"},
    KeyBinding{'F', Action::frame_all, "f", "frame everything"},
    KeyBinding{'C', Action::screenshot, "c", "write what is shown to sinew-0001.png and so on"},
    KeyBinding{258, Action::next_scene, "tab", "next showcase scene"},
    KeyBinding{'E', Action::toggle_plan, "e", "what each frame evaluates: the live plan on / off"},
    KeyBinding{'T', Action::toggle_keys, "t", "timeline: keys and curves on / off"},
    KeyBinding{'I', Action::toggle_inside, "i", "look inside: nodes, joints, vertices; a click on the model picks one"},
    KeyBinding{'H', Action::toggle_panel, "h", "panel on / off"},
    KeyBinding{kEscape, Action::quit, "esc", "close"},
    KeyBinding{'Q', Action::quit, "q", "close"},
};

}  // namespace

std::span<const KeyBinding> key_bindings() noexcept { return kBindings; }

std::optional<Action> action_of_key(int key) noexcept {
  for (const auto& binding : kBindings)
    if (binding.key == key) return binding.action;
  return std::nullopt;
}

std::string describe_keys() {
  std::string text;
  for (const auto& binding : kBindings) {
    text += "  " + std::string(binding.name);
    text.append(10 - binding.name.size(), ' ');
    text += std::string(binding.meaning) + "\n";
  }
  return text +
         "  drag      left button: turn; right or middle button, or shift + left: move\n"
         "  wheel     nearer / farther\n";
}

}  // namespace sinew::viewer
