// SPDX-License-Identifier: MIT
#include "viewer/app/actions.h"

namespace sinew::viewer {

bool apply(Action action, Settings& settings) noexcept {
  switch (action) {
    case Action::toggle_ao: settings.ambient_occlusion = !settings.ambient_occlusion; return true;
    case Action::toggle_ao_only: toggle_ao_only(settings); return true;
    case Action::next_show: next_show(settings); return true;
    case Action::next_ground: next_ground(settings); return true;
    case Action::toggle_skeleton: settings.skeleton = !settings.skeleton; return true;
    case Action::next_skinning: next_skinning(settings); return true;
    case Action::next_updates: next_updates(settings); return true;
    case Action::toggle_panel: settings.panel = !settings.panel; return true;
    case Action::toggle_plan: toggle_plan(settings); return true;
    case Action::toggle_inside: toggle_inside(settings); return true;
    case Action::toggle_keys: toggle_keys(settings); return true;
    default: return false;
  }
}

bool apply(Action action, Playback& playback) {
  switch (action) {
    case Action::toggle_play: playback.toggle(); return true;
    case Action::step_back: playback.step(-1); return true;
    case Action::step_forward: playback.step(+1); return true;
    case Action::faster: playback.faster(); return true;
    case Action::slower: playback.slower(); return true;
    case Action::toggle_loop: playback.next_mode(); return true;
    case Action::next_clip: playback.next(+1); return true;
    case Action::previous_clip: playback.next(-1); return true;
    default: return false;
  }
}

}  // namespace sinew::viewer
