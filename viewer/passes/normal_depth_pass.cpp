// SPDX-License-Identifier: MIT
#include "viewer/passes/record_passes.h"

namespace sinew::viewer {

void record_normal_depth(const PassContext& context) {
  context.targets.next_use(context.commands, Target::depth, kWriteDepth, false);
  const bool normals = context.graph.normal_image;
  if (normals) context.targets.next_use(context.commands, Target::normals, kWriteColor, false);
  {
    const VkImageView color = normals ? context.targets.view(Target::normals) : VK_NULL_HANDLE;
    const Rendering rendering(context.commands, {color, VK_ATTACHMENT_LOAD_OP_CLEAR,
                                                 context.targets.view(Target::depth), true, context.targets.extent()});
    draw_meshes(context, context.draws.opaque(), {.pass = Pass::normal_depth, .depth_only = !normals});
  }
  context.targets.next_use(context.commands, Target::depth, kReadDepth);
  if (normals) context.targets.next_use(context.commands, Target::normals, kReadInShader);
}

}  // namespace sinew::viewer
