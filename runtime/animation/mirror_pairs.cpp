// SPDX-License-Identifier: MIT
#include "runtime/animation/mirror_pairs.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "runtime/animation/side_names.h"
#include "runtime/animation/truth_pose.h"
#include "runtime/base/contract.h"
#include "runtime/math/decompose.h"

namespace sinew {
namespace {

constexpr double kNear = 0.02;  // relative to the size: joints this near to each other's mirror image may be partners
constexpr std::size_t kMostSiblings = 256;  // above this, siblings are not compared by position
constexpr std::size_t kMostOffsets = 16;    // plane offsets that are tried
constexpr double kAlongAxis = 0.98;         // from this cosine on, the normal is rounded to a coordinate axis

bool is_own_partner(const std::vector<std::uint32_t>& partner, std::uint32_t j) noexcept { return partner[j] == j; }

/// The letters of a name, without the digits that number joints.
std::string letters_of(const std::string& name) {
  std::string letters;
  for (const char c : name)
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) letters += c;
  return letters;
}

/// Partners that the options give, then partners by names.
std::vector<std::uint32_t> named_partners(const Skeleton& skeleton, const MirrorOptions& options) {
  std::vector<std::uint32_t> partner = name_partners(skeleton.names);
  const auto part = [&](std::uint32_t joint) {
    const std::uint32_t other = partner[joint];
    partner[other] = other;
    partner[joint] = joint;
  };
  for (const auto& [a, b] : options.pairs) {
    CONTRACT(a < partner.size() && b < partner.size());
    part(a);
    part(b);
    partner[a] = b;
    partner[b] = a;
  }
  return partner;
}

/// Walks down the hierarchy and pairs joints under parents that are partners.
class Walk {
 public:
  Walk(const Skeleton& skeleton, const ReferencePose& reference, const MirrorOptions& options,
       std::vector<std::uint32_t> named, const Vec3<double>& normal, double offset)
      : skeleton_(skeleton), reference_(reference), options_(options), named_(std::move(named)) {
    const std::size_t joints = skeleton.joint_count();
    pairs_.normal = normal;
    pairs_.offset = offset;
    pairs_.partner.resize(joints);
    std::iota(pairs_.partner.begin(), pairs_.partner.end(), 0u);
    pairs_.keeps_own.resize(joints);
    decided_.resize(joints);
    siblings_.resize(joints + 1);
    for (std::uint32_t j = 0; j < joints; ++j) siblings_[slot(skeleton.parents[j])].push_back(j);
    for (std::uint32_t j = 0; j < joints && !has_names_; ++j) has_names_ = named_[j] != j;
  }

  JointPairs run() {
    for (std::uint32_t j = 0; j < decided_.size(); ++j)
      if (!decided_[j]) decide(j);
    std::sort(pairs_.unpaired.begin(), pairs_.unpaired.end());
    return std::move(pairs_);
  }

 private:
  std::size_t slot(std::uint32_t parent) const noexcept { return parent == kNone ? decided_.size() : parent; }
  std::uint32_t parents_partner(std::uint32_t j) const noexcept {
    const std::uint32_t parent = skeleton_.parents[j];
    return parent == kNone ? kNone : pairs_.partner[parent];
  }

  void decide(std::uint32_t j) {
    const std::uint32_t parent = skeleton_.parents[j];
    if (parent != kNone && pairs_.keeps_own[parent]) return keep_own(j, false);
    const std::uint32_t by_name = named_[j];
    if (by_name != j && by_name != kNone) {
      if (!decided_[by_name] && skeleton_.parents[by_name] == parents_partner(j)) return pair(j, by_name);
      named_[j] = named_[by_name] = kNone;  // their parents are not partners
    }
    if (const std::uint32_t by_place = nearest(j); by_place != kNone) return pair(j, by_place);
    if (parents_partner(j) == parent)
      pair(j, j);
    else
      keep_own(j, true);
  }

