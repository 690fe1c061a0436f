// SPDX-License-Identifier: MIT
#include "viewer/app/compare/comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "runtime/compress/compile_clip_within.h"
#include "runtime/compress/virtual_vertices.h"
#include "viewer/app/compare/picture_grid.h"
#include "viewer/app/scene_choice.h"

namespace sinew::viewer {
namespace {

/// The scene with the clip compiled within a budget.
std::unique_ptr<LoadedScene> compiled(const LoadedScene& loaded, std::uint32_t clip, double budget_m) {
  auto own = std::make_unique<LoadedScene>(loaded);
  if (clip >= own->scene.animations.size()) return own;
  const VirtualVertices vertices = virtual_vertices(loaded.scene);
  own->scene.clips[clip] = compile_clip_within(loaded.scene, loaded.scene.animations[clip], vertices, budget_m).clip;
  return own;
}

bool same_meshes(const Scene& a, const Scene& b) {
  if (a.instances.size() != b.instances.size() || a.meshes.size() != b.meshes.size()) return false;
  for (std::size_t i = 0; i < a.instances.size(); ++i)
    if (a.instances[i].mesh != b.instances[i].mesh) return false;
  for (std::size_t m = 0; m < a.meshes.size(); ++m) {
    if (a.meshes[m].primitives.size() != b.meshes[m].primitives.size()) return false;
    for (std::size_t p = 0; p < a.meshes[m].primitives.size(); ++p)
      if (a.meshes[m].primitives[p].vertex_count() != b.meshes[m].primitives[p].vertex_count()) return false;
  }
  return true;
}

/// The next of 1, 2, 5, 10, ... that is at least as large, so that pictures of a sequence mostly share one scale.
double rounded_up(double metres) {
  if (!(metres > 0.0)) return 1e-3;
  const double decade = std::pow(10.0, std::floor(std::log10(metres)));
  for (const double step : {1.0, 2.0, 5.0})
    if (metres <= step * decade * (1.0 + 1e-9)) return step * decade;
  return 10.0 * decade;
}

std::string place_of(const Scene& scene, const FrameResult& frame, const VertexDistances& distances) {
  for (std::size_t i = 0; i < frame.instances.size(); ++i) {
    const Mesh& mesh = scene.meshes[scene.instances[i].mesh];
    const std::uint32_t first = frame.instances[i].first_primitive;
    if (distances.worst_primitive >= first && distances.worst_primitive < first + mesh.primitives.size())
      return "mesh \"" + mesh.name + "\", primitive " + std::to_string(distances.worst_primitive - first) +
             ", vertex " + std::to_string(distances.worst_vertex);
  }
  return {};
}

}  // namespace

tl::expected<std::unique_ptr<Comparison>, std::string> Comparison::make(Device& device, const Options& options,
                                                                        const std::vector<LoadedScene>& loaded_scenes,
                                                                        const std::vector<CompareView>& views,
                                                                        std::uint32_t clip) {
  std::unique_ptr<Comparison> made(new Comparison(device, options));
  const LoadedScene& first = loaded_scenes.front();
  for (const CompareView& view : views) {
    View& added = made->views_.emplace_back();
    Options own = options;
    own.skinning = view.skinning;
    std::uint32_t own_clip = clip;
    added.label = view.label;
    added.loaded = &first;
    if (view.kind == CompareView::Kind::compiled) {
      added.own = compiled(first, clip, view.budget_m);
      added.loaded = added.own.get();
    } else if (view.kind == CompareView::Kind::file) {
      added.loaded = &loaded_scenes[view.file];
      added.label = added.loaded->name;
      own.skinning = options.skinning;
      if (!same_meshes(first.scene, added.loaded->scene))
        return tl::unexpected("--compare: " + added.label + " has other meshes than " + first.name);
      const auto same = same_clip(clip_names(first.scene), clip, added.loaded->scene);
      if (!same) return tl::unexpected("--compare: " + added.label + " has no clip of the same name");
      own_clip = *same;
    }
    added.maker = std::make_unique<PictureMaker>(device, own, *added.loaded, own_clip);
    if (made->views_.size() > 1) added.maker->frame_like(*made->views_.front().maker);
  }
  return made;
}

Picture Comparison::at(double time_s, double turn_rad) {
  std::vector<Picture> pictures;
  for (View& view : views_) pictures.push_back(view.maker->at(time_s, turn_rad));
  return compose(std::move(pictures), time_s);
}

Picture Comparison::in_sequence(std::uint32_t picture, const std::function<double(std::uint32_t)>& time_of) {
  std::vector<Picture> pictures;
  for (View& view : views_) pictures.push_back(view.maker->in_sequence(picture, time_of));
  return compose(std::move(pictures), time_of(picture));
}

Picture Comparison::compose(std::vector<Picture> pictures, double time_s) {
  const Scene& scene = views_.front().loaded->scene;
  const FrameResult& reference = views_.front().maker->pose();
  std::vector<VertexDistances> distances;
  rows_.clear();
  double worst_m = 0.0;
  for (const View& view : views_) {
    distances.push_back(vertex_distances(scene, reference, view.maker->pose()));
    rows_.push_back({view.label, distances.back().worst_m, distances.back().mean_m, 0.0,
                     rows_.empty() ? "" : place_of(scene, reference, distances.back())});
    worst_m = std::max(worst_m, distances.back().worst_m);
  }
  full_m_ = rounded_up(worst_m);
  std::vector<Picture> below{distance_scale(options_.width, options_.height)};
  for (std::size_t v = 1; v < views_.size(); ++v) {
    const PictureMaker& maker = *views_[v].maker;
    const Scene painted = painted_scene(views_[v].loaded->scene, maker.pose(), distances[v], full_m_);
    below.push_back(
        Headless(device_, painted, options_.width, options_.height).render(maker.pose(), maker.view(), maker.look()));
  }
  std::move(below.begin(), below.end(), std::back_inserter(pictures));
  for (std::size_t v = 0; v < views_.size(); ++v)  // last: it evaluates other moments, which replace the pose
    rows_[v].evaluation_us = views_[v].maker->evaluation_us(time_s);
  return picture_grid(pictures, views_.size());
}

std::string describe(const Comparison& comparison) {
  std::string text;
  char line[160];
  std::size_t widest = 0;
  for (const Comparison::Row& row : comparison.rows()) widest = std::max(widest, row.label.size());
  for (const Comparison::Row& row : comparison.rows()) {
    const bool first = &row == &comparison.rows().front();
    text.append(row.label).append(widest - row.label.size(), ' ');
    if (first)
      std::snprintf(line, sizeof(line), "  %9.1f us  the others are compared with it\n", row.evaluation_us);
    else
      std::snprintf(line, sizeof(line), "  %9.1f us  worst %.4g mm, mean %.4g mm; ", row.evaluation_us,
                    1e3 * row.worst_m, 1e3 * row.mean_m);
    text += line;
    if (!first) text += row.worst_place + '\n';
  }
  std::snprintf(line, sizeof(line), "colours: blue 0, red %.4g mm\n", 1e3 * comparison.full_m());
  return text + line;
}

}  // namespace sinew::viewer
