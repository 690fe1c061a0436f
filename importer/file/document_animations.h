// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "runtime/base/index.h"

/// The part of gltf::Document (document.h) that holds animations.
namespace sinew::gltf {

struct AnimationSampler {
  std::uint32_t input = kNone, output = kNone;
  std::string interpolation = "LINEAR";
};

struct AnimationChannel {
  std::uint32_t sampler = kNone, node = kNone;
  std::string path;
  std::string pointer;  ///< KHR_animation_pointer: an RFC 6901 pointer into the document
};

struct Animation {
  std::string name;
  std::vector<AnimationSampler> samplers;
  std::vector<AnimationChannel> channels;
  nlohmann::json extras = {};  ///< null if it has no events and no curves
};

}  // namespace sinew::gltf
