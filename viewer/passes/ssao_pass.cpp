// SPDX-License-Identifier: MIT
#include "viewer/passes/record_passes.h"

namespace sinew::viewer {

void record_ssao(const PassContext& context) {
  context.targets.next_use(context.commands, Target::access, kWriteColor, false);
  {
    const Rendering rendering(
        context.commands, {.color = context.targets.view(Target::access), .extent = context.targets.access_extent()});
    draw_screen(context, context.pipelines.screen(Pass::ssao), context.set.set());
  }
  context.targets.next_use(context.commands, Target::access, kReadInShader);
}

}  // namespace sinew::viewer
