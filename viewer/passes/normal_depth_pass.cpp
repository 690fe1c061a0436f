// SPDX-License-Identifier: MIT
#include "viewer/passes/record_passes.h"

namespace sinew::viewer {

void record_normal_depth(const PassContext& context) {
  context.targets.next_use(context.commands, Target::depth, kWriteDepth, false);
  context.targets.next_use(context.commands, Target::normals, kWriteColor, false);
  {
    const Rendering rendering(context.commands, {context.targets.view(Target::normals), VK_ATTACHMENT_LOAD_OP_CLEAR,
                                                 context.targets.view(Target::depth), true, context.targets.extent()});
    draw_meshes(context, context.draws.opaque(), {.pass = Pass::normal_depth});
  }
  context.targets.next_use(context.commands, Target::depth, kReadDepth);
  context.targets.next_use(context.commands, Target::normals, kReadInShader);
}

}  // namespace sinew::viewer
