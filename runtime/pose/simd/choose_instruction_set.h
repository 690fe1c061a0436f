// SPDX-License-Identifier: MIT
#pragma once

namespace sinew {

/// Chooses the instruction set of all jobs, unless that was done before. Without this call the first job chooses it.
/// That can take some 30 us in a virtual machine, as long as six frames.
void choose_instruction_set() noexcept;

}  // namespace sinew
