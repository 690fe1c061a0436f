// SPDX-License-Identifier: MIT
#include "importer/tool/verify/verify_tolerance.h"

#include <cmath>

#include <fmt/core.h>

#include "importer/tool/length_text.h"

namespace sinew::tool {

void add_tolerance_options(Command& command, ToleranceOptions& options) {
  command.option(
      "--tolerance", "LENGTH", &options.distance,
      fmt::format(
          "Largest distance that counts as equal, {} (default: 0.01% of the larger of model and value). Of a file "
          "without meshes the size is that of the box around its joints",
          kLengthHelp));
  command.option("--tolerance-normals", "ANGLE", &options.normals,
                 "Largest angle between normals or tangents that counts as equal, such as 1deg or 0.01rad (default: "
                 "0.057deg). Normals of 8 bits, which convert --quantize writes, are off by up to 0.5deg");
  command.option("--tolerance-weights", "N", &options.weights,
                 "Largest difference of morph weights that counts as equal, such as 0.01 or 1% (default: 0.0001)");
  command.option("--tolerance-matrices", "N", &options.matrices,
                 "Largest difference of a number in the rotation and scale of a joint, in parts of its largest such "
                 "number: 0.001 or 0.1% (default: what moves a point one model size away by --tolerance)");
}

tl::expected<PoseTolerance, std::string> parse_tolerance(const ToleranceOptions& options, double model_size_m) {
  PoseTolerance out;
  out.model_size_m = model_size_m;
  if (options.distance) {
    const auto distance = parse_length(*options.distance);
    if (!distance) return tl::unexpected("--tolerance: " + distance.error());
    out.distance_m = distance->metres + distance->of_model * model_size_m;
  }
  if (options.normals) {
    const auto angle = parse_angle(*options.normals);
    if (!angle) return tl::unexpected("--tolerance-normals: " + angle.error());
    out.direction = 2.0 * std::sin(*angle / 2.0);
  }
  if (options.weights) {
    const auto weight = parse_ratio(*options.weights);
    if (!weight) return tl::unexpected("--tolerance-weights: " + weight.error());
    out.weight = *weight;
  }
  if (options.matrices) {
    const auto matrix = parse_ratio(*options.matrices);
    if (!matrix) return tl::unexpected("--tolerance-matrices: " + matrix.error());
    out.matrix = *matrix;
  }
  return out;
}

}  // namespace sinew::tool
