// SPDX-License-Identifier: MIT
#include "viewer/study/frame_study.h"

#include <cmath>
#include <stdexcept>

#include "runtime/plan/run_plan.h"
#include "samples/showcase/scene_builder.h"
#include "samples/showcase/shapes.h"
#include "viewer/app/headless.h"
#include "viewer/app/orbit_camera.h"

namespace sinew::viewer {
namespace {

/// A picture that is drawn in one way, repeatedly.
class Drawing {
 public:
  Drawing(Device& device, const Scene& scene, const FrameResult& frame, const ClipExtent& bounds,
          const RenderOptions& options, const FrameEffort& effort)
      : frame_(frame), options_(options), headless_(device, scene, effort.width, effort.height) {
    OrbitCamera camera;
    camera.frame(bounds.outline.points(), static_cast<double>(effort.width) / effort.height);
    view_ = camera.view(bounds.reached);
  }

  void draw(PictureTimes& times) {
    headless_.render(frame_, view_, options_);
    double all = 0.0;
    for (const PassTime& time : headless_.pass_times()) {
      all += time.milliseconds;
      if (time.pass == name_of(Pass::opaque)) times.opaque_ms.push_back(time.milliseconds);
    }
    if (all > 0.0) times.all_ms.push_back(all);
  }

  std::uint32_t draws() const { return headless_.report().drawn; }

 private:
  const FrameResult& frame_;
  RenderOptions options_;
  View view_;
  Headless headless_;
};

/// Both in turns, after one picture of each.
void take_turns(Drawing& one, PictureTimes& of_one, Drawing& other, PictureTimes& of_other, int repetitions) {
  PictureTimes first;
  one.draw(first);
  other.draw(first);
  for (int i = 0; i < repetitions; ++i) {
    one.draw(of_one);
    other.draw(of_other);
  }
}

RenderOptions base_options(const ClipExtent& bounds) {
  RenderOptions options;
  options.ao = ambient_occlusion_for(bounds.largest);
  return options;
}

RenderOptions full_options(const ClipExtent& bounds) {
  RenderOptions options = base_options(bounds);
  options.lighting.environment = studio_environment();
  options.backdrop = Backdrop::blurred;
  options.shadows = {true, bounds.reached};
  options.smooth_edges = true;
  return options;
}

/// A scene that stands still, its frame and its extent.
struct Still {
  explicit Still(Scene made) : scene(std::move(made)), plan(compile_plan(scene, {})), buffer(plan) {
    if (run_plan(plan, {}, buffer) != ErrorCode::ok) throw std::runtime_error("the frame cannot be evaluated");
    bounds = clip_extent(scene, kNone);
  }
  Still(const Still&) = delete;
  Still& operator=(const Still&) = delete;

  Scene scene;
  Plan plan;
  FrameBuffer buffer;
  ClipExtent bounds;
};

/// Balls of `columns` x `rows` quads, a draw and a material each.
class Balls {
 public:
  Balls(std::uint32_t columns, std::uint32_t rows) : columns_(columns), rows_(rows) {}

  void add(const glm::vec3& centre, float radius) {
    const float hue = static_cast<float>(count_++);
    const glm::vec3 color = 0.5f + 0.3f * glm::vec3(std::sin(hue), std::sin(hue + 2.0f), std::sin(hue + 4.0f));
    const std::string name = "ball " + std::to_string(count_);
    builder_.add_prop(name, showcase::sphere(centre, radius, columns_, rows_),
                      builder_.add_material(name, color, 0.6f));
  }
  Scene finish() { return builder_.finish(); }

 private:
  showcase::SceneBuilder builder_;
  std::uint32_t columns_, rows_, count_ = 0;
};

Scene sheet(std::uint32_t draws) {
  Balls balls(16, 8);
  const auto wide = static_cast<std::uint32_t>(std::ceil(std::sqrt(16.0 / 9.0 * draws)));
  for (std::uint32_t i = 0; i < draws; ++i)
    balls.add({static_cast<float>(i % wide), static_cast<float>(i / wide), 0.0f}, 0.48f);
  return balls.finish();
}

Scene doll() {
  Balls balls(48, 24);
  balls.add({0.0f, 1.62f, 0.0f}, 0.13f);
  balls.add({0.0f, 1.46f, 0.0f}, 0.06f);
  for (const float y : {1.28f, 1.12f, 0.96f}) balls.add({0.0f, y, 0.0f}, 0.16f);
  for (const float side : {-1.0f, 1.0f}) {
    for (const float y : {0.78f, 0.60f, 0.40f, 0.18f}) balls.add({0.1f * side, y, 0.0f}, 0.11f);
    for (const float x : {0.24f, 0.42f, 0.60f}) balls.add({x * side, 1.34f, 0.0f}, 0.09f);
  }
  return balls.finish();
}

Scene one_ball() {
  Balls balls(256, 196);
  balls.add({0.0f, 0.0f, 0.0f}, 1.0f);
  return balls.finish();
}

std::uint64_t triangles_of(const Scene& scene) {
  std::uint64_t count = 0;
  for (const MeshInstance& instance : scene.instances)
    for (const Primitive& primitive : scene.meshes[instance.mesh].primitives)
      if (primitive.topology == Topology::triangles) count += primitive.indices.size() / 3;
  return count;
}

}  // namespace

DrawTrial study_draws(Device& device, std::uint32_t draws, const FrameEffort& effort) {
  const Still still(sheet(draws));
  RenderOptions options = base_options(still.bounds);
  Drawing with(device, still.scene, still.buffer.result(), still.bounds, options, effort);
  options.ao.on = false;
  Drawing without(device, still.scene, still.buffer.result(), still.bounds, options, effort);
  DrawTrial trial;
  take_turns(without, trial.without, with, trial.with, effort.repetitions);
  trial.draws = with.draws();
  return trial;
}

FrameTrial study_frame(Device& device, const std::string& name, const Scene& scene, const FrameResult& frame,
                       const ClipExtent& bounds, const FrameEffort& effort) {
  Drawing base(device, scene, frame, bounds, base_options(bounds), effort);
  Drawing full(device, scene, frame, bounds, full_options(bounds), effort);
  FrameTrial trial{.name = name, .triangles = triangles_of(scene)};
  take_turns(base, trial.base, full, trial.full, effort.repetitions);
  trial.draws = base.draws();
  return trial;
}

std::vector<FrameTrial> study_built_in_frames(Device& device, const FrameEffort& effort) {
  const Still parts(doll()), ball(one_ball());
  return {study_frame(device, "doll of 19 parts", parts.scene, parts.buffer.result(), parts.bounds, effort),
          study_frame(device, "ball", ball.scene, ball.buffer.result(), ball.bounds, effort)};
}

}  // namespace sinew::viewer
