// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "importer/tool/poses/pose.h"

namespace sinew::tool {

/// One value that differs: by how much, and how much is allowed.
struct Deviation {
  std::string where;    ///< "clip 0, 1.5 s, node 3, primitive 0, vertex 17, positions"
  double amount = 0.0;  ///< infinite when the value is missing
  double tolerance = 0.0;
  const char* unit = "m";  ///< "m", "" for directions and weights, "bits" for hashes

  double severity() const noexcept { return amount / tolerance; }
};

/// How far values may differ. Lengths are in the unit of the file, metres by the specification.
/// - Positions, dqs and translations of nodes: the distance. Rotation and scale of nodes: the distance by which they
///   move a point that is one model size away, relative to the node's largest matrix entry.
/// - Directions and weights: the absolute difference. Weights beyond 1 are compared relative to the largest.
/// All tolerances grow by 1.5 times Pose::non_unit of the golden sample, because rotations that are not unit
/// quaternions may be normalised or not.
struct PoseTolerance {
  std::optional<double> distance_m;  ///< empty = `relative` times the larger of model size and value
  double relative = 1e-4;
  double direction = 1e-3;
  double weight = 1e-4;
  double model_size_m = 1.0;
  bool exact = false;  ///< every hash of Pose::bits must be equal, too
};

/// Compares poses: looks up everything that the golden pose holds. Null entries of the golden pose are skipped.
class PoseComparison {
 public:
  PoseComparison(const PoseTolerance& tolerance, std::size_t keep_worst)
      : tolerance_(tolerance), keep_worst_(keep_worst) {}

  void compare(std::uint32_t clip, const Pose& golden, const Pose& pose);
  void missing(std::string where);  ///< a whole clip or sample is missing

  std::uint64_t compared() const noexcept { return compared_; }
  std::uint64_t failed() const noexcept { return failed_; }
  double largest_m() const noexcept { return largest_m_; }                 ///< of the values with a unit
  const std::vector<Deviation>& worst() const noexcept { return worst_; }  ///< worst first

 private:
  double allowed_m(double size_m) const noexcept;
  void compare_bits(const Pose& golden, const Pose& pose, const std::string& where);
  void compare_node(const NodeWorld& golden, const NodeWorld* pose, const std::string& where);
  void compare_primitive(const PrimitivePose& golden, const PrimitivePose* pose, const std::string& where);
  template <class Where>
  void add(double amount, double tolerance, const char* unit, const Where& where);

  PoseTolerance tolerance_;
  std::size_t keep_worst_;
  double slack_ = 0.0;
  std::uint64_t compared_ = 0, failed_ = 0;
  double largest_m_ = 0.0;
  std::vector<Deviation> worst_;
};

}  // namespace sinew::tool
