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
#include "runtime/jobs/skin_linear.h"

namespace sinew::cost {
namespace {

/// Largest distance in mm of positions skinned by `influences` from those of the part's own influences in double precision.
double error_mm(const SkinnedPart& part, const VertexInfluences& influences) {
  PlainVertices<double> truth(part.vertex_count());
  DeformedVertices found(part.vertex_count());
  double largest_m = 0.0;
  for (const PosedSkin& pose : part.poses) {
    skin_plainly<double>(part.primitive->influences, pose.exact, {part.primitive->positions, {}, {}}, NormalRule::linear, truth);
    run(SkinLinearJob{&influences, pose.palette, part.in(), found.out(), NormalRule::linear});
    largest_m = std::max(largest_m, largest_distance<glm::vec3, Vec3<double>>(found.positions, truth.positions));
  }
  return 1e3 * largest_m;
}

void add_variant(Study& study, const SkinnedPart& part, const std::string& name, VertexInfluences influences, double bytes_per_influence, const char* note) {
  struct Skinned {
    SkinnedPart part;
    VertexInfluences influences;
    DeformedVertices out;
  };
  Point point;
  point.name = name, point.note = note;
  point.error = error_mm(part, influences);
  point.values = {{"weights and joints", bytes_per_influence * static_cast<double>(influences.weights.size()) / static_cast<double>(part.vertex_count()), "bytes a vertex"}};
  const auto skinned = std::make_shared<Skinned>(Skinned{part, std::move(influences), DeformedVertices(part.vertex_count())});
  study.add(std::move(point), {part.vertex_count(), [skinned] {
              run(SkinLinearJob{&skinned->influences, skinned->part.poses.front().palette, skinned->part.in(), skinned->out.out(), NormalRule::linear});
            }});
}

std::vector<std::string> findings(const Group& group, double hardly_seen_mm) {
  const Point& all = default_of(group);
  std::vector<std::string> out{fmt::format("All influences with float weights take {}.", time_of(group, all))};
  for (const Point& point : group.points)
    if (&point != &all)
      out.push_back(sentence(fmt::format("{}: vertices are up to {} elsewhere; {}.", point.name, error_of(group, point), time_beside(group, point, all))));
  if (const Point* best = cheapest_within(group, hardly_seen_mm))
    out.push_back(fmt::format("The cheapest that stays within {}, a ten-thousandth of the model's size: {}.", length(hardly_seen_mm), best->name));
  return out;
}

}  // namespace

Study study_influences(const Subject& subject) {
  Study study;
  Group& group = study.group;
  group.name = "influences", group.title = "Skinning: influences and weights";
  group.question = "How many joints must move a vertex here, and how fine must their weights be?";
  group.error_name = "largest distance from the full result", group.error_unit = "mm", group.item = "vertex";
  const auto part = skinned_part(subject);
  if (!part) return group.left_out = "the file has no skinned vertices", study;
  group.about = fmt::format("Linear blending of positions and normals of the largest primitive: {}. The error is the largest distance of a vertex "
                            "from where all its influences put it in double precision.", part->description);
  const VertexInfluences& all = part->primitive->influences;
  constexpr double kFloatWeight = 6.0, kWeight16 = 4.0, kWeight8 = 3.0;  // bytes, with a 16-bit joint
  std::uint32_t most = 0;
  for (const InfluenceGroup& g : all.groups) most = std::max(most, g.influence_count);
  const std::pair<std::uint32_t, const char*> fewer[] = {{1, "one influence"}, {2, "two influences"}, {4, "four influences"}};
  for (const auto& [count, name] : fewer)
    if (count < most) add_variant(study, *part, name, heaviest_influences(all, count), kFloatWeight, "the heaviest, renormalised");
  add_variant(study, *part, "all influences", all, kFloatWeight, "float weights");
  group.points.back().is_default = true;
  add_variant(study, *part, "rounding weights to 16 bits", coarse_weights(all, 65535), kWeight16, "all influences; widened to float at load");
  add_variant(study, *part, "rounding weights to 8 bits", coarse_weights(all, 255), kWeight8, "all influences; widened to float at load");
  study.findings = [limit = subject.hardly_seen_mm()](const Group& g) { return findings(g, limit); };
  return study;
}

}  // namespace sinew::cost
