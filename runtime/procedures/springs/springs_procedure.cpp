// SPDX-License-Identifier: MIT
#include "runtime/procedures/springs/springs_procedure.h"

namespace sinew {
namespace {

void run_springs(void* context, const ProcedurePose& pose) {
  auto& springs = *static_cast<SpringsContext*>(context);
  const SpringsJob job{.springs = springs.springs,
                       .skeleton = &pose.skeleton,
                       .pose = pose.local,
                       .root = springs.root,
                       .dt_s = springs.dt_s,
                       .state = springs.state,
                       .scratch = springs.scratch,
                       .event = springs.event,
                       .weight = pose.share,
                       .tails = springs.tails,
                       .counts = &springs.counts};
  springs.code = run(job);
}

}  // namespace

PoseProcedure springs_procedure(SpringsContext& context) noexcept {
  const bool stays = context.event == SpringEvent::none && springs_asleep(context.state, context.root);
  return {&run_springs, &context, stays ? springs_sleeps(context.state) : ContentVersion{0}};
}

}  // namespace sinew
