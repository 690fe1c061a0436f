// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>
#include <vector>

#include "runtime/base/result.h"
#include "tests/ozz_numbers/tally.h"

namespace sinew::ozz {

using Four = std::array<float, 4>;  ///< a number for each of four joints
using Axes = std::array<Four, 3>;   ///< x, y and z

/// Transforms of four joints, number by number, as the tests of ozz write them.
struct SoaPose {
  Axes translation{};
  std::array<Four, 4> rotation{{{}, {}, {}, {1, 1, 1, 1}}};  ///< x, y, z and w
  Axes scale{{{1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}}};
};

/// Twelve numbers that rise by `step` from `first`: the four of x, then y, then z.
Axes rising(float first, float step = 1.0f);

struct SoaLayer {
  std::vector<SoaPose> pose;
  float weight = 1.0f;
  std::vector<float> joint_weights = {};  ///< one for each joint, or empty
};

/// A blend of ozz: layers are averaged, those below `threshold` in sum with the rest pose, and then differences are
/// added in the joint's frame.
struct SoaBlend {
  std::vector<SoaLayer> layers, additive;
  std::vector<SoaPose> rest;
  double threshold = 0.1;  ///< the default of ozz
};

/// Runs a blend as a pose program.
/// out  as many groups of four joints as `rest`
ErrorCode run(const SoaBlend& blend, std::vector<SoaPose>& out);

/// Numbers to compare with; empty parts are not compared.
struct SoaNumbers {
  std::vector<Axes> translation, scale;
  std::vector<std::array<Four, 4>> rotation;
};

/// Runs a blend, which must be accepted, and counts its numbers.
Tally tally_of(const SoaBlend& blend, const SoaNumbers& expected);

}  // namespace sinew::ozz
