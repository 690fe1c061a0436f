// SPDX-License-Identifier: MIT
#include "importer/decode/draco_stream.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <exception>

namespace sinew {
namespace {

constexpr std::uint16_t kMetadataFlag = 0x8000;
/// Plausibility limit: far above real compression ratios, yet small enough that a short stream cannot cause huge
/// allocations.
constexpr std::uint64_t kMaxElementsPerByte = 256;
constexpr std::uint64_t kPlausibleElements = 65536;

draco::DecoderBuffer buffer_of(gltf::Bytes stream) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(stream.data()), stream.size());
  return buffer;
}

}  // namespace

tl::expected<DracoSize, std::string> probe_draco(gltf::Bytes stream) {
  const auto truncated = tl::make_unexpected("the Draco stream ends early");
  draco::DecoderBuffer buffer = buffer_of(stream);
  draco::DracoHeader header{};
  if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok()) return tl::make_unexpected("is no Draco stream");
  if (header.version_major != 2 || header.version_minor != 2)
    return tl::make_unexpected("has Draco version " + std::to_string(header.version_major) + "." +
                               std::to_string(header.version_minor) + ", glTF uses 2.2");
  if (header.encoder_type != draco::TRIANGULAR_MESH) return tl::make_unexpected("holds no mesh");
  buffer.set_bitstream_version(DRACO_BITSTREAM_VERSION(2, 2));
  if ((header.flags & kMetadataFlag) != 0) {
    draco::GeometryMetadata metadata;
    if (!draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata)) return truncated;
  }
  DracoSize size;
  if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING) {
    std::uint8_t traversal = 0;
    if (!buffer.Decode(&traversal) || !draco::DecodeVarint(&size.vertices, &buffer) ||
        !draco::DecodeVarint(&size.faces, &buffer))
      return truncated;
  } else if (!draco::DecodeVarint(&size.faces, &buffer) || !draco::DecodeVarint(&size.vertices, &buffer)) {
    return truncated;
  }
  if (std::max(size.faces, size.vertices) > kPlausibleElements + kMaxElementsPerByte * stream.size())
    return tl::make_unexpected("claims " + std::to_string(size.faces) + " faces and " + std::to_string(size.vertices) +
                               " vertices in " + std::to_string(stream.size()) + " bytes");
  return size;
}

tl::expected<std::shared_ptr<const draco::Mesh>, std::string> decode_draco_stream(gltf::Bytes stream) try {
  draco::DecoderBuffer buffer = buffer_of(stream);
  draco::Decoder decoder;
  auto mesh = decoder.DecodeMeshFromBuffer(&buffer);
  if (!mesh.ok()) return tl::make_unexpected("the Draco stream is damaged: " + mesh.status().error_msg_string());
  return std::shared_ptr<const draco::Mesh>(std::move(mesh).value());
} catch (const std::exception& error) {
  return tl::make_unexpected(std::string("the Draco stream is damaged: ") + error.what());
}

}  // namespace sinew
