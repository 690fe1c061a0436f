// SPDX-License-Identifier: MIT
#include "viewer/study/occlusion_study.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "runtime/base/contract.h"
#include "viewer/app/headless.h"

namespace sinew::viewer {
namespace {

OcclusionTrial trial(std::string name, OcclusionShape shape, bool blur, std::string note) {
  OcclusionTrial made;
  made.name = std::move(name);
  made.note = std::move(note);
  made.shape = shape;
  made.blur = blur;
  made.is_default = shape == OcclusionShape{} && blur;
  return made;
}

std::vector<OcclusionTrial> trials_of(bool every_way) {
  using Samples = std::vector<std::uint32_t>;
  std::vector<OcclusionTrial> trials;
  for (const std::uint32_t samples : every_way ? Samples{4, 8, 14, 24, 32, 64} : Samples{4, 14, 64})
    trials.push_back(trial(std::to_string(samples) + " samples", {.samples = samples}, true,
                           "at half size, blurred on each surface"));
  for (const std::uint32_t samples : every_way ? Samples{4, 14, 32, 64} : Samples{14})
    trials.push_back(trial(std::to_string(samples) + " full size", {.samples = samples, .step = 1}, true,
                           "for every pixel, blurred on each surface"));
  trials.push_back(trial("14 no blur", {}, false, "at half size, as the samples are"));
  if (!every_way) return trials;
  trials.push_back(trial("14 plain blur", {.keep_edges = false}, true, "at half size, blurred across edges"));
  trials.push_back(
      trial("14 wide blur", {.blur_reach = 4}, true, "at half size, blurred twice as far on each surface"));
  return trials;
}

/// Renders with one set of options, repeatedly.
class Drawing {
 public:
  Drawing(Device& device, const Scene& scene, const OcclusionEffort& effort, const OcclusionTrial& trial,
          const AmbientOcclusion& settings)
      : headless_(device, scene, effort.width, effort.height, trial.shape) {
    options_.show = Show::ao;
    options_.ao = settings;
    options_.ao.on = true;
    options_.ao.blur = trial.blur;
    options_.transparent_background = true;
  }

  Picture draw(const FrameResult& frame, const View& view) { return headless_.render(frame, view, options_); }

  /// Time of the ambient occlusion passes in the last picture; negative without timestamps.
  double milliseconds() const {
    double sum = 0.0;
    for (const PassTime& time : headless_.pass_times())
      for (const Pass pass : {Pass::ssao, Pass::blur_horizontal, Pass::blur_vertical})
        if (time.pass == name_of(pass)) sum += time.milliseconds;
    return headless_.pass_times().empty() ? -1.0 : sum;
  }

 private:
  Headless headless_;
  RenderOptions options_;
};

struct Difference {
  std::uint64_t pixels = 0;
  double squares = 0.0;
  double root_mean() const { return pixels > 0 ? std::sqrt(squares / static_cast<double>(pixels)) : 0.0; }
};

/// Compares the pixels that show a surface both in the picture and to the rays; at outlines the two may differ.
template <class Access>
Difference difference_of(const Picture& picture, const std::vector<double>& truth, const Access& access) {
  Difference d;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] < 0.0 || picture.rgba[4 * i + 3] == 0) continue;
    const double off = access(picture.rgba[4 * i]) - truth[i];
    d.squares += off * off;
    ++d.pixels;
  }
  return d;
}

}  // namespace

std::vector<double> true_access(const RayCaster& rays, const View& view, std::uint32_t width, std::uint32_t height,
                                double radius_m, int ray_count) {
  CONTRACT(!view.parallel());
  const glm::dvec3 eye = eye_of(view);
  const double slope_y = std::tan(0.5 * view.fov_y_rad), slope_x = slope_y * width / height;
  std::vector<double> access;
  access.reserve(std::size_t{width} * height);
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) {
      const glm::dvec3 in_view((2.0 * (x + 0.5) / width - 1.0) * slope_x, (1.0 - 2.0 * (y + 0.5) / height) * slope_y,
                               -1.0);
      glm::dvec3 direction(0.0);  // the rotation of the view: its inverse is its transpose
      for (int r = 0; r < 3; ++r) direction += in_view[r] * glm::dvec3(view.view_from_world.row[r]);
      const auto seen = rays.seen(eye, direction);
      access.push_back(seen ? rays.open_share(*seen, radius_m, ray_count) : -1.0);
    }
  return access;
}

OcclusionStudy study_occlusion(Device& device, const Scene& scene, const FrameResult& frame, const View& view,
                               const AmbientOcclusion& settings, const OcclusionEffort& effort) {
  OcclusionStudy study{device.name(),
                       effort.width,
                       effort.height,
                       0,
                       0.0,
                       static_cast<double>(settings.radius_m),
                       trials_of(effort.every_way)};
  const std::vector<double> truth =
      true_access(RayCaster(scene, frame), view, effort.width, effort.height, study.radius_m, effort.rays);
  std::vector<std::unique_ptr<Drawing>> drawings;
  std::vector<std::size_t> order;
  for (OcclusionTrial& trial : study.trials) {
    drawings.push_back(std::make_unique<Drawing>(device, scene, effort, trial, settings));
    const Picture picture = drawings.back()->draw(frame, view);
    const Difference off = difference_of(picture, truth, [](std::uint8_t grey) { return grey / 255.0; });
    trial.error = off.root_mean();
    study.pixels = off.pixels;
    study.error_without = difference_of(picture, truth, [](std::uint8_t) { return 1.0; }).root_mean();
    order.push_back(order.size());
  }
  std::mt19937 random(1);
  for (int repetition = 0; repetition < effort.repetitions; ++repetition) {
    std::shuffle(order.begin(), order.end(), random);
    for (const std::size_t i : order) {
      drawings[i]->draw(frame, view);
      if (const double ms = drawings[i]->milliseconds(); ms >= 0.0) study.trials[i].milliseconds.push_back(ms);
    }
  }
  return study;
}

}  // namespace sinew::viewer
