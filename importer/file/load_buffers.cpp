// SPDX-License-Identifier: MIT
#include "importer/file/load_buffers.h"

#include <string>
#include <utility>
#include <vector>

#include "importer/file/data_uri.h"
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

tl::expected<std::vector<std::byte>, FileFault> fetch(const std::string& uri, SandboxedFiles& files, std::string* mime_type) {
  using Kind = FileFault::Kind;
  if (!is_data_uri(uri)) return files.read(uri);
  auto data = decode_data_uri(uri);
  if (!data) return tl::make_unexpected(FileFault{Kind::missing, "the data URI is not base64"});
  if (mime_type != nullptr && mime_type->empty()) *mime_type = data->mime_type;
  return std::move(data->bytes);
}

Rule rule_of(FileFault::Kind kind) {
  switch (kind) {
    case FileFault::Kind::forbidden: return Rule::uri_forbidden;
    case FileFault::Kind::too_large: return Rule::file_too_large;
    case FileFault::Kind::missing: break;
  }
  return Rule::buffer_missing;
}

/// Per buffer: it has views, and all of them are compressed. Nothing reads its bytes.
std::vector<bool> find_unread_buffers(const Document& document) {
  std::vector<bool> used(document.buffers.size(), false), read = used;
  for (const auto& view : document.buffer_views) {
    used[view.buffer] = true;
    if (!meshopt_extension(view.extensions)) read[view.buffer] = true;
  }
  for (std::size_t i = 0; i < used.size(); ++i) used[i] = used[i] && !read[i];
  return used;
}

void load_buffer(Document& document, std::uint32_t index, bool unread, SandboxedFiles& files, std::optional<Bytes> bin,
                 IssueLog& log) {
  auto& buffer = document.buffers[index];
  const std::string place = pointer("buffers", index);
  const bool says_so = static_cast<bool>(meshopt_extension(buffer.extensions));
  Bytes bytes;
  if (says_so && unread) {
    buffer.placeholder = true;
    return;
  }
  if (!buffer.uri.empty()) {
    auto read = fetch(buffer.uri, files, nullptr);
    if (!read) return log.report(rule_of(read.error().kind), pointer(place, "uri"), read.error().detail);
    bytes = keep(document, std::move(*read));
  } else if (index == 0 && bin) {
    bytes = *bin;
  } else if (says_so || unread) {
    buffer.placeholder = true;
    return;
  } else {
    return log.report(Rule::buffer_missing, place, "has no uri and the file has no BIN chunk for it");
  }
  if (bytes.size() < buffer.byte_length)
    return log.report(Rule::buffer_short, pointer(place, "byteLength"),
                      std::to_string(buffer.byte_length) + " bytes, there are " + std::to_string(bytes.size()));
  if (buffer.uri.empty() && bytes.size() - buffer.byte_length > 3)
    log.report(Rule::buffer_longer, pointer(place, "byteLength"),
               std::to_string(buffer.byte_length) + " bytes, the BIN chunk has " + std::to_string(bytes.size()) + "; the rest is ignored");
  buffer.bytes = bytes.first(static_cast<std::size_t>(buffer.byte_length));
}

void point_view(Document& document, std::size_t index, IssueLog& log) {
  auto& view = document.buffer_views[index];
  const auto& buffer = document.buffers[view.buffer];
  const std::string place = pointer("bufferViews", index);
  if (view.byte_length == 0) log.report(Rule::buffer_view_empty, pointer(place, "byteLength"), "has no bytes");
  if (view.byte_offset > buffer.byte_length || view.byte_length > buffer.byte_length - view.byte_offset)
    return log.report(Rule::buffer_view_range, place, std::to_string(view.byte_length) + " bytes from byte " + std::to_string(view.byte_offset) +
                          " leave the " + std::to_string(buffer.byte_length) + " bytes of " + pointer("buffers", view.buffer));
  if (!buffer.placeholder)
    view.bytes = buffer.bytes.subspan(static_cast<std::size_t>(view.byte_offset), static_cast<std::size_t>(view.byte_length));
  else if (!meshopt_extension(view.extensions))
    log.report(Rule::buffer_missing, pointer(place, "buffer"), "is a placeholder, and the view is not compressed");
}

}  // namespace

void load_buffers(Document& document, SandboxedFiles& files, std::optional<Bytes> bin, IssueLog& log) {
  const std::vector<bool> unread = find_unread_buffers(document);
  for (std::uint32_t i = 0; i < document.buffers.size(); ++i) load_buffer(document, i, unread[i], files, bin, log);
  if (!log.ok()) return;
  for (std::size_t i = 0; i < document.buffer_views.size(); ++i) point_view(document, i, log);
}

void load_images(Document& document, SandboxedFiles& files, IssueLog& log) {
  for (std::size_t i = 0; i < document.images.size(); ++i) {
    auto& image = document.images[i];
    if (image.buffer_view != kNone) {
      image.encoded = document.buffer_views[image.buffer_view].bytes;
    } else if (image.uri.empty()) {
      image.missing_reason = "the image has neither uri nor bufferView";
    } else if (auto read = fetch(image.uri, files, &image.mime_type)) {
      image.encoded = keep(document, std::move(*read));
    } else {
      image.missing_reason = read.error().detail;
    }
    if (image.encoded.empty() && image.missing_reason.empty()) image.missing_reason = "the image has no bytes";
    if (!image.missing_reason.empty())
      log.report(Rule::image_missing, pointer("images", i), image.missing_reason + "; a placeholder is shown");
  }
}

}  // namespace sinew
