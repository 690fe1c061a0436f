// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/base/index.h"
#include "runtime/math/conventions.h"

namespace sinew {

/// A shape that keeps the tails of springs outside, or inside. It moves with a joint of the animated pose.
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

/// Direction towards which stiffness pulls a joint.
enum class SpringGoal : std::uint8_t {
  rest,  ///< the rest rotation, as in VRM; the animated rotation is ignored
  pose,  ///< the animated rotation, for secondary motion on top of clips
};

/// Values that all joints of one spring share.
struct SpringGroup {
  std::uint32_t center = kNone;  ///< joint relative to which inertia is computed; kNone = the world
  SpringGoal goal = SpringGoal::rest;
  std::vector<std::uint32_t> colliders;  ///< into SpringSetup::colliders, tested in this order
};

/// A joint that swings about its origin. Its tail is a point mass at a fixed distance.
struct SpringJoint {
  std::uint32_t joint = kNone;
  std::uint32_t group = 0;   ///< into SpringSetup::groups
  Vec3<double> tail_m{0.0};  ///< position of the tail in the space of the joint, usually the translation of its child
  double stiffness = 1.0;    ///< pull towards the goal: metres per second, added every 1/60 s
  double drag = 0.4;         ///< [0, 1] part of the velocity that is lost in 1/60 s
  Vec3<double> gravity_m_s{0.0};  ///< pull in a constant direction: metres per second, added every 1/60 s
  double hit_radius_m = 0.0;      ///< radius of the tail for collisions, in world metres

  /// True: a tail's distance from the new head is that of its previous place, moved along with the chain. The reference
  /// implementation of VRM 1.0 works so, and characters are tuned with it. False: the distance is the bone's length.
  bool lagging_length = false;
};

/// Springs of a character as a file or an engine describes them.
struct SpringSetup {
  std::vector<SpringGroup> groups;
  std::vector<SpringJoint> joints;  ///< in any order; each joint at most once
  std::vector<SpringCollider> colliders;
};

/// Settings of the simulation. Results depend on `tick_s`, but not on the frame rate.
struct SpringSettings {
  double tick_s = 1.0 / 60.0;      ///< > 0. VRM's equation depends on it, and characters are tuned at 1/60 s.
  std::uint32_t max_ticks = 8;     ///< >= 1: most ticks in one frame; time beyond is dropped
  double sleep_rad_per_s = 1e-4;   ///< slower joints count as quiet; 0 = springs never sleep
  std::uint32_t sleep_ticks = 15;  ///< quiet ticks without a change of input after which springs sleep
};

}  // namespace sinew
