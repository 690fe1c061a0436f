// SPDX-License-Identifier: MIT
// Mirroring real rigs: partners are found, and the mirrored pose is the mirror image of the pose.
#include <gtest/gtest.h>

#include <cstring>

#include "importer/import_gltf.h"
#include "runtime/animation/mirror_animation.h"
#include "runtime/animation/side_names.h"
#include "runtime/animation/truth_pose.h"
#include "runtime/base/same_bits.h"
#include "runtime/model/mirror_scene.h"
#include "tests/reference/mirror.h"
#include "tests/support/corpus.h"
#include "tests/support/near.h"

namespace sinew::test {
namespace {
using Vec3d = Vec3<double>;

std::vector<std::filesystem::path> rigs() {
  std::vector<std::filesystem::path> files = files_for_tests("models", {".gltf", ".glb"});
  const auto more = corpus_files("retarget", {".glb"});
  files.insert(files.end(), more.begin(), more.end());
  return files;
}

template <class Visit>
std::size_t each_scene(const Visit& visit) {
  ImportOptions options;
  options.decode_images = options.make_tangents = options.make_normals = false;
  std::size_t count = 0;
  for (const auto& file : rigs()) {
    const auto imported = import_gltf(file, options);
    if (!imported) continue;  // import_corpus_test reports failed imports
    visit(imported->scene, file.filename().string());
    ++count;
  }
  return count;
}

double size_of(const Skeleton& skeleton) {
  std::vector<Transformd> rest;
  for (const Transform& t : skeleton.rest) rest.push_back(in_double(t));
  std::vector<Affined> model(rest.size());
  model_from_local(skeleton, rest, model);
  Vec3d low(1e30), high(-1e30);
  for (const Affined& m : model) {
    low = glm::min(low, translation_of(m));
    high = glm::max(high, translation_of(m));
  }
  return largest_component(high - low);
}

TEST(mirror_corpus, names_that_tell_a_side_have_a_partner_or_are_listed) {
  std::size_t pairs = 0;
  each_scene([&](const Scene& scene, const std::string& file) {
    const MirrorMap map = make_mirror_map(scene);
    pairs += paired_joints(map);
    for (std::uint32_t j = 0; j < map.joints.size(); ++j) {
      const std::uint32_t p = map.joints[j].source;
      EXPECT_EQ(map.joints[p].source, j) << file;
      const Side a = side_of(scene.skeleton.names[j]), b = side_of(scene.skeleton.names[p]);
      const bool is_other_side = p == j || a == Side::none || (b != a && b != Side::none);
      EXPECT_TRUE(is_other_side) << file << ": " << scene.skeleton.names[j];
    }
  });
  if (corpus()) {
    EXPECT_GT(pairs, 200u);
  }
}

/// Bodies that are symmetric at rest within 2 % of their size must mirror within 6 % in every pose: deviations of bones
/// add up along a limb.
TEST(mirror_corpus, joints_of_the_mirrored_clip_are_where_the_mirror_image_of_the_clip_has_them) {
  std::size_t clips = 0;
  each_scene([&](const Scene& scene, const std::string& file) {
    const MirrorMap map = make_mirror_map(scene);
    if (paired_joints(map) < 8) return;
    const double size = size_of(scene.skeleton);
    for (const Animation& animation : scene.animations) {
      const Animation mirrored = mirror_animation(animation, map, scene.skeleton, scene.first_weight);
      TruthPose before, after;
      evaluate_truth(animation, scene.skeleton, 0.37 * animation.duration_s, before);
      evaluate_truth(mirrored, scene.skeleton, 0.37 * animation.duration_s, after);
      ++clips;
      const Vec3d normal(map.plane_normal);
      for (std::uint32_t j = 0; j < map.joints.size(); ++j) {
        if (map.joints[j].source == j) continue;
        const Vec3d place = translation_of(before.model[j]);
        const Vec3d image = place - normal * (2.0 * (glm::dot(normal, place) - static_cast<double>(map.plane_offset)));
        EXPECT_LT(distance(translation_of(after.model[map.joints[j].source]), image), 0.06 * size)
            << file << ", " << animation.name << ": " << scene.skeleton.names[j];
      }
    }
  });
  if (corpus()) {
    EXPECT_GT(clips, 80u);
  }
}

TEST(mirror_corpus, clips_twice_mirrored_come_back) {
  std::size_t same = 0, rounded = 0;
  each_scene([&](const Scene& scene, const std::string& file) {
    const MirrorMap map = make_mirror_map(scene);
    for (const Animation& animation : scene.animations) {
      const Animation once = mirror_animation(animation, map, scene.skeleton, scene.first_weight);
      const Animation twice = mirror_animation(once, map, scene.skeleton, scene.first_weight);
      ASSERT_EQ(twice.bones.size(), animation.bones.size());
      for (std::size_t b = 0; b < twice.bones.size(); ++b) {
        const std::span<const glm::quat> a = animation.bones[b].rotation.values, c = twice.bones[b].rotation.values;
        EXPECT_EQ(twice.bones[b].joint, animation.bones[b].joint);
        ++(same_bits<glm::quat>(a, c) ? same : rounded);
        for (std::size_t k = 0; k < a.size(); ++k)
          for (int i = 0; i < 4; ++i)
            ASSERT_NEAR(a[k][i], c[k][i], 1e-6f * (1.0f + std::abs(a[k][i]))) << file << ", " << animation.name;
      }
    }
  });
  if (corpus()) {
    EXPECT_GT(same, 20 * rounded) << "most rigs are symmetric, and nothing of theirs is rounded";
  }
}

}  // namespace
}  // namespace sinew::test
