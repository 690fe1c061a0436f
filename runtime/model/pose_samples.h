// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/math/conventions.h"

namespace sinew {

/// The part of a joint's rotation that is measured: all of it, the direction of an axis (swing), or the turn about
/// that axis (twist).
enum class RotationMeasure : std::uint8_t { full, swing, twist };

/// A joint whose local rotation drives a corrective.
struct PoseDriver {
  std::uint32_t joint = 0;
  float weight = 1.0f;  ///< factor of its angle in the distance between two poses, >= 0
  RotationMeasure measure = RotationMeasure::full;
  glm::vec3 axis{0.0f, 1.0f, 0.0f};  ///< joint space, any length; for swing and twist
};

/// Radial functions of the distance d between two poses, x = d / radius.
enum class RadialKernel : std::uint8_t {
  linear,      ///< -x: no overshoot along a line of poses, with a kink at each sample
  gaussian,    ///< exp(-x^2): smooth, fades to nothing beyond about 2.5 radii
  thin_plate,  ///< x^2 ln x: biharmonic, least bending, grows far away; use with the affine tail
};

/// A polynomial that is fitted together with the radial functions, so results far from all samples need not fade to
/// zero.
enum class PolynomialTail : std::uint8_t {
  none,
  constant,
  affine,  ///< 1 and, per driver, the sines of its rotation from the first sample: full 3, swing 2, twist 1
};

/// The input of a corrective: sample poses of some joints, and the morph weights wanted in each.
///
/// in   rotations[S * D]  local rotations, sample by sample, any length but zero; the first sample is the neutral
///      weights[M]        indices into the scene's flat array of morph weights (Scene::first_weight)
///      values[S * M]     added to each of these weights in each sample; any sign and size
struct PoseSamples {
  std::string name;
  std::vector<PoseDriver> drivers;  ///< [D] joints that drive the corrective
  std::vector<glm::quat> rotations;
  std::vector<std::uint32_t> weights;
  std::vector<float> values;
  RadialKernel kernel = RadialKernel::gaussian;
  float radius_rad = 1.0f;
  PolynomialTail tail = PolynomialTail::none;
  float regularisation = 0.0f;  ///< added to the diagonal: smooths, and allows samples that are close to each other
  bool partition = false;       ///< weighs samples by shares that are not negative and sum to 1
  bool clamp = false;           ///< limits results to the range of the samples' values

  std::size_t sample_count() const noexcept { return drivers.empty() ? 0 : rotations.size() / drivers.size(); }
};

/// Checks the input of a corrective.
/// err  size_mismatch (no driver, sample or weight, or arrays of wrong length);
///      not_finite (a number, a rotation or axis of length 0, or all driver weights are 0);
///      unsupported (negative driver weight or regularisation, radius <= 0)
SINEW_API ErrorCode check(const PoseSamples& samples) noexcept;

}  // namespace sinew
