// SPDX-License-Identifier: MIT
#include <cmath>
#include <utility>

#include "runtime/math/quaternion.h"
#include "runtime/procedures/constraints/node_constraints.h"

namespace sinew {

/// Depth-first sort: each constraint is placed after the constraints of the joints that it reads.
class ConstraintSorter {
 public:
  ConstraintSorter(const Skeleton& skeleton, std::span<const NodeConstraint> constraints)
      : skeleton_(skeleton), from_(constraints), of_joint_(skeleton.joint_count(), kNone) {
    made_.joints_ = skeleton.joint_count();
  }

  tl::expected<NodeConstraints, ConstraintFault> sort() {
    for (std::size_t c = 0; c < from_.size() && fault_.code == ErrorCode::ok; ++c) check_one(c);
    stages_.assign(from_.size(), Stage::waiting);
    for (std::size_t c = 0; c < from_.size() && fault_.code == ErrorCode::ok; ++c) visit(static_cast<std::uint32_t>(c));
    if (fault_.code != ErrorCode::ok) return tl::unexpected(std::move(fault_));
    return std::move(made_);
  }

 private:
  enum class Stage : std::uint8_t { waiting, open, done };

  /// A constraint that is being placed, and the joint whose constraint it waits for.
  struct Visit {
    std::uint32_t constraint;
    std::uint32_t next;  ///< next joint to look at; then its parents
    std::uint32_t then;  ///< second joint to start from afterwards; kNone = none
  };

  void refuse(std::size_t index, ErrorCode code, const std::string& rule) {
    if (fault_.code == ErrorCode::ok) fault_ = {code, "constraints[" + std::to_string(index) + "]: " + rule};
  }

  void check_one(std::size_t index) {
    const NodeConstraint& c = from_[index];
    const std::size_t joints = skeleton_.joint_count();
    if (c.joint >= joints || c.source >= joints)
      return refuse(index, ErrorCode::index_out_of_range, "the skeleton has no such joint");
    if (of_joint_[c.joint] != kNone)
      return refuse(index, ErrorCode::index_out_of_range, "joint " + name_of(c.joint) + " has a constraint already");
    if (skeleton_.fixed_matrix_of[c.joint] != kNone)
      return refuse(index, ErrorCode::unsupported, "joint " + name_of(c.joint) + " has a fixed matrix");
    const double length = safe_length(c.axis);
    if (!std::isfinite(length)) return refuse(index, ErrorCode::not_finite, "its axis is not finite");
    if (c.kind != NodeConstraint::Kind::rotation && length == 0.0)
      return refuse(index, ErrorCode::unsupported, "its axis has no direction");
    if (!(c.weight >= 0.0 && c.weight <= 1.0))
      return refuse(index, ErrorCode::not_a_fraction, "its weight is not between 0 and 1");
    of_joint_[c.joint] = static_cast<std::uint32_t>(index);
  }

  Visit opened(std::uint32_t constraint) {
    stages_[constraint] = Stage::open;
    const NodeConstraint& c = from_[constraint];
    const bool is_aim = c.kind == NodeConstraint::Kind::aim;
    return {constraint, c.source, is_aim ? skeleton_.parents[c.joint] : kNone};
  }

  /// Places a constraint and all that it needs. No recursion, since a file may have a chain of any length.
  void visit(std::uint32_t first) {
    if (stages_[first] != Stage::waiting) return;
    std::vector<Visit> open{opened(first)};
    while (!open.empty() && fault_.code == ErrorCode::ok) {
      Visit& top = open.back();
      const NodeConstraint& constraint = from_[top.constraint];
      if (top.next == kNone) {
        top.next = std::exchange(top.then, kNone);
        if (top.next != kNone) continue;
        stages_[top.constraint] = Stage::done;
        made_.ordered_.push_back(constraint);
        open.pop_back();
        continue;
      }
      const std::uint32_t joint = top.next, needed = of_joint_[joint];
      top.next = constraint.kind == NodeConstraint::Kind::aim ? skeleton_.parents[joint] : kNone;
      if (needed == kNone || stages_[needed] == Stage::done) continue;
      if (stages_[needed] == Stage::open) return name_circle(open, needed);
      open.push_back(opened(needed));
    }
  }

  void name_circle(const std::vector<Visit>& open, std::uint32_t first) {
    std::size_t begin = 0;
    while (open[begin].constraint != first) ++begin;
    std::string text = "joint " + name_of(from_[first].joint);
    for (std::size_t i = begin + 1; i < open.size(); ++i)
      text += " follows " + name_of(from_[open[i].constraint].joint) + ", which";
    refuse(first, ErrorCode::follows_itself, text + " follows " + name_of(from_[first].joint));
  }

  std::string name_of(std::uint32_t joint) const { return '"' + skeleton_.names[joint] + '"'; }

  const Skeleton& skeleton_;
  std::span<const NodeConstraint> from_;
  NodeConstraints made_;
  ConstraintFault fault_;
  std::vector<std::uint32_t> of_joint_;  ///< [joints] the constraint of a joint; kNone = none
  std::vector<Stage> stages_;            ///< [constraints]
};

tl::expected<NodeConstraints, ConstraintFault> sort_constraints(const Skeleton& skeleton,
                                                                std::span<const NodeConstraint> constraints) {
  return ConstraintSorter(skeleton, constraints).sort();
}

}  // namespace sinew
