// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "importer/read/extension_fields.h"
#include "runtime/model/material.h"

namespace sinew {

/// Reads every texture with its sampler. An image named by EXT_texture_webp or EXT_texture_avif is preferred
/// to `source`, and `source` to an image of a kind that is not decoded (KTX2, DDS).
/// in       references in range
/// out      one entry for each of document.textures, in their order
/// warning  sampler-values, extension-value
std::vector<Texture> read_textures(const gltf::Document& document, IssueLog& log);

/// Reads how a material uses a texture. KHR_texture_transform may select another texture coordinate set (G60).
/// in    place   JSON pointer of the texture info
TextureUse read_texture_use(gltf::TextureInfo info, const std::string& place, IssueLog& log);

/// The same for the member `name` of an extension; unused where it is absent or names no texture.
TextureUse read_texture_use(const ExtensionFields& extension, const char* name, std::size_t texture_count);

}  // namespace sinew
