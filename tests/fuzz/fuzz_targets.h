// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

namespace sinew::fuzz {

using Bytes = std::span<const std::byte>;

/// A fuzz target accepts any bytes. A broken promise throws an exception, which libFuzzer and GoogleTest report.
struct Target {
  std::string_view name;
  void (*run)(Bytes input);
};

void import_glb(Bytes input);           ///< a whole file, then one frame of its scene
void import_json(Bytes input);          ///< .gltf text with its buffers in data URIs
void read_accessors(Bytes input);       ///< valid JSON around arbitrary accessors and bytes: see accessors_target.cpp
void decode_compressed(Bytes input);    ///< meshopt and Draco streams: see compressed_target.cpp
void decode_images(Bytes input);        ///< PNG, JPEG, WebP, AVIF, KTX2
void load_compiled_clips(Bytes input);  ///< compiled clips: the input as a file, and behind a valid head
void play_geometry(Bytes input);        ///< geometry caches: the input as a file, and as the frames of a valid one
void read_asset_files(Bytes input);     ///< .sinew files: the input as it is, and with correct checksums
void read_poses(Bytes input);           ///< golden poses for `sinew verify`
void read_motion(Bytes input);          ///< BVH files, which become glTF
void play_graphs(Bytes input);          ///< motion graphs as text; sound ones are played and restored
void play_graph_bytes(Bytes input);     ///< motion graphs as bytes

std::span<const Target> targets() noexcept;

/// Throws when `holds` is false.
void require(bool holds, const char* promise);

}  // namespace sinew::fuzz
