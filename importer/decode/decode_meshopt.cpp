// SPDX-License-Identifier: MIT
#include "importer/decode/decode_meshopt.h"

#include <meshoptimizer.h>

#include <string>
#include <utility>
#include <vector>

#include "importer/decode/attribute_stream.h"
#include "importer/file/json_pointer.h"
#include "importer/file/json_shape.h"
#include "importer/file/meshopt_extension.h"

namespace sinew {
namespace {

using gltf::Json;

constexpr JsonValueShape kMeshoptIndex{.kind = JsonKind::integer, .lower = 0, .upper = 2147483646.0};
constexpr JsonValueShape kMeshoptSize{.kind = JsonKind::integer, .lower = 0, .upper = 9007199254740991.0};
constexpr JsonValueShape kMeshoptCount{.kind = JsonKind::integer, .lower = 1, .upper = 4294967295.0};
constexpr JsonValueShape kMeshoptStride{.kind = JsonKind::integer, .lower = 2, .upper = 256};
constexpr std::string_view kMeshoptModes[] = {"ATTRIBUTES", "TRIANGLES", "INDICES"};
constexpr std::string_view kMeshoptFilters[] = {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"};
constexpr JsonProperty kMeshoptProperties[] = {{"buffer", kMeshoptIndex, true},
                                               {"byteOffset", kMeshoptSize},
                                               {"byteLength", kMeshoptSize, true},
                                               {"byteStride", kMeshoptStride, true},
                                               {"count", kMeshoptCount, true},
                                               {"mode", {.kind = JsonKind::string, .words = kMeshoptModes}, true},
                                               {"filter", {.kind = JsonKind::string, .words = kMeshoptFilters}}};
constexpr JsonObjectShape kMeshoptObject{kMeshoptProperties};
constexpr JsonValueShape kMeshoptShape{.kind = JsonKind::object, .object = &kMeshoptObject};

/// Upper bound of decoded bytes per encoded byte. The extreme is version 1 of the attribute codec, which stores 256
/// equal bytes in 2 bits.
constexpr std::uint64_t kMaxRatio = 1024;

struct Stream {
  std::uint64_t offset = 0, length = 0, count = 0, stride = 0;
  std::uint32_t buffer = 0;
  std::string mode, filter;

  std::uint64_t decoded_bytes() const noexcept { return count * stride; }
};

Stream read_stream(const Json& json) {
  const auto size = [&](const char* name) { return static_cast<std::uint64_t>(json.value(name, 0.0)); };
  return {size("byteOffset"),
          size("byteLength"),
          size("count"),
          size("byteStride"),
          static_cast<std::uint32_t>(size("buffer")),
          json["mode"].get<std::string>(),
          json.value("filter", "NONE")};
}

/// The first rule of the extension that is broken; empty = none.
std::string fault(const Stream& s, const gltf::BufferView& view) {
  const bool attributes = s.mode == "ATTRIBUTES";
  if (s.decoded_bytes() != view.byte_length)
    return std::to_string(s.count) + " elements of " + std::to_string(s.stride) + " bytes are not the " +
           std::to_string(view.byte_length) + " bytes of the view";
  if (view.byte_stride != 0 && view.byte_stride != s.stride) return "byteStride differs from that of the view";
  if (attributes && s.stride % 4 != 0) return "byteStride is no multiple of 4";
  if (!attributes && s.stride != 2 && s.stride != 4) return "indices have 2 or 4 bytes";
  if (s.mode == "TRIANGLES" && s.count % 3 != 0) return "the count is no multiple of 3";
  if (!attributes && s.filter != "NONE") return "only attributes have filters";
  if (s.filter == "OCTAHEDRAL" && s.stride != 4 && s.stride != 8) return "octahedral filters work on 4 or 8 bytes";
  if (s.filter == "COLOR" && s.stride != 4 && s.stride != 8) return "color filters work on 4 or 8 bytes";
  if (s.filter == "QUATERNION" && s.stride != 8) return "quaternion filters work on 8 bytes";
  if (s.decoded_bytes() > kMaxRatio * s.length)
    return std::to_string(s.length) + " bytes cannot hold " + std::to_string(s.decoded_bytes());
  return {};
}

/// The version of the attribute codec (low 4 bits of the first byte); 0 for other streams.
unsigned attribute_version(const Stream& s, gltf::Bytes encoded) {
  if (s.mode != "ATTRIBUTES" || encoded.empty()) return 0;
  const auto first = std::to_integer<unsigned>(encoded.front());
  return (first & 0xf0u) == 0xa0u ? first & 0x0fu : 0;
}

bool decode(const Stream& s, gltf::Bytes encoded, std::vector<std::byte>& out) {
  const auto* data = reinterpret_cast<const unsigned char*>(encoded.data());
  const auto count = static_cast<std::size_t>(s.count), stride = static_cast<std::size_t>(s.stride);
  if (s.mode == "TRIANGLES") return meshopt_decodeIndexBuffer(out.data(), count, stride, data, encoded.size()) == 0;
  if (s.mode == "INDICES") return meshopt_decodeIndexSequence(out.data(), count, stride, data, encoded.size()) == 0;
  const bool whole = attribute_version(s, encoded) == 1
                         ? decode_attribute_stream(encoded, stride, out)
                         : meshopt_decodeVertexBuffer(out.data(), count, stride, data, encoded.size()) == 0;
  if (!whole) return false;
  if (s.filter == "COLOR") decode_color_filter(out, stride / 4);
  if (s.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(out.data(), count, stride);
  if (s.filter == "QUATERNION") meshopt_decodeFilterQuat(out.data(), count, stride);
  if (s.filter == "EXPONENTIAL") meshopt_decodeFilterExp(out.data(), count, stride);
  return true;
}

void decode_view(gltf::Document& document, std::size_t index, DecodeBudget& budget, IssueLog& log) {
  auto& view = document.buffer_views[index];
  const MeshoptExtension extension = meshopt_extension(view.extensions);
  const std::string place = pointer("bufferViews", index, "extensions", extension.name);
  const std::size_t errors = log.error_count();
  check_shape(*extension.value, kMeshoptShape, place, log);
  if (log.error_count() != errors) return;
  const Stream stream = read_stream(*extension.value);
  if (stream.buffer >= document.buffers.size())
    return log.report(
        Rule::reference, pointer(place, "buffer"),
        "index " + std::to_string(stream.buffer) + " of " + std::to_string(document.buffers.size()) + " entries");
  const gltf::Bytes source = document.buffers[stream.buffer].bytes;
  if (stream.offset > source.size() || stream.length > source.size() - stream.offset)
    return log.report(Rule::buffer_view_range, place,
                      std::to_string(stream.length) + " bytes from byte " + std::to_string(stream.offset) +
                          " leave the " + std::to_string(source.size()) + " bytes of " +
                          pointer("buffers", stream.buffer));
  if (const std::string broken = fault(stream, view); !broken.empty())
    return log.report(Rule::decode_failed, place, broken);
  const auto encoded = source.subspan(static_cast<std::size_t>(stream.offset), static_cast<std::size_t>(stream.length));
  if (const unsigned version = attribute_version(stream, encoded); version > 1) {
    const bool has_copy = !view.bytes.empty();
    return log.report(has_copy ? Rule::meshopt_fallback : Rule::meshopt_version, place,
                      "version " + std::to_string(version) + " of the attribute codec is not supported" +
                          (has_copy ? "; the uncompressed copy is read" : ""));
  }
  if (!budget.take(stream.decoded_bytes()))
    return log.report(Rule::memory_budget, place, "decoding would take more memory than a file of this size may");

  std::vector<std::byte> decoded(static_cast<std::size_t>(stream.decoded_bytes()));
  if (!decode(stream, encoded, decoded))
    return log.report(Rule::decode_failed, place, "the " + stream.mode + " stream is damaged");
  document.storage.push_back(std::move(decoded));
  view.bytes = document.storage.back();
}

}  // namespace

void decode_meshopt(gltf::Document& document, DecodeBudget& budget, IssueLog& log) {
  for (std::size_t i = 0; i < document.buffer_views.size(); ++i)
    if (meshopt_extension(document.buffer_views[i].extensions)) decode_view(document, i, budget, log);
}

}  // namespace sinew
