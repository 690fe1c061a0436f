// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "importer/geometry_cache/geometry_take.h"
#include "importer/tool/cost/report.h"
#include "importer/tool/cost/study.h"
#include "runtime/model/scene.h"

namespace sinew::cost {

using Progress = std::function<void(const char* work, double done_0_to_1)>;

/// The scenes that the studies look at: one file's scene for all, or scenes of the showcase that suit each study.
struct Scenes {
  const Scene* moving = nullptr;
  const Scene* skinned = nullptr;
  const Scene* morphed = nullptr;
};

/// Runs every study on one clip of each scene, and measures the times of all of them together.
/// in    clip   of a file's scene; empty = the clip that animates most joints
/// cost  about one second (quick) or twenty, on the calling thread
Report make_report(const Scenes& scenes, std::optional<std::uint32_t> clip, const Effort& effort,
                   const Progress& progress);

/// The study of geometry caches alone, on positions that are known for every frame.
Report make_geometry_report(GeometryTake take, double budget_m, const Effort& effort, const Progress& progress);

}  // namespace sinew::cost
