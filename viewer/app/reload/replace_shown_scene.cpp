// SPDX-License-Identifier: MIT
#include "viewer/app/reload/replace_shown_scene.h"

#include <optional>
#include <utility>
#include <vector>

#include "viewer/app/bake_visibility.h"
#include "viewer/app/open/open_files.h"
#include "viewer/app/scene_choice.h"
#include "viewer/device/device_error.h"

namespace sinew::viewer {
namespace {

/// State that the new scene takes over from the old one.
struct State {
  Evaluation evaluation;
  Playback playback;
  std::vector<std::string> clips;
  std::optional<GraphPlayer> graph;

  /// The current clip's counterpart in another scene. Empty (the first clip) if the old scene had no clips.
  std::optional<std::uint32_t> clip_in(const Scene& scene) const {
    return clips.empty() ? std::nullopt : same_clip(clips, playback.clip(), scene);
  }
};

State state_of(const LoadedScene& loaded, ShownScene& shown) {
  const GraphPlayer* const graph = shown.graph();
  return {shown.evaluation(), shown.playback(), clip_names(loaded.scene),
          graph == nullptr ? std::nullopt : std::optional(*graph)};
}

std::unique_ptr<ShownScene> show(const LoadedScene& loaded, const State& state, const MakeShown& make) {
  auto shown = make(loaded, state.evaluation);
  shown->playback().continue_from(state.playback, state.clip_in(loaded.scene));
  if (state.graph && shown->graph() != nullptr) shown->graph()->continue_from(*state.graph);
  shown->catch_up();
  return shown;
}

}  // namespace

BackgroundReload::Read make_reload_job(const Options& options, const LoadedScene& loaded, ShownScene& shown) {
  return [options, environment = loaded.environment, state = state_of(loaded, shown)](const auto& log_line) {
    auto changed = reload_scene(options, environment, log_line);
    if (!changed) return changed;
    add_missing_centers(*changed, state.evaluation.skinning);
    if (options.occlusion_method != OcclusionMethod::rays) return changed;
    const std::uint32_t first = changed->scene.animations.empty() ? kNone : 0;
    const VisibilityBaking baking{options.key_poses, state.clip_in(changed->scene).value_or(first)};
    if (auto done = bake_missing_visibility(*changed, baking, log_line); !done) log_line(done.error());
    return changed;
  };
}

tl::expected<void, std::string> replace_shown_scene(const Device& device, LoadedScene changed, LoadedScene& loaded,
                                                    std::unique_ptr<ShownScene>& shown, const MakeShown& make) {
  const State state = state_of(loaded, *shown);
  // The skinning method may have changed since the reload began.
  add_missing_centers(changed, state.evaluation.skinning);
  device.wait_idle();
  shown.reset();
  std::swap(loaded, changed);
  try {
    shown = show(loaded, state, make);
  } catch (const DeviceError& error) {
    std::swap(loaded, changed);
    shown = show(loaded, state, make);
    return tl::unexpected(std::string(error.what()));
  }
  return {};
}

}  // namespace sinew::viewer
