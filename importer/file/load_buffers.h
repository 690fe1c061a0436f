// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "importer/file/document.h"
#include "importer/file/sandboxed_files.h"
#include "importer/issue_log.h"

namespace sinew {

/// Reads the bytes of every buffer from a file, a data URI or the BIN chunk. Placeholder buffers of
/// EXT_meshopt_compression stay empty (T6, G61). So does a missing buffer that no accessor reads (G66).
/// in       references in range
/// err      uri-forbidden, buffer-missing, buffer-short, file-too-large
/// warning  buffer-unread, buffer-longer
void load_buffers(gltf::Document& document, SandboxedFiles& files, std::optional<gltf::Bytes> bin, IssueLog& log);

/// Points every view at its bytes in the buffer. Views of placeholder buffers stay empty until a decoder fills them.
/// err      buffer-view-range, buffer-missing
/// warning  buffer-view-empty
void point_views(gltf::Document& document, IssueLog& log);

/// Reads the encoded bytes of every image. An image that cannot be read gets a reason and a warning (G66).
/// in       views with their bytes
/// warning  image-missing, uri-forbidden
void load_images(gltf::Document& document, SandboxedFiles& files, IssueLog& log);

}  // namespace sinew
