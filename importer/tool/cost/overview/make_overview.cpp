// SPDX-License-Identifier: MIT
#include "importer/tool/cost/overview/make_overview.h"

#include "importer/tool/cost/overview/choices.h"
#include "importer/tool/cost/overview/frame_parts.h"
#include "importer/tool/cost/overview/pictures.h"

namespace sinew::cost {
namespace {

constexpr double kSmallest_m = 0.05, kLargest_m = 20.0;  // of models whose unit is the metre, as glTF asks

}  // namespace

Overview make_overview(std::span<const Group> groups, const Subject& subject, const std::string& file) {
  Overview overview;
  overview.size_m = subject.size_m;
  overview.odd_unit = subject.size_m < kSmallest_m || subject.size_m > kLargest_m;
  overview.evaluation = evaluation_parts(subject.scene, subject.clip, subject.effort);
  overview.choices = find_choices(groups, overview.evaluation, subject.size_m);
  overview.not_drawn = "this is a built-in scene";
  if (file.empty()) return overview;
  overview.not_drawn.clear();
  overview.command = recommended_command(overview.choices, groups, file);
  const Animation* clip = subject.animation();
  const DrawnMoment middle{file, subject.clip, clip == nullptr ? 0.0 : 0.5 * clip->duration_s};
  const auto plan = plan_of_picture(middle);
  if (!plan) {
    overview.not_drawn = plan.error();
    return overview;
  }
  overview.drawing = drawing_parts(*plan);
  for (Choice& choice : overview.choices)
    if (const auto drawn = add_picture(middle, subject.size_m, choice); !drawn) choice.picture_note = drawn.error();
  return overview;
}

}  // namespace sinew::cost
