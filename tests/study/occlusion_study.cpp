// SPDX-License-Identifier: MIT
#include "tests/study/occlusion_study.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <random>

#include "importer/ambient/access_surfaces.h"
#include "viewer/app/headless.h"
#include "tests/study/exhaustive_access.h"

namespace sinew::viewer {
namespace {

OcclusionTrial trial(std::string name, OcclusionMethod method, OcclusionShape shape, bool blur, std::string note) {
  OcclusionTrial made;
  made.name = std::move(name);
  made.note = std::move(note);
  made.method = method;
  made.shape = shape;
  made.blur = blur;
  made.is_default = method == AmbientOcclusion{}.method && shape == OcclusionShape{} && blur;
  return made;
}

OcclusionTrial points(OcclusionShape shape) {
  const bool full = shape.step == 1;
  return trial(
      std::to_string(shape.samples) + (full ? " full size" : " samples"), OcclusionMethod::ssao, shape, true,
      full ? "points, for every pixel, blurred on each surface" : "points, at half size, blurred on each surface");
}

std::string slices_of(const OcclusionShape& shape) {
  return std::to_string(shape.slices) + (shape.slices == 1 ? " slice of " : " slices of ") +
         std::to_string(2 * shape.steps);
}

OcclusionTrial horizons(OcclusionShape shape) {
  const bool full = shape.step == 1;
  return trial(
      slices_of(shape) + (full ? " full size" : ""), OcclusionMethod::gtao, shape, true,
      full ? "horizons, for every pixel, blurred on each surface" : "horizons, at half size, blurred on each surface");
}

OcclusionTrial other_blur(const std::string& which, OcclusionShape shape, bool blur, const std::string& note) {
  return trial(slices_of(shape) + which, OcclusionMethod::gtao, shape, blur, "horizons, at half size, " + note);
}

std::vector<OcclusionTrial> trials_of(bool every_way) {
  std::vector<OcclusionTrial> trials;
  for (const std::uint32_t samples : {4u, 14u, 64u}) trials.push_back(points({.samples = samples}));
  trials.push_back(points({.step = 1}));
  trials.push_back(horizons({.slices = 1}));
  trials.push_back(horizons({}));
  trials.push_back(horizons({.step = 1}));
  trials.push_back(other_blur(" no blur", {}, false, "as the slices are"));
  if (!every_way) return trials;
  for (const std::uint32_t samples : {8u, 32u}) trials.push_back(points({.samples = samples}));
  for (const auto& [slices, steps] :
       std::array<std::pair<std::uint32_t, std::uint32_t>, 4>{{{1, 4}, {2, 4}, {4, 6}, {8, 8}}})
    trials.push_back(horizons({.slices = slices, .steps = steps}));
  trials.push_back(other_blur(" plain blur", {.keep_edges = false}, true, "blurred across edges"));
  trials.push_back(other_blur(" wide blur", {.blur_reach = 4}, true, "blurred twice as far on each surface"));
  return trials;
}

/// Root mean square difference over the pixels that show a surface.
double root_mean_square(const std::vector<double>& access, const std::vector<double>& truth) {
  double squares = 0.0;
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] < 0.0) continue;
    squares += (access[i] - truth[i]) * (access[i] - truth[i]);
    ++pixels;
  }
  return pixels > 0 ? std::sqrt(squares / static_cast<double>(pixels)) : 0.0;
}

/// Renders with one set of options, repeatedly.
class Drawing {
 public:
  Drawing(Device& device, const Scene& scene, const OcclusionEffort& effort, const OcclusionTrial& trial,
          const AmbientOcclusion& settings, const VertexAccess* access = nullptr)
      : headless_(device, scene, effort.width, effort.height, trial.shape, access) {
    options_.show = Show::ao;
    options_.ao = settings;
    options_.ao.method = trial.method;
    options_.ao.on = true;
    options_.ao.blur = trial.blur;
    options_.transparent_background = true;
  }

  Picture draw(const FrameResult& frame, const View& view) { return headless_.render(frame, view, options_); }

