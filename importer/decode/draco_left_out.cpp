// SPDX-License-Identifier: MIT
// Compiled instead of decode_draco.cpp in builds without SINEW_DRACO.
#include "importer/decode/decode_draco.h"
#include "importer/decode/mend_decoded.h"
#include "importer/file/json_pointer.h"

namespace sinew {

void decode_draco(gltf::Document& document, DecodeBudget&, IssueLog& log) {
  for (std::size_t m = 0; m < document.meshes.size(); ++m)
    for (std::size_t p = 0; p < document.meshes[m].primitives.size(); ++p) {
      const auto& primitive = document.meshes[m].primitives[p];
      if (!primitive.extensions.is_object() || !primitive.extensions.contains("KHR_draco_mesh_compression")) continue;
      log.report(Rule::decode_failed, pointer("meshes", m, "primitives", p, "extensions", "KHR_draco_mesh_compression"),
                 "this build of sinew reads no Draco: it was made without the option SINEW_DRACO");
      forget_bounds(document, primitive);
    }
}

}  // namespace sinew
