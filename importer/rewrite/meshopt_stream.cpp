// SPDX-License-Identifier: MIT
#include "importer/rewrite/meshopt_stream.h"

#include <meshoptimizer.h>

#include <cstring>

namespace sinew::rewrite {
namespace {

constexpr const char* kMeshopt = "EXT_meshopt_compression";

std::vector<unsigned> widened(std::size_t stride, const std::vector<std::byte>& indices) {
  std::vector<unsigned> out(indices.size() / stride);
  for (std::size_t i = 0; i < out.size(); ++i) {
    std::uint16_t narrow = 0;
    if (stride == 4) std::memcpy(&out[i], indices.data() + 4 * i, 4);
    if (stride == 2) std::memcpy(&narrow, indices.data() + 2 * i, 2);
    if (stride == 2) out[i] = narrow;
  }
  return out;
}

std::size_t encode_indices(bool triangles, std::size_t stride, const std::vector<std::byte>& elements,
                           std::vector<std::byte>& out) {
  const std::vector<unsigned> indices = widened(stride, elements);
  auto* to = reinterpret_cast<unsigned char*>(out.data());
  if (!triangles) return meshopt_encodeIndexSequence(to, out.size(), indices.data(), indices.size());
  return meshopt_encodeIndexBuffer(to, out.size(), indices.data(), indices.size());
}

}  // namespace

std::optional<EncodedStream> encode_meshopt(StreamUse use, std::size_t stride, const std::vector<std::byte>& elements) {
  const std::size_t count = elements.size() / stride;
  const bool index = use == StreamUse::triangles || use == StreamUse::indices;
  if (index ? stride < 2 || stride > 4 : stride % 4 != 0 || stride > 256) return std::nullopt;
  const bool triangles = use == StreamUse::triangles && count % 3 == 0;
  EncodedStream out;
  out.mode = triangles ? "TRIANGLES" : index ? "INDICES" : "ATTRIBUTES";
  out.bytes.resize(elements.size());  // encoding fails if the result is not smaller
  std::size_t size = 0;
  if (index) {
    meshopt_encodeIndexVersion(1);
    size = encode_indices(triangles, stride, elements, out.bytes);
  } else {
    meshopt_encodeVertexVersion(0);
    size = meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(out.bytes.data()), out.bytes.size(),
                                      elements.data(), count, stride);
  }
  if (size == 0 || size >= elements.size()) return std::nullopt;
  out.bytes.resize(size);
  return out;
}

void undo_filter(Filter filter, std::size_t stride, std::vector<std::byte>& elements) {
  const std::size_t count = elements.size() / stride;
  if (filter == Filter::octahedral) meshopt_decodeFilterOct(elements.data(), count, stride);
  if (filter == Filter::quaternion) meshopt_decodeFilterQuat(elements.data(), count, stride);
  if (filter == Filter::exponential) meshopt_decodeFilterExp(elements.data(), count, stride);
}

void declare_meshopt(const char* mode, Filter filter, std::size_t stride, std::size_t decoded_size, std::uint32_t view,
                     Draft& draft) {
  static const char* const kFilters[] = {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"};
  Json& entry = draft.json["bufferViews"][view];
  Json extension{{"buffer", 0}, {"byteStride", stride}, {"count", decoded_size / stride}, {"mode", mode}};
  if (filter != Filter::none) extension["filter"] = kFilters[static_cast<std::size_t>(filter)];
  entry["buffer"] = 1;
  entry["byteLength"] = decoded_size;
  entry["extensions"][kMeshopt] = std::move(extension);
  declare(draft, kMeshopt, true);
}

}  // namespace sinew::rewrite
