// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "importer/geometry_cache/encode_geometry_cache.h"
#include "importer/tool/bake/bake_scene.h"
#include "importer/tool/cost/geometry_cache/stored_frames.h"
#include "importer/tool/cost/studies.h"
#include "importer/tool/cost/words.h"
#include "importer/tool/length_text.h"
#include "importer/tool/messages.h"
#include "runtime/geometry_cache/geometry_decoder.h"

namespace sinew::cost {
namespace {

constexpr double kFps = 30.0, kDefaultBudget_m = 1e-4;
constexpr double kFarBudget = 100.0;  // a model so many times larger or smaller than usual needs another default

/// A cache in memory.
struct Baked {
  std::vector<std::byte> file;
  GeometryCache cache;
  GeometryDecoder decoder;
  MappedFrames source;
  std::vector<glm::vec3> shown;

  explicit Baked(std::vector<std::byte> bytes)
      : file(std::move(bytes)), cache(*GeometryCache::open(file)), decoder(cache), source{cache, file} {
    shown.resize(point_count());
  }
  std::size_t point_count() const {
    std::size_t count = 0;
    for (const GeometryMesh& mesh : cache.meshes()) count += mesh.streams[0].point_count;
    return count;
  }
  /// Decodes a frame into the points of all meshes, one mesh after another.
  void show(std::uint32_t frame) {
    decoder.decode(frame, source);
    std::span<glm::vec3> left = shown;
    for (std::size_t m = 0; m < cache.meshes().size(); ++m) {  // caches of this study have one stream a mesh
      const std::size_t count = cache.meshes()[m].streams[0].point_count;
      decoder.write_points(m, left.first(count));
      left = left.subspan(count);
    }
  }
};

std::shared_ptr<Baked> bake(GeometryTake& take, double budget_m) {
  for (TakeMesh& mesh : take.meshes) mesh.streams[0].budget = budget_m;
  auto file = encode_geometry_cache(take, {.keep_triangles = false});
  return file ? std::make_shared<Baked>(std::move(*file)) : nullptr;
}

/// The frames of a take, with their points in the order of a cache of this take.
PointFrames in_order_of(const Baked& baked, const GeometryTake& take) {
  PointFrames out(baked.cache.frame_count());
  for (std::size_t m = 0; m < take.meshes.size(); ++m) {
    const GeometryStream& stream = baked.cache.meshes()[m].streams[0];
    for (std::size_t f = 0; f < out.size(); ++f) {
      const std::size_t first = out[f].size();
      out[f].resize(first + stream.point_count);
      for (std::size_t v = 0; v < stream.point_of_vertex.size(); ++v)
        out[f][first + stream.point_of_vertex[v]] = take.meshes[m].streams[0].frames[f][v];
    }
  }
  return out;
}

double farthest_mm(std::span<const glm::vec3> a, std::span<const glm::vec3> b) {
  double most = 0.0;
  for (std::size_t p = 0; p < a.size(); ++p) most = std::max(most, glm::distance(glm::dvec3(a[p]), glm::dvec3(b[p])));
  return 1e3 * most;
}

/// Adds a way to store the frames. `show(frame)` returns its points and is called for one frame after another.
void add_way(Study& study, Point point, double bytes, const PointFrames& truth,
             const std::function<std::span<const glm::vec3>(std::size_t)>& show) {
  const std::size_t frames = truth.size(), items = frames * truth[0].size();
  for (std::size_t f = 0; f < frames; ++f) point.error = std::max(point.error, farthest_mm(show(f), truth[f]));
  point.size = bytes / static_cast<double>(items);
  point.values = {{"of floats", 100.0 * *point.size / sizeof(glm::vec3), "%"}};
  study.add(std::move(point), {items, [show, frames] {
                                 for (std::size_t f = 0; f < frames; ++f) show(f);
                               }});
}

void add_cache(Study& study, const std::shared_ptr<Baked>& baked, double budget_m, bool is_default,
               const PointFrames& truth) {
  Point point;
  point.name = "sinew " + tool::length_text(budget_m);
  point.note = "sinew bake --budget; with the directory, without the faces";
  point.is_default = is_default;
  add_way(study, std::move(point), static_cast<double>(baked->file.size()), truth, [baked](std::size_t frame) {
    baked->show(static_cast<std::uint32_t>(frame));
    return std::span<const glm::vec3>(baked->shown);
  });
}

void add_others(Study& study, const PointFrames& truth, double step) {
  for (NamedFrames& way : stored_ways(truth, step)) {
    struct Play {
      std::unique_ptr<StoredFrames> frames;
      std::vector<glm::vec3> shown;
    };
    const auto play = std::make_shared<Play>(Play{std::move(way.frames), std::vector<glm::vec3>(truth[0].size())});
    Point point;
    point.name = way.name;
    point.note = way.note;
    add_way(study, std::move(point), static_cast<double>(play->frames->bytes()), truth, [play](std::size_t frame) {
      play->frames->decode(frame, play->shown);
      return std::span<const glm::vec3>(play->shown);
    });
  }
}

std::string beside_ours(const Group& group, const char* name, const Point& ours) {
  const Point* other = find(group, name);
  return other == nullptr ? std::string()
                          : fmt::format("{} takes {} times its bytes, and {} to decode", name,
                                        number(*other->size / *ours.size), time_of(group, *other));
}

std::vector<std::string> findings_of_frames(const Group& group) {
  const Point& ours = default_of(group);
  return {fmt::format("The cache takes {} bytes a point and frame, {} % of floats, and decodes in {}, within {}.",
                      number(*ours.size), number(100.0 * *ours.size / sizeof(glm::vec3)), time_of(group, ours),
                      error_of(group, ours)),
          fmt::format("Of the same numbers {}; {}.", beside_ours(group, "zstd -19", ours),
                      beside_ours(group, "meshopt", ours)),
          fmt::format("Of residuals {}; {}.", beside_ours(group, "zstd -19, residuals", ours),
                      beside_ours(group, "meshopt, residuals", ours))};
}

void name_group(Group& group) {
  group.name = "geometry_cache";
  group.title = "Geometry cache";
  group.question = "How should every vertex of every frame be kept?";
  group.error_name = "largest error";
  group.error_unit = "mm";
  group.item = "point";
  group.size_unit = "bytes a point and frame";
}

}  // namespace

Study study_geometry(GeometryTake take, double budget_m, const Effort& effort) {
  Study study;
  name_group(study.group);
  if (take.meshes.empty()) return left_out(std::move(study), "the file has no triangles");
  std::size_t frames = take.meshes[0].streams[0].frames.size();
  if (frames < 2) return left_out(std::move(study), "nothing moves");
  frames = std::min(frames, std::max<std::size_t>(2, effort.key_intervals));
  for (TakeMesh& mesh : take.meshes) {
    mesh.between.clear();
    mesh.streams.resize(1);
    mesh.streams[0].frames.resize(frames);
  }
  const std::shared_ptr<Baked> chosen = bake(take, budget_m);
  if (!chosen || chosen->point_count() == 0) return left_out(std::move(study), "its positions cannot be baked");
  const PointFrames truth = in_order_of(*chosen, take);
  study.group.about = fmt::format(
      "{} in {}, of {} at {:.4g} a second. Whole numbers have the step of the cache of {}; times are those of one "
      "frame after another, into floats.",
      tool::counted(truth[0].size(), "point"), tool::counted(take.meshes.size(), "primitive"),
      tool::counted(frames, "frame"), 1.0 / take.frame_s, tool::length_text(budget_m));
  add_cache(study, chosen, budget_m, true, truth);
  for (const double other_m : {0.1 * budget_m, 10.0 * budget_m})
    if (const auto baked = bake(take, other_m); baked && baked->point_count() == truth[0].size())
      add_cache(study, baked, other_m, false, in_order_of(*baked, take));
  add_others(study, truth, static_cast<double>(chosen->cache.meshes()[0].streams[0].step));
  study.findings = findings_of_frames;
  return study;
}

Study study_geometry(const Subject& subject) {
  Study study;
  name_group(study.group);
  if (subject.clip == kNone) return left_out(std::move(study), "the file has no clips");
  auto baked =
      tool::bake_scene(subject.scene, subject.clip, kFps, {}, std::max<std::size_t>(2, subject.effort.key_intervals));
  if (!baked) return left_out(std::move(study), baked.error());
  const double hardly_seen_m = 1e-3 * subject.hardly_seen_mm();
  const bool is_usual = hardly_seen_m > kDefaultBudget_m / kFarBudget && hardly_seen_m < kDefaultBudget_m * kFarBudget;
  const double budget_m = is_usual ? kDefaultBudget_m : std::pow(10.0, std::round(std::log10(hardly_seen_m)));
  return study_geometry(std::move(baked->take), budget_m, subject.effort);
}

}  // namespace sinew::cost