  void pair(std::uint32_t a, std::uint32_t b) {
    pairs_.partner[a] = b;
    pairs_.partner[b] = a;
    decided_[a] = decided_[b] = true;
    if (a == b && !is_forced(a) && asks_for_partner(a)) pairs_.unpaired.push_back(a);
  }
  void keep_own(std::uint32_t j, bool is_first) {
    pairs_.keeps_own[j] = decided_[j] = true;
    if (is_first) pairs_.unpaired.push_back(j);
  }

  bool is_forced(std::uint32_t j) const noexcept {
    return std::find(options_.pairs.begin(), options_.pairs.end(), std::array{j, j}) != options_.pairs.end();
  }
  bool asks_for_partner(std::uint32_t j) const {
    return side_of(skeleton_.names[j]) != Side::none ||
           std::abs(pairs_.distance(reference_.position(j))) > kNear * reference_.size;
  }
  /// True unless the names of both joints differ in more than digits.
  bool may_be_partners(std::uint32_t a, std::uint32_t b) const {
    return !has_names_ || letters_of(skeleton_.names[a]) == letters_of(skeleton_.names[b]);
  }

  /// The child of the parent's partner that is nearest to the mirror image of this joint; kNone if none is near.
  std::uint32_t nearest(std::uint32_t j) const {
    if (is_forced(j)) return kNone;
    const std::vector<std::uint32_t>& candidates = siblings_[slot(parents_partner(j))];
    if (candidates.size() > kMostSiblings) return kNone;
    const Vec3<double> image = pairs_.reflected(reference_.position(j));
    std::uint32_t best = kNone;
    double least = kNear * reference_.size;
    const auto offer = [&](std::uint32_t c) {
      const double apart = safe_length(image - reference_.position(c));
      if (apart > least || (apart == least && best != kNone)) return;
      best = c;
      least = apart;
    };
    if (parents_partner(j) == skeleton_.parents[j]) offer(j);
    for (const std::uint32_t c : candidates)
      if (c != j && !decided_[c] && (named_[c] == c || named_[c] == kNone) && may_be_partners(j, c)) offer(c);
    return best;
  }

  const Skeleton& skeleton_;
  const ReferencePose& reference_;
  const MirrorOptions& options_;
  std::vector<std::uint32_t> named_;
  std::vector<std::vector<std::uint32_t>> siblings_;  // children of each joint, then the roots
  std::vector<bool> decided_;
  bool has_names_ = false;
  JointPairs pairs_;
};

std::size_t count_pairs(const JointPairs& pairs) {
  std::size_t count = 0;
  for (std::uint32_t j = 0; j < pairs.partner.size(); ++j) count += !is_own_partner(pairs.partner, j);
  return count;
}

/// Computes the plane from given partners: the direction between partners, and the mean offset of their midpoints.
void plane_of_partners(const ReferencePose& reference, const std::vector<std::uint32_t>& partner, Vec3<double>& normal,
                       double& offset, bool normal_is_given) {
  Vec3<double> between(0.0), middles(0.0);
  double count = 0.0;
  for (std::uint32_t j = 0; j < partner.size(); ++j) {
    if (partner[j] <= j) continue;
    const Vec3<double> a = reference.position(j), b = reference.position(partner[j]);
    between += glm::dot(between, a - b) < 0.0 ? b - a : a - b;
    middles += (a + b) * 0.5;
    count += 1.0;
  }
  if (!normal_is_given) {
    normal = normalised_or(between, Vec3<double>(1.0, 0.0, 0.0));
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(normal[axis]) >= kAlongAxis) {
        normal = Vec3<double>(0.0);
        normal[axis] = 1.0;
      }
  }
  offset = glm::dot(normal, middles) / count;
}

