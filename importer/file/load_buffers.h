// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "importer/file/document.h"
#include "importer/file/sandboxed_files.h"
#include "importer/issue_log.h"

namespace sinew {

/// Reads the bytes of every buffer from a file, a data URI or the BIN chunk. Fallback buffers of
/// EXT_meshopt_compression stay empty, as do missing buffers that no accessor reads.
/// in       references are in range
/// err      uri-forbidden, buffer-missing, buffer-short, file-too-large
/// warning  buffer-unread, buffer-longer
void load_buffers(gltf::Document& document, SandboxedFiles& files, std::optional<gltf::Bytes> bin, IssueLog& log);

/// Sets the bytes of every buffer view. Views of placeholder buffers stay empty until a decoder fills them.
/// err      buffer-view-range, buffer-missing
/// warning  buffer-view-empty
void point_views(gltf::Document& document, IssueLog& log);

/// Reads the encoded bytes of every image. An image that cannot be read gets a reason and a warning.
/// in       buffer views have their bytes
/// warning  image-missing, uri-forbidden
void load_images(gltf::Document& document, SandboxedFiles& files, IssueLog& log);

}  // namespace sinew
