// SPDX-License-Identifier: MIT
// Poses and vertices have the bits of the stored hashes (hashes.txt), for every thread count and instruction set.
// Vertices have one set of bits with fused multiply-add and another without (conventions.h). After a deliberate change
// of arithmetic, record new hashes on a machine with fused multiply-add:
//     SINEW_RECORD=1 build/release/bin/sinew-test-golden     writes the new hashes into hashes.txt
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "runtime/plan/frame_hash.h"
#include "runtime/threads/job_thread.h"
#include "tests/golden/golden_scenes.h"
#include "tests/support/simd_targets.h"
#include "tests/threads/thread_executor.h"

namespace sinew::test {
namespace {

/// One way to evaluate a scene: the name of its hash, and its needs.
struct Method {
  const char* name;
  Needs needs;
};

std::vector<Method> methods() {
  Needs linear, cofactor, dual_quaternion, center_of_rotation;
  cofactor.skin.normal_rule = NormalRule::cofactor;
  dual_quaternion.skin.kind = Skinning::dual_quaternion;
  center_of_rotation.skin.kind = Skinning::center_of_rotation;
  return {{"linear", linear},
          {"cofactor", cofactor},
          {"dual-quaternion", dual_quaternion},
          {"center-of-rotation", center_of_rotation}};
}

/// Frames of one scene with one method: each clip alone at the golden times, then two clips blended.
class Frames {
 public:
  Frames(const Scene& scene, const Needs& needs) : plan_(compile_plan(lend(scene), needs)), buffer_(plan_) {
    layers_.push_back({});
    for (std::uint32_t clip = 0; clip < scene.clips.size(); ++clip)
      for (const double t : kGoldenTimes_s) layers_.push_back({{clip, t, 1.0f}});
    if (scene.clips.size() > 1)
      for (const double t : kGoldenTimes_s) layers_.push_back({{0, t, 0.75f}, {1, 0.5 * t, 0.375f}});
  }

  const Plan& plan() const { return plan_; }
  std::size_t count() const { return layers_.size(); }
  FrameInput input(std::size_t i) const { return {layers_[i], {}, {}}; }
  const FrameResult& run(std::size_t i) {
    EXPECT_EQ(run_plan(plan_, input(i), buffer_), ErrorCode::ok);
    return buffer_.result();
  }

 private:
  Plan plan_;
  FrameBuffer buffer_;
  std::vector<std::vector<ClipLayer>> layers_;
};

using Hashes = std::map<std::string, std::uint64_t>;  ///< "scene pose", "scene method" or "scene method/unfused"

const char* vertex_suffix(std::int64_t target) { return fuses_multiply_add(target) ? "" : "/unfused"; }

/// Hashes over all frames, on one instruction set.
Hashes hashes_of(const std::vector<GoldenScene>& scenes, std::int64_t target) {
  const OnlyTarget only(target);
  Hashes out;
  for (const auto& [name, scene] : scenes)
    for (const Method& method : methods()) {
      Frames frames(scene, method.needs);
      BitHash poses, vertices;
      for (std::size_t i = 0; i < frames.count(); ++i) {
        const FrameResult& frame = frames.run(i);
        const std::uint64_t pose = hash_pose(frame), vertex = hash_vertices(frame);
        poses.add(std::span(&pose, 1));
        vertices.add(std::span(&vertex, 1));
      }
      out[name + " pose"] = poses.value();
      out[name + " " + method.name + vertex_suffix(target)] = vertices.value();
    }
  return out;
}

std::string hash_file() { return SINEW_SOURCE_DIR "/tests/golden/hashes.txt"; }

std::string text_of(const Hashes& hashes) {
  std::ostringstream text;
  for (const auto& [name, value] : hashes) text << name << " " << std::hex << value << "\n";
  return text.str();
}

Hashes stored_hashes() {
  Hashes out;
  std::ifstream file(hash_file());
  std::string scene, what;
  for (std::uint64_t value; file >> scene >> what >> std::hex >> value;) out[scene + " " + what] = value;
  return out;
}

void expect_stored(const Hashes& found, const std::string& where) {
  const Hashes stored = stored_hashes();
  for (const auto& [name, value] : found) {
    const auto same = stored.find(name);
    ASSERT_NE(same, stored.end()) << "hashes.txt lacks " << name << "; see the top of golden_hash_test.cpp";
    EXPECT_EQ(value, same->second) << name << " on " << where
                                   << "; if that was meant: SINEW_RECORD=1 sinew-test-golden";
  }
}

/// Hashes of all instruction sets of this machine. If they differ, the tests fail and the first set's hashes are
/// returned.
Hashes hashes_everywhere(const std::vector<GoldenScene>& scenes) {
  Hashes out;
  for (const std::int64_t target : simd_targets()) out.merge(hashes_of(scenes, target));
  return out;
}

class golden_hash : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    scenes_ = new std::vector<GoldenScene>(golden_scenes());
    if (!std::getenv("SINEW_RECORD")) return;
    std::ofstream(hash_file()) << text_of(hashes_everywhere(*scenes_));
    std::printf("recorded %s:\n%s", hash_file().c_str(), text_of(stored_hashes()).c_str());
  }
  static void TearDownTestSuite() { delete scenes_; }
  static const std::vector<GoldenScene>& scenes() { return *scenes_; }

