// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "runtime/model/material.h"

namespace sinew {

/// Every texture with its sampler. EXT_texture_webp names an image that goes before `source`.
/// in   references in range.   out  as many as document.textures, in their order
/// warning sampler-values, extension-value
std::vector<Texture> read_textures(const gltf::Document& document, IssueLog& log);

/// How a material uses a texture; KHR_texture_transform may name another texture coordinate set (G60).
/// in   `place` points at the texture info
TextureUse read_texture_use(const gltf::TextureInfo& info, const std::string& place, IssueLog& log);

}  // namespace sinew
