// SPDX-License-Identifier: MIT
#include "tests/study/frame_study.h"

#include <cmath>

#include "tests/study/study_scenes.h"
#include "viewer/app/camera/orbit_camera.h"
#include "viewer/app/headless.h"

namespace sinew::viewer {
namespace {

/// Draws one picture with fixed options, repeatedly.
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
    // Other bounds by a step of float: shadow maps are drawn in each picture, as of a body that moves.
    float& bound = options_.shadows.bounds.upper.x;
    if (options_.shadows.on) bound = std::nextafter(bound, 2.0f * std::abs(bound) + 1.0f);
    headless_.render(frame_, view_, options_);
    times.add(headless_.pass_times());
  }

  std::uint32_t draws() const { return headless_.report().drawn; }

 private:
  const FrameResult& frame_;
  RenderOptions options_;
  View view_;
  Headless headless_;
};

/// Draws one picture of each to warm up, then both alternately.
void take_turns(Drawing& one, PictureTimes& of_one, Drawing& other, PictureTimes& of_other, int repetitions) {
  PictureTimes first;
  one.draw(first);
  other.draw(first);
  for (int i = 0; i < repetitions; ++i) {
    one.draw(of_one);
    other.draw(of_other);
  }
}

std::uint64_t triangles_of(const Scene& scene) {
  std::uint64_t count = 0;
  for (const MeshInstance& instance : scene.instances)
    for (const Primitive& primitive : scene.meshes[instance.mesh].primitives)
      if (primitive.topology == Topology::triangles) count += primitive.indices.size() / 3;
  return count;
}

}  // namespace

RenderOptions base_look(const ClipExtent& bounds) {
  RenderOptions options;
  options.ao = ambient_occlusion_for(bounds.largest);
  return options;
}

RenderOptions full_look(const ClipExtent& bounds) {
  RenderOptions options = base_look(bounds);
  options.lighting.environment = studio_environment();
  options.backdrop = Backdrop::blurred;
  options.shadows = {true, bounds.reached};
  options.smooth_edges = true;
  return options;
}

void PictureTimes::add(std::span<const PassTime> passes) {
  if (passes.empty()) return;
  ran.clear();
  double& all = all_ms.emplace_back(0.0);
  for (const PassTime& time : passes) {
    ran.emplace_back(time.pass);
    all += time.milliseconds;
    if (time.pass == name_of(Pass::opaque)) opaque_ms.push_back(time.milliseconds);
  }
}

DrawTrial study_draws(Device& device, std::uint32_t draws, const FrameEffort& effort) {
  const Still still(sheet_of_balls(draws));
  RenderOptions options = base_look(still.bounds);
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
  Drawing base(device, scene, frame, bounds, base_look(bounds), effort);
  Drawing full(device, scene, frame, bounds, full_look(bounds), effort);
  FrameTrial trial{.name = name, .triangles = triangles_of(scene)};
  take_turns(base, trial.base, full, trial.full, effort.repetitions);
  trial.draws = base.draws();
  return trial;
}

std::vector<FrameTrial> study_built_in_frames(Device& device, const FrameEffort& effort) {
  const Still parts(doll_of_balls()), ball(fine_ball());
  return {study_frame(device, "doll of 19 parts", parts.scene, parts.buffer.result(), parts.bounds, effort),
          study_frame(device, "ball", ball.scene, ball.buffer.result(), ball.bounds, effort)};
}

}  // namespace sinew::viewer