 private:
  inline static const std::vector<GoldenScene>* scenes_ = nullptr;
};

TEST_F(golden_hash, N27_N28_poses_and_vertices_have_the_stored_bits_on_every_instruction_set) {
  for (const std::int64_t target : simd_targets()) expect_stored(hashes_of(scenes(), target), simd_name(target));
}

TEST_F(golden_hash, every_scene_and_method_has_bits_of_its_own) {
  std::vector<std::uint64_t> values;
  const auto stored = stored_hashes();
  for (const auto& [name, value] : stored) {
    // With one influence and no uneven scale, vertices move rigidly with their joint, so all skinning methods agree.
    const std::string plain = name.substr(0, name.find('/'));
    if (plain == "tree-1 cofactor" || plain == "tree-1 dual-quaternion" || plain == "tree-1 center-of-rotation")
      EXPECT_EQ(value, stored.at("tree-1 linear" + name.substr(plain.size()))) << name;
    else
      values.push_back(value);
  }
  std::sort(values.begin(), values.end());
  EXPECT_EQ(std::adjacent_find(values.begin(), values.end()), values.end())
      << "two hashes are equal: they see no difference";
}

TEST_F(golden_hash, N27_any_thread_count_gives_the_bits_of_one) {
  for (const Method& method : methods())
    for (const auto& [name, scene] : scenes()) {
      Frames frames(scene, method.needs);
      std::vector<std::uint64_t> expected;
      std::vector<FrameInput> inputs;
      for (std::size_t i = 0; i < frames.count(); ++i) {
        expected.push_back(hash_vertices(frames.run(i)));
        inputs.push_back(frames.input(i));
      }
      for (const std::size_t threads : {1, 2, 3, 5, 8, 16}) {
        ThreadPool pool(threads);
        JobThread jobs({.executor = pool.executor(), .inline_below_bytes = 0, .part_bytes = 1});
        for (std::size_t c = 0; c < inputs.size(); ++c) jobs.add_character(frames.plan());
        jobs.wait(*jobs.submit(inputs));
        for (std::uint32_t c = 0; c < inputs.size(); ++c)
          EXPECT_EQ(hash_vertices(*jobs.latest(c)), expected[c])
              << name << ", " << method.name << ", " << threads << " threads, frame " << c;
      }
    }
}

/// All vertex numbers of all frames, in order.
std::vector<float> numbers_of(const Scene& scene, const Needs& needs) {
  std::vector<float> out;
  Frames frames(scene, needs);
  for (std::size_t i = 0; i < frames.count(); ++i)
    for (const DeformedPrimitive& p : frames.run(i).primitives) {
      for (const glm::vec3& v : p.positions) out.insert(out.end(), {v.x, v.y, v.z});
      for (const glm::vec3& v : p.normals) out.insert(out.end(), {v.x, v.y, v.z});
      for (const glm::vec4& v : p.tangents) out.insert(out.end(), {v.x, v.y, v.z});
    }
  return out;
}

TEST_F(golden_hash, N27_two_roundings_instead_of_one_move_vertices_by_less_than_a_fifty_thousandth) {
  // The bound allows for blends of joints in arbitrary directions; ordinary rigs stay near 1e-6.
  for (const auto& [name, scene] : scenes()) {
    if (name == "collapsing") continue;  // the direction of a vector near zero can differ by more than any bound
    for (const Method& method : methods()) {
      const std::vector<float> expected = numbers_of(scene, method.needs);
      float size = 1;
      for (const float x : expected) size = std::max(size, std::abs(x));
      for (const std::int64_t target : simd_targets()) {
        const OnlyTarget only(target);
        const std::vector<float> found = numbers_of(scene, method.needs);
        ASSERT_EQ(found.size(), expected.size());
        float worst = 0;
        for (std::size_t i = 0; i < found.size(); ++i) worst = std::max(worst, std::abs(found[i] - expected[i]));
        EXPECT_LE(worst, 2e-5f * size) << name << ", " << method.name << " on " << simd_name(target);
      }
    }
  }
}

}  // namespace
}  // namespace sinew::test
