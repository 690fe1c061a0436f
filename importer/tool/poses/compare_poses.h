// SPDX-License-Identifier: MIT
#pragma once
#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "importer/tool/poses/pose.h"

namespace sinew::tool {

/// The largest difference among values of one kind in one node or primitive, and the allowed difference.
struct Deviation {
  std::string where;    ///< "clip 0 "Walk", 1.5 s, node 3 "hand", primitive 0, vertex 17, positions"
  double amount = 0.0;  ///< infinite when the value is missing
  double tolerance = 0.0;
  const char* unit = "m";  ///< "m", "deg" for directions, "" for weights, "bits" for hashes, "numbers" for vertices
                           ///< that have other ones
  std::uint64_t more = 0;  ///< number of other values of this kind that are out of tolerance
  const char* kind = "";   ///< "translation", "matrix", "weights", "bits", or a key of kVertexKinds; a literal
  std::uint32_t clip = kNone, node = kNone;  ///< kNone: the rest pose, or a value that belongs to no node
  double time_s = 0.0;

  /// True if this is farther out of its tolerance. Of two without a tolerance, or of two that are missing, the larger
  /// is.
  bool is_worse_than(const Deviation& other) const noexcept;
};

/// Names that deviations show in quotes after numbers; lists may be shorter, and names empty.
struct PoseNames {
  std::vector<std::string> clips, nodes;
};

/// How far values may differ. Lengths are in the unit of the file, metres by the specification.
/// - Positions, dqs and translations of nodes: the distance. Rotation and scale of nodes: the distance by which they
///   move a point that is one model size away, relative to the node's largest matrix entry.
/// - With `matrix` rotation and scale of nodes instead: the largest difference of a matrix entry, relative to the
///   largest.
/// - Directions: the angle. Weights: the absolute difference; beyond 1 it is relative to the largest.
/// All tolerances grow by 1.5 times Pose::non_unit of the golden sample, because rotations that are not unit
/// quaternions may be normalised or not.
struct PoseTolerance {
  std::optional<double> distance_m;  ///< empty = `relative` times the larger of model size and value
  double relative = 1e-4;
  double direction = 1e-3;  ///< length of the difference of unit vectors: radians, for small angles
  double weight = 1e-4;
  std::optional<double> matrix = std::nullopt;
  double model_size_m = 1.0;
  bool exact = false;  ///< every hash of Pose::bits must be equal, too
};

/// Compares poses: looks up everything that the golden pose holds. Null entries of the golden pose are skipped.
class PoseComparison {
 public:
  explicit PoseComparison(const PoseTolerance& tolerance, PoseNames names = {})
      : tolerance_(tolerance), names_(std::move(names)) {}

  /// out   the largest difference of this pose over its tolerance; infinite when a value is missing
  double compare(std::uint32_t clip, const Pose& golden, const Pose& pose);
  void missing(std::string where);  ///< a whole clip or sample is missing

  std::uint64_t compared() const noexcept { return compared_; }
  std::uint64_t failed() const noexcept { return failed_; }
  double largest_m() const noexcept { return largest_m_; }  ///< the largest difference of a value with a unit
  std::vector<Deviation> worst() const;  ///< the worst first, one for each kind of values of a node or primitive
  std::string clip_text(std::uint32_t clip) const;  ///< as in Deviation::where
  const PoseNames& names() const noexcept { return names_; }

 private:
  double allowed_m(double size_m) const noexcept;
  void compare_bits(const Pose& golden, const Pose& pose, const std::string& where);
  void compare_node(const NodeWorld& golden, const NodeWorld* pose, const std::string& where);
  void compare_primitive(const PrimitivePose& golden, const PrimitivePose* pose, const std::string& where);
  bool report_renumbered(const PrimitivePose& golden, const PrimitivePose& pose, const std::string& where);
  std::string node_text(std::uint32_t node) const;
  /// The kind of values that a deviation belongs to, and its node and primitive.
  struct Kind {
    const char* name = "";  ///< points to a literal
    std::uint32_t node = kNone, primitive = kNone;
    friend auto operator<=>(const Kind&, const Kind&) = default;
  };
  template <class Where>
  void add(const Kind& kind, double amount, double tolerance, const char* unit, const Where& where);

  PoseTolerance tolerance_;
  double slack_ = 0.0;
  std::uint32_t clip_ = kNone;  // of the pose that is compared, with its time and largest difference over tolerance
  double time_s_ = 0.0, ratio_ = 0.0;
  std::uint64_t compared_ = 0, failed_ = 0;
  double largest_m_ = 0.0;
  PoseNames names_;
  std::map<Kind, Deviation> worst_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> renumbered_;  ///< node and primitive
};

}  // namespace sinew::tool
