// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "importer/tool/cost/skinned_part.h"
#include "importer/tool/cost/studies.h"
#include "importer/tool/cost/words.h"
#include "runtime/deform/skin_linear.h"

namespace sinew::cost {
namespace {

struct NormalError {
  double largest_deg = 0.0, mean_deg = 0.0;
};

NormalError error_of(const SkinnedPart& part, NormalRule rule) {
  PlainVertices<double> truth(part.vertex_count());
  DeformedVertices found(part.vertex_count());
  NormalError error;
  for (const PosedSkin& pose : part.poses) {
    skin_plainly<double>(part.primitive->influences, pose.exact, part.in(), NormalRule::cofactor, truth);
    run_unchecked(SkinLinearJob{&part.primitive->influences, pose.palette, part.in(), found.out(), rule});
    for (std::size_t v = 0; v < part.vertex_count(); ++v) {
      const double angle = angle_deg(found.normals[v], truth.normals[v]);
      error.largest_deg = std::max(error.largest_deg, angle);
      error.mean_deg += angle / static_cast<double>(part.vertex_count() * part.poses.size());
    }
  }
  return error;
}

std::vector<std::string> findings_of_normals(const Group& group) {
  const Point &plain = group.points[0], &cofactor = group.points[1];
  const double mean_deg = plain.values[0].value;
  std::vector<std::string> out{fmt::format("Turning normals with the blended matrix itself, as shaders do, is off by "
                                           "{} degrees on average and by up to {} here.",
                                           number(mean_deg), cost::error_of(group, plain)),
                               fmt::format("The cofactor matrix is right under any scale, within {}, and {}.",
                                           cost::error_of(group, cofactor), time_beside(group, cofactor, plain))};
  constexpr double kNoticeable = 1.0;
  const char* const verdict =
      mean_deg < kNoticeable
          ? "For this file the matrix itself will do: an average below a degree is not seen in shading."
          : "An average above a degree is seen in shading: for this file the exact rule (Needs::skin.normal_rule "
            "= cofactor) is worth its time.";
  out.emplace_back(verdict);
  return out;
}

}  // namespace

Study study_skinned_normals(const Subject& subject) {
  Study study;
  Group& group = study.group;
  group.name = "normals";
  group.title = "Skinning: normals";
  group.question = "Do the normals of this file need the exact rule?";
  group.error_name = "largest angle from the true normal";
  group.error_unit = "degrees";
  group.item = "vertex";
  const auto part = skinned_part(subject);
  if (!part) return left_out(std::move(study), "the file has no skinned vertices");
  if (part->primitive->normals.empty())
    return left_out(std::move(study), "the largest skinned primitive has no normals");
  group.about = fmt::format(
      "Linear blending of positions and normals of the largest primitive: {}. Truth is the cofactor matrix of the "
      "blended matrix in double precision.",
      part->description);
  struct Skinned {
    SkinnedPart part;
    DeformedVertices out;
  };
  const auto skinned = std::make_shared<Skinned>(Skinned{*part, DeformedVertices(part->vertex_count())});
  const std::pair<NormalRule, const char*> rules[] = {{NormalRule::linear, "blended matrix"},
                                                      {NormalRule::cofactor, "cofactor matrix"}};
  for (const auto& [rule, name] : rules) {
    Point point;
    const NormalError error = error_of(*part, rule);
    point.name = name;
    point.error = error.largest_deg;
    point.is_default = rule == NormalRule::linear;
    point.values = {{"average angle", error.mean_deg, "degrees"}};
    point.note = rule == NormalRule::linear ? "right when joints are rigid or scaled evenly" : "right under any scale";
    study.add(std::move(point),
              {part->vertex_count(), [skinned, chosen = rule] {
                 run_unchecked(SkinLinearJob{&skinned->part.primitive->influences, skinned->part.poses.front().palette,
                                             skinned->part.in(), skinned->out.out(), chosen});
               }});
  }
  study.findings = findings_of_normals;
  return study;
}

}  // namespace sinew::cost
