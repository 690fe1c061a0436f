// SPDX-License-Identifier: MIT
#include "tests/study/occlusion_json.h"

#include <nlohmann/json.hpp>

namespace sinew::viewer {

using Json = nlohmann::ordered_json;

Json json_of(const OcclusionStudy& study) {
  Json out = {{"device", study.device}, {"width", study.width},       {"height", study.height},
              {"pixels", study.pixels}, {"radius_m", study.radius_m}, {"error_without", study.error_without},
              {"trials", Json::array()}};
  for (const OcclusionTrial& t : study.trials)
    out["trials"].push_back(
        {{"name", t.name},
         {"note", t.note},
         {"method", t.method == OcclusionMethod::ssao ? "ssao" : "gtao"},
         {"samples", t.method == OcclusionMethod::ssao ? t.shape.samples : 2 * t.shape.slices * t.shape.steps},
         {"full_size", t.shape.step == 1},
         {"blur", t.blur && t.shape.keep_edges && t.shape.blur_reach == OcclusionShape{}.blur_reach},
         {"default", t.is_default},
         {"error", t.error},
         {"milliseconds", t.milliseconds}});
  out["exhaustive_horizons"] = Json::array();
  for (const ExhaustiveTrial& t : study.exhaustive)
    out["exhaustive_horizons"].push_back({{"thickness", t.thickness}, {"error", t.error}});
  out["at_vertices"] = Json::array();
  for (const VertexTrial& t : study.at_vertices)
    out["at_vertices"].push_back(
        {{"rays", t.rays}, {"vertex_error", t.vertex_error}, {"error", t.error}, {"seconds", t.seconds}});
  return out;
}

}  // namespace sinew::viewer
