// SPDX-License-Identifier: MIT
#include "importer/tool/cost/make_report.h"

#include <chrono>
#include <iterator>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "importer/platform/program.h"
#include "importer/tool/cost/instruction_sets.h"
#include "importer/tool/cost/measure.h"
#include "importer/tool/cost/studies.h"

namespace sinew::cost {
namespace {

constexpr double kShareOfErrors = 0.3;  // part of the whole time: the errors are computed before the times are measured

std::string date_now() {
  const std::chrono::year_month_day day(std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()));
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(day.year()), static_cast<unsigned>(day.month()),
                     static_cast<unsigned>(day.day()));
}

std::string compiler() {
#ifdef __clang__
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

/// The facts of the machine and the build on which times depend, as names and values.
std::vector<std::pair<std::string, std::string>> describe_machine() {
  const InstructionSet best = instruction_sets().front();
  return {{"processor", platform::processor_name()},
          {"cores", std::to_string(std::thread::hardware_concurrency())},
          {"load while measuring", platform::load_average()},
          {"system", platform::system_name()},
          {"compiler", compiler()},
          {"build", SINEW_BUILD_TYPE},
          {"instructions", fmt::format("{}, {} floats wide", best.name, best.float_lanes)},
          {"sinew", SINEW_VERSION},
          {"measured on", date_now()}};
}

Report measured(std::vector<Study> studies, const Effort& effort, const Progress& progress) {
  measure(studies, effort, [&](double done) { progress("times", kShareOfErrors + (1.0 - kShareOfErrors) * done); });
  Report report;
  report.machine = describe_machine();
  for (Study& study : studies) report.groups.push_back(std::move(study.group));
  return report;
}

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
  const Look looks[] = {
      {study_rotation, moving},           {study_storage, moving},          {study_influences, skinned},
      {study_skinning, skinned},          {study_skinned_normals, skinned}, {study_morphing, morphed},
      {study_arithmetic, skinned},        {study_retargeting, moving},      {study_geometry, moving},
      {study_inverse_kinematics, moving}, {study_springs, moving}};
  std::vector<Study> studies;
  for (const Look& look : looks) {
    progress("errors", kShareOfErrors * static_cast<double>(studies.size()) / static_cast<double>(std::size(looks)));
    studies.push_back(look.study(look.subject));
  }
  return measured(std::move(studies), effort, progress);
}

Report make_geometry_report(GeometryTake take, double budget_m, const Effort& effort, const Progress& progress) {
  progress("errors", 0.0);
  std::vector<Study> studies;
  studies.push_back(study_geometry(std::move(take), budget_m, effort));
  return measured(std::move(studies), effort, progress);
}

}  // namespace sinew::cost