  std::optional<double> milliseconds() const { return occlusion_time_ms(headless_.pass_times()); }

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

/// Root mean square difference over the vertices of all meshes.
double difference_of(const MeshAccess& a, const MeshAccess& b) {
  Difference d;
  for (std::size_t m = 0; m < a.size(); ++m)
    for (std::size_t p = 0; p < a[m].size(); ++p)
      for (std::size_t v = 0; v < a[m][p].size(); ++v, ++d.pixels) {
        const double off = static_cast<double>(a[m][p][v]) - static_cast<double>(b[m][p][v]);
        d.squares += off * off;
      }
  return d.root_mean();
}

/// Bakes with several numbers of rays that reach as far as those of the pixels.
std::vector<VertexTrial> study_vertices(Device& device, const Scene& scene, const FrameResult& frame, const View& view,
                                        const AmbientOcclusion& settings, const OcclusionEffort& effort,
                                        const std::vector<double>& truth) {
  constexpr std::size_t kMostVertices = 20000;  // 4,096 rays each take a minute
  std::size_t vertices = 0;
  for (const PlacedSurface& placed : surfaces_of(scene, frame)) vertices += placed.surface.positions.size();
  if (vertices == 0 || vertices > kMostVertices) return {};
  const double reach = static_cast<double>(settings.radius_m);
  const MeshAccess exact = bake_mesh_access(scene, frame, {.rays = 4096, .distance_m = reach});
  std::vector<VertexTrial> trials;
  for (const std::uint32_t rays :
       effort.every_way ? std::vector<std::uint32_t>{16, 64, 256, 1024} : std::vector<std::uint32_t>{64, 256}) {
    const auto start = std::chrono::steady_clock::now();
    VertexAccess access;
    access.values = bake_mesh_access(scene, frame, {.rays = rays, .distance_m = reach, .seed = 2});
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    OcclusionTrial drawn;
    drawn.method = OcclusionMethod::rays;
    const Picture picture = Drawing(device, scene, effort, drawn, settings, &access).draw(frame, view);
    const Difference off = difference_of(picture, truth, [](std::uint8_t grey) { return grey / 255.0; });
    trials.push_back({rays, difference_of(access.values, exact), off.root_mean(), seconds});
  }
  return trials;
}

}  // namespace

std::optional<double> occlusion_time_ms(std::span<const PassTime> times) {
  if (times.empty()) return std::nullopt;
  double sum = 0.0;
  for (const PassTime& time : times)
    for (const Pass pass : {Pass::ssao, Pass::blur_horizontal, Pass::blur_vertical})
      if (time.pass == name_of(pass)) sum += time.milliseconds;
  return sum;
}

std::vector<double> true_access(const RayCaster& rays, const SeenPixels& seen, double radius_m, int ray_count) {
  std::vector<double> access;
  for (const auto& pixel : seen.pixels) access.push_back(pixel ? rays.open_share(*pixel, radius_m, ray_count) : -1.0);
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
  const RayCaster rays(scene, frame);
  const SeenPixels seen = seen_pixels(rays, view, effort.width, effort.height);
  const std::vector<double> truth = true_access(rays, seen, study.radius_m, effort.rays);
  if (effort.exhaustive)
    for (const double thickness : {0.0, 0.1, 0.2, 0.3})
      study.exhaustive.push_back(
          {thickness, root_mean_square(exhaustive_access(seen, view, study.radius_m, thickness), truth)});
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
  study.at_vertices = study_vertices(device, scene, frame, view, settings, effort, truth);
  std::mt19937 random(1);
  for (int repetition = 0; repetition < effort.repetitions; ++repetition) {
    std::shuffle(order.begin(), order.end(), random);
    for (const std::size_t i : order) {
      drawings[i]->draw(frame, view);
      if (const auto ms = drawings[i]->milliseconds()) study.trials[i].milliseconds.push_back(*ms);
    }
  }
  return study;
}

}  // namespace sinew::viewer
