// SPDX-License-Identifier: MIT
#include "viewer/app/reload/background_reload.h"

#include <chrono>
#include <new>
#include <utility>

#include "runtime/base/contract.h"

namespace sinew::viewer {
namespace {

ReloadResult run(const BackgroundReload::Read& read) {
  std::vector<std::string> messages;
  try {
    auto loaded = read([&](const std::string& line) { messages.push_back(line); });
    return {std::move(loaded), std::move(messages)};
  } catch (const std::bad_alloc&) {
    return {tl::unexpected(LoadError{3, "out of memory"}), std::move(messages)};
  }
}

}  // namespace

void BackgroundReload::begin(Read read) {
  CONTRACT(!running());
  result_ = std::async(std::launch::async, [read = std::move(read)] { return run(read); });
}

std::optional<ReloadResult> BackgroundReload::take() {
  if (!running() || result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
  return result_.get();
}

}  // namespace sinew::viewer
