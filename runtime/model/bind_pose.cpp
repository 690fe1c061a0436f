// SPDX-License-Identifier: MIT
#include "runtime/model/bind_pose.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

#include "runtime/animation/truth_pose.h"
#include "runtime/math/decompose.h"
#include "runtime/math/inverse.h"
#include "runtime/math/matrix_rotation.h"

namespace sinew {
namespace {

constexpr double kSame = 1e-4;          // radians, and fractions of the size and of scales: what files round
constexpr double kOtherPose = 1e-3;     // as kSame; from this difference on, two skins show another pose
constexpr double kSameUnit = 0.05;      // relative difference of units; a pose may scale its top joint a little
constexpr double kMostTurned = 1.05;    // radians that a pose may turn the top joint of a skin: 60 degrees
constexpr double kFarthest = 1.0;       // fraction of the size that a pose may move the top joint of a skin
constexpr double kTurnedLittle = 0.52;  // as kMostTurned, for a space that belongs to no node: 30 degrees
constexpr double kNearest = 0.25;       // as kFarthest, for a space that belongs to no node
constexpr double kRounds = 0.01;        // relative distance of a unit from a power of ten that counts as rounding

double unit_of(const Affined& m) noexcept { return std::cbrt(std::abs(determinant(m))); }

/// How far two model matrices of one joint are from each other.
struct Difference {
  double angle_rad = 0.0, distance = 0.0, unit = 1.0;  ///< unit: the scale of one, divided by that of the other

  bool is_plausible_pose(double size) const noexcept {
    return std::abs(unit - 1.0) <= kSameUnit && angle_rad <= kMostTurned && distance <= kFarthest * size;
  }
};

Difference difference_of(const Affined& a, const Affined& b) noexcept {
  const auto turned = [](const Affined& m) { return decompose_polar(linear_part(m)).quat; };
  return {rotation_angle_between(turned(a), turned(b)), safe_length(translation_of(a) - translation_of(b)),
          unit_of(a) / unit_of(b)};
}

/// Bind matrices of the joints of a skin, in the space in which it was bound.
struct BoundSkin {
  std::uint32_t skin = 0;
  std::vector<std::uint32_t> joints;  ///< joints of the skin, rising
  std::vector<Affined> bind;          ///< parallel to `joints`
  std::vector<std::uint32_t> tops;    ///< rising; joints without an ancestor in the skin

  /// Null if no bind matrix tells where the joint stands.
  const Affined* find(std::uint32_t joint) const noexcept {
    const auto at = std::lower_bound(joints.begin(), joints.end(), joint);
    return at == joints.end() || *at != joint ? nullptr : &bind[static_cast<std::size_t>(at - joints.begin())];
  }
};

bool tells_a_pose(const Skin& skin) noexcept {
  const auto same = [&](const Affine& m) { return m == skin.inverse_bind.front(); };
  if (skin.inverse_bind.empty()) return false;
  const bool all_same = std::all_of(skin.inverse_bind.begin(), skin.inverse_bind.end(), same);
  return !all_same || (skin.inverse_bind.size() == 1 && skin.inverse_bind.front() != Affine{});
}

std::uint32_t nearest_above(const Skeleton& skeleton, const BoundSkin& bound, std::uint32_t joint) noexcept {
  do joint = skeleton.parents[joint];
  while (joint != kNone && bound.find(joint) == nullptr);
  return joint;
}

BoundSkin bound_skin(const Scene& scene, std::uint32_t s) {
  const Skin& skin = scene.skins[s];
  BoundSkin bound{s, {}, {}, {}};
  if (!tells_a_pose(skin)) return bound;
  std::vector<std::size_t> order(skin.joints.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return skin.joints[a] < skin.joints[b]; });
  for (const std::size_t i : order)
    if (const auto bind = inverse_of(affine_cast<double>(skin.inverse_bind[i]))) {
      bound.joints.push_back(skin.joints[i]);
      bound.bind.push_back(*bind);
    }
  for (const std::uint32_t j : bound.joints)
    if (nearest_above(scene.skeleton, bound, j) == kNone) bound.tops.push_back(j);
  return bound;
}

/// The skins whose bind matrices tell a pose; skins with more joints come first.
std::vector<BoundSkin> bound_skins(const Scene& scene) {
  std::vector<std::uint32_t> order(scene.skins.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return scene.skins[a].joints.size() > scene.skins[b].joints.size();
  });
  std::vector<BoundSkin> skins;
  for (const std::uint32_t s : order)
    if (BoundSkin bound = bound_skin(scene, s); !bound.tops.empty()) skins.push_back(std::move(bound));
  return skins;
}

