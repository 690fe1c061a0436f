// SPDX-License-Identifier: MIT
#include "viewer/passes/frame_graph.h"

#include <algorithm>

namespace sinew::viewer {

std::string_view name_of(Pass pass) noexcept {
  constexpr std::array<std::string_view, kPassCount> names = {
      "shadow", "normal_depth", "ssao",     "blur_horizontal", "blur_vertical", "opaque",  "outline", "ground",
      "behind", "transparent",  "weighted", "exposure",        "backdrop",      "tonemap", "show",    "overlay"};
  return names[static_cast<std::size_t>(pass)];
}

FrameGraph::FrameGraph(const FrameNeeds& needs) noexcept {
  const bool picture = needs.show == Show::color;
  const bool occlusion = needs.occluded();
  const bool outlined = needs.outlined();
  const bool prepass = occlusion || outlined || !picture || needs.hides_lines();
  if (needs.shadowed() && !needs.shadows_kept) add(Pass::shadow);
  if (prepass) add(Pass::normal_depth);
  if (occlusion) {
    add(Pass::ssao);
    if (needs.blur) {
      add(Pass::blur_horizontal);
      add(Pass::blur_vertical);
    }
  }
  const bool drawn = picture && needs.draws();
  if (drawn) {
    add(Pass::opaque);
    if (outlined) add(Pass::outline);
    if (needs.ground) add(Pass::ground);
    if (needs.blurs_behind()) add(Pass::behind);
    if (needs.blended) add(Pass::transparent);
    if (needs.weighted) add(Pass::weighted);
    if (needs.auto_exposure && (needs.opaque || needs.blended || needs.weighted)) add(Pass::exposure);
  }
  if (picture && needs.backdrop) add(Pass::backdrop);
  if (drawn) add(Pass::tonemap);
  if (!picture) add(Pass::show);
  if (needs.overlay) add(Pass::overlay);
  ground_occluded = occlusion && needs.ground && needs.ground_touched;
  sampled = drawn && needs.smooth_edges;
  depth_image = prepass || (drawn && !sampled);
  vertex_visibility = needs.reads_baked();
  normal_image = occlusion || outlined || needs.show == Show::normals || needs.show == Show::level ||
                 (vertex_visibility && needs.show == Show::ao);
  color_image = drawn;
  behind_image = has(Pass::behind);
  weighted_images = has(Pass::weighted);
  exposure_image = has(Pass::exposure);
  unlit_image = drawn && (needs.unlit || (needs.grid && exposure_image));
  ground_behind = has(Pass::ground) && sampled && !needs.blended && !behind_image && !unlit_image;
  shadow_maps = needs.shadowed() ? needs.shadows : 0;
  ao_image = occlusion;
  bent_normals = needs.bent();
  half_blurred_ao = occlusion && needs.blur;
}

bool FrameGraph::has(Pass pass) const noexcept { return std::find(begin(), end(), pass) != end(); }

}  // namespace sinew::viewer
