// SPDX-License-Identifier: MIT
#include <string>

#include "importer/tool/compare_poses.h"
#include "importer/tool/pose_input.h"
#include "tests/fuzz/fuzz_targets.h"

namespace sinew::fuzz {

void read_poses(Bytes input) {
  const auto file = tool::parse_poses(std::string(reinterpret_cast<const char*>(input.data()), input.size()));
  if (!file) return require(!file.error().rule.empty(), "an error names its rule");
  tool::PoseComparison comparison({}, 8);
  for (const auto& clip : file->clips)
    for (const auto& pose : clip.samples) comparison.compare(clip.clip, pose, pose);
  require(comparison.failed() == 0, "poses agree with themselves");
}

}  // namespace sinew::fuzz
