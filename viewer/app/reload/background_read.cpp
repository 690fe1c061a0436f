// SPDX-License-Identifier: MIT
#include "viewer/app/reload/background_read.h"

#include <chrono>
#include <new>
#include <utility>

#include "runtime/base/contract.h"

namespace sinew::viewer {
namespace {

ReadExhibit run(const BackgroundRead::Read& read) {
  std::vector<std::string> said;
  try {
    auto exhibit = read([&](const std::string& line) { said.push_back(line); });
    return {std::move(exhibit), std::move(said)};
  } catch (const std::bad_alloc&) {
    return {tl::unexpected(LoadError{3, "out of memory"}), std::move(said)};
  }
}

}  // namespace

void BackgroundRead::begin(Read read) {
  CONTRACT(!running());
  result_ = std::async(std::launch::async, [read = std::move(read)] { return run(read); });
}

std::optional<ReadExhibit> BackgroundRead::take() {
  if (!running() || result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
  return result_.get();
}

}  // namespace sinew::viewer
