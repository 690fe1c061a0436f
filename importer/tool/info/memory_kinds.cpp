// SPDX-License-Identifier: MIT
#include "importer/tool/info/memory_kinds.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/core.h>

#include "importer/tool/messages.h"

namespace sinew::tool {

Json memory_json(const MemoryBytes& bytes) {
  const std::pair<const char*, std::size_t> kinds[] = {
      {"skeletons", bytes.skeletons}, {"animations", bytes.animations},
      {"clip_keys", bytes.clip_keys}, {"clip_tables", bytes.clip_tables},
      {"skins", bytes.skins},         {"vertices", bytes.vertices},
      {"morphs", bytes.morphs},       {"images", bytes.images},
      {"others", bytes.others},       {"plans", bytes.plans},
      {"frames", bytes.frames}};
  Json out{{"total", bytes.total()}};
  for (const auto& [kind, size] : kinds)
    if (size > 0) out[kind] = size;
  return out;
}

std::string memory_text(const Json& memory) {
  std::string kinds;
  for (const auto& [kind, size] : memory.items()) {
    if (kind == "total") continue;
    std::string words(kind);
    std::replace(words.begin(), words.end(), '_', ' ');
    kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", words, size_text(size.get<double>()));
  }
  const std::string total = size_text(memory["total"].get<double>());
  return kinds.empty() ? fmt::format("memory: {}\n", total) : fmt::format("memory: {} ({})\n", total, kinds);
}

}  // namespace sinew::tool
