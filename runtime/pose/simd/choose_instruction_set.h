// SPDX-License-Identifier: MIT
#pragma once

namespace sinew {

/// Chooses the instruction set of all jobs, unless it is chosen already. The first job would else do it, which takes
/// some 30 us in a virtual machine: as long as six frames.
void choose_instruction_set() noexcept;

}  // namespace sinew
