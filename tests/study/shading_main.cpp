// SPDX-License-Identifier: MIT
// sinew-shading-study measures texture filters and interpolations of normals on this machine's Vulkan device: tables,
// or JSON for `sinew cost`.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "viewer/device/device_error.h"
#include "tests/study/shading_study.h"

namespace sinew::viewer {
namespace {

using Json = nlohmann::ordered_json;

/// Negative without times.
double least(const std::vector<double>& milliseconds) {
  return milliseconds.empty() ? -1.0 : *std::min_element(milliseconds.begin(), milliseconds.end());
}

Json json_of(const ShadingStudy& study, const ShadingEffort& effort) {
  Json out = {{"device", study.device},
              {"width", effort.width},
              {"height", effort.height},
              {"samples", effort.samples},
              {"max_anisotropy", study.max_anisotropy},
              {"filters", Json::array()},
              {"normals", Json::array()}};
  for (const FilterTrial& t : study.filters)
    out["filters"].push_back({{"name", t.name},
                              {"error", t.error},
                              {"error_turned", t.error_turned},
                              {"milliseconds", t.milliseconds},
                              {"bytes", t.texel_bytes}});
  for (const NormalTrial& t : study.normals)
    out["normals"].push_back(
        {{"name", t.name}, {"milliseconds", t.milliseconds}, {"milliseconds_mapped", t.milliseconds_mapped}});
  return out;
}

void print(const ShadingStudy& study, const ShadingEffort& effort) {
  std::printf("%s, %u x %u; anisotropy up to %.0f\n\n", study.device.c_str(), effort.width, effort.height,
              static_cast<double>(study.max_anisotropy));
  std::printf(
      "A plane that reaches the horizon, against %u x %u samples a pixel: error in %% of full light,\n"
      "turned = the texture lies at 45 degrees, memory of a texture of 256 x 256\n\n",
      effort.samples, effort.samples);
  std::printf("| filter | error | turned | ms | KiB |\n|---|---|---|---|---|\n");
  for (const FilterTrial& t : study.filters)
    std::printf("| %s | %.2f | %.2f | %.2f | %.0f |\n", t.name.c_str(), 100.0 * t.error, 100.0 * t.error_turned,
                least(t.milliseconds), static_cast<double>(t.texel_bytes) / 1024.0);
  std::printf("\nA sphere of 48 x 24 quads\n\n| normals | ms | ms with a normal map |\n|---|---|---|\n");
  for (const NormalTrial& t : study.normals)
    std::printf("| %s | %.2f | %.2f |\n", t.name.c_str(), least(t.milliseconds), least(t.milliseconds_mapped));
}

}  // namespace
}  // namespace sinew::viewer

int main(int argc, char** argv) {
  using namespace sinew::viewer;
  ShadingEffort effort;
  bool quick = false, json = false;
  CLI::App program(
      "What texture filters and interpolations of normals cost on this machine, and how far filters are from "
      "supersampling.",
      "sinew-shading-study");
  program.add_option("--width", effort.width, "Of the pictures (320)")->check(CLI::Range(8u, 1024u));
  program.add_option("--height", effort.height, "Of the pictures (200)")->check(CLI::Range(8u, 1024u));
  program.add_option("--repetitions", effort.repetitions, "Of which the least time counts (15)")
      ->check(CLI::Range(1, 1000));
  program.add_flag("--quick", quick, "A small picture and few repetitions");
  program.add_flag("--json", json, "JSON instead of tables; without a device it says so");
  CLI11_PARSE(program, argc, argv);
  if (quick) effort = ShadingEffort::quick();
  try {
    Device device;
    const ShadingStudy study = study_shading(device, effort);
    json ? void(std::puts(json_of(study, effort).dump(1).c_str())) : print(study, effort);
    return 0;
  } catch (const DeviceError& error) {
    if (json) {
      std::puts(Json{{"left_out", std::string("there is no Vulkan device: ") + error.what()}}.dump().c_str());
      return 0;
    }
    std::fprintf(stderr, "sinew-shading-study: there is no Vulkan device: %s\n", error.what());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sinew-shading-study: %s\n", error.what());
  }
  return 3;
}
