// SPDX-License-Identifier: MIT
// A target with an sRGB format and one without show the same: colours, and data such as normals.
#include <algorithm>
#include <cstdlib>
#include <string>

#include "tests/viewer/device_fixture.h"
#include "viewer/passes/render_options.h"

namespace sinew::viewer {
namespace {

class encoded_target : public DeviceTest {};

/// The largest difference of two bytes; -1 if one picture is uniform.
int difference(const BuiltScene& built, const RenderOptions& options) {
  const View view = look_at({3.0, 2.5, 4.0}, {0.0, 0.5, 0.0}, 0.8, 0.05);
  const auto plain = render_bytes(built, 40, 32, view, options, VK_FORMAT_R8G8B8A8_UNORM);
  const auto encoding = render_bytes(built, 40, 32, view, options, VK_FORMAT_R8G8B8A8_SRGB);
  const auto [least, most] = std::minmax_element(plain.begin(), plain.end());
  if (*least == *most) return -1;
  int largest = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) largest = std::max(largest, std::abs(plain[i] - encoding[i]));
  return largest;
}

TEST_F(encoded_target, shows_the_same_in_every_mode) {
  const BuiltScene built = box_and_sphere_on_floor();
  for (const Show show : {Show::color, Show::ao, Show::normals, Show::depth, Show::level}) {
    RenderOptions options;
    options.show = show;
    options.depth_range = {1.0f, 9.0f};
    options.transparent_background = show == Show::normals;
    const int off = difference(built, options);
    EXPECT_GE(off, 0) << "the picture is blank, mode " << static_cast<int>(show);
    EXPECT_LE(off, 1) << "mode " << static_cast<int>(show);
  }
}

TEST_F(encoded_target, shows_the_same_of_what_no_light_changes) {
  const BuiltScene built = box_and_sphere_on_floor();
  RenderOptions options;
  options.shading = Shading::gooch;
  const int off = difference(built, options);
  EXPECT_GE(off, 0);
  EXPECT_LE(off, 1);
}

}  // namespace
}  // namespace sinew::viewer
