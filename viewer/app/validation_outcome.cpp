// SPDX-License-Identifier: MIT
#include "viewer/app/validation_outcome.h"

#include <cstdio>

namespace sinew::viewer {

int exit_code_after_validation(const Options& options, const Device& device) {
  if (!options.validate) return 0;
  if (!device.validation_active()) {
    std::fputs("sinew-viewer: --validate: the validation layer is not installed (Debian: vulkan-validationlayers)\n",
               stderr);
    return 3;
  }
  const auto messages = static_cast<unsigned long long>(device.validation_messages());
  if (messages != 0) std::fprintf(stderr, "sinew-viewer: --validate: %llu messages\n", messages);
  return messages == 0 ? 0 : 3;
}

}  // namespace sinew::viewer
