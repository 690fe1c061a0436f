// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "importer/tool/cost/report.h"
#include "importer/tool/cost/study.h"
#include "runtime/model/scene.h"

namespace sinew::cost {

using Progress = std::function<void(const char* work, double done_0_to_1)>;

/// The scenes that the groups look at: one file's for all, or those of the showcase, each where it has something to
/// show.
struct Scenes {
  const Scene* moving = nullptr;
  const Scene* skinned = nullptr;
  const Scene* morphed = nullptr;
};

/// Looks at every choice, on one clip of each scene, and measures all of them together.
/// in   clip  of a file's scene; nothing = the one that moves most joints
/// cost about a second (quick) or twenty, on the calling thread
Report make_report(const Scenes& scenes, std::optional<std::uint32_t> clip, const Effort& effort,
                   const Progress& progress);

}  // namespace sinew::cost
