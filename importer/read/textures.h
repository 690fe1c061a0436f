// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "importer/read/extension_fields.h"
#include "runtime/model/material.h"

namespace sinew {

/// Reads every texture with its sampler. Prefers the image of EXT_texture_webp, EXT_texture_avif or KHR_texture_basisu
/// over `source`, and `source` over formats that are not decoded (DDS).
/// in       references are in range
/// out      one entry for each of document.textures, in their order
/// warning  sampler-values, extension-value
std::vector<Texture> read_textures(const gltf::Document& document, IssueLog& log);

/// Reads a texture reference of a material. KHR_texture_transform may select another texture coordinate set.
/// in    place   JSON pointer of the texture info
TextureUse read_texture_use(gltf::TextureInfo info, const std::string& place, IssueLog& log);

/// Reads the texture reference `name` of an extension; unused if absent or invalid.
TextureUse read_texture_use(const ExtensionFields& extension, const char* name, std::size_t texture_count);

}  // namespace sinew
