// SPDX-License-Identifier: MIT
#include "viewer/app/clip_choice.h"

#include <charconv>

namespace sinew::viewer {

std::optional<std::uint32_t> choose_clip(const Scene& scene, std::string_view text) {
  if (text == "none") return kNone;
  std::uint32_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error == std::errc() && end == text.data() + text.size() && index < scene.animations.size()) return index;
  for (std::size_t i = 0; i < scene.animations.size(); ++i)
    if (scene.animations[i].name == text) return static_cast<std::uint32_t>(i);
  return std::nullopt;
}

std::string describe_missing_clip(const Scene& scene, std::string_view text) {
  const std::string message = "--clip " + std::string(text) + ": no such clip; the scene has ";
  if (scene.animations.empty()) return message + "none";
  constexpr std::size_t kShown = 12;
  std::string list;
  for (std::size_t i = 0; i < scene.animations.size() && i < kShown; ++i)
    list += (i ? ", " : "") + std::to_string(i) + " \"" + scene.animations[i].name + "\"";
  return message + list + (scene.animations.size() > kShown ? ", ..." : "");
}

std::string clip_label(const Scene& scene, std::uint32_t clip) {
  if (clip >= scene.animations.size()) return "rest pose";
  const auto& name = scene.animations[clip].name;
  return name.empty() ? "(unnamed)" : name;
}

}  // namespace sinew::viewer
