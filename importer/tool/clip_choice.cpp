// SPDX-License-Identifier: MIT
#include "importer/tool/clip_choice.h"

#include <charconv>
#include <numeric>
#include <string_view>

#include <fmt/core.h>

#include "importer/tool/messages.h"
#include "runtime/model/numbered_name.h"

namespace sinew::tool {
namespace {

std::optional<std::uint32_t> whole_number(const std::string& text) {
  std::uint32_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return number;
}

/// Finds a clip by its name and its number among the clips of that name, counted from 1.
std::optional<std::uint32_t> find_clip(const Scene& scene, std::string_view name, std::uint32_t number) {
  for (std::uint32_t i = 0; i < scene.animations.size(); ++i)
    if (scene.animations[i].name == name && --number == 0) return i;
  return std::nullopt;
}

}  // namespace

std::string list_of_clips(const Scene& scene) {
  if (scene.animations.empty()) return "the file has no clips";
  constexpr std::size_t kShown = 12;
  std::string list = fmt::format("the file has {}:", counted(scene.animations.size(), "clip"));
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
  if (const auto clip = find_clip(scene, *wanted, 1)) return ClipChoice{*clip};
  if (const auto numbered = parse_numbered_name(*wanted))
    if (const auto clip = find_clip(scene, numbered->name, numbered->number)) return ClipChoice{*clip};
  return tl::unexpected(fmt::format("--clip {}: no such clip; {}", *wanted, list_of_clips(scene)));
}

}  // namespace sinew::tool
