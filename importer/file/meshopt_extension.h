// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "importer/file/document.h"

namespace sinew {

/// The meshopt compression extension of a buffer or buffer view, under its EXT name or its ratified KHR name.
struct MeshoptExtension {
  const char* name = nullptr;
  const gltf::Json* value = nullptr;

  explicit operator bool() const noexcept { return value != nullptr; }
};

inline MeshoptExtension meshopt_extension(const gltf::Json& extensions) {
  constexpr std::array kNames{"KHR_meshopt_compression", "EXT_meshopt_compression"};
  if (extensions.is_object())
    for (const char* name : kNames)
      if (const auto found = extensions.find(name); found != extensions.end()) return {name, &*found};
  return {};
}

}  // namespace sinew
