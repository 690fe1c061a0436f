// SPDX-License-Identifier: MIT
#include "runtime/c_assets/sinew_assets.h"

#include <memory>
#include <utility>

#include "runtime/asset_file/read_assets.h"
#include "runtime/c/boundary.h"
#include "runtime/c/handles.h"

using namespace sinew;

namespace {

std::span<const std::byte> span_of(const void* bytes, std::size_t byte_count) noexcept {
  return {static_cast<const std::byte*>(bytes), byte_count};
}

sinew_error refuse(const AssetFileError& error, sinew_messages** messages) {
  if (messages == nullptr) return SINEW_BAD_FILE;
  auto made = std::make_unique<sinew_messages>();
  made->lines.push_back(describe(error));
  *messages = made.release();
  return SINEW_BAD_FILE;
}

}  // namespace

int sinew_looks_like_assets(const void* bytes, std::size_t byte_count) {
  return bytes != nullptr && looks_like_asset_file(span_of(bytes, byte_count));
}

sinew_error sinew_assets_read(const void* bytes, std::size_t byte_count, sinew_scene** scene,
                              sinew_messages** messages) {
  if (bytes == nullptr || scene == nullptr) return SINEW_NULL_ARGUMENT;
  return c::guarded([&] {
    const auto file = AssetFile::open(span_of(bytes, byte_count));
    if (!file) return refuse(file.error(), messages);
    auto read = read_scene(*file);
    if (!read) return refuse(read.error(), messages);
    auto boxes = read_clip_boxes(*file, *read);
    if (!boxes) return refuse(boxes.error(), messages);
    *scene = new sinew_scene{*std::move(read), {}, *std::move(boxes)};
    return SINEW_OK;
  });
}

sinew_error sinew_assets_add_clips(sinew_scene* scene, const void* bytes, std::size_t byte_count,
                                   sinew_messages** messages) {
  if (scene == nullptr || bytes == nullptr) return SINEW_NULL_ARGUMENT;
  if (scene->plan_count != 0) return SINEW_BUSY;
  return c::guarded([&] {
    const auto file = AssetFile::open(span_of(bytes, byte_count));
    if (!file) return refuse(file.error(), messages);
    const auto added = add_clips(*file, scene->scene);
    return added ? SINEW_OK : refuse(added.error(), messages);
  });
}
