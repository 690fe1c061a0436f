// SPDX-License-Identifier: MIT
#include "runtime/memory/memory_of.h"

#include <gtest/gtest.h>

#include <memory>

#include "runtime/model/mirror_scene.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/allocation_counter.h"

namespace sinew::test {
namespace {

Scene scene_with_everything() {
  Scene scene = random_scene(3, {.joints = 40, .flat_normals = true, .correctives = 1});
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    scene.meshes[m].name = "a mesh with a long name, number " + std::to_string(m);
    scene.meshes[m].target_names.assign(scene.meshes[m].target_count(), "a target with a name longer than most");
  }
  scene.images.push_back({.name = "picture", .width = 32, .height = 32, .rgba = std::vector<std::uint8_t>(4096)});
  scene.lights.push_back({.name = "a light with a long name of its own"});
  return scene;
}

/// Expects nearly equal sizes: allocators round each block up, and control blocks of shared pointers are not counted.
void expect_close(std::size_t counted, std::size_t allocated) {
  EXPECT_LE(counted, allocated);
  EXPECT_GE(static_cast<double>(counted), 0.9 * static_cast<double>(allocated));
}

/// Heap bytes allocated since construction and still in use.
class BytesInUse {
 public:
  std::size_t count() const {
    const PeakMemory now;  // resets the peak
    return since_.bytes();
  }

