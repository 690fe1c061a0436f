// SPDX-License-Identifier: MIT
#include "viewer/app/reload/go_over.h"

#include <optional>
#include <utility>
#include <vector>

#include "viewer/app/bake_access.h"
#include "viewer/app/scene_choice.h"
#include "viewer/device/device_error.h"

namespace sinew::viewer {
namespace {

/// What goes on from the old scene to the new one.
struct State {
  Evaluation evaluation;
  Playback playback;
  std::vector<std::string> clips;

  /// The clip that plays, in another scene. Where there was none to play, the first one does.
  std::optional<std::uint32_t> clip_in(const Scene& scene) const {
    return clips.empty() ? std::nullopt : same_clip(clips, playback.clip(), scene);
  }
};

State state_of(const Exhibit& exhibit, ShownScene& shown) {
  return {shown.evaluation(), shown.playback(), clip_names(exhibit.scene)};
}

std::unique_ptr<ShownScene> show(const Exhibit& exhibit, const State& state, const MakeShown& make) {
  auto shown = make(exhibit, state.evaluation);
  shown->playback().continue_from(state.playback, state.clip_in(exhibit.scene));
  shown->catch_up();
  return shown;
}

}  // namespace

BackgroundRead::Read reading(const Options& options, const Exhibit& exhibit, ShownScene& shown) {
  return [&options, environment = exhibit.environment, state = state_of(exhibit, shown)](const auto& say) {
    auto changed = reload_exhibit(options, environment, say);
    if (!changed) return changed;
    add_missing_centers(*changed, state.evaluation.skinning);
    if (options.occlusion_method != OcclusionMethod::rays) return changed;
    const std::uint32_t first = changed->scene.animations.empty() ? kNone : 0;
    const AccessBaking baking{options.key_poses, state.clip_in(changed->scene).value_or(first)};
    if (auto done = add_missing_access(*changed, baking, say); !done) say(done.error());
    return changed;
  };
}

tl::expected<void, std::string> go_over(const Device& device, Exhibit changed, Exhibit& exhibit,
                                        std::unique_ptr<ShownScene>& shown, const MakeShown& make) {
  const State state = state_of(exhibit, *shown);
  add_missing_centers(changed, state.evaluation.skinning);  // the kind of skinning may have changed since it was read
  device.wait_idle();
  shown.reset();
  std::swap(exhibit, changed);
  try {
    shown = show(exhibit, state, make);
  } catch (const DeviceError& error) {
    std::swap(exhibit, changed);
    shown = show(exhibit, state, make);
    return tl::unexpected(std::string(error.what()));
  }
  return {};
}

}  // namespace sinew::viewer
