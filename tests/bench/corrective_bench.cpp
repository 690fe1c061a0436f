// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "runtime/pose/correct_pose.h"
#include "tests/bench/measure.h"
#include "tests/reference/pose_corrective.h"
#include "tests/scenes/pose_samples.h"
#include "tests/support/tiny_assets.h"

namespace sinew::bench {
namespace {

/// A solved corrective of joints that may turn any way, and a pose of them.
struct Corrected {
  PoseCorrective corrective;
  test::PoseBuffer pose;
  std::vector<glm::quat> rotations;
  std::vector<double> scratch;
  std::vector<float> weights;

  Corrected(std::uint32_t drivers, std::size_t samples, std::uint32_t weight_count)
      : pose(drivers), weights(weight_count) {
    test::FixedRandom random(drivers);
    PoseSamples given = test::random_samples(random, drivers, samples, weight_count);
    for (PoseDriver& driver : given.drivers) driver.measure = RotationMeasure::full;
    corrective = solve_corrective(std::move(given)).value();
    scratch.resize(scratch_size(corrective));
    for (std::uint32_t d = 0; d < drivers; ++d) {
      rotations.push_back(random.rotation_by(random.in(-2.1, 2.1)));
      Transform t;
      t.rotation = rotations[d];
      pose.span().set(d, t);
    }
  }

  void correct() {
    std::fill(weights.begin(), weights.end(), 0.0f);
    run_unchecked(
        CorrectPoseJob{.corrective = &corrective, .pose = pose.span(), .scratch = scratch, .weights = weights});
  }

  /// The same in plain GLM code: in float, angles by arc cosine, which loses half its digits near a sample.
  void correct_glm() {
    const PoseSamples& samples = corrective.samples;
    const std::size_t drivers = samples.drivers.size();
    std::fill(weights.begin(), weights.end(), 0.0f);
    for (std::size_t s = 0; s < samples.sample_count(); ++s) {
      float squared = 0.0f;
      for (std::size_t d = 0; d < drivers; ++d) {
        const float cosine = std::abs(glm::dot(rotations[d], samples.rotations[s * drivers + d]));
        const float distance =
            samples.drivers[d].weight * 2.0f * std::acos(std::min(cosine, 1.0f)) / samples.radius_rad;
        squared += distance * distance;
      }
      const float basis = std::exp(-squared);
      for (std::size_t w = 0; w < weights.size(); ++w)
        weights[w] += basis * static_cast<float>(corrective.coefficients[s * weights.size() + w]);
    }
  }

  /// Largest error of a weight against long double, relative to the largest value of a sample.
  double error() const {
    reference::Pose turned;
    for (const glm::quat& rotation : rotations) turned.push_back(reference::rotation_of(rotation));
    const auto truth = reference::correct_pose(corrective.samples, turned);
    double worst = 0.0, largest = 0.0;
    for (const float value : corrective.samples.values)
      largest = std::max(largest, std::abs(static_cast<double>(value)));
    for (std::size_t w = 0; w < weights.size(); ++w)
      worst = std::max(worst, std::abs(static_cast<double>(weights[w]) - static_cast<double>(truth[w])));
    return worst / largest;
  }
};

}  // namespace

void add_correctives() {
  for (const auto& [drivers, samples] : {std::pair{1u, 8u}, {4u, 32u}}) {
    const auto corrected = std::make_shared<Corrected>(drivers, samples, 8u);
    const std::string tail = std::to_string(drivers) + "joints/" + std::to_string(samples) + "samples/8weights";
    corrected->correct();
    const double error = corrected->error();
    corrected->correct_glm();
    const double glm_error = corrected->error();
    add("correct_pose/sinew/" + tail, samples, [corrected] { corrected->correct(); }, {error, 0});
    add("correct_pose/glm/" + tail, samples, [corrected] { corrected->correct_glm(); }, {glm_error, 0});
  }
}

}  // namespace sinew::bench
