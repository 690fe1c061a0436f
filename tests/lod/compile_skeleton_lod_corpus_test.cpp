// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "importer/import_gltf.h"
#include "runtime/lod/compile_skeleton_lod.h"
#include "tests/plan/frame_difference.h"
#include "tests/support/corpus.h"

namespace sinew::test {
namespace {

TEST(compile_skeleton_lod_corpus, models_keep_their_shape_within_what_is_asked) {
  std::size_t models = 0, joints = 0, left_out = 0, left_out_turned = 0;
  for (const auto& file : files_for_tests("models", {".glb", ".gltf"})) {
    if (std::filesystem::file_size(file) > 2'000'000) continue;
    ImportOptions options;
    options.decode_images = false;
    const auto imported = import_gltf(file, options);
    if (!imported || imported->scene.clips.empty() || imported->scene.instances.empty()) continue;
    const Scene& scene = imported->scene;
    const double far_m = difference_of(scene, {}, 0, 4).far_m, tolerance_m = 0.01 * far_m;
    const std::uint32_t clip = 0;
    const CompiledSkeletonLod within = compile_skeleton_lod(scene, tolerance_m, {&clip, 1});
    const Difference off = difference_of(scene, within.detail, 0, 60);
    EXPECT_LE(off.worst_m, 1.02 * tolerance_m + 3e-6 * off.far_m) << file;
    Needs needs;
    needs.skin.kind = Skinning::dual_quaternion;
    const CompiledSkeletonLod turned = compile_skeleton_lod(scene, tolerance_m, {&clip, 1}, needs);
    EXPECT_LE(turned.left_out, within.left_out);
    EXPECT_LE(difference_of(scene, turned.detail, 0, 60, Skinning::dual_quaternion).worst_m,
              1.05 * tolerance_m + 3e-6 * off.far_m)
        << file;
    left_out_turned += turned.left_out;
    ++models;
    joints += scene.skeleton.joint_count();
    left_out += within.left_out;
  }
  EXPECT_GT(models, 5u);
  std::printf("%zu models: %zu of %zu joints left out within 1%% of their size, %zu with dual quaternions\n", models,
              left_out, joints, left_out_turned);
}

}  // namespace
}  // namespace sinew::test
