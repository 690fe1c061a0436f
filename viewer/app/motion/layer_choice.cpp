// SPDX-License-Identifier: MIT
#include "viewer/app/motion/layer_choice.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viewer/app/option_text.h"
#include "viewer/app/scene_choice.h"

namespace sinew::viewer {
namespace {

constexpr float kMostWeight = 1e6f;

}  // namespace

tl::expected<LayerText, std::string> parse_layer(std::string_view text) {
  LayerText layer;
  std::size_t at = text.find(',');
  layer.clip = text.substr(0, at);
  while (at != std::string_view::npos) {
    text.remove_prefix(at + 1);
    at = text.find(',');
    const std::string_view part = text.substr(0, at);
    if (part == "mirror") {
      layer.mirrored = true;
    } else if (part == "add") {
      layer.use = LayerUse::add_to_rest;
    } else if (part == "add-start") {
      layer.use = LayerUse::add_to_start;
    } else if (part.starts_with("mask=")) {
      layer.mask = part.substr(5);
    } else if (part.starts_with("weight=")) {
      const auto weight = number<float>(part.substr(7));
      if (!weight || std::abs(*weight) > kMostWeight) return tl::unexpected("'" + std::string(part) + "' is no weight");
      layer.weight = *weight;
    } else {
      return tl::unexpected("'" + std::string(part) + "' is none of weight=W, mask=JOINT, mirror, add, add-start");
    }
  }
  if (layer.clip.empty()) return tl::unexpected(std::string("a layer begins with its clip"));
  if (layer.use == LayerUse::cover && (layer.weight < 0.0f || layer.weight > 1.0f))
    return tl::unexpected(std::string("the weight of a layer that covers is from 0 to 1; add takes others, too"));
  return layer;
}

tl::expected<std::vector<LayerSetting>, std::string> find_layers(const std::vector<LayerText>& layers,
                                                                 const Scene& scene) {
  std::vector<LayerSetting> found;
  for (const LayerText& layer : layers) {
    const auto clip = choose_clip(scene, layer.clip);
    if (!clip || *clip == kNone)
      return tl::unexpected("--layer: " + describe_missing_clip(scene, layer.clip).substr(7));
    LayerSetting setting{*clip, layer.weight, kNone, layer.mirrored, layer.use};
    if (!layer.mask.empty()) {
      const auto joint = scene.skeleton.find(layer.mask);
      if (!joint) return tl::unexpected("--layer: mask=" + layer.mask + ": the scene has no such joint");
      setting.mask = *joint;
    }
    found.push_back(setting);
  }
  return found;
}

void keep_layers_of(const Scene& scene, MotionSettings& settings) {
  std::erase_if(settings.layers, [&](const LayerSetting& layer) {
    return layer.clip >= scene.animations.size() || (layer.mask != kNone && layer.mask >= scene.skeleton.joint_count());
  });
  if (settings.morph_weights.size() != scene.weight_count()) settings.morph_weights.clear();
}

}  // namespace sinew::viewer