/// Tries planes perpendicular to the coordinate axes. Returns the one at which most joints find a partner by position.
JointPairs best_by_places(const Skeleton& skeleton, const ReferencePose& reference, const MirrorOptions& options,
                          const std::vector<std::uint32_t>& named) {
  std::vector<Vec3<double>> normals = {{1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}};
  if (options.plane_normal) normals = {normalised_or(Vec3<double>(*options.plane_normal), normals[0])};
  std::vector<std::uint32_t> children(skeleton.joint_count()), places;
  for (const std::uint32_t parent : skeleton.parents)
    if (parent != kNone) ++children[parent];
  for (std::uint32_t j = 0; j < children.size() && places.size() < kMostOffsets; ++j)
    if (children[j] > 1 || skeleton.parents[j] == kNone) places.push_back(j);
  JointPairs best;
  bool is_first = true;
  for (const Vec3<double>& normal : normals)
    for (const std::uint32_t j : places) {
      JointPairs found =
          Walk(skeleton, reference, options, named, normal, glm::dot(normal, reference.position(j))).run();
      if (is_first || count_pairs(found) > count_pairs(best)) best = std::move(found);
      is_first = false;
    }
  Vec3<double> given = best.normal;
  if (count_pairs(best) > 0) plane_of_partners(reference, best.partner, given, best.offset, true);
  return best;
}

}  // namespace

ReferencePose reference_pose(const Skeleton& skeleton, std::span<const Transform> local) {
  CONTRACT(local.empty() || local.size() == skeleton.joint_count());
  ReferencePose pose;
  Vec3<double> low(0.0), high(0.0);
  for (std::uint32_t j = 0; j < skeleton.joint_count(); ++j) {
    const std::uint32_t fixed = skeleton.fixed_matrix_of[j], parent = skeleton.parents[j];
    Transformd own = in_double(local.empty() ? skeleton.rest[j] : local[j]);
    if (fixed != kNone) own = decompose_trs(affine_cast<double>(skeleton.fixed_matrices[fixed])).transform;
    own.rotation = normalised(own.rotation);
    pose.local.push_back(own);
    pose.rotation.push_back(parent == kNone ? own.rotation : normalised(pose.rotation[parent] * own.rotation));
    const Affined matrix = affine_from_transform(own);
    pose.model.push_back(parent == kNone ? matrix : pose.model[parent] * matrix);
    low = j == 0 ? pose.position(j) : glm::min(low, pose.position(j));
    high = j == 0 ? pose.position(j) : glm::max(high, pose.position(j));
  }
  pose.size = largest_component(high - low);
  return pose;
}

std::vector<std::uint32_t> symmetric_joints(const JointPairs& pairs) {
  std::vector<std::uint32_t> joints;
  for (std::uint32_t j = 0; j < pairs.partner.size(); ++j)
    if (!pairs.keeps_own[j] && !std::binary_search(pairs.unpaired.begin(), pairs.unpaired.end(), j))
      joints.push_back(j);
  return joints;
}

double asymmetry_of(const ReferencePose& reference, const JointPairs& pairs,
                    std::span<const std::uint32_t> joints) noexcept {
  double sum = 0.0;
  for (const std::uint32_t j : joints)
    sum += safe_length(pairs.reflected(reference.position(j)) - reference.position(pairs.partner[j]));
  return sum > 0.0 ? sum / static_cast<double>(joints.size()) / reference.size : 0.0;
}

JointPairs pair_joints(const Skeleton& skeleton, const ReferencePose& reference, const MirrorOptions& options) {
  const std::vector<std::uint32_t> named = named_partners(skeleton, options);
  bool has_pairs = false;
  for (std::uint32_t j = 0; j < named.size(); ++j) has_pairs |= named[j] != j;
  if (!has_pairs) return best_by_places(skeleton, reference, options, named);
  Vec3<double> normal(1.0, 0.0, 0.0);
  if (options.plane_normal) normal = normalised_or(Vec3<double>(*options.plane_normal), normal);
  double offset = 0.0;
  plane_of_partners(reference, named, normal, offset, options.plane_normal.has_value());
  return Walk(skeleton, reference, options, named, normal, offset).run();
}

}  // namespace sinew
