// SPDX-License-Identifier: MIT
#include "importer/tool/poses/compare_poses.h"
#include "importer/tool/poses/pose_input.h"
#include "tests/fuzz/fuzz_targets.h"

namespace sinew::fuzz {

void read_poses(Bytes input) {
  tool::PoseComparison comparison({});
  const auto compare = [&](std::size_t, const tool::Pose& pose) {
    comparison.compare(0, pose, pose);
    return true;
  };
  const auto file = tool::parse_poses({reinterpret_cast<const char*>(input.data()), input.size()}, compare);
  if (!file) require(!file.error().rule.empty(), "an error names its rule");
  require(comparison.failed() == 0, "poses agree with themselves");
}

}  // namespace sinew::fuzz
