// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/base/index.h"
#include "runtime/math/conventions.h"

namespace sinew {

/// A shape that the tails of springs stay out of, or inside of. It moves with a joint of the animated pose.
struct SpringCollider {
  enum class Kind : std::uint8_t { sphere, capsule, plane };
  Kind kind = Kind::sphere;
  std::uint32_t joint = kNone;
  Vec3<double> offset{0.0};            ///< centre, first end of a capsule, or a point of the plane; space of the joint
  Vec3<double> tail{0.0};              ///< capsule only: the second end
  Vec3<double> normal{0.0, 1.0, 0.0};  ///< plane only: points to the free side
  double radius_m = 0.0;               ///< world metres: the scale of the joint does not change it
  bool inside = false;                 ///< sphere or capsule: keeps tails inside
};

/// Direction that stiffness pulls a joint to.
enum class SpringGoal : std::uint8_t {
  rest,  ///< the rest rotation, as VRM says; the animated rotation of the joint is ignored
  pose,  ///< the animated rotation, for jiggle on top of clips
};

/// Values that all joints of one spring share.
struct SpringGroup {
  std::uint32_t center = kNone;  ///< joint; inertia is relative to it, kNone = to the world
  SpringGoal goal = SpringGoal::rest;
  std::vector<std::uint32_t> colliders;  ///< into SpringSetup::colliders, tested in this order
};

/// A joint that swings about its origin. Its tail is a point mass at a fixed distance.
struct SpringJoint {
  std::uint32_t joint = kNone;
  std::uint32_t group = 0;        ///< into SpringSetup::groups
  Vec3<double> tail_m{0.0};       ///< in the space of the joint: as a rule the translation of its child
  double stiffness = 1.0;         ///< pull to the goal, metres per second in each 1/60 s
  double drag = 0.4;              ///< [0, 1] part of the velocity that is lost in 1/60 s
  Vec3<double> gravity_m_s{0.0};  ///< pull of constant direction, metres per second in each 1/60 s
  double hit_radius_m = 0.0;      ///< radius of the tail against colliders, world metres

  /// The tail is held at the distance that its place of the tick before has from the new head, with the chain moved
  /// along. The reference implementation of VRM 1.0 works so, and characters are tuned with it. Otherwise the distance
  /// is the length of the bone.
  bool lagging_length = false;
};

/// Springs of a character, as a file or an engine states them.
struct SpringSetup {
  std::vector<SpringGroup> groups;
  std::vector<SpringJoint> joints;  ///< in any order; each joint at most once
  std::vector<SpringCollider> colliders;
};

/// How springs are stepped. Results depend on `tick_s`, and not on how many frames an engine shows.
struct SpringSettings {
  double tick_s = 1.0 / 60.0;      ///< > 0. VRM's equation has a time step in it, and characters are tuned at 1/60 s.
  std::uint32_t max_ticks = 8;     ///< >= 1; time beyond these ticks of one frame is dropped
  double sleep_rad_per_s = 1e-4;   ///< joints slower than this count as quiet; 0 = springs never sleep
  std::uint32_t sleep_ticks = 15;  ///< springs sleep after this many quiet ticks without a change of input
};

}  // namespace sinew
