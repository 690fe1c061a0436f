// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/model/scene.h"
#include "runtime/plan/frame_result.h"
#include "tests/reference/blurred.h"
#include "tests/reference/surface_point.h"
#include "viewer/passes/render_options.h"
#include "viewer/passes/view.h"

namespace sinew::reference {

/// The input of a reference picture. The viewer's structs are read as data only: no function of the viewer is called.
struct PictureOf {
  const Scene& scene;
  const FrameResult& frame;
  viewer::View view;
  viewer::RenderOptions options;
  int width = 0, height = 0;
  viewer::Gradient ambient;                 ///< the gradient that lights the environment of the options
  std::span<const double> visibility = {};  ///< [width * height] ambient visibility of opaque surfaces; empty = 1
  std::span<const glm::dvec3> bend = {};    ///< [width * height] Openness::bend, in view space; empty = none
  const Blurred* blurred = nullptr;  ///< blurred_opaque() of this picture; null = no rough surface lets light through
};

/// Colour at a point of the picture, in pixels from the upper left corner; (x + 0.5, y + 0.5) is the middle of a pixel.
/// sRGB as displayed, straight alpha.
/// eq   layers over each other from far to near, light * alpha + below * (1 - alpha), in linear light;
///      displayed = sRGB(mix(background, (lit * tone curve(exposure * light / lit) + unlit colours) / coverage,
///      coverage)), lit = the share of surfaces that are not KHR_materials_unlit; exposure changes only their light
///      KHR_materials_transmission: light + below * its share that passes through, instead of below * (1 - alpha);
///      for a rough surface, `below` is the blurred picture of the opaque surfaces behind it
///      Transparency::weighted: surfaces that blend lie over all others as a weighted mean (eq in picture.cpp)
///      Gooch shading: tones (tests/reference/gooch.h) and outlines on opaque surfaces instead of light
/// in   picture.options.show  normals: view space, n / 2 + 1/2;  depth: bright = near;  ao: `visibility`
glm::dvec4 color_at(const PictureOf& picture, double x, double y);

/// The opaque surfaces of the picture, blurred as rough transmitting surfaces show them.
Blurred blurred_opaque(const PictureOf& picture);

/// Exposure that maps the log average of the picture's light to middle grey; 1 if the picture has no light. Unlit
/// surfaces, the background and black pixels do not count.
/// eq   0.18 / exp(mean of log(luminance) over pixels, weighted by coverage)
double automatic_exposure(const PictureOf& picture);

/// The line from the eye through a point of the picture.
SightLine sight_line(const PictureOf& picture, double x, double y);

/// Distance from the eye plane of the nearest opaque surface, metres (0 = none), and its normal in view space.
struct DepthAndNormal {
  double distance_m = 0.0;
  glm::dvec3 normal{0.0};
};
DepthAndNormal depth_at(const PictureOf& picture, double x, double y);

}  // namespace sinew::reference
