// SPDX-License-Identifier: MIT
#include "viewer/study/shading_study.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include <glm/geometric.hpp>

#include "runtime/plan/run_plan.h"
#include "samples/showcase/scene_builder.h"
#include "samples/showcase/shapes.h"
#include "viewer/app/headless.h"
#include "viewer/upload/srgb_codes.h"

namespace sinew::viewer {
namespace {

/// A scene that stands still, and its frame.
class Still {
 public:
  explicit Still(Scene scene) : scene_(std::move(scene)), plan_(compile_plan(scene_, {})), frame_(plan_) {
    if (run_plan(plan_, {}, frame_) != ErrorCode::ok) throw std::runtime_error("the frame cannot be evaluated");
  }
  Still(const Still&) = delete;
  Still& operator=(const Still&) = delete;

  const Scene& scene() const noexcept { return scene_; }
  const FrameResult& frame() const noexcept { return frame_.result(); }

 private:
  Scene scene_;
  Plan plan_;
  FrameBuffer frame_;
};

/// Squares of black and white in three sizes, and colours that tell them apart.
Image pattern() {
  Image image;
  image.width = image.height = 256;
  for (std::uint32_t y = 0; y < image.height; ++y)
    for (std::uint32_t x = 0; x < image.width; ++x) {
      const std::uint32_t side = x < 128 ? (y < 128 ? 4 : 16) : 32;
      const bool light = (x / side + y / side) % 2 == 0;
      image.rgba.insert(image.rgba.end(),
                        {static_cast<std::uint8_t>(light ? 235 : 20), static_cast<std::uint8_t>(light ? 230 : x / 4),
                         static_cast<std::uint8_t>(light ? 210 : y / 2), 255});
    }
  return image;
}

/// A plane at y = 0 that shows the pattern as it is, without light.
Scene plane(bool turned) {
  constexpr float kHalf = 40.0f;
  showcase::SceneBuilder builder;
  Primitive p;
  p.positions = {{-kHalf, 0, -kHalf}, {-kHalf, 0, kHalf}, {kHalf, 0, kHalf}, {kHalf, 0, -kHalf}};
  p.normals.assign(4, {0.0f, 1.0f, 0.0f});
  p.texcoords = {{{0, 0}, {0, kHalf}, {kHalf, kHalf}, {kHalf, 0}}};
  p.indices = {0, 1, 2, 0, 2, 3};
  Material material;
  material.unlit = true;
  material.base_color_texture.texture = builder.add_texture(pattern(), {});
  if (turned) material.base_color_texture.rotation_rad = 0.25f * std::numbers::pi_v<float>;
  builder.add_prop("plane", std::move(p), builder.add_material(std::move(material)));
  return builder.finish();
}

/// A sphere with tangents.
Scene sphere(bool mapped) {
  showcase::SceneBuilder builder;
  Primitive p = showcase::sphere({0, 0, 0}, 1.0f, 48, 24);
  p.texcoords = {std::vector<glm::vec2>(p.positions.size(), glm::vec2(0.5f))};
  for (const glm::vec3& n : p.normals) {
    const glm::vec3 along = glm::cross(glm::vec3(0, 1, 0), n);
    const float length = glm::length(along);
    p.tangents.emplace_back(length > 0.0f ? along / length : glm::vec3(1, 0, 0), 1.0f);
  }
  Image lean;
  lean.width = lean.height = 1;
  lean.rgba = {150, 110, 240, 255};
  Material material;
  material.roughness = 0.6f;
  material.metallic = 0.0f;
  if (mapped) material.normal_texture.texture = builder.add_texture(std::move(lean), {});
  builder.add_prop("sphere", std::move(p), builder.add_material(std::move(material)));
  return builder.finish();
}

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
        headless_(device, still.scene(), width, height, {}, nullptr, filter) {}

  Picture draw() {
    Picture picture = headless_.render(still_.frame(), view_, options_);
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
  const Still still(plane(turned));
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
  const Still still(sphere(mapped));
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
