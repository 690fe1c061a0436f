// SPDX-License-Identifier: MIT
#include "tests/fuzz/import_target.h"

#include <tbb/global_control.h>

#include <cstdint>
#include <string_view>

#include "importer/file/glb_container.h"
#include "importer/file/json_fault.h"
#include "importer/file/json_reader.h"
#include "importer/import_gltf.h"
#include "runtime/plan/run_plan.h"

namespace sinew::fuzz {

void import_and_evaluate(Bytes file) {
  // One thread: waking others takes longer than a small file, and the run's other programs use the other cores.
  static const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  ImportOptions options;
  options.max_image_pixels = 1 << 12;
  options.max_unpacked_bytes = std::uint64_t{1} << 22;  // larger claims are refused before memory is filled
  options.thorough = true;
  const auto imported = import_gltf(file, "fuzz", options);
  if (!imported) return require(!imported.error().issue.rule.empty(), "an error names its rule");
  require(imported->facts.file_bytes >= file.size(), "the bytes of the file are counted");
  const Scene& scene = imported->scene;
  require(check(scene) == ErrorCode::ok, "an imported scene passes the checks");
  const Plan plan = compile_plan(lend(scene), Needs{.out = {.bounds = true}});
  FrameBuffer frame(plan);
  const ClipLayer layer{.clip = 0, .time_s = 0.3};
  const bool animated = !scene.clips.empty();
  require(run_plan(plan, {.layers = {&layer, animated ? 1u : 0u}}, frame) == ErrorCode::ok, "an imported scene runs");
}

void import_glb(Bytes input) { import_and_evaluate(input); }

void import_json(Bytes input) {
  if (looks_like_glb(input)) return;
  const std::string_view text(reinterpret_cast<const char*>(input.data()), input.size());
  JsonMemory memory;
  JsonPool pool(2048, &memory);
  JsonBuilder tree(&pool, 256, &memory);
  JsonOutcome outcome{};
  const auto read = [&](JsonBuilder& builder) { return (outcome = read_json(text, builder)) == JsonOutcome::read; };
  tree.Populate(read);
  require(outcome != JsonOutcome::invalid || !describe_json_fault(text).empty(), "text that is refused has a fault");
  import_and_evaluate(input);
}

}  // namespace sinew::fuzz
