// SPDX-License-Identifier: MIT
#include "viewer/passes/record_passes.h"

namespace sinew::viewer {

void record_opaque(const PassContext& context) {
  const bool prepass = context.graph.has(Pass::normal_depth);
  context.targets.next_use(context.commands, Target::color, kWriteColor, false);
  if (!prepass) context.targets.next_use(context.commands, Target::depth, kWriteDepth, false);
  {
    const Rendering rendering(context.commands,
                              {context.targets.view(Target::color), VK_ATTACHMENT_LOAD_OP_CLEAR,
                               context.targets.view(Target::depth), !prepass, context.targets.extent()});
    draw_meshes(context, context.draws.opaque(),
                {.pass = Pass::opaque, .after_prepass = prepass, .occluded = context.graph.access_image});
  }
  if (!prepass) context.targets.next_use(context.commands, Target::depth, kReadDepth);
}

}  // namespace sinew::viewer
