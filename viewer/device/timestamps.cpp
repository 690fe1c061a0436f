// SPDX-License-Identifier: MIT
#include "viewer/device/timestamps.h"

#include "runtime/base/contract.h"

namespace sinew::viewer {

Timestamps::Timestamps(const Device& device, std::uint32_t max_marks) : device_(device), max_marks_(max_marks) {
  if (device.timestamp_bits() == 0) return;
  VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
  info.queryType = VK_QUERY_TYPE_TIMESTAMP;
  info.queryCount = max_marks;
  must(vkCreateQueryPool(device.handle(), &info, nullptr, &pool_), "vkCreateQueryPool");
}

Timestamps::~Timestamps() { vkDestroyQueryPool(device_.handle(), pool_, nullptr); }

void Timestamps::begin(VkCommandBuffer commands) {
  marks_ = 0;
  if (!pool_) return;
  vkCmdResetQueryPool(commands, pool_, 0, max_marks_);
  mark(commands);
}

void Timestamps::mark(VkCommandBuffer commands) {
  if (!pool_) return;
  CONTRACT(marks_ < max_marks_);
  vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool_, marks_++);
}

std::vector<double> Timestamps::milliseconds() const {
  if (marks_ < 2) return {};
  std::vector<std::uint64_t> ticks(marks_);
  must(vkGetQueryPoolResults(device_.handle(), pool_, 0, marks_, marks_ * sizeof(std::uint64_t), ticks.data(),
                             sizeof(std::uint64_t), VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
       "vkGetQueryPoolResults");
  const std::uint64_t valid =
      device_.timestamp_bits() >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << device_.timestamp_bits()) - 1;
  std::vector<double> spans;
  for (std::size_t i = 1; i < ticks.size(); ++i)
    spans.push_back(static_cast<double>((ticks[i] - ticks[i - 1]) & valid) *
                    static_cast<double>(device_.limits().timestampPeriod) * 1e-6);
  return spans;
}

}  // namespace sinew::viewer
