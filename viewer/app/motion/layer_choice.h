// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/model/scene.h"
#include "viewer/app/motion/motion_settings.h"

namespace sinew::viewer {

/// A layer of the command line: "CLIP[,weight=W][,mask=JOINT][,mirror][,add|,add-start]".
struct LayerText {
  std::string clip, mask;  ///< `mask` is the name of a joint; empty = all joints
  float weight = 1.0f;
  bool mirrored = false;
  LayerUse use = LayerUse::cover;
};

/// err  one sentence that quotes the faulty part
tl::expected<LayerText, std::string> parse_layer(std::string_view text);

/// Finds clip and joint of each layer in a scene.
/// err  one sentence: a clip or joint that the scene lacks
tl::expected<std::vector<LayerSetting>, std::string> find_layers(const std::vector<LayerText>& layers,
                                                                 const Scene& scene);

/// Removes layers of clips and joints that a scene does not have, and morph weights if it has another number of them.
void keep_layers_of(const Scene& scene, MotionSettings& settings);

}  // namespace sinew::viewer
