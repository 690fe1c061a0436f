// SPDX-License-Identifier: MIT
#include "runtime/threads/crowd.h"

#include <algorithm>
#include <utility>

#include "runtime/base/prefetch.h"

namespace sinew {
namespace {

constexpr std::size_t kLooksAhead = 4;  // characters, whose state arrives while as many inputs are looked at
constexpr std::size_t kPastCachesBytes = std::size_t{16} << 20;  // frames of all characters that no caches hold

}  // namespace

struct Crowd::Character {
  Character(const Plan& shown, const CrowdOptions& options) : plan(shown), slots(options.frame_buffers) {
    for (std::uint8_t b = 0; b < options.frame_buffers; ++b) buffers.emplace_back(shown, *options.memory);
  }

  FrameBuffer& to_write() noexcept { return buffers[slots.writing()]; }

  Plan plan;
  std::vector<FrameBuffer> buffers;
  TripleSlots slots;
  const FrameBuffer* last_good = nullptr;
  ErrorCode error = ErrorCode::ok;  // of the frame that has just run
  bool is_to_run = false;           // its input is not that of the last good frame
};

Crowd::Crowd(const CrowdOptions& options) : options_(options) {}
Crowd::~Crowd() = default;

void Crowd::add(const Plan& plan) {
  auto character = std::make_unique<Character>(plan, options_);
  InputCopy input(plan, *options_.memory), other_input(plan, *options_.memory);
  const std::size_t count = characters_.size() + 1;
  characters_.reserve(count);
  part_end_.reserve(count);
  queued_.reserve(count);
  running_.reserve(count);  // from here on nothing throws
  characters_.push_back(std::move(character));
  queued_.push_back(std::move(input));
  running_.push_back(std::move(other_input));
  if (part_end_.empty() || last_part_bytes_ >= options_.part_bytes) {
    part_end_.push_back(0);
    last_part_bytes_ = 0;
  }
  part_end_.back() = count;
  bytes_ += plan.frame_bytes();
  last_part_bytes_ += plan.frame_bytes();
}

ErrorCode Crowd::check(std::span<const FrameInput> inputs) const noexcept {
  if (inputs.size() != characters_.size()) return ErrorCode::size_mismatch;
  for (std::size_t c = 0; c < inputs.size(); ++c)
    if (const ErrorCode error = queued_[c].check_room(inputs[c]); error != ErrorCode::ok) return error;
  return ErrorCode::ok;
}

bool Crowd::can_write() const noexcept {
  return std::all_of(characters_.begin(), characters_.end(), [](const auto& c) { return c->slots.can_write(); });
}

void Crowd::queue(std::span<const FrameInput> inputs) {
  for (std::size_t c = 0; c < inputs.size(); ++c) queued_[c].assign(inputs[c]);
}

void Crowd::start(std::uint64_t number) noexcept {
  std::swap(queued_, running_);
  tasks_run_.store(0, std::memory_order_relaxed);
  started_.store(number, std::memory_order_release);
}

std::size_t Crowd::task_count() const noexcept {
  return part_end_.size() < 2 || bytes_ < options_.inline_below_bytes ? 1 : part_end_.size();
}

bool Crowd::run_task(std::size_t task) noexcept {
  const std::size_t count = task_count();
  if (count > 1)
    run_part(task);
  else
    for (std::size_t p = 0; p < part_end_.size(); ++p) run_part(p);
  return tasks_run_.fetch_add(1, std::memory_order_acq_rel) + 1 == count;
}

/// Memory of a crowd has left the caches when its turn comes. Looking at all inputs of a part first lets their
/// characters arrive together, and tells whose frame to ask for while the one before it runs.
void Crowd::run_part(std::size_t part) noexcept {
  const std::uint64_t number = started_.load(std::memory_order_acquire);
  const std::size_t first = part == 0 ? 0 : part_end_[part - 1], end = part_end_[part];
  for (std::size_t c = first; c < end; ++c) {
    if (c + kLooksAhead < characters_.size()) prefetch(characters_[c + kLooksAhead].get(), sizeof(Character));
    look_at_input(c);
  }
  const auto next_to_run = [&](std::size_t c) {
    while (c < end && !characters_[c]->is_to_run) ++c;
    return c;
  };
  for (std::size_t c = next_to_run(first), next = end; c < end; c = next) {
    next = next_to_run(c + 1);
    if (next < end) characters_[next]->to_write().prefetch();
    run_character(c, number);
  }
}

void Crowd::look_at_input(std::size_t c) noexcept {
  Character& character = *characters_[c];
  character.is_to_run = character.last_good == nullptr || !holds_result_of(*character.last_good, running_[c].view());
  if (character.is_to_run) character.slots.prepare_to_write();
  character.error = ErrorCode::ok;
}

void Crowd::run_character(std::size_t c, std::uint64_t number) noexcept {
  Character& character = *characters_[c];
  FrameBuffer& buffer = character.to_write();
  buffer.count_from(number - 1);
  buffer.write_past_caches(bytes_ >= kPastCachesBytes);
  if (character.last_good != nullptr) buffer.follow(*character.last_good);
  character.error = run_plan(character.plan, running_[c].view(), buffer);
  if (character.error == ErrorCode::ok) character.last_good = &buffer;
}

ErrorCode Crowd::publish() noexcept {
  ErrorCode first = ErrorCode::ok;
  for (const auto& character : characters_) {
    if (character->is_to_run && character->error == ErrorCode::ok) character->slots.publish();
    if (first == ErrorCode::ok) first = character->error;
  }
  return first;
}

const FrameResult* Crowd::latest(std::size_t character) noexcept {
  Character& shown = *characters_[character];
  shown.slots.take_newest();
  return shown.slots.ever_read() ? &shown.buffers[shown.slots.reading()].result() : nullptr;
}

}  // namespace sinew
