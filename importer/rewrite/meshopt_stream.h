// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "importer/rewrite/streams.h"

namespace sinew::rewrite {

struct EncodedStream {
  const char* mode = "";  ///< as EXT_meshopt_compression names it
  std::vector<std::byte> bytes;
};

/// Compresses elements of `stride` bytes.
/// out   nothing where the codec does not take them or the result would not be smaller
std::optional<EncodedStream> encode_meshopt(StreamUse use, std::size_t stride, const std::vector<std::byte>& elements);

/// Turns filtered elements into plain ones, for a stream that is not compressed after all.
void undo_filter(Filter filter, std::size_t stride, std::vector<std::byte>& elements);

/// Says in the document that a view holds a compressed stream.
/// in    decoded_size   bytes of the view when it is decoded
void declare_meshopt(const char* mode, Filter filter, std::size_t stride, std::size_t decoded_size, std::uint32_t view,
                     Draft& draft);

}  // namespace sinew::rewrite
