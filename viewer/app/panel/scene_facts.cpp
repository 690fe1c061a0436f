// SPDX-License-Identifier: MIT
#include "viewer/app/panel/scene_facts.h"

namespace sinew::viewer {

PanelFacts scene_facts(ShownScene& shown) {
  const LoadedScene& loaded = shown.loaded();
  PanelFacts facts;
  facts.name = loaded.name;
  facts.note = loaded.note;
  facts.scene = &loaded.scene;
  facts.needs = &shown.needs();
  facts.rig = loaded.rig.get();
  facts.graph = shown.graph();
  facts.pose = &shown.newest();
  facts.program = shown.program();
  facts.cache = shown.cache_facts();
  facts.updates = shown.update_levels().reason();
  facts.has_visibility = loaded.visibility != nullptr;
  facts.resting = shown.resting();
  return facts;
}

}  // namespace sinew::viewer
