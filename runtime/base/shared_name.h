// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>
#include <utility>

namespace sinew {

/// An immutable name whose copies share one string, for objects that a file names once and instantiates often. It
/// converts to std::string.
/// owns  the string, together with its copies;  cost  of a copy O(1), allocates nothing
class SharedName {
 public:
  SharedName() = default;
  SharedName(std::string text) : text_(text.empty() ? nullptr : std::make_shared<const std::string>(std::move(text))) {}
  SharedName(const char* text) : SharedName(std::string(text)) {}

  const std::string& str() const noexcept {
    static const std::string none;
    return text_ ? *text_ : none;
  }
  operator const std::string&() const noexcept { return str(); }
  friend bool operator==(const SharedName& a, const SharedName& b) noexcept { return a.str() == b.str(); }

 private:
  std::shared_ptr<const std::string> text_;
};

}  // namespace sinew
