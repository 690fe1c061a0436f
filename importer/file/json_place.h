// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "importer/file/json_pointer.h"

namespace sinew {

/// A location in a document as a linked list on the stack. Its text is built only for reports, because names may be as
/// long as the file.
struct JsonPlace {
  const JsonPlace* parent = nullptr;
  std::string_view name;  ///< property name; empty for an array entry. In the first frame: a whole JSON pointer
  std::size_t index = 0;

  std::string text() const {
    if (parent == nullptr) return std::string(name);
    return parent->text() + (name.data() != nullptr ? pointer(pointer_token(name)) : pointer(index));
  }
};

}  // namespace sinew
