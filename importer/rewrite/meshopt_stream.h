// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "importer/rewrite/streams.h"

namespace sinew::rewrite {

struct EncodedStream {
  const char* mode = "";  ///< mode name of EXT_meshopt_compression
  std::vector<std::byte> bytes;
};

/// Compresses elements of `stride` bytes.
/// out   empty if the codec does not support them or the result would not be smaller
std::optional<EncodedStream> encode_meshopt(StreamUse use, std::size_t stride, const std::vector<std::byte>& elements);

/// Reverts a filter, for a stream that is not compressed after all.
void undo_filter(Filter filter, std::size_t stride, std::vector<std::byte>& elements);

/// Marks a view as compressed in the document.
/// in    decoded_size   bytes of the decoded view
void declare_meshopt(const char* mode, Filter filter, std::size_t stride, std::size_t decoded_size, std::uint32_t view,
                     Draft& draft);

}  // namespace sinew::rewrite
