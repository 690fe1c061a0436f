// SPDX-License-Identifier: MIT
#include "runtime/asset_file/read_assets.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

#include "runtime/animation/skeleton_signature.h"
#include "runtime/asset_file/asset_fields.h"
#include "runtime/asset_file/asset_reader.h"
#include "runtime/asset_file/look_fields.h"
#include "runtime/asset_file/read_pages.h"
#include "runtime/base/all_finite.h"
#include "runtime/clip/clip_file.h"
#include "runtime/clip/clip_rest.h"
#include "runtime/clip/decompile_clip.h"
#include "runtime/model/scene.h"

namespace sinew {
namespace {

template <class T>
using Read = tl::expected<T, AssetFileError>;

tl::unexpected<AssetFileError> refuse(const char* rule, AssetKind kind, std::string detail) {
  return tl::unexpected(AssetFileError{rule, std::string(name_of(kind)), 0, std::move(detail)});
}

/// Reads a block with `read(reader)`.
template <class ReadFields>
Read<void> read_block(const AssetFile& file, AssetKind kind, const ReadFields& read) {
  std::vector<std::byte> unpacked;
  const auto bytes = file.bytes_of(kind, unpacked);
  if (!bytes) return tl::unexpected(bytes.error());
  AssetReader reader(*bytes, kind);
  read(reader);
  if (!reader.finish()) return tl::unexpected(reader.error());
  return {};
}

std::string hex(std::uint64_t number) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) text += kDigits[number >> shift & 15];
  return text;
}

Read<void> check_signature(const AssetFile& file, AssetKind kind, std::uint64_t signature) {
  const AssetBlock* block = file.find(kind);
  if (block == nullptr || block->skeleton_signature == signature) return {};
  return refuse(
      "asset-signature", kind,
      "the block belongs to skeleton " + hex(block->skeleton_signature) + ", not to skeleton " + hex(signature));
}

/// Checks a scene with the skeleton alone, or with skeleton and model.
Read<void> check_part(const Scene& scene, AssetKind kind) {
  const ErrorCode code = check(scene);
  if (code == ErrorCode::ok) return {};
  return refuse("asset-value", kind, std::string(describe(code)));
}

Read<void> read_model(const AssetFile& file, Scene& scene) {
  if (const auto bound = check_signature(file, AssetKind::model, skeleton_signature(scene.skeleton)); !bound)
    return bound;
  const auto read = read_block(file, AssetKind::model, [&](AssetReader& in) {
    std::apply([&](auto&... field) { (in.read(field), ...); }, model_fields(scene));
  });
  return read ? check_part(scene, AssetKind::model) : read;
}

/// Checks that clips move as many joints, morph weights and properties as the scene has.
Read<void> check_binding(const std::vector<Clip>& clips, const Scene& scene) {
  struct Count {
    const char* what;
    std::size_t of_clip, of_scene;
  };
  for (const Clip& clip : clips)
    for (const Count& count : {Count{"joints", clip.joint_count(), scene.skeleton.joint_count()},
                               Count{"morph weights", clip.weight_count(), scene.weight_count()},
                               Count{"numbers of properties", clip.property_count(), scene.properties.rest.size()}})
      if (count.of_clip != count.of_scene)
        return refuse("asset-binding", AssetKind::clips,
                      "clip \"" + clip.name() + "\" was compiled for " + std::to_string(count.of_clip) + " " +
                          count.what + ", the scene has " + std::to_string(count.of_scene));
  return {};
}

/// Makes animations from the keys of the clips, within a memory limit.
Read<std::vector<Animation>> decompile(const std::vector<Clip>& clips, const Scene& scene, std::uint64_t limit) {
  const std::vector<float> rest_weights = rest_weights_of(scene);
  const ClipRest rest = clip_rest(scene.skeleton, rest_weights, scene.properties);
  std::vector<Animation> animations;
  for (const Clip& clip : clips) {
    const std::uint64_t bytes = decompiled_bytes(clip);
    if (bytes > limit)
      return refuse("asset-memory", AssetKind::clips, "the keys of the clips take far more memory than their bytes");
    limit -= bytes;
    auto animation = decompile_clip(clip, rest, scene.first_weight, scene.properties);
    if (!animation)
      return refuse("asset-binding", AssetKind::clips,
                    "clip \"" + clip.name() + "\" moves a part of a property, or weights of two instances at a time");
    animations.push_back(*std::move(animation));
  }
  return animations;
}

