// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "importer/tool/cost/fewer_influences.h"
#include "importer/tool/cost/skinned_part.h"
#include "importer/tool/cost/studies.h"
#include "importer/tool/cost/words.h"
#include "runtime/deform/skin_linear.h"

namespace sinew::cost {
namespace {

/// Largest distance in mm between positions skinned with `influences` and those skinned with all influences of the part
/// in double precision.
double error_mm(const SkinnedPart& part, const InfluenceStreams& influences) {
  PlainVertices<double> truth(part.vertex_count());
  DeformedVertices found(part.vertex_count());
  double largest_m = 0.0;
  for (const PosedSkin& pose : part.poses) {
    skin_plainly<double>(part.primitive->influences, pose.exact, {part.primitive->positions, {}, {}},
                         NormalRule::linear, truth);
    run_unchecked(SkinLinearJob{influences, pose.palette, part.in(), found.out(), NormalRule::linear});
    largest_m = std::max(largest_m, largest_distance<glm::vec3, Vec3<double>>(found.positions, truth.positions));
  }
  return 1e3 * largest_m;
}

/// in   weights  float or normalised integers, parallel to `influences.joints`
template <class N>
void add_variant(Study& study, const SkinnedPart& part, const char* name, const VertexInfluences& influences,
                 std::vector<N> weights, const char* note) {
  struct Skinned {
    SkinnedPart part;
    VertexInfluences influences;
    std::vector<N> weights;
    DeformedVertices out;

    InfluenceStreams streams() const {
      return {influences.groups, std::span(influences.joints), std::span<const N>(weights)};
    }
  };
  const auto skinned =
      std::make_shared<Skinned>(Skinned{part, influences, std::move(weights), DeformedVertices(part.vertex_count())});
  constexpr std::size_t kBytes = sizeof(N) + sizeof(std::uint16_t);
  Point point;
  point.name = name;
  point.note = note;
  point.error = error_mm(part, skinned->streams());
  point.values = {{"weights and joints",
                   static_cast<double>(kBytes * influences.joints.size()) / static_cast<double>(part.vertex_count()),
                   "bytes a vertex"}};
  study.add(std::move(point),
            {part.vertex_count(), [skinned] {
               run_unchecked(SkinLinearJob{skinned->streams(), skinned->part.poses.front().palette, skinned->part.in(),
                                           skinned->out.out(), NormalRule::linear});
             }});
}

std::vector<std::string> findings_of_influences(const Group& group, double hardly_seen_mm) {
  const Point& all = default_of(group);
  std::vector<std::string> out{fmt::format("All influences with float weights take {}.", time_of(group, all))};
  for (const Point& point : group.points)
    if (&point != &all)
      out.push_back(sentence(fmt::format("{}: vertices are up to {} elsewhere; {}.", point.name, error_of(group, point),
                                         time_beside(group, point, all))));
  if (const Point* best = cheapest_within(group, hardly_seen_mm))
    out.push_back(fmt::format("The cheapest that stays within {}, a ten-thousandth of the model's size: {}.",
                              length(hardly_seen_mm), best->name));
  return out;
}

}  // namespace

Study study_influences(const Subject& subject) {
  Study study;
  Group& group = study.group;
  group.name = "influences";
  group.title = "Skinning: influences and weights";
  group.question = "How many joints must move a vertex here, and how fine must their weights be?";
  group.error_name = "largest distance from the full result";
  group.error_unit = "mm";
  group.item = "vertex";
  const auto part = skinned_part(subject);
  if (!part) return left_out(std::move(study), "the file has no skinned vertices");
  group.about = fmt::format(
      "Linear blending of positions and normals of the largest primitive: {}. The error is the largest distance of a "
      "vertex "
      "from where all its influences put it in double precision.",
      part->description);
  const VertexInfluences& all = part->primitive->influences;
  std::uint32_t most = 0;
  for (const InfluenceGroup& g : all.groups) most = std::max(most, g.influence_count);
  const std::pair<std::uint32_t, const char*> fewer[] = {
      {1, "one influence"}, {2, "two influences"}, {4, "four influences"}};
  for (const auto& [count, name] : fewer)
    if (count < most) {
      const VertexInfluences heaviest = heaviest_influences(all, count);
      add_variant(study, *part, name, heaviest, heaviest.weights, "the heaviest, renormalised");
    }
  add_variant(study, *part, "all influences", all, all.weights, "float weights");
  group.points.back().is_default = true;
  add_variant(study, *part, "16-bit weights", all, whole_weights<std::uint16_t>(all),
              "all influences; widened to float as they are read");
  add_variant(study, *part, "8-bit weights", all, whole_weights<std::uint8_t>(all),
              "all influences; widened to float as they are read");
  study.findings = [limit = subject.hardly_seen_mm()](const Group& g) { return findings_of_influences(g, limit); };
  return study;
}

}  // namespace sinew::cost
