// SPDX-License-Identifier: MIT
#include "runtime/clip/clip_layout.h"
#include "runtime/memory/array_bytes.h"
#include "runtime/memory/memory_of.h"

namespace sinew {
namespace {

template <class TrackType>
std::size_t bytes_of_track(const TrackType& track) {
  return bytes_of(track.times_s) + bytes_of(track.values);
}

std::size_t bytes_of_keys(const Animation& animation) {
  return bytes_of(animation.name) +
         bytes_of(animation.bones,
                  [](const BoneAnimation& bone) {
                    return bytes_of_track(bone.translation) + bytes_of_track(bone.rotation) +
                           bytes_of_track(bone.scale);
                  }) +
         bytes_of(animation.weights, [](const WeightAnimation& a) { return bytes_of_track(a.weights); }) +
         bytes_of(animation.properties, [](const PropertyTrack& track) { return bytes_of_track(track.values); });
}

/// Bytes of the tables, without the packed keys, which copies share.
std::size_t bytes_of_tables(const PackedRows& rows) {
  return bytes_of(rows.first_byte) + bytes_of(rows.byte) + bytes_of(rows.mask) + bytes_of(rows.step) +
         bytes_of(rows.low) + bytes_of(rows.derived) + bytes_of(rows.kinds) + bytes_of(rows.power);
}

std::size_t bytes_of_tables(const TrackBlock& block) {
  return bytes_of(block.targets) + bytes_of(block.places.lane_of) + bytes_of(block.places.lanes_before) +
         bytes_of_tables(block.packed);
}

std::size_t bytes_of_vertices(const Primitive& p) {
  return bytes_of(p.indices) + bytes_of(p.positions) + bytes_of(p.normals) + bytes_of(p.tangents) +
         bytes_of(p.texcoords, [](const auto& set) { return bytes_of(set); }) + bytes_of(p.colors) +
         bytes_of(p.influences.groups) + bytes_of(p.influences.joints) + bytes_of(p.influences.weights) +
         bytes_of(p.centers_of_rotation) + bytes_of(p.variant_materials) + bytes_of(p.source_vertex);
}

std::size_t bytes_of_target(const MorphTarget& target) {
  const auto deltas = [](const auto& sparse) { return bytes_of(sparse.vertices) + bytes_of(sparse.deltas); };
  return deltas(target.positions) + deltas(target.normals) + deltas(target.tangents) + deltas(target.colors) +
         bytes_of(target.texcoords, deltas);
}

std::size_t bytes_of_samples(const PoseCorrective& corrective) {
  const PoseSamples& samples = corrective.samples;
  return bytes_of(samples.drivers) + bytes_of(samples.rotations) + bytes_of(samples.weights) +
         bytes_of(samples.values) + bytes_of(corrective.coefficients) + bytes_of(corrective.lower) +
         bytes_of(corrective.upper);
}

std::size_t bytes_of_image(const Image& image) {
  return bytes_of(image.name) + bytes_of(image.rgba) + bytes_of(image.missing_reason) + bytes_of(image.mime_type) +
         bytes_of(image.encoded);
}

}  // namespace

MemoryCount& MemoryCount::add(const Skeleton& s) {
  bytes_.skeletons += bytes_of(s.parents) + bytes_of(s.rest) + bytes_of(s.fixed_matrices) +
                      bytes_of(s.fixed_matrix_of) + bytes_of_texts(s.names) + bytes_of(s.node_of_joint) +
                      bytes_of(s.joint_of_node) + bytes_of(s.level_begin);
  return *this;
}

void MemoryCount::add(const RestNumbers& rest) {
  if (is_new(rest.get())) bytes_.clip_tables += sizeof(*rest) + bytes_of(*rest);
}

void MemoryCount::add(const BaseNumbers& base) {
  add(base.rest());
  bytes_.clip_tables += base.own().size_bytes();
}

MemoryCount& MemoryCount::add(const Clip& clip) {
  const ClipLayout& layout = clip.layout();
  if (!is_new(&layout)) return *this;
  bytes_.clip_tables += sizeof layout + bytes_of(layout.name) + bytes_of(layout.groups);
  add(layout.base_pose);
  add(layout.base_weights);
  add(layout.base_properties);
  for (const TimeGroup& group : layout.groups) {
    if (is_new(group.times.times_s().data())) bytes_.clip_keys += group.times.byte_size() + 2 * kSharedArrayBytes;
    bytes_.clip_tables += bytes_of(group.blocks, [](const TrackBlock& block) { return bytes_of_tables(block); });
    for (const TrackBlock& block : group.blocks) {
      if (is_new(block.rows.data())) bytes_.clip_keys += bytes_of(block.rows);
      if (is_new(block.packed.bits.data())) bytes_.clip_keys += bytes_of(block.packed.bits);
    }
  }
  return *this;
}

void MemoryCount::add(const ClipChannels& channels) {
  for (const SharedArray<std::string>* names : {&channels.joints, &channels.weights, &channels.numbers})
    if (is_new(names->data())) bytes_.clip_tables += bytes_of_texts(*names);
  add(channels.rest.pose);
  add(channels.rest.weights);
  add(channels.rest.properties);
}

MemoryCount& MemoryCount::add(const ClipLibrary& library) {
  bytes_.clip_tables += bytes_of(library.clips_) + bytes_of(library.files_);
  add(library.channels_);
  for (const ClipLibrary::File& file : library.files_) add(file.channels);
  for (const Clip& clip : library.clips_) add(clip);
  return *this;
}

void MemoryCount::add(const Mesh& mesh) {
  bytes_.others += bytes_of(mesh.name) + bytes_of(mesh.primitives);
  bytes_.morphs += bytes_of(mesh.default_weights) + bytes_of_texts(mesh.target_names);
  for (const Primitive& primitive : mesh.primitives) {
    bytes_.vertices += bytes_of_vertices(primitive);
    bytes_.morphs += bytes_of(primitive.morphs.targets, bytes_of_target);
  }
}

MemoryCount& MemoryCount::add(const Scene& scene) {
  add(scene.skeleton);
  bytes_.animations += bytes_of(scene.animations, bytes_of_keys);
  bytes_.clip_tables += bytes_of(scene.clips) + bytes_of(scene.properties.entries) + bytes_of(scene.properties.rest);
  for (const Clip& clip : scene.clips) add(clip);
  bytes_.skins += bytes_of(scene.skins, [](const Skin& skin) {
    return bytes_of(skin.name) + bytes_of(skin.joints) + bytes_of(skin.inverse_bind);
  });
  bytes_.others += bytes_of(scene.meshes);
  for (const Mesh& mesh : scene.meshes) add(mesh);
  bytes_.images += bytes_of(scene.images, bytes_of_image);
  const auto named = [this](const auto& thing) {
    const std::string& name = thing.name.str();
    return is_new(&name) && !name.empty() ? sizeof name + bytes_of(name) : 0;
  };
  bytes_.others += bytes_of(scene.instances, [](const MeshInstance& instance) {
    return bytes_of(instance.rest_weights) + bytes_of(instance.copies);
  });
  bytes_.others += bytes_of(scene.first_weight) + bytes_of(scene.correctives, bytes_of_samples) +
                   bytes_of(scene.hidden_joints) + bytes_of_texts(scene.variants) + bytes_of(scene.textures) +
                   bytes_of(scene.cameras, named) + bytes_of(scene.lights, named);
  bytes_.others +=
      bytes_of(scene.materials, [](const Material& material) { return bytes_of(material.name); }) +
      bytes_of(scene.scenes, [](const SceneRoots& roots) { return bytes_of(roots.name) + bytes_of(roots.joints); });
  return *this;
}

}  // namespace sinew