Read<std::vector<Animation>> animations_of(const AssetFile& file, const std::vector<Clip>& clips, const Scene& scene) {
  if (file.find(AssetKind::animations) == nullptr) {
    std::uint64_t bytes = 0;  // unpacked, including packed pages
    for (const Clip& clip : clips) bytes += clip.byte_size();
    return decompile(clips, scene, kAssetMadeBytes + kAssetMadeTimes * bytes);
  }
  const std::uint64_t signature = file.find(AssetKind::clips)->skeleton_signature;
  if (const auto bound = check_signature(file, AssetKind::animations, signature); !bound)
    return tl::unexpected(bound.error());
  std::vector<Animation> animations;
  const auto read = read_block(file, AssetKind::animations, [&](AssetReader& in) { in.read(animations); });
  if (!read) return tl::unexpected(read.error());
  if (animations.size() != clips.size())
    return refuse("asset-value", AssetKind::animations, "there are more or fewer than clips");
  for (std::size_t c = 0; c < clips.size(); ++c) animations[c].annotations = clips[c].annotations();
  return animations;
}

bool is_finite(const Aabb& box) noexcept {
  return all_finite(std::span(&box.lower.x, 3)) && all_finite(std::span(&box.upper.x, 3));
}

/// Describes what is wrong with the boxes of a scene; null if nothing is.
const char* fault_of(const ClipBoxes& boxes, const Scene& scene) noexcept {
  if (boxes.size() > scene.clips.size()) return "there are boxes of more clips than the scene has";
  for (const std::vector<Aabb>& of_clip : boxes) {
    if (!of_clip.empty() && of_clip.size() != scene.instances.size())
      return "a clip has boxes of more or fewer mesh instances than the scene has";
    if (!std::all_of(of_clip.begin(), of_clip.end(), is_finite)) return "a box is not finite";
  }
  return nullptr;
}

bool is_finite(const Transform& t) noexcept {
  return all_finite(std::span(&t.translation.x, 3)) && all_finite(std::span(&t.rotation.x, 4)) &&
         all_finite(std::span(&t.scale.x, 3));
}

bool is_length(double m) noexcept { return std::isfinite(m) && m >= 0.0; }

/// Describes what is wrong with a skeleton LOD; null if nothing is.
const char* fault_of(const StoredSkeletonLod& stored, std::size_t joint_count) noexcept {
  const CompiledSkeletonLod& lod = stored.lod;
  const auto of_joints = [&](std::size_t size) { return size == 0 || size == joint_count; };
  if (!of_joints(stored.kept.size()) || !of_joints(lod.detail.held.size()) || lod.left_out > joint_count)
    return "a skeleton LOD has more or fewer joints than the skeleton";
  if (std::any_of(stored.kept.begin(), stored.kept.end(), [](std::uint8_t kept) { return kept > 1; }))
    return "a flag is neither 0 nor 1";
  if (!std::all_of(lod.detail.held.begin(), lod.detail.held.end(), [](const Transform& t) { return is_finite(t); }))
    return "a held transform is not finite";
  if (!is_length(lod.tolerance_m) || !is_length(lod.measured_m)) return "the error of a skeleton LOD is no length";
  if (lod.worst_joint != kNone && lod.worst_joint >= joint_count) return "there is no such joint";
  return nullptr;
}

}  // namespace

Read<Skeleton> read_skeleton(const AssetFile& file) {
  Scene scene;
  scene.first_weight = {0};
  const auto read = read_block(file, AssetKind::skeleton, [&](AssetReader& in) { in.read(scene.skeleton); });
  if (!read) return tl::unexpected(read.error());
  if (const auto checked = check_part(scene, AssetKind::skeleton); !checked) return tl::unexpected(checked.error());
  if (const auto same = check_signature(file, AssetKind::skeleton, skeleton_signature(scene.skeleton)); !same)
    return tl::unexpected(same.error());
  return std::move(scene.skeleton);
}

Read<std::vector<Clip>> read_clips(const AssetFile& file, std::uint64_t skeleton_signature, LongClips long_clips) {
  std::vector<std::byte> unpacked;
  const auto bytes = file.bytes_of(AssetKind::clips, unpacked);
  if (!bytes) return tl::unexpected(bytes.error());
  for (const AssetKind kind : {AssetKind::clips, AssetKind::pages, AssetKind::page_keys})
    if (const auto bound = check_signature(file, kind, skeleton_signature); !bound)
      return tl::unexpected(bound.error());
  auto clips = load_clips(*bytes);
  if (!clips)
    return tl::unexpected(AssetFileError{clips.error().rule, std::string(name_of(AssetKind::clips)),
                                         clips.error().offset, clips.error().detail});
  if (long_clips == LongClips::joined) return join_pages(file, *std::move(clips));
  return *std::move(clips);
}

