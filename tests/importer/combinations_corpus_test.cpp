// SPDX-License-Identifier: MIT
// Real files give the same bits whether vertices share blended matrices or not.
#include <gtest/gtest.h>

#include "importer/import_gltf.h"
#include "runtime/plan/frame_hash.h"
#include "runtime/plan/run_plan.h"
#include "tests/plan/changed_plan.h"
#include "tests/support/corpus.h"

namespace sinew::test {
namespace {

TEST(combinations_corpus, C06_give_every_file_the_bits_of_vertices_that_blend_for_themselves) {
  ImportOptions options;
  options.decode_images = false;
  std::uint64_t blended = 0;
  for (const auto& file : files_for_tests("models", {".gltf", ".glb"})) {
    const auto imported = import_gltf(file, options);
    if (!imported) continue;  // other tests report it
    const Plan combined = compile_plan(lend(imported->scene), {}), plain = without_combinations(combined);
    FrameBuffer with(combined), without(plain);
    for (std::uint32_t clip = 0; clip < imported->scene.animations.size(); ++clip) {
      const ClipLayer layer{clip, 0.37 * imported->scene.animations[clip].duration_s};
      const FrameInput input{.layers = {&layer, 1}, .weights = {}, .root = {}};
      ASSERT_EQ(run_plan(combined, input, with), ErrorCode::ok);
      ASSERT_EQ(run_plan(plain, input, without), ErrorCode::ok);
      EXPECT_EQ(hash_vertices(with.result()), hash_vertices(without.result())) << file << ", clip " << clip;
      blended += with.result().work.combinations_blended;
    }
  }
  EXPECT_GT(blended, 0u) << "no file whose vertices share enough";
}

}  // namespace
}  // namespace sinew::test
