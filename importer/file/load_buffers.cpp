// SPDX-License-Identifier: MIT
#include "importer/file/load_buffers.h"

#include <string>
#include <utility>
#include <vector>

#include "importer/file/data_uri.h"
#include "importer/file/foreign_file.h"
#include "importer/file/json_pointer.h"
#include "importer/file/meshopt_extension.h"

namespace sinew {
namespace {

using gltf::Bytes;
using gltf::Document;

Bytes keep(Document& document, std::vector<std::byte> bytes) {
  document.storage.push_back(std::move(bytes));
  return document.storage.back();
}

/// Fetches the bytes of a URI; the document owns them.
tl::expected<Bytes, FileFault> fetch(Document& document, const std::string& uri, SandboxedFiles& files,
                                     std::string* mime_type) {
  using Kind = FileFault::Kind;
  if (!is_data_uri(uri)) return files.read(uri, document.storage);
  auto data = decode_data_uri(uri);
  if (!data) return tl::make_unexpected(FileFault{Kind::missing, "the data URI is not base64"});
  if (mime_type != nullptr && mime_type->empty()) *mime_type = data->mime_type;
  return keep(document, std::move(data->bytes));
}

/// How views and accessors use a buffer.
struct BufferUse {
  bool in_accessor = false;  ///< an accessor reads it directly, without decompression
  bool compressed_view = false, plain_view = false;
};

std::vector<BufferUse> find_uses(const Document& document) {
  std::vector<BufferUse> uses(document.buffers.size());
  for (const auto& view : document.buffer_views)
    if (view.buffer != kNone)
      (meshopt_extension(view.extensions) ? uses[view.buffer].compressed_view : uses[view.buffer].plain_view) = true;
  const auto mark = [&](std::uint32_t view) {
    if (view == kNone || document.buffer_views[view].buffer == kNone ||
        meshopt_extension(document.buffer_views[view].extensions))
      return;
    uses[document.buffer_views[view].buffer].in_accessor = true;
  };
  for (const auto& accessor : document.accessors) {
    mark(accessor.buffer_view);
    mark(accessor.sparse.indices_view);
    mark(accessor.sparse.values_view);
  }
  return uses;
}

/// Reports a missing buffer: an error only if an accessor reads it.
void report_missing(gltf::Buffer& buffer, const BufferUse& use, std::string place, std::string detail, IssueLog& log) {
  buffer.placeholder = true;
  log.report(use.in_accessor ? Rule::buffer_missing : Rule::buffer_unread, std::move(place), std::move(detail));
}

void load_buffer(Document& document, std::uint32_t index, const BufferUse& use, SandboxedFiles& files,
                 std::optional<Bytes> bin, IssueLog& log) {
  auto& buffer = document.buffers[index];
  const std::string place = pointer("buffers", index);
  const bool unread = use.compressed_view && !use.plain_view;
  const bool in_chunk = index == 0 && bin && buffer.uri.empty();
  const bool says_so = static_cast<bool>(meshopt_extension(buffer.extensions));
  Bytes bytes;
  if (says_so && unread) {
    buffer.placeholder = true;
    return;
  }
  if (!buffer.uri.empty()) {
    const auto read = fetch(document, buffer.uri, files, nullptr);
    if (!read && read.error().kind == FileFault::Kind::missing)
      return report_missing(buffer, use, pointer(place, "uri"), read.error().detail, log);
    if (!read) {
      const bool large = read.error().kind == FileFault::Kind::too_large;
      return log.report(large ? Rule::file_too_large : Rule::uri_forbidden, pointer(place, "uri"), read.error().detail);
    }
    if (const auto kind = describe_stand_in(*read))
      return report_missing(buffer, use, pointer(place, "uri"), "the file is " + *kind, log);
    bytes = *read;
    std::string().swap(buffer.uri);  // frees the text of a data URI, which is as long as the data
  } else if (in_chunk) {
    bytes = *bin;
  } else if (says_so || unread) {
    buffer.placeholder = true;
    return;
  } else {
    return report_missing(buffer, use, place, "has no uri and the file has no BIN chunk for it", log);
  }
  if (bytes.size() < buffer.byte_length) {
    buffer.bytes = bytes;  // a view whose bytes are inside them is sound
    return log.report(Rule::buffer_short, place,
                      std::to_string(buffer.byte_length) + " bytes, there are " + std::to_string(bytes.size()));
  }
  if (in_chunk && bytes.size() - buffer.byte_length > 3)
    log.report(Rule::buffer_longer, pointer(place, "byteLength"),
               std::to_string(buffer.byte_length) + " bytes, the BIN chunk has " + std::to_string(bytes.size()) +
                   "; the rest is ignored");
  buffer.bytes = bytes.first(static_cast<std::size_t>(buffer.byte_length));
}

void point_view(Document& document, std::size_t index, const BufferUse& use, IssueLog& log) {
  auto& view = document.buffer_views[index];
  const auto& buffer = document.buffers[view.buffer];
  const auto place = [&](const char* part) { return pointer("bufferViews", index, part); };
  if (view.byte_length == 0) log.report(Rule::buffer_view_empty, place("byteLength"), "has no bytes");
  if (view.byte_offset > buffer.byte_length || view.byte_length > buffer.byte_length - view.byte_offset)
    return log.report(
        Rule::buffer_view_range, place(view.byte_offset >= buffer.byte_length ? "byteOffset" : "byteLength"),
        std::to_string(view.byte_length) + " bytes from byte " + std::to_string(view.byte_offset) + " leave the " +
            std::to_string(buffer.byte_length) + " bytes of " + pointer("buffers", view.buffer));
  if (!buffer.placeholder)
    view.bytes =
        buffer.bytes.subspan(static_cast<std::size_t>(view.byte_offset), static_cast<std::size_t>(view.byte_length));
  else if (!meshopt_extension(view.extensions) && use.in_accessor)
    log.report(Rule::buffer_missing, place("buffer"), "is a placeholder, and the view is not compressed");
}

}  // namespace

void load_buffers(Document& document, SandboxedFiles& files, std::optional<Bytes> bin, IssueLog& log) {
  const auto uses = find_uses(document);
  for (std::uint32_t i = 0; i < document.buffers.size(); ++i) load_buffer(document, i, uses[i], files, bin, log);
}

void point_views(Document& document, IssueLog& log) {
  const auto uses = find_uses(document);
  for (std::size_t i = 0; i < document.buffer_views.size(); ++i)
    if (const std::uint32_t buffer = document.buffer_views[i].buffer; buffer != kNone)
      point_view(document, i, uses[buffer], log);
}

void load_images(Document& document, SandboxedFiles& files, IssueLog& log) {
  for (std::size_t i = 0; i < document.images.size(); ++i) {
    auto& image = document.images[i];
    if (image.buffer_view != kNone) {
      image.encoded = document.buffer_views[image.buffer_view].bytes;
    } else if (image.uri.empty()) {
      image.missing_reason = "the image has neither uri nor bufferView";
    } else if (const auto read = fetch(document, image.uri, files, &image.mime_type)) {
      image.encoded = *read;
      if (const auto kind = describe_stand_in(*read)) image.missing_reason = "the file is " + *kind;
    } else {
      image.missing_reason = read.error().detail;
      if (read.error().kind == FileFault::Kind::forbidden) {
        log.report_as_warning(Rule::uri_forbidden, pointer("images", i, "uri"),
                              image.missing_reason + "; a placeholder is shown");
        continue;
      }
    }
    if (image.encoded.empty() && image.missing_reason.empty()) image.missing_reason = "the image has no bytes";
    if (!image.missing_reason.empty())
      log.report(Rule::image_missing, pointer("images", i), image.missing_reason + "; a placeholder is shown");
  }
}

}  // namespace sinew
