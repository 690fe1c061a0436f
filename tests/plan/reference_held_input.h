// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/lod/update_rate.h"
#include "tests/scenes/random_inputs.h"

namespace sinew::test {

/// Reference implementation of HeldInput, written from the description in its header. Layers play whole clips.
class ReferenceHeldInput {
 public:
  explicit ReferenceHeldInput(const RandomInputs& inputs) : held_(inputs), now_(inputs) {}

  void next(const RandomInputs& now, UpdateLevel level, std::uint64_t frame, std::uint32_t phase) {
    const bool is_due = (frame + phase) % (1u << static_cast<unsigned>(level)) == 0;
    if (is_due || woke_) held_ = now.without_pages();
    woke_ = now.view().asleep;
    now_ = now;
  }

  /// The input to run; valid until next().
  FrameInput view() const {
    FrameInput input = held_.view();
    input.out_of_view = now_.view().out_of_view;
    input.asleep = now_.view().asleep;
    return input;
  }

 private:
  RandomInputs held_, now_;
  bool woke_ = true;
};

}  // namespace sinew::test
