// SPDX-License-Identifier: MIT
#include "viewer/passes/pass_stages.h"

namespace sinew::viewer {
namespace {

std::string_view why_not_occluded(const FrameNeeds& needs) {
  if (!needs.opaque) return "nothing opaque is in view";
  if (needs.reads_baked()) return "ambient visibility comes with the vertices, baked by rays";
  if (!needs.occlusion) return "ambient occlusion is switched off or of strength 0";
  if (needs.show != Show::color && needs.show != Show::ao)
    return "the picture shows a buffer that needs no ambient occlusion";
  if (needs.gooch) return "Gooch shading counts no light";
  return "there is no ambient light for occlusion to scale";
}

std::string_view why_normal_depth(const FrameNeeds& needs, bool runs) {
  if (!runs) return why_not_occluded(needs);
  if (needs.occluded()) return "ambient occlusion reads normals and depth";
  if (needs.outlined()) return "outlines read normals and depth";
  if (needs.show == Show::color) return "depth only: lines are fainter behind surfaces";
  if (needs.reads_baked()) return "ambient visibility of the vertices goes beside the normals";
  if (needs.show == Show::level) return "the picture shows the levels of textures";
  return needs.show == Show::normals ? "the picture shows normals" : "depth only: the picture asks for no normals";
}

std::string_view why_blur(const FrameNeeds& needs) {
  if (!needs.occluded()) return why_not_occluded(needs);
  return needs.blur ? "smooths ambient visibility on each surface" : "the blur is switched off";
}

std::string_view why_outline(const FrameNeeds& needs) {
  if (!needs.gooch) return "outlines are part of Gooch shading";
  if (needs.show != Show::color) return "the picture shows a buffer instead";
  return needs.opaque ? "lines at silhouettes and creases" : "nothing opaque is in view";
}

std::string_view why_shadow(const FrameNeeds& needs) {
  if (needs.shadowed() && needs.shadows_kept) return "no light and nothing that casts shadows has moved: maps are kept";
  if (needs.shadowed()) return "depth as each light sees it that casts shadows";
  if (needs.gooch) return "Gooch shading counts no light";
  if (!needs.shadows) return "no light casts shadows";
  return needs.show == Show::color ? "nothing is in view" : "the picture shows a buffer instead";
}

std::string_view why_no_ground(NoGround reason) {
  if (reason == NoGround::nothing_darkens)
    return "nothing darkens it: no shadow falls on it in view, and nothing is near it";
  return "no ground is asked for, or the eye is below it";
}

std::string_view why_backdrop(const FrameNeeds& needs) {
  if (needs.show != Show::color) return "the picture shows a buffer instead";
  return needs.backdrop ? "the environment behind the scene" : "no environment is seen behind the scene";
}

std::string_view why(Pass pass, const FrameNeeds& needs, bool runs) {
  const bool picture = needs.show == Show::color;
  switch (pass) {
    case Pass::shadow: return why_shadow(needs);
    case Pass::normal_depth: return why_normal_depth(needs, runs);
    case Pass::ssao:
      if (needs.bent()) return "ambient occlusion is on; reflections read bent normals";
      return runs ? "ambient occlusion is on" : why_not_occluded(needs);
    case Pass::blur_horizontal:
    case Pass::blur_vertical: return why_blur(needs);
    case Pass::outline: return why_outline(needs);
    case Pass::transparent:
      if (!needs.blended && needs.weighted) return "what is blended is so in any order";
      if (!needs.blended) return "nothing blended is in view";
      return picture ? "blended surfaces, from far to near" : "the picture shows a buffer instead";
    case Pass::weighted:
      if (!needs.weighted) return "nothing is in view that blends in any order";
      return picture ? "sums of blended surfaces in any order" : "the picture shows a buffer instead";
    case Pass::exposure:
      if (needs.gooch) return "Gooch shading counts no light";
      if (!needs.auto_exposure) return "the exposure is given";
      if (!picture) return "the picture shows a buffer instead";
      return runs ? "from the log average of light" : "nothing is in view";
    case Pass::ground:
      if (!needs.ground) return why_no_ground(needs.no_ground);
      return picture ? needs.gooch ? "the grid alone" : "darkens what is behind, by shadows and contact"
                     : "the picture shows a buffer instead";
    case Pass::behind:
      if (!needs.frosted) return "nothing rough or thick is in view that lets light through";
      if (needs.gooch) return "Gooch shading lets no light through";
      return picture ? "rough surfaces blur what is behind them, thick ones refract it"
                     : "the picture shows a buffer instead";
    case Pass::overlay: return runs ? "lines over the picture" : "no lines are asked for";
    case Pass::show: return runs ? "the picture is one of the buffers" : "the picture is the lit scene";
    case Pass::backdrop: return why_backdrop(needs);
    case Pass::opaque:
      if (!picture) return "the picture shows a buffer instead";
      if (!runs) return "nothing is in view";
      if (!needs.opaque) return "clears the picture for what is not opaque";
      if (needs.gooch) return "cool to warm tones of what is opaque or alpha-tested";
      return needs.reads_baked() ? "shades what is opaque or alpha-tested, with the ambient visibility of the vertices"
                                 : "shades what is opaque or alpha-tested";
    case Pass::tonemap:
      if (!picture) return "the picture shows a buffer instead";
      if (!runs) return "nothing is in view";
      return needs.unlit ? "from light to displayed colours; unlit ones stay as they are"
                         : "from light to displayed colours";
  }
  return {};
}

std::uint64_t count_of(Pass pass, const PassWork& work) {
  const std::uint64_t width = work.extent.width, height = work.extent.height;
  switch (pass) {
    case Pass::shadow: return work.caster_draws;
    case Pass::normal_depth:
    case Pass::opaque: return work.opaque_draws;
    case Pass::transparent: return work.blended_draws;
    case Pass::weighted: return work.weighted_draws;
    case Pass::ground: return 1;
    case Pass::overlay: return work.lines;
    case Pass::ssao:
    case Pass::blur_horizontal:
    case Pass::blur_vertical: return work.ao_texels;
    case Pass::outline: return work.outline_pixels;
    case Pass::tonemap: return work.drawn_pixels;
    case Pass::behind:
    case Pass::exposure:
    case Pass::backdrop:
    case Pass::show: return width * height;
  }
  return 0;
}

}  // namespace

std::array<PassStage, kPassCount> describe_passes(const FrameNeeds& needs, const PassWork& work) {
  const FrameGraph graph(needs);
  std::array<PassStage, kPassCount> stages;
  for (std::size_t i = 0; i < kPassCount; ++i) {
    const Pass pass = static_cast<Pass>(i);
    const bool runs = graph.has(pass);
    stages[i] = {pass, runs, why(pass, needs, runs), runs ? count_of(pass, work) : 0};
  }
  return stages;
}

}  // namespace sinew::viewer
