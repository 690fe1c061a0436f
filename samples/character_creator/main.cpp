// SPDX-License-Identifier: MIT
// One clip library from two files for three outfits in two body sizes. Outfits are swapped between frames while clips
// play. A new outfit continues at the same time, and no clip is stored twice.
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "runtime/base/same_bits.h"
#include "runtime/memory/memory_of.h"
#include "runtime/plan/run_plan.h"
#include "samples/showcase/scene_builder.h"
#include "samples/showcase/shapes.h"

namespace {

using namespace sinew;

constexpr std::uint32_t kHips = 0, kSpine = 1, kLeg = 2, kArm = 3;
constexpr double kFrame_s = 1.0 / 60.0;

void add_body(showcase::SceneBuilder& scene, float size) {
  const std::uint32_t hips = scene.add_joint("hips", kNone, {.translation = {0, size, 0}});
  const std::uint32_t spine = scene.add_joint("spine", hips, {.translation = {0, 0.5f * size, 0}});
  scene.add_joint("leg", hips, {.translation = {0.1f * size, 0, 0}});
  scene.add_joint("arm", spine, {.translation = {0.3f * size, 0, 0}});
}

/// A joint that swings about z, with its keys at 30 a second.
BoneAnimation swing(std::uint32_t joint, float angle_rad) {
  BoneAnimation bone;
  bone.joint = joint;
  for (int k = 0; k <= 60; ++k) {
    const float half = 0.5f * angle_rad * std::sin(0.1047198f * static_cast<float>(k));
    bone.rotation.times_s.push_back(static_cast<float>(k) / 30.0f);
    bone.rotation.values.push_back(quat_xyzw(0.0f, 0.0f, std::sin(half), std::cos(half)));
  }
  return bone;
}

/// A file of two clips, as exported by an animator. It also contains a camera rig, so the body's joints have other
/// indices.
Scene make_walks() {
  showcase::SceneBuilder file;
  file.add_joint("camera rig", kNone, {});
  add_body(file, 1.0f);
  file.add_animation({"walk", 2.0, {swing(1 + kLeg, 0.5f), swing(1 + kArm, -0.4f)}, {}});
  file.add_animation({"run", 2.0, {swing(1 + kLeg, 1.0f), swing(1 + kArm, -0.9f), swing(1 + kSpine, 0.1f)}, {}});
  return file.finish();
}

Scene make_gestures() {
  showcase::SceneBuilder file;
  add_body(file, 1.0f);
  file.add_animation({"wave", 2.0, {swing(kArm, 1.5f)}, {}});
  return file.finish();
}

/// A model without clips: a box for each of these joints, skinned to the joint.
Scene make_outfit(const std::string& name, float size, std::initializer_list<std::uint16_t> joints) {
  showcase::SceneBuilder scene;
  add_body(scene, size);
  Primitive cloth;
  for (const std::uint16_t joint : joints) {
    const Primitive box = showcase::box({0, 0, 0}, glm::vec3(0.1f * size));
    showcase::append(cloth, box);
    cloth.influences.joints.insert(cloth.influences.joints.end(), box.vertex_count(), joint);
  }
  const auto vertices = static_cast<std::uint32_t>(cloth.vertex_count());
  cloth.influences.weights.assign(vertices, 1.0f);
  cloth.influences.groups = {{0, vertices, 1, 0}};
  const std::uint32_t skin = scene.add_skin({name, {kHips, kSpine, kLeg, kArm}, std::vector<Affine>(4), kNone});
  scene.add_instance(kHips, scene.add_mesh({name, {cloth}, {}, {}}), skin);
  return scene.finish();
}

struct Outfit {
  std::shared_ptr<const Scene> scene;
  std::vector<Clip> clips;  ///< clips of the library, bound to this scene
  Plan plan;
};

std::vector<Outfit> dress(const ClipLibrary& library) {
  std::vector<Outfit> outfits;
  for (const float size : {1.0f, 1.3f}) {
    outfits.push_back({share(make_outfit("coat", size, {kHips, kSpine, kArm})), {}, {}});
    outfits.push_back({share(make_outfit("armour", size, {kHips, kSpine, kLeg, kArm})), {}, {}});
    outfits.push_back({share(make_outfit("shorts", size, {kHips, kLeg})), {}, {}});
  }
  for (Outfit& outfit : outfits) {
    outfit.clips = clips_for(library, *outfit.scene).clips;
    outfit.plan = compile_plan(outfit.scene, outfit.clips, Needs{});
  }
  return outfits;
}

void print_memory(const ClipLibrary& library, const std::vector<Outfit>& outfits) {
  MemoryCount together;
  together.add(library);
  std::size_t alone = 0;
  for (const Outfit& outfit : outfits) {
    MemoryCount one;
    for (const Clip& clip : outfit.clips) {
      one.add(clip);
      together.add(clip);
    }
    alone += one.bytes().clip_keys;
  }
  std::printf("keys of clips: %zu bytes for all, %zu if each outfit had its own\n", together.bytes().clip_keys, alone);
}

/// Plays `clip` and swaps the outfits of one size. Returns true if each frame has the joints of an outfit that is never
/// swapped.
bool swap_outfits(const std::vector<Outfit>& outfits, std::size_t first, std::uint32_t clip, int frames) {
  FrameBuffer never_off(outfits[first].plan), worn(outfits[first].plan);
  for (int f = 0; f < frames; ++f) {
    const Plan& plan = outfits[first + static_cast<std::size_t>(f) % 3].plan;
    const std::uint64_t last_frame = worn.result().frame;
    worn = FrameBuffer(plan);  // the program owns the clock, so the motion continues
    worn.count_from(last_frame);
    const ClipLayer layer{.clip = clip, .time_s = f * kFrame_s};
    const FrameInput input{.layers = {&layer, 1}};
    if (run_plan(plan, input, worn) != ErrorCode::ok ||
        run_plan(outfits[first].plan, input, never_off) != ErrorCode::ok)
      return false;
    if (!same_bits<Affine>(worn.result().model, never_off.result().model)) return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  int frames = 120;
  if (argc > 1) {
    const char* const end = argv[1] + std::strlen(argv[1]);
    const auto [stop, error] = std::from_chars(argv[1], end, frames);
    if (argc > 2 || error != std::errc{} || stop != end || frames < 1) {
      std::fprintf(stderr, "usage: character_creator [frames, at least 1]\n");
      return 2;
    }
  }
  showcase::SceneBuilder body;
  add_body(body, 1.0f);
  ClipLibrary library(body.finish().skeleton);
  // The files are not needed any more: the library owns their clips.
  for (const Scene& file : {make_walks(), make_gestures()})
    if (!library.add(file, IfUnbound::refuse).empty()) return 1;

  const std::vector<Outfit> outfits = dress(library);
  print_memory(library, outfits);
  for (std::size_t first = 0; first < outfits.size(); first += 3)
    for (const char* const name : {"walk", "run", "wave"}) {
      const auto clip = library.find(name);
      if (!clip || !swap_outfits(outfits, first, *clip, frames)) {
        std::fprintf(stderr, "%s: a frame after a swap is not where it was\n", name);
        return 1;
      }
    }
  std::printf("%d frames of each clip in three outfits and two sizes: joints have the same bits through all swaps\n",
              frames);
  return 0;
}