Read<void> add_clips(const AssetFile& file, Scene& scene, LongClips long_clips) {
  auto clips = read_clips(file, skeleton_signature(scene.skeleton), long_clips);
  if (!clips) return tl::unexpected(clips.error());
  if (const auto bound = check_binding(*clips, scene); !bound) return bound;
  auto animations = animations_of(file, *clips, scene);
  if (!animations) return tl::unexpected(animations.error());
  if (const ErrorCode code = check_animations(*animations, scene); code != ErrorCode::ok)
    return refuse("asset-value", file.find(AssetKind::animations) != nullptr ? AssetKind::animations : AssetKind::clips,
                  std::string(describe(code)));
  scene.clips.insert(scene.clips.end(), clips->begin(), clips->end());
  scene.animations.insert(scene.animations.end(), std::move_iterator(animations->begin()),
                          std::move_iterator(animations->end()));
  return {};
}

Read<Scene> read_scene(const AssetFile& file, LongClips long_clips) {
  auto skeleton = read_skeleton(file);
  if (!skeleton) return tl::unexpected(skeleton.error());
  Scene scene;
  scene.skeleton = *std::move(skeleton);
  scene.first_weight = {0};
  if (file.find(AssetKind::model) != nullptr)
    if (const auto read = read_model(file, scene); !read) return tl::unexpected(read.error());
  if (file.find(AssetKind::clips) != nullptr || file.find(AssetKind::animations) != nullptr)
    if (const auto added = add_clips(file, scene, long_clips); !added) return tl::unexpected(added.error());
  return scene;
}

Read<ClipBoxes> read_clip_boxes(const AssetFile& file, const Scene& scene) {
  ClipBoxes boxes;
  if (file.find(AssetKind::bounds) == nullptr) return boxes;
  if (const auto bound = check_signature(file, AssetKind::bounds, skeleton_signature(scene.skeleton)); !bound)
    return tl::unexpected(bound.error());
  const auto read = read_block(file, AssetKind::bounds, [&](AssetReader& in) { in.read(boxes); });
  if (!read) return tl::unexpected(read.error());
  if (const char* fault = fault_of(boxes, scene)) return refuse("asset-value", AssetKind::bounds, fault);
  return boxes;
}

Read<std::vector<CompiledSkeletonLod>> read_skeleton_lods(const AssetFile& file, const Skeleton& skeleton) {
  std::vector<CompiledSkeletonLod> lods;
  if (file.find(AssetKind::skeleton_lods) == nullptr) return lods;
  if (const auto bound = check_signature(file, AssetKind::skeleton_lods, skeleton_signature(skeleton)); !bound)
    return tl::unexpected(bound.error());
  std::vector<StoredSkeletonLod> stored;
  const auto read = read_block(file, AssetKind::skeleton_lods, [&](AssetReader& in) { in.read(stored); });
  if (!read) return tl::unexpected(read.error());
  for (StoredSkeletonLod& level : stored) {
    if (const char* fault = fault_of(level, skeleton.joint_count()))
      return refuse("asset-value", AssetKind::skeleton_lods, fault);
    level.lod.detail.kept.assign(level.kept.begin(), level.kept.end());
    lods.push_back(std::move(level.lod));
  }
  return lods;
}

Read<std::vector<StoredGraph>> read_graphs(const AssetFile& file) {
  std::vector<StoredGraph> graphs;
  if (file.find(AssetKind::graphs) == nullptr) return graphs;
  const auto read = read_block(file, AssetKind::graphs, [&](AssetReader& in) {
    std::uint64_t count = 0;
    for (in.read(count); count > 0 && in.ok(); --count) {
      StoredGraph& graph = graphs.emplace_back();
      in.read(graph.name);
      in.read(graph.bytes);
    }
  });
  if (!read) return tl::unexpected(read.error());
  std::set<std::string_view> names;
  for (const StoredGraph& graph : graphs)
    if (!names.insert(graph.name).second) return refuse("asset-value", AssetKind::graphs, "two graphs have one name");
  return graphs;
}

}  // namespace sinew
