// SPDX-License-Identifier: MIT
#include "viewer/app/scene_choice.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include "runtime/model/numbered_name.h"

namespace sinew::viewer {
namespace {

struct Choice {
  std::uint32_t index;
  std::string_view name;
};

std::vector<Choice> clips(const Scene& scene) {
  std::vector<Choice> choices;
  for (std::uint32_t i = 0; i < scene.animations.size(); ++i) choices.push_back({i, scene.animations[i].name});
  return choices;
}

std::vector<Choice> cameras_on_nodes(const Scene& scene) {
  std::vector<Choice> choices;
  for (std::uint32_t i = 0; i < scene.cameras.size(); ++i)
    if (scene.cameras[i].joint != kNone) choices.push_back({i, scene.cameras[i].name.str()});
  return choices;
}

std::vector<Choice> variants(const Scene& scene) {
  std::vector<Choice> choices;
  for (std::uint32_t i = 0; i < scene.variants.size(); ++i) choices.push_back({i, scene.variants[i]});
  return choices;
}

std::vector<Choice> joints(const Scene& scene) {
  std::vector<Choice> choices;
  for (std::uint32_t i = 0; i < scene.skeleton.names.size(); ++i) choices.push_back({i, scene.skeleton.names[i]});
  return choices;
}

std::optional<std::uint32_t> choose(const std::vector<Choice>& choices, std::string_view text) {
  std::uint32_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  const bool number = error == std::errc() && end == text.data() + text.size();
  for (const Choice& choice : choices)
    if (number && choice.index == index) return index;
  const auto named = [&](std::string_view name, std::uint32_t place) -> std::optional<std::uint32_t> {
    for (const Choice& choice : choices)
      if (choice.name == name && --place == 0) return choice.index;
    return std::nullopt;
  };
  if (const auto found = named(text, 1)) return found;
  const auto numbered = parse_numbered_name(text);
  return numbered ? named(numbered->name, numbered->number) : std::nullopt;
}

std::optional<std::uint32_t> same(const std::vector<Choice>& before, std::uint32_t index,
                                  const std::vector<Choice>& now) {
  if (index == kNone) return kNone;
  const auto chosen = std::find_if(before.begin(), before.end(), [&](const Choice& c) { return c.index == index; });
  if (chosen == before.end()) return std::nullopt;
  const auto named_alike = [&](const Choice& c) { return c.name == chosen->name; };
  auto earlier = std::count_if(before.begin(), chosen, named_alike);
  for (const Choice& choice : now)
    if (named_alike(choice) && earlier-- == 0) return choice.index;
  return std::nullopt;
}

std::string describe_missing(const char* what, const std::vector<Choice>& choices, std::string_view text) {
  const std::string message =
      std::string("--") + what + " " + std::string(text) + ": no such " + what + "; the scene has ";
  if (choices.empty()) return message + "none";
  constexpr std::size_t kShown = 12;
  std::string list;
  for (std::size_t i = 0; i < choices.size() && i < kShown; ++i)
    list += (i ? ", " : "") + std::to_string(choices[i].index) + " \"" + std::string(choices[i].name) + '"';
  return message + list + (choices.size() > kShown ? ", ..." : "");
}

std::string label(const std::string& name, std::uint32_t index) {
  return name.empty() ? "(unnamed) " + std::to_string(index) : name;
}

}  // namespace

std::optional<std::uint32_t> choose_clip(const Scene& scene, std::string_view text) {
  return text == "none" ? kNone : choose(clips(scene), text);
}
std::optional<std::uint32_t> choose_camera(const Scene& scene, std::string_view text) {
  return choose(cameras_on_nodes(scene), text);
}
std::optional<std::uint32_t> choose_joint(const Scene& scene, std::string_view text) {
  return choose(joints(scene), text);
}
std::optional<std::uint32_t> choose_variant(const Scene& scene, std::string_view text) {
  return choose(variants(scene), text);
}

std::vector<std::string> clip_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const auto& clip : scene.animations) names.push_back(clip.name);
  return names;
}

std::optional<std::uint32_t> same_clip(const std::vector<std::string>& clips_before, std::uint32_t index,
                                       const Scene& now) {
  std::vector<Choice> before;
  for (const std::string& name : clips_before) before.push_back({static_cast<std::uint32_t>(before.size()), name});
  return same(before, index, clips(now));
}
std::optional<std::uint32_t> same_camera(const Scene& before, std::uint32_t index, const Scene& now) {
  return same(cameras_on_nodes(before), index, cameras_on_nodes(now));
}
std::optional<std::uint32_t> same_joint(const Scene& before, std::uint32_t index, const Scene& now) {
  return same(joints(before), index, joints(now));
}
std::optional<std::uint32_t> same_variant(const Scene& before, std::uint32_t index, const Scene& now) {
  return same(variants(before), index, variants(now));
}

std::string describe_missing_clip(const Scene& scene, std::string_view text) {
  return describe_missing("clip", clips(scene), text);
}
std::string describe_missing_camera(const Scene& scene, std::string_view text) {
  return describe_missing("camera", cameras_on_nodes(scene), text);
}
std::string describe_missing_joint(const Scene& scene, std::string_view text) {
  return describe_missing("joint", joints(scene), text);
}
std::string describe_missing_variant(const Scene& scene, std::string_view text) {
  return describe_missing("variant", variants(scene), text);
}

std::string clip_label(const Scene& scene, std::uint32_t clip) {
  return clip < scene.animations.size() ? label(scene.animations[clip].name, clip) : "rest pose";
}
std::string camera_label(const Scene& scene, std::uint32_t camera) {
  return camera < scene.cameras.size() ? label(scene.cameras[camera].name, camera) : "free";
}
std::string variant_label(const Scene& scene, std::uint32_t variant) {
  return variant < scene.variants.size() ? label(scene.variants[variant], variant) : "as in the file";
}

}  // namespace sinew::viewer
