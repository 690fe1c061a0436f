// SPDX-License-Identifier: MIT
#include <cstdlib>

#include "importer/export_glb.h"
#include "importer/import_gltf.h"
#include "samples/showcase/showcase.h"
#include "tests/bench/measure.h"
#include "tests/bench/tinygltf_parse.h"

namespace sinew::bench {

/// Whole import of a showcase file from memory beside tinygltf's parse alone; an item is one byte of the file.
void add_import() {
  for (const auto& scene : showcase::showcase()) {
    auto bytes = export_glb(scene.scene);
    if (!bytes) std::abort();
    const std::string name = scene.name.substr(scene.name.find(' ') + 1);
    add("import/sinew/" + name, bytes->size(), [bytes = *bytes, name] {
      if (!import_gltf(bytes, name)) std::abort();
    });
    add("import/tinygltf/" + name, bytes->size(), [bytes = *bytes] {
      if (parse_with_tinygltf(bytes) < 1) std::abort();
    });
  }
}

}  // namespace sinew::bench
