// SPDX-License-Identifier: MIT
#include "viewer/passes/record_passes.h"

namespace sinew::viewer {

void record_ssao_blur(const PassContext& context, bool vertical) {
  const Target to = vertical ? Target::access : Target::access_between;
  context.targets.next_use(context.commands, to, kWriteColor, false);
  {
    const Rendering rendering(context.commands,
                              {.color = context.targets.view(to), .extent = context.targets.access_extent()});
    draw_screen(context, context.pipelines.screen(vertical ? Pass::blur_vertical : Pass::blur_horizontal),
                vertical ? context.set.between_blurs() : context.set.set());
  }
  context.targets.next_use(context.commands, to, kReadInShader);
}

}  // namespace sinew::viewer
