// SPDX-License-Identifier: MIT
#include "viewer/passes/record_passes.h"

namespace sinew::viewer {

void record_transparent(const PassContext& context) {
  context.targets.next_use(context.commands, Target::color, kWriteColor);
  const Rendering rendering(context.commands, {context.targets.view(Target::color), VK_ATTACHMENT_LOAD_OP_LOAD,
                                               context.targets.view(Target::depth), false, context.targets.extent()});
  draw_meshes(context, context.draws.blended(), {.pass = Pass::transparent});
}

}  // namespace sinew::viewer
