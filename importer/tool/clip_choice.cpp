// SPDX-License-Identifier: MIT
#include "importer/tool/clip_choice.h"

#include <charconv>
#include <numeric>

#include <fmt/core.h>

namespace sinew::tool {
namespace {

std::optional<std::uint32_t> whole_number(const std::string& text) {
  std::uint32_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return number;
}

}  // namespace

std::string list_of_clips(const Scene& scene) {
  if (scene.animations.empty()) return "the file has no clips";
  constexpr std::size_t kShown = 12;
  std::string list = fmt::format("the file has {} clips:", scene.animations.size());
  for (std::size_t i = 0; i < scene.animations.size() && i < kShown; ++i)
    list += fmt::format("{} {} \"{}\"", i ? "," : "", i, scene.animations[i].name);
  return scene.animations.size() > kShown ? list + ", ..." : list;
}

tl::expected<ClipChoice, std::string> choose_clips(const Scene& scene, const std::optional<std::string>& wanted) {
  const auto count = static_cast<std::uint32_t>(scene.animations.size());
  if (!wanted) {
    ClipChoice all(std::size_t{count} + 1, kNone);
    std::iota(all.begin() + 1, all.end(), 0u);
    return all;
  }
  if (*wanted == "none") return ClipChoice{kNone};
  if (const auto index = whole_number(*wanted); index && *index < count) return ClipChoice{*index};
  for (std::uint32_t i = 0; i < count; ++i)
    if (scene.animations[i].name == *wanted) return ClipChoice{i};
  return tl::unexpected(fmt::format("--clip {}: no such clip; {}", *wanted, list_of_clips(scene)));
}

}  // namespace sinew::tool