/// The rotation by quarter turns about axes that is nearest to a rotation.
Mat3<double> quarter_turns(const Mat3<double>& rotation) noexcept {
  constexpr int kOrders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  Mat3<double> best(1.0);
  double most = -4.0;
  for (const auto& order : kOrders)
    for (int signs = 0; signs < 8; ++signs) {
      Mat3<double> turn(0.0);
      for (int c = 0; c < 3; ++c) turn[c][order[c]] = (signs >> c & 1) != 0 ? -1.0 : 1.0;
      double trace = 0.0;  // of transpose(turn) * rotation: 1 + 2 cos of the angle between both
      for (int c = 0; c < 3; ++c) trace += glm::dot(turn[c], rotation[c]);
      if (glm::determinant(turn) < 0.0 || trace <= most) continue;
      most = trace;
      best = turn;
    }
  return best;
}

double rounded_unit(double unit) noexcept {
  const double power = std::pow(10.0, std::round(std::log10(unit)));
  return std::abs(unit / power - 1.0) <= kRounds ? power : unit;
}

/// Finds the bind pose, joint by joint.
class Posing {
 public:
  explicit Posing(const Scene& scene) : scene_(scene), skeleton_(scene.skeleton), skins_(bound_skins(scene)) {
    for (const Transform& local : skeleton_.rest) rest_.push_back(in_double(local));
    rest_model_.resize(rest_.size());
    model_from_local(skeleton_, rest_, rest_model_);
    placed_.resize(skins_.size());
    skins_of_joint_.resize(rest_.size());
    for (std::uint32_t s = 0; s < skins_.size(); ++s)
      for (const std::uint32_t j : skins_[s].joints) skins_of_joint_[j].push_back(s);
    pose_.local = skeleton_.rest;
    pose_.is_bound.resize(rest_.size());
    measure_size();
  }

  BindPose run() {
    for (std::uint32_t j = 0; j < rest_.size(); ++j) place(j);
    std::sort(pose_.other_skins.begin(), pose_.other_skins.end());
    return std::move(pose_);
  }

 private:
  void measure_size() {
    Vec3<double> low(std::numeric_limits<double>::infinity()), high(-low);
    for (const BoundSkin& skin : skins_)
      for (const std::uint32_t j : skin.joints) {
        low = glm::min(low, translation_of(rest_model_[j]));
        high = glm::max(high, translation_of(rest_model_[j]));
      }
    if (!skins_.empty()) pose_.size = largest_component(high - low);
    if (!(pose_.size > 0.0)) pose_.size = 1.0;
  }

  /// The model matrix that a joint has if only joints above it leave their rest transform.
  Affined carried(std::uint32_t j) const noexcept {
    const std::uint32_t parent = skeleton_.parents[j];
    if (parent == kNone || parent >= model_.size()) return rest_model_[j];
    return model_[parent] * local_matrix(j);
  }
  Affined local_matrix(std::uint32_t j) const noexcept {
    const std::uint32_t fixed = skeleton_.fixed_matrix_of[j];
    return fixed == kNone ? affine_from_transform(rest_[j]) : affine_cast<double>(skeleton_.fixed_matrices[fixed]);
  }

  void place(std::uint32_t j) {
    const std::uint32_t parent = skeleton_.parents[j];
    const Affined at_rest = carried(j);
    std::optional<Affined> bound;
    for (const std::uint32_t s : skins_of_joint_[j]) {
      if (!bound)
        bound = bound_matrix(s, j);
      else
        compare(s, j, *bound);
    }
    pose_.is_bound[j] = bound.has_value();
    if (bound && skeleton_.fixed_matrix_of[j] == kNone) set_local(j, parent, *bound);
    model_.push_back(pose_.local[j] == skeleton_.rest[j] ? at_rest
                                                         : (parent == kNone ? Affined{} : model_[parent]) *
                                                               affine_from_transform(in_double(pose_.local[j])));
    if (!bound) return;
    const double distance = safe_length(translation_of(model_[j]) - translation_of(rest_model_[j]));
    if (distance <= pose_.distance) return;
    pose_.distance = distance;
    pose_.joint = j;
  }

  /// eq   M_j of bind_pose.h
  Affined bound_matrix(std::size_t s, std::uint32_t j) {
    const BoundSkin& skin = skins_[s];
    const std::uint32_t above = nearest_above(skeleton_, skin, j);
    if (above != kNone) {
      const auto to_above = inverse_of(*skin.find(above));
      return to_above ? model_[above] * *to_above * *skin.find(j) : carried(j);
    }
    if (!placed_[s]) placed_[s] = space_of(skin, j);
    return *placed_[s] * *skin.find(j);
  }

