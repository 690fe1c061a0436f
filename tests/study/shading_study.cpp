// SPDX-License-Identifier: MIT
#include "tests/study/shading_study.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "runtime/base/contract.h"
#include "viewer/app/headless.h"
#include "tests/study/study_scenes.h"
#include "viewer/upload/srgb_codes.h"

namespace sinew::viewer {
namespace {

RenderOptions plain_options(NormalInterpolation normals = NormalInterpolation::interpolated) {
  RenderOptions options;
  options.ao.on = false;
  options.normals = normals;
  options.background = glm::vec3(0.0f);
  return options;
}

/// A scene that is drawn in one way, repeatedly.
class Drawing {
 public:
  Drawing(Device& device, const Still& still, const View& view, std::uint32_t width, std::uint32_t height,
          const TextureFilter& filter, const RenderOptions& options)
      : still_(still),
        view_(view),
        options_(options),
        headless_(device, still.scene, width, height, {}, nullptr, filter) {}

  Picture draw() {
    Picture picture = headless_.render(still_.buffer.result(), view_, options_);
    for (const PassTime& time : headless_.pass_times())
      if (time.pass == name_of(Pass::opaque)) milliseconds_.push_back(time.milliseconds);
    return picture;
  }

  /// The first picture does not count: the driver compiles shaders for it.
  void forget_times() noexcept { milliseconds_.clear(); }
  const std::vector<double>& milliseconds() const noexcept { return milliseconds_; }
  std::uint64_t texel_bytes() const { return headless_.texel_bytes(); }

 private:
  const Still& still_;
  View view_;
  RenderOptions options_;
  Headless headless_;
  std::vector<double> milliseconds_;
};

using Light = std::vector<double>;  ///< [3 * pixels] linear

/// Means of samples x samples pixels.
Light means(const Picture& fine, std::uint32_t samples) {
  const SrgbCodes& codes = srgb_codes();
  const std::uint32_t width = fine.width / samples, height = fine.height / samples;
  Light light(std::size_t{3} * width * height);
  for (std::size_t y = 0; y < std::size_t{height} * samples; ++y)
    for (std::size_t x = 0; x < std::size_t{width} * samples; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        light[3 * (y / samples * width + x / samples) + c] +=
            static_cast<double>(codes.decode(fine.rgba[4 * (y * fine.width + x) + c])) / (samples * samples);
  return light;
}

double root_mean_square(const Light& a, const Light& b) {
  CONTRACT(a.size() == b.size());
  double squares = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) squares += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(squares / static_cast<double>(a.size()));
}

struct NamedFilter {
  const char* name;
  TextureFilter filter;
};

constexpr NamedFilter kFilters[] = {{"nearest", {FilterKind::nearest}},
                                    {"bilinear", {FilterKind::bilinear}},
                                    {"trilinear", {FilterKind::trilinear}},
                                    {"anisotropic=2", {FilterKind::anisotropic, 2}},
                                    {"anisotropic=8", {FilterKind::anisotropic, 8}},
                                    {"anisotropic=16", {FilterKind::anisotropic, 16}},
                                    {"ripmap", {FilterKind::rip_map}}};

void take_turns(std::vector<std::unique_ptr<Drawing>>& drawings, int repetitions) {
  for (auto& drawing : drawings) {
    drawing->draw();
    drawing->forget_times();
  }
  for (int i = 0; i < repetitions; ++i)
    for (auto& drawing : drawings) drawing->draw();
}

/// Errors of all filters on the plane, and their times.
void study_plane(Device& device, const ShadingEffort& effort, bool turned, std::vector<FilterTrial>& trials) {
  const Still still(patterned_plane(turned));
  const View view = look_at({0.0, 1.0, 0.0}, {0.0, 0.55, -1.0}, 0.9, 0.05);
  const Light truth = means(Drawing(device, still, view, effort.width * effort.samples, effort.height * effort.samples,
                                    {FilterKind::bilinear}, plain_options())
                                .draw(),
                            effort.samples);
  std::vector<std::unique_ptr<Drawing>> drawings;
  for (const NamedFilter& named : kFilters)
    drawings.push_back(
        std::make_unique<Drawing>(device, still, view, effort.width, effort.height, named.filter, plain_options()));
  take_turns(drawings, turned ? 0 : effort.repetitions);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (!turned) trials[i].milliseconds = drawings[i]->milliseconds();
    trials[i].texel_bytes = drawings[i]->texel_bytes();
    (turned ? trials[i].error_turned : trials[i].error) = root_mean_square(means(drawings[i]->draw(), 1), truth);
  }
}

void study_normals(Device& device, const ShadingEffort& effort, bool mapped, std::vector<NormalTrial>& trials) {
  const Still still(sphere_with_tangents(mapped));
  const View view = look_at({0.0, 0.3, 2.0}, {0.0, 0.0, 0.0}, 0.8, 0.05);
  std::vector<std::unique_ptr<Drawing>> drawings;
  for (const NormalInterpolation normals : {NormalInterpolation::interpolated, NormalInterpolation::quaternion})
    drawings.push_back(std::make_unique<Drawing>(device, still, view, effort.width, effort.height, TextureFilter{},
                                                 plain_options(normals)));
  take_turns(drawings, effort.repetitions);
  for (std::size_t i = 0; i < trials.size(); ++i)
    (mapped ? trials[i].milliseconds_mapped : trials[i].milliseconds) = drawings[i]->milliseconds();
}

}  // namespace

ShadingStudy study_shading(Device& device, const ShadingEffort& effort) {
  ShadingStudy study{device.name(), device.max_anisotropy(), {}, {{"interpolated", {}, {}}, {"quaternion", {}, {}}}};
  for (const NamedFilter& named : kFilters) study.filters.emplace_back().name = named.name;
  for (const bool turned : {false, true}) study_plane(device, effort, turned, study.filters);
  for (const bool mapped : {false, true}) study_normals(device, effort, mapped, study.normals);
  return study;
}

}  // namespace sinew::viewer
