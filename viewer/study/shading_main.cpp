// SPDX-License-Identifier: MIT
// sinew-shading-study measures texture filters and interpolations of normals on this machine's Vulkan device: tables.
#include <cstdio>
#include <exception>

#include <CLI/CLI.hpp>

#include "viewer/device/device_error.h"
#include "viewer/study/shading_study.h"

namespace sinew::viewer {
namespace {

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
                t.milliseconds, static_cast<double>(t.texel_bytes) / 1024.0);
  std::printf("\nA sphere of 48 x 24 quads\n\n| normals | ms | ms with a normal map |\n|---|---|---|\n");
  for (const NormalTrial& t : study.normals)
    std::printf("| %s | %.2f | %.2f |\n", t.name.c_str(), t.milliseconds, t.milliseconds_mapped);
}

}  // namespace
}  // namespace sinew::viewer

int main(int argc, char** argv) {
  using namespace sinew::viewer;
  ShadingEffort effort;
  CLI::App program(
      "What texture filters and interpolations of normals cost on this machine, and how far filters are from "
      "supersampling.",
      "sinew-shading-study");
  program.add_option("--width", effort.width, "Of the pictures (320)")->check(CLI::Range(8u, 1024u));
  program.add_option("--height", effort.height, "Of the pictures (200)")->check(CLI::Range(8u, 1024u));
  program.add_option("--repetitions", effort.repetitions, "Of which the least time counts (15)")
      ->check(CLI::Range(1, 1000));
  CLI11_PARSE(program, argc, argv);
  try {
    Device device;
    print(study_shading(device, effort), effort);
    return 0;
  } catch (const DeviceError& error) {
    std::fprintf(stderr, "sinew-shading-study: there is no Vulkan device: %s\n", error.what());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sinew-shading-study: %s\n", error.what());
  }
  return 3;
}
