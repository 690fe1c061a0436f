// SPDX-License-Identifier: MIT
// Loading asset files from memory, compared with copying their bytes into newly allocated memory, and the way from a
// file to the first frame.
#include <cstdlib>

#include "importer/import_gltf.h"
#include "runtime/asset_file/read_assets.h"
#include "runtime/asset_file/write_asset_file.h"
#include "runtime/compress/compile_clip_within.h"
#include "runtime/plan/run_plan.h"
#include "tests/bench/measure.h"
#include "tests/scenes/skeletons.h"
#include "tests/scenes/skinned_surface.h"
#include "tests/scenes/swinging.h"
#include "tests/support/corpus.h"

namespace sinew::bench {
namespace {

using File = std::shared_ptr<const std::vector<std::byte>>;

void add_copy(const std::string& name, const File& file) {
  add("load_assets/copy/" + name, file->size(),
      [file] {
        std::vector<std::byte> copy(*file);
        benchmark::DoNotOptimize(copy.data());
      },
      {Facts{}.error, 2 * file->size()});
}

/// Loads the whole scene of a file.
void add_scene(const std::string& name, const Scene& scene, const AssetFileOptions& options = {}) {
  const File file = std::make_shared<const std::vector<std::byte>>(write_asset_file(scene, options));
  add("load_assets/sinew/" + name, file->size(),
      [file] {
        const auto opened = AssetFile::open(*file);
        if (!opened || !read_scene(*opened)) std::abort();
      },
      {Facts{}.error, 2 * file->size()});
  add_copy(name, file);
}

/// Loads a file, compiles its plan, and makes the first frame.
void add_start(const std::string& name, const Scene& scene) {
  const File file = std::make_shared<const std::vector<std::byte>>(write_asset_file(scene));
  add("start/sinew/" + name, 1, [file] {
    const auto opened = AssetFile::open(*file);
    const auto loaded = opened ? read_scene(*opened) : tl::unexpected(opened.error());
    if (!loaded) std::abort();
    const Plan plan = compile_plan(lend(*loaded), Needs{.out = {.tangents = false}});
    FrameBuffer frame(plan);
    const ClipLayer layer{.clip = 0, .time_s = 0.1};
    if (run_plan(plan, {.layers = {&layer, loaded->clips.empty() ? 0u : 1u}}, frame) != ErrorCode::ok) std::abort();
  });
}

/// Every model of the corpus that can be imported.
void add_corpus() {
  ImportOptions options;
  options.decode_images = false;
  for (const auto& path : test::corpus_files("models", {".gltf", ".glb"})) {
    const auto file = import_gltf(path, options);
    if (!file) continue;
    const std::string name = path.parent_path().filename().string();
    add_scene(name, file->scene);
    add_start(name, file->scene);
  }
}

/// Loads only the compiled clips of a file, without their animations.
void add_clips_alone(const std::string& name, const Scene& scene) {
  const File file =
      std::make_shared<const std::vector<std::byte>>(write_asset_file(scene, {.skeleton = false, .model = false}));
  add("load_assets/sinew/" + name, file->size(),
      [file] {
        const auto opened = AssetFile::open(*file);
        if (!opened || !read_clips(*opened, opened->blocks()[0].skeleton_signature)) std::abort();
      },
      {Facts{}.error, 2 * file->size()});
  add_copy(name, file);
}

}  // namespace

void add_asset_files() {
  Skeleton biped = scenes::biped();
  Animation swinging = scenes::swinging(biped, 60);
  Scene scene = scenes::swinging_surface(std::move(biped), std::move(swinging), 100'000, 4);
  add_scene("biped67/100k", scene);
  Scene library = scenes::swinging_surface(scenes::biped(), scene.animations[0], 300, 4);
  library.clips[0] = compile_clip_within(library, library.animations[0], virtual_vertices(library), 1e-4).clip;
  library.clips.resize(300, library.clips[0]);
  library.animations.resize(300, library.animations[0]);
  add_scene("biped67/300clips", library);
  add_clips_alone("biped67/300clips/alone", library);
  add_corpus();
}

}  // namespace sinew::bench
