// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "runtime/model/scene.h"

namespace sinew::test {

/// A scene whose results are stored as hashes.
struct GoldenScene {
  std::string name;
  Scene scene;
};

/// A biped, a tree, random scenes with every kind of track, skin and morph target, and a scene of collapsing joints.
/// All numbers are rounded to multiples of 2^-16. So they do not depend on the last bits of a machine's sine and log.
std::vector<GoldenScene> golden_scenes();

/// Times at which each clip is sampled, in seconds: at keys, between keys, outside the clip.
inline constexpr double kGoldenTimes_s[] = {0.0, 1.0 / 60, 0.4, 0.75, 1.3125, 1.9, 2.5};

}  // namespace sinew::test
