// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "importer/file/json_pointer.h"

namespace sinew {

/// A place in a document as a chain of frames on the stack, so that its text is made only for reports: names may be as
/// long as the file.
struct JsonPlace {
  const JsonPlace* parent = nullptr;
  std::string_view name;  ///< of a property; for an array entry empty. Of the first frame: a whole JSON pointer
  std::size_t index = 0;

  std::string text() const {
    if (parent == nullptr) return std::string(name);
    return parent->text() + (name.data() != nullptr ? pointer(pointer_token(name)) : pointer(index));
  }
};

}  // namespace sinew
