// SPDX-License-Identifier: MIT
#include "importer/tool/cost/make_report.h"

#include <iterator>

#include "importer/tool/cost/machine.h"
#include "importer/tool/cost/measure.h"
#include "importer/tool/cost/studies.h"

namespace sinew::cost {
namespace {

constexpr double kShareOfErrors = 0.3;  // of the whole time; the errors are computed before the times are measured

}  // namespace

Report make_report(const Scenes& scenes, std::optional<std::uint32_t> clip, const Effort& effort,
                   const Progress& progress) {
  const auto subject_of = [&](const Scene* scene) {
    return Subject(*scene, clip ? *clip : busiest_clip(*scene), effort);
  };
  const Subject moving = subject_of(scenes.moving), skinned = subject_of(scenes.skinned),
                morphed = subject_of(scenes.morphed);
  struct Look {
    Study (*study)(const Subject&);
    const Subject& subject;
  };
  const Look looks[] = {{study_rotation, moving},   {study_storage, moving},          {study_influences, skinned},
                        {study_skinning, skinned},  {study_skinned_normals, skinned}, {study_morphing, morphed},
                        {study_arithmetic, skinned}};
  std::vector<Study> studies;
  for (const Look& look : looks) {
    progress("errors", kShareOfErrors * static_cast<double>(studies.size()) / static_cast<double>(std::size(looks)));
    studies.push_back(look.study(look.subject));
  }
  measure(studies, effort, [&](double done) { progress("times", kShareOfErrors + (1.0 - kShareOfErrors) * done); });
  Report report;
  report.machine = describe_machine();
  for (Study& study : studies) report.groups.push_back(std::move(study.group));
  return report;
}

}  // namespace sinew::cost
