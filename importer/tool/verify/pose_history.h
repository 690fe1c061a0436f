// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "importer/tool/poses/compare_poses.h"
#include "runtime/animation/skeleton.h"

namespace sinew::tool {

using Point = std::array<double, 3>;  ///< in world space, in the unit of the file

/// One joint through all samples of one clip.
struct JointHistory {
  std::string name;  ///< as PoseComparison shows it
  std::uint32_t clip = kNone, node = kNone;
  double worst_s = 0.0;  ///< when the joint is farthest from its golden pose
  std::vector<double> times_s;
  std::vector<Point> golden, now;
  std::vector<double> turned_deg;  ///< the largest angle between an axis and the golden axis
};

/// Both poses at the worst time: joints, the bones between them, and the vertices that the golden pose lists.
struct PoseFigure {
  std::uint32_t clip = kNone;
  double time_s = 0.0;
  std::vector<std::pair<std::size_t, std::size_t>> bones;  ///< indices into both arrays of joints
  std::vector<Point> golden, now;
  std::vector<Point> golden_vertices, vertices;
};

/// Facts for drawing where a file differs from its golden poses.
struct PoseHistory {
  std::vector<std::string> starts;  ///< moved joints without a moved joint above them: the cause is in these
  std::vector<JointHistory> joints;
  PoseFigure figure;

  /// Chooses what to record: the first joint of `starts`, then the worst ones; and the time of the worst difference.
  /// in   worst  from PoseComparison::worst()
  static PoseHistory of(const std::vector<Deviation>& worst, const Skeleton& skeleton, const PoseNames& names);

  /// Records one sample of both. Samples come in the order of the golden file.
  void add(std::uint32_t clip, const Pose& golden, const Pose& pose, const Skeleton& skeleton);
};

}  // namespace sinew::tool
