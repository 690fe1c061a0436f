// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <fmt/format.h>

#include "importer/tool/cost/instruction_sets.h"
#include "importer/tool/cost/limb.h"
#include "importer/tool/cost/studies.h"
#include "importer/tool/cost/words.h"
#include "runtime/deform/skin_linear.h"

namespace sinew::cost {
namespace {

/// The data of all variants, and memory for their results.
struct Bench {
  Limb limb;  // used if the file has no skinned vertices
  SkinnedPart part;
  DeformedVertices found;
  PlainVertices<float> plain;
  PlainVertices<double> exact;
  std::vector<std::vector<Affine>> float_palettes;  // palettes for each pose

  explicit Bench(const Subject& subject) {
    const auto own = skinned_part(subject);
    part = own ? *own : part_of(limb);
    found = DeformedVertices(part.vertex_count());
    plain = PlainVertices<float>(part.vertex_count());
    exact = PlainVertices<double>(part.vertex_count());
    for (const PosedSkin& pose : part.poses) {
      float_palettes.emplace_back();
      for (const JointMatrix& m : pose.palette) float_palettes.back().push_back(affine_from(m));
    }
  }

  void run_job(std::size_t pose) {
    run_unchecked(SkinLinearJob{&part.primitive->influences, part.poses[pose].palette, part.in(), found.out(),
                                NormalRule::linear});
  }
  void run_plain_float(std::size_t pose) {
    skin_plainly<float>(part.primitive->influences, float_palettes[pose], part.in(), NormalRule::linear, plain);
  }
  void run_double(std::size_t pose) {
    skin_plainly<double>(part.primitive->influences, part.poses[pose].exact, part.in(), NormalRule::linear, exact);
  }
};

/// The largest error of a position, in float steps at the size of the model.
template <class V>
double error_ulp(const std::vector<V>& found, const std::vector<Vec3<double>>& truth) {
  double size = 0.0;
  for (const auto& p : truth) size = std::max(size, largest_component(p));
  const auto nearest = static_cast<float>(size);
  const auto step = static_cast<double>(std::nextafter(nearest, std::numeric_limits<float>::infinity()) - nearest);
  return largest_distance<V, Vec3<double>>(found, truth) / step;
}

void add_job(Study& study, const std::shared_ptr<Bench>& bench, const InstructionSet& set) {
  double error = 0.0;
  allow_only(set);
  for (std::size_t pose = 0; pose < bench->part.poses.size(); ++pose) {
    bench->run_double(pose);
    bench->run_job(pose);
    error = std::max(error, error_ulp(bench->found.positions, bench->exact.positions));
  }
  allow_all_instruction_sets();
  Point point;
  point.name = fmt::format("{}{}", set.name, set.fused ? ", fused" : "");
  point.error = error;
  point.is_default = set.is_best;
  point.values = {{"lanes", static_cast<double>(set.float_lanes), ""}};
  point.note = set.fused ? "the job in lanes of float, multiply and add rounded once"
                         : "the job in lanes of float, multiply and add rounded twice";
  study.add(std::move(point), {bench->part.vertex_count(), [bench] { bench->run_job(0); }, [set] { allow_only(set); },
                               allow_all_instruction_sets});
}

void add_plain(Study& study, const std::shared_ptr<Bench>& bench) {
  double error = 0.0;
  for (std::size_t pose = 0; pose < bench->part.poses.size(); ++pose) {
    bench->run_double(pose);
    bench->run_plain_float(pose);
    error = std::max(error, error_ulp(bench->plain.positions, bench->exact.positions));
  }
  Point single, precise;
  single.name = "plain float";
  single.error = error;
  single.note = "one vertex after the other, as the compiler makes it";
  precise.name = "plain double";
  precise.note = "the truth that the others are compared with";
  single.values = precise.values = {{"lanes", 1.0, ""}};
  study.add(std::move(single), {bench->part.vertex_count(), [bench] { bench->run_plain_float(0); }});
  study.add(std::move(precise), {bench->part.vertex_count(), [bench] { bench->run_double(0); }});
}

std::vector<std::string> findings_of_arithmetic(const Group& group) {
  const Point &best = default_of(group), *single = find(group, "plain float"), *precise = find(group, "plain double");
  std::vector<std::string> out{
      fmt::format("The widest lanes of this machine, {}, take {} and are off by {} in the last place.", best.name,
                  time_of(group, best), error_of(group, best)),
      fmt::format("Double precision in plain code costs {} times as much, plain float {} times.",
                  number(precise->time_ns / best.time_ns), number(single->time_ns / best.time_ns))};
  return out;
}

}  // namespace

Study study_arithmetic(const Subject& subject) {
  Study study;
  Group& group = study.group;
  group.name = "arithmetic";
  group.title = "Arithmetic";
  group.question = "What do precision and vector width cost?";
  group.error_name = "largest error of a position";
  group.error_unit = "steps of float";
  group.item = "vertex";
  const auto bench = std::make_shared<Bench>(subject);
  group.about = fmt::format(
      "Linear blending of positions and normals: {}. Truth is the same sum in double precision, from the same float "
      "palette.",
      bench->part.description);
  for (const InstructionSet& set : instruction_sets()) add_job(study, bench, set);
  add_plain(study, bench);
  study.findings = findings_of_arithmetic;
  return study;
}

}  // namespace sinew::cost