  /// X of bind_pose.h
  /// in   first  the first top joint of the skin
  Affined space_of(const BoundSkin& skin, std::uint32_t first) const {
    const auto from_bind = inverse_of(*skin.find(first));
    const Affined as_rested = from_bind ? carried(first) * *from_bind : Affined{};
    if (rests_as_bound(skin, as_rested)) return as_rested;
    std::optional<Affined> best;
    double least = std::numeric_limits<double>::infinity();
    const auto offer = [&](const Affined& space) {
      double sum = 0.0;
      for (const std::uint32_t top : skin.tops) {
        const Difference off = difference_of(space * *skin.find(top), carried(top));
        if (!off.is_plausible_pose(pose_.size)) return;
        sum += off.angle_rad + off.distance / pose_.size;
      }
      if (sum >= least) return;
      least = sum;
      best = space;
    };
    for (const MeshInstance& instance : scene_.instances)
      if (instance.skin == skin.skin && nearest_above(skeleton_, skin, instance.joint) == kNone)
        offer(rest_model_[instance.joint]);
    for (const std::uint32_t top : skin.tops)
      for (std::uint32_t j = skeleton_.parents[top]; j != kNone; j = skeleton_.parents[j])
        offer(j < model_.size() ? model_[j] : rest_model_[j]);
    offer(Affined{});
    if (best) return *best;

    const std::uint32_t parent = skeleton_.parents[first];
    const Affined above = parent == kNone ? Affined{} : model_[parent];
    const auto to_above = inverse_of(above);
    if (!to_above) return as_rested;
    const Affined near = *to_above * as_rested;
    const double unit = rounded_unit(unit_of(near));
    const Mat3<double> turn = quarter_turns(matrix_from_unit_quat(decompose_polar(linear_part(near)).quat));
    const Affined turned = above * affine_from(turn * unit, Vec3<double>(0.0));
    const Difference off = difference_of(turned * *skin.find(first), carried(first));
    return off.angle_rad <= kTurnedLittle && off.distance <= kNearest * pose_.size ? turned : as_rested;
  }

  /// True if the joints of a skin have the same places relative to each other as when they were bound. A file may put
  /// such a body anywhere.
  bool rests_as_bound(const BoundSkin& skin, const Affined& space) const noexcept {
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
      const Difference off = difference_of(space * skin.bind[i], rest_model_[skin.joints[i]]);
      if (off.angle_rad > kOtherPose || off.distance > kOtherPose * pose_.size) return false;
    }
    return true;
  }

  /// Lists a skin if its pose differs from that of the skins before it.
  void compare(std::size_t s, std::uint32_t j, const Affined& bound) {
    const BoundSkin& skin = skins_[s];
    const std::uint32_t above = nearest_above(skeleton_, skin, j);
    std::optional<Affined> own;
    if (above == kNone && !placed_[s]) {  // Joints that two skins share tell how the spaces of the skins are related.
      if (const auto from_bind = inverse_of(*skin.find(j))) placed_[s] = bound * *from_bind;
    } else {
      own = bound_matrix(s, j);
    }
    if (!own || is_listed(skin.skin)) return;
    const Difference off = difference_of(*own, bound);
    if (off.angle_rad > kOtherPose || off.distance > kOtherPose * pose_.size) pose_.other_skins.push_back(skin.skin);
  }
  bool is_listed(std::uint32_t skin) const noexcept {
    return std::find(pose_.other_skins.begin(), pose_.other_skins.end(), skin) != pose_.other_skins.end();
  }

  /// Parts that agree with the rest pose keep its bits.
  void set_local(std::uint32_t j, std::uint32_t parent, const Affined& bound) {
    const auto to_parent = parent == kNone ? std::optional(Affined{}) : inverse_of(model_[parent]);
    if (!to_parent) return;
    const Transformd& rest = rest_[j];
    Mat3<double> linear = linear_part(*to_parent * bound);
    Vec3<double> signs(1.0);  // A matrix does not tell which axes a negative scale mirrors, so the rest pose does.
    for (int c = 0; c < 3; ++c) {
      signs[c] = rest.scale[c] < 0.0 ? -1.0 : 1.0;
      linear[c] *= signs[c];
    }
    const Vec3<double> translation = translation_of(*to_parent * bound);
    const Transformd own = decompose_trs(affine_from(linear, translation)).transform;
    const Vec3<double> scale = own.scale * signs;
    const double unit = parent == kNone ? 1.0 : unit_of(model_[parent]);
    Transform& local = pose_.local[j];
    if (safe_length(translation - rest.translation) * unit > kSame * pose_.size)
      local.translation = glm::vec3(translation);
    if (rotation_angle_between(own.rotation, rest.rotation) > kSame)
      local.rotation = quat_cast<float>(aligned_with(rest.rotation, normalised(own.rotation)));
    if (largest_component(scale - rest.scale) > kSame * largest_component(rest.scale)) local.scale = glm::vec3(scale);
    if (!(local == skeleton_.rest[j])) pose_.differs.push_back(j);
  }

  const Scene& scene_;
  const Skeleton& skeleton_;
  std::vector<BoundSkin> skins_;
  std::vector<std::vector<std::uint32_t>> skins_of_joint_;  // indices into skins_, rising
  std::vector<std::optional<Affined>> placed_;              // [skins_] X
  std::vector<Transformd> rest_;
  std::vector<Affined> rest_model_, model_;  // model_ has the joints that are placed
  BindPose pose_;
};

}  // namespace

BindPose bind_pose(const Scene& scene) { return Posing(scene).run(); }

}  // namespace sinew
