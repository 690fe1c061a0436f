// SPDX-License-Identifier: MIT
#include "viewer/passes/record_passes.h"

namespace sinew::viewer {

void record_tonemap(const PassContext& context) {
  context.targets.next_use(context.commands, Target::color, kReadInShader);
  const Rendering rendering(context.commands, {.color = context.target.view, .extent = context.target.extent});
  draw_screen(context, context.pipelines.screen(Pass::tonemap), context.set.set());
}

void record_show(const PassContext& context) {
  const Rendering rendering(context.commands, {.color = context.target.view, .extent = context.target.extent});
  draw_screen(context, context.pipelines.screen(Pass::show, context.inputs.options.show), context.set.set());
}

}  // namespace sinew::viewer
