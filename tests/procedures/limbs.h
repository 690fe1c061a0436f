// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/procedures/two_bone_ik.h"
#include "tests/procedures/posed.h"

namespace sinew::test {

/// A parent, and a limb of three joints below it: joints 0, and 1, 2, 3.
struct Limb : Posed {
  Limb(const Transform& parent, const Vec3<float>& upper, const Vec3<float>& lower) : Posed(chain_skeleton(4)) {
    set(0, parent);
    set(1, {});
    set(2, {.translation = upper});
    set(3, {.translation = lower});
  }
  TwoBoneGoal goal(const Vec3<double>& target) {
    TwoBoneGoal out;
    out.root = 1;
    out.middle = 2;
    out.tip = 3;
    out.target = target;
    return out;
  }
  IkResult solve(const TwoBoneGoal& goal) {
    IkResult result;
    const TwoBoneIkJob job{&skeleton, pose.span(), goal, nullptr, &result};
    EXPECT_EQ(run(job), ErrorCode::ok);
    return result;
  }
  double left(const Vec3<double>& target) { return distance(place(3), target); }
};

/// A limb with random bones, pose and parent.
/// in   scale  of the parent
inline Limb random_limb(FixedRandom& random, const Vec3<float>& scale, double far = 1.0) {
  const Transform parent{random.vec3(-far, far), random.rotation(), scale};
  const auto bone = [&] { return random.direction() * static_cast<float>(random.in(0.3, 1.0)); };
  Limb limb(parent, bone(), bone());
  limb.set(1, {.translation = random.vec3(), .rotation = random.rotation()});
  limb.rest();
  Transform middle = limb.get(2);
  middle.rotation = random.rotation();
  limb.set(2, middle);
  return limb;
}

/// Bounds of the distance between root and tip in the space of the parent.
struct Bounds {
  double least, most;
};
inline Bounds bounds_of(Limb& limb) {
  const double a = safe_length(Vec3<double>(limb.get(2).translation)),
               b = safe_length(Vec3<double>(limb.get(3).translation));
  return {std::abs(a - b), a + b};
}

/// A target in reach, in model space.
inline Vec3<double> reachable(Limb& limb, FixedRandom& random) {
  const Bounds bounds = bounds_of(limb);
  const double d = bounds.least + (bounds.most - bounds.least) * random.in(0.001, 0.999);
  return transform_point(limb.model(0), Vec3<double>(limb.get(1).translation) + random.direction<double>() * d);
}

/// Length of the straight limb in model space, at least.
inline double length_of(Limb& limb) {
  return distance(limb.place(1), limb.place(2)) + distance(limb.place(2), limb.place(3));
}

}  // namespace sinew::test