 private:
  PeakMemory since_;
};

MemoryBytes of_clips(std::span<const Clip> clips) {
  MemoryCount count;
  for (const Clip& clip : clips) count.add(clip);
  return count.bytes();
}

TEST(memory_of, a_scene_takes_what_its_copy_allocates_and_what_both_share) {
  const Scene scene = scene_with_everything();
  const std::size_t name_of_light = sizeof(std::string) + scene.lights[0].name.str().size() + 1;
  const std::size_t shared = of_clips(scene.clips).total() + name_of_light;
  const BytesInUse in_use;
  const Scene copy = scene;
  const std::size_t allocated = in_use.count();
  const MemoryBytes bytes = memory_of(copy);
  expect_close(bytes.total() - shared, allocated);
  EXPECT_EQ(bytes.images, copy.images.capacity() * sizeof(Image) + 4096);
  EXPECT_GT(bytes.morphs, 0u);
  EXPECT_GT(bytes.vertices, bytes.skins);
  EXPECT_GT(bytes.clip_keys, 0u);
  EXPECT_EQ(bytes.plans + bytes.frames, 0u);
}

/// True if growing an array or string of the scene grows the count of that kind.
bool counts(const Scene& scene, auto& array, std::size_t MemoryBytes::*kind) {
  const std::size_t before = memory_of(scene).*kind, size = sizeof(array[0]) * 10000;
  array.resize(array.size() + 10000);
  const std::size_t more = memory_of(scene).*kind - before;
  return more + size / 10 >= size;  // the array may have had spare capacity
}

TEST(memory_of, every_array_of_a_mesh_counts) {
  Scene scene = scene_with_everything();
  Primitive& p = scene.meshes[0].primitives[0];
  const auto grows = [&](auto& array, std::size_t MemoryBytes::*kind) { return counts(scene, array, kind); };
  EXPECT_TRUE(grows(p.positions, &MemoryBytes::vertices));
  EXPECT_TRUE(grows(p.normals, &MemoryBytes::vertices));
  EXPECT_TRUE(grows(p.tangents, &MemoryBytes::vertices));
  EXPECT_TRUE(grows(p.indices, &MemoryBytes::vertices));
  EXPECT_TRUE(grows(p.colors, &MemoryBytes::vertices));
  EXPECT_TRUE(grows(p.texcoords.emplace_back(), &MemoryBytes::vertices));
  EXPECT_TRUE(grows(p.influences.joints, &MemoryBytes::vertices));
  EXPECT_TRUE(grows(p.influences.weights, &MemoryBytes::vertices));
  EXPECT_TRUE(grows(p.centers_of_rotation, &MemoryBytes::vertices));
  EXPECT_TRUE(grows(p.source_vertex, &MemoryBytes::vertices));
  EXPECT_TRUE(grows(p.morphs.targets.emplace_back().normals.deltas, &MemoryBytes::morphs));
  EXPECT_TRUE(grows(scene.skins.at(0).inverse_bind, &MemoryBytes::skins));
  EXPECT_TRUE(grows(scene.instances.at(0).rest_weights, &MemoryBytes::others));
  EXPECT_TRUE(grows(scene.animations.at(0).bones.at(0).rotation.values, &MemoryBytes::animations));
}

TEST(memory_of, every_array_and_text_of_a_scene_counts) {
  Scene scene = scene_with_everything();
  const auto other = [&](auto& array) { return counts(scene, array, &MemoryBytes::others); };
  Image& image = scene.images.at(0);
  for (std::string* text : {&image.name, &image.missing_reason, &image.mime_type})
    EXPECT_TRUE(counts(scene, *text, &MemoryBytes::images));
  EXPECT_TRUE(counts(scene, image.rgba, &MemoryBytes::images));
  EXPECT_TRUE(counts(scene, image.encoded, &MemoryBytes::images));
  EXPECT_TRUE(counts(scene, scene.skins.at(0).name, &MemoryBytes::skins));
  EXPECT_TRUE(counts(scene, scene.skins.at(0).joints, &MemoryBytes::skins));
  EXPECT_TRUE(counts(scene, scene.skeleton.fixed_matrices, &MemoryBytes::skeletons));
  EXPECT_TRUE(counts(scene, scene.skeleton.node_of_joint, &MemoryBytes::skeletons));
  EXPECT_TRUE(counts(scene, scene.animations.at(0).name, &MemoryBytes::animations));
  EXPECT_TRUE(counts(scene, scene.meshes.at(0).default_weights, &MemoryBytes::morphs));
  EXPECT_TRUE(other(scene.meshes.at(0).name));
  EXPECT_TRUE(other(scene.instances.at(0).copies));
  EXPECT_TRUE(other(scene.hidden_joints));
  EXPECT_TRUE(other(scene.textures));
  EXPECT_TRUE(other(scene.first_weight));
  EXPECT_TRUE(other(scene.materials.emplace_back().name));
  EXPECT_TRUE(other(scene.scenes.emplace_back().name));
  EXPECT_TRUE(other(scene.scenes.back().joints));
  EXPECT_TRUE(other(scene.variants.emplace_back()));
  PoseCorrective& corrective = scene.correctives.at(0);
  EXPECT_TRUE(other(corrective.samples.rotations));
  EXPECT_TRUE(other(corrective.samples.values));
  EXPECT_TRUE(other(corrective.coefficients));
  EXPECT_TRUE(other(corrective.lower));
}

TEST(memory_of, a_clip_takes_what_compiling_it_leaves) {
  const Scene scene = scene_with_everything();
  const std::vector<float> rest_weights = rest_weights_of(scene);
  for (const bool packed : {false, true}) {
    KeyTolerances rounding;
    if (packed) rounding.bones.assign(scene.animations[0].bones.size(), {1e-3, 1e-3, 1e-3});
    const BytesInUse in_use;
    const Clip clip = compile_clip(scene.animations[0], scene.skeleton, rest_weights, scene.first_weight, {}, rounding);
    expect_close(memory_of(clip).total(), in_use.count());
  }
}

TEST(memory_of, a_plan_and_a_frame_take_what_making_them_leaves) {
  const Scene scene = scene_with_everything();
  for (const bool leaves_out : {false, true}) {
    Needs needs;
    needs.in.masks = {std::vector<float>(scene.skeleton.joint_count(), 0.5f)};
    needs.skin.kind = Skinning::dual_quaternion;
    needs.skin.per_instance = {Skinning::linear, Skinning::dual_quaternion, Skinning::linear, Skinning::linear};
    if (leaves_out) {
      needs.out.skeleton_lod.kept.assign(scene.skeleton.joint_count(), true);
      needs.out.skeleton_lod.kept.back() = false;
    }
    const BytesInUse in_use;
    const Plan plan = compile_plan(lend(scene), needs);
    const std::size_t of_plan = in_use.count();
    MemoryCount count;
    const std::size_t of_scene = count.add(scene).bytes().total();  // clips share keys
    expect_close(count.add(plan).bytes().total() - of_scene, of_plan);

    const BytesInUse more;
    const FrameBuffer frame(plan);
    expect_close(memory_of(frame).total(), more.count());
    EXPECT_EQ(memory_of(frame).frames, plan.frame_bytes());
    std::vector<std::byte> own(plan.frame_bytes() + FrameBuffer::kAlignment);
    const auto begin = reinterpret_cast<std::uintptr_t>(own.data());
    const std::size_t aligned = (FrameBuffer::kAlignment - begin % FrameBuffer::kAlignment) % FrameBuffer::kAlignment;
    EXPECT_EQ(memory_of(FrameBuffer(plan, std::span(own).subspan(aligned))).total(), 0u) << "it is the caller's";
  }
}

TEST(memory_of, how_plans_mirror_counts_once) {
  const Scene scene = scene_with_everything();
  Needs needs;
  const Plan plain = compile_plan(lend(scene), needs);
  needs.in.mirror = std::make_shared<const MirrorMap>(make_mirror_map(scene));
  const Plan a = compile_plan(lend(scene), needs), b = compile_plan(lend(scene), needs);
  const std::size_t of_map = sizeof(MirrorMap) + needs.in.mirror->joints.size() * sizeof(needs.in.mirror->joints[0]);
  const std::size_t of_a = memory_of(a).plans, both = MemoryCount().add(a).add(b).bytes().plans;
  EXPECT_GE(of_a, memory_of(plain).plans + of_map);
  EXPECT_LE(both, 2 * of_a - of_map);
  EXPECT_GT(both, of_a);
}

TEST(memory_of, a_library_takes_what_adding_to_it_leaves) {
  Scene scene = scene_with_everything();
  for (std::string& name : scene.skeleton.names) name.resize(200, 'x');
  finish_scene(scene);
  for (const std::size_t files : {0u, 1u, 3u}) {
    const BytesInUse in_use;
    ClipLibrary library(scene.skeleton);
    for (std::size_t f = 0; f < files; ++f) library.add(scene);
    const std::size_t allocated = in_use.count();
    MemoryCount count;
    const std::size_t of_scene = count.add(scene).bytes().total();  // clips share keys and rest values
    expect_close(count.add(library).bytes().total() - of_scene, allocated);
  }
}

TEST(memory_of, what_is_shared_counts_once) {
  const Scene scene = scene_with_everything();
  Scene larger = scene;
  for (Transform& rest : larger.skeleton.rest) rest.translation *= 2.0f;
  larger.animations.clear();
  finish_scene(larger);
  ClipLibrary library(scene.skeleton);
  library.add(scene);
  const BoundClips bound = clips_for(library, larger);
  MemoryCount together;
  together.add(library);
  const MemoryBytes of_library = together.bytes();
  EXPECT_EQ(of_library.clip_keys, of_clips(scene.clips).clip_keys);
  EXPECT_EQ(together.add(library[0]).bytes().total(), of_library.total());
  for (const Clip& clip : bound.clips) together.add(clip);
  EXPECT_EQ(together.bytes().clip_keys, of_library.clip_keys) << "the same keys";
  EXPECT_GT(together.bytes().clip_tables, of_library.clip_tables);
  EXPECT_EQ(of_clips(bound.clips).clip_keys, of_library.clip_keys);
}

}  // namespace
}  // namespace sinew::test
