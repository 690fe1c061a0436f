// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "importer/file/document.h"
#include "importer/file/sandboxed_files.h"
#include "importer/issue_log.h"

namespace sinew {

/// Reads the bytes of every buffer (file, data URI or BIN chunk). Placeholder buffers of EXT_meshopt_compression stay
/// empty (T6, G61). A missing buffer that no accessor reads stays empty too (G66).
/// in   references in range
/// err  uri-forbidden, buffer-missing, buffer-short, file-too-large;  warning buffer-unread, buffer-longer
void load_buffers(gltf::Document& document, SandboxedFiles& files, std::optional<gltf::Bytes> bin, IssueLog& log);

/// Points every view into the bytes of its buffer. Views in placeholders stay empty: a decoder fills those.
/// err  buffer-view-range, buffer-missing;  warning buffer-view-empty
void point_views(gltf::Document& document, IssueLog& log);

/// Fetches the encoded bytes of every image; what cannot be had leaves a reason and a warning (G66).
/// in   views with their bytes
/// warning image-missing
void load_images(gltf::Document& document, SandboxedFiles& files, IssueLog& log);

}  // namespace sinew
