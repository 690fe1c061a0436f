// SPDX-License-Identifier: MIT
// Pose-space deformation: an arm under linear blending loses volume when the wrist turns. Corrective shapes restore it.
// They are sculpted at five twists, and the rotation of the wrist weighs them. The result is compared with the same arm
// under dual quaternions.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <glm/geometric.hpp>

#include "runtime/plan/run_plan.h"
#include "samples/showcase/showcase.h"

namespace {

using namespace sinew;

constexpr std::uint32_t kLeftArm = 1, kRightArm = 2;

/// Largest distance between corresponding vertices of the two arms at a twist of the wrist; the arms stand side by
/// side.
float largest_difference_m(const showcase::ShowcaseScene& shown, double degrees) {
  const Plan plan = compile_plan(lend(shown.scene), shown.needs);
  FrameBuffer frame(plan);
  const ClipLayer layer{.clip = 0, .time_s = degrees / 60.0};
  if (run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, frame) != ErrorCode::ok) std::abort();
  const FrameResult& result = frame.result();
  const auto& left = result.primitives[result.instances[kLeftArm].first_primitive].positions;
  const auto& right = result.primitives[result.instances[kRightArm].first_primitive].positions;
  const auto shoulder = [&](std::uint32_t arm) {
    return translation_of(result.model[shown.scene.skins[shown.scene.instances[arm].skin].joints[0]]);
  };
  const glm::vec3 apart = shoulder(kRightArm) - shoulder(kLeftArm);
  float largest_m = 0.0f;
  for (std::size_t v = 0; v < left.size(); ++v)
    largest_m = std::max(largest_m, glm::distance(left[v] + apart, right[v]));
  return largest_m;
}

}  // namespace

int main(int argc, char** argv) {
  char* end = nullptr;
  const double step_deg = argc < 2 ? 15.0 : std::strtod(argv[1], &end);
  if (argc > 2 || (end && (end == argv[1] || *end)) || !(step_deg >= 1.0 && step_deg <= 150.0)) {
    std::fprintf(stderr, "usage: correct_a_twist [STEP in degrees, 1 to 150]\n");
    return 2;
  }

  const showcase::ShowcaseScene plain = showcase::twisted_arms(), corrected = showcase::corrected_arms();
  std::printf("largest distance from the dual-quaternion arm\n  twist        linear   with correctives\n");
  bool as_known = true;
  for (double degrees = 0.0; degrees <= 150.0; degrees += step_deg) {
    const float linear_m = largest_difference_m(plain, degrees), corrected_m = largest_difference_m(corrected, degrees);
    std::printf("  %5.1f deg  %7.4f    %7.4f m\n", degrees, linear_m, corrected_m);
    as_known = as_known && corrected_m <= 0.2f * linear_m + 0.004f;
  }
  for (const double sculpted_deg : {0.0, 30.0, 60.0, 90.0, 120.0, 150.0})
    as_known = as_known && largest_difference_m(corrected, sculpted_deg) < 1e-4f;
  return as_known ? 0 : 1;
}
