// SPDX-License-Identifier: MIT
#include "importer/tool/poses/pose_writer.h"

#include "importer/tool/poses/pose_arrays.h"
#include "importer/tool/poses/pose_csv.h"
#include "importer/tool/poses/pose_json.h"

namespace sinew::tool {

PoseFormat format_of_name(std::string_view file) noexcept {
  if (file.ends_with(".gz")) file.remove_suffix(3);
  if (file.ends_with(".csv")) return PoseFormat::csv;
  if (file.ends_with(".npy")) return PoseFormat::npy;
  return file.ends_with(".npz") ? PoseFormat::npz : PoseFormat::json;
}

bool holds_vertices(PoseFormat format) noexcept { return format == PoseFormat::json || format == PoseFormat::npz; }

std::unique_ptr<PoseWriter> make_pose_writer(PoseFormat format, const Scene& scene, std::size_t samples,
                                             StreamedFile& out) {
  switch (format) {
    case PoseFormat::csv: return std::make_unique<PoseCsv>(scene, out);
    case PoseFormat::npy: return std::make_unique<WorldArray>(samples, out);
    case PoseFormat::npz: return std::make_unique<PoseArrays>(scene, samples, out);
    case PoseFormat::json: break;
  }
  return std::make_unique<PoseJson>(out);
}

}  // namespace sinew::tool
