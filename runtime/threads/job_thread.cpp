// SPDX-License-Identifier: MIT
#include "runtime/threads/job_thread.h"

#include <array>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "runtime/base/contract.h"
#include "runtime/base/prefetch.h"
#include "runtime/threads/tbb_executor.h"
#include "runtime/threads/triple_slots.h"

namespace sinew {
namespace {

/// A FrameInput that owns what it shows. Buffers keep their capacity from frame to frame.
struct OwnInput {
  std::pmr::vector<ClipLayer> layers, next_layers;
  std::pmr::vector<float> weights;
  std::pmr::vector<std::uint8_t> out_of_view;
  Affine root;
  float interpolation_factor = 0.0f;
  bool asleep = false;

  OwnInput(const Plan& plan, std::pmr::memory_resource* memory)
      : layers(memory), next_layers(memory), weights(memory), out_of_view(memory) {
    layers.reserve(plan.needs.max_layers);
    if (plan.interpolate) next_layers.reserve(plan.needs.max_layers);
    weights.reserve(plan.rest_weights.size());
    out_of_view.reserve(plan.scene->instances.size());
  }
  void assign(const FrameInput& input) {
    layers.assign(input.layers.begin(), input.layers.end());
    weights.assign(input.weights.begin(), input.weights.end());
    out_of_view.assign(input.out_of_view.begin(), input.out_of_view.end());
    next_layers.assign(input.next_layers.begin(), input.next_layers.end());
    root = input.root, interpolation_factor = input.interpolation_factor, asleep = input.asleep;
  }
  FrameInput view() const noexcept {
    return {.layers = layers,
            .weights = weights,
            .root = root,
            .next_layers = next_layers,
            .interpolation_factor = interpolation_factor,
            .out_of_view = out_of_view,
            .asleep = asleep};
  }
};

struct Batch {
  std::vector<OwnInput> inputs;
  Ticket ticket = 0;
};

constexpr std::size_t kLooksAhead = 4;  // characters, whose state arrives while as many inputs are looked at

struct CharacterState {
  CharacterState(const Plan& shown, std::pmr::memory_resource& memory)
      : plan(&shown), buffers{FrameBuffer(shown, memory), FrameBuffer(shown, memory), FrameBuffer(shown, memory)} {}

  const Plan* plan;
  std::array<FrameBuffer, 3> buffers;
  TripleSlots slots;
  const FrameBuffer* last_good = nullptr;
  ErrorCode error = ErrorCode::ok;  // of the frame that has just run
  bool is_to_run = false;           // its input is not that of the last good frame

  FrameBuffer& to_write() noexcept { return buffers[slots.writing()]; }
};

}  // namespace

struct JobThread::State {
  explicit State(JobThreadOptions given) : options(std::move(given)) {
    if (!options.executor) options.executor = run_with_tbb;
    if (options.frame_memory == nullptr) options.frame_memory = std::pmr::new_delete_resource();
    run_one = [this](std::size_t p) { run_part(p); };
    worker = std::thread([this]() noexcept { work(); });
  }

  void work() noexcept;
  void run_batch();
  void run_part(std::size_t p) noexcept;
  void look_at_input(std::size_t c) noexcept;
  void run_character(std::size_t c, Ticket ticket) noexcept;
  void add_to_parts(std::size_t c) noexcept;
  void publish() noexcept;
  bool idle() const noexcept { return !has_queued && !in_flight; }

  JobThreadOptions options;
  std::function<void(std::size_t)> run_one;
  std::vector<std::unique_ptr<CharacterState>> characters;
  std::vector<std::size_t> part_end;           // characters of part p: from the end of the one before to part_end[p]
  std::size_t bytes = 0, last_part_bytes = 0;  // of the frames of all characters, and of those in the last part

  mutable std::mutex mutex;
  mutable std::condition_variable changed;  // a frame was queued or finished, or the thread shall stop
  Batch queued;                             // guarded by mutex
  bool has_queued = false, in_flight = false, stop = false;
  Ticket last_submitted = 0;

  Batch running;  // the worker's while in_flight
  // What one thread writes before the executor and other threads after it must be visible whatever the executor does to
  // order them, and an executor that leaves out or repeats a character must be noticed.
  alignas(64) std::atomic<Ticket> started{0};         // read by all
  alignas(64) std::atomic<std::size_t> parts_run{0};  // written by all
  alignas(64) std::atomic<Ticket> finished{0};
  std::atomic<ErrorCode> error{ErrorCode::ok};
  std::thread worker;
};

void JobThread::State::work() noexcept {
  std::unique_lock lock(mutex);
  for (;;) {
    changed.wait(lock, [this] { return stop || has_queued; });
    if (stop) return;
    std::swap(queued, running);
    has_queued = false, in_flight = true;
    lock.unlock();
    run_batch();
    lock.lock();
    in_flight = false;
    finished.store(running.ticket, std::memory_order_release);
    changed.notify_all();
  }
}

void JobThread::State::run_batch() {
  parts_run.store(0, std::memory_order_relaxed);
  started.store(running.ticket, std::memory_order_release);
  if (part_end.size() < 2 || bytes < options.inline_below_bytes)
    for (std::size_t p = 0; p < part_end.size(); ++p) run_part(p);
  else
    options.executor(part_end.size(), run_one);
  CONTRACT(parts_run.load(std::memory_order_acquire) == part_end.size());
  publish();
}

/// Memory of a crowd has left the caches when its turn comes. Looking at all inputs of a part first lets their
/// characters arrive together, and tells whose frame to ask for while the one before it runs.
void JobThread::State::run_part(std::size_t p) noexcept {
  const Ticket ticket = started.load(std::memory_order_acquire);
  const std::size_t first = p == 0 ? 0 : part_end[p - 1], end = part_end[p];
  for (std::size_t c = first; c < end; ++c) {
    if (c + kLooksAhead < characters.size()) prefetch(characters[c + kLooksAhead].get(), sizeof(CharacterState));
    look_at_input(c);
  }
  const auto next_to_run = [&](std::size_t c) {
    while (c < end && !characters[c]->is_to_run) ++c;
    return c;
  };
  for (std::size_t c = next_to_run(first), next = end; c < end; c = next) {
    next = next_to_run(c + 1);
    if (next < end) characters[next]->to_write().prefetch(*characters[next]->plan);
    run_character(c, ticket);
  }
  parts_run.fetch_add(1, std::memory_order_acq_rel);
}

void JobThread::State::look_at_input(std::size_t c) noexcept {
  CharacterState& character = *characters[c];
  character.is_to_run = character.last_good == nullptr ||
                        !character.last_good->holds_result_of(*character.plan, running.inputs[c].view());
  character.error = ErrorCode::ok;
}

void JobThread::State::run_character(std::size_t c, Ticket ticket) noexcept {
  CharacterState& character = *characters[c];
  FrameBuffer& buffer = character.to_write();
  buffer.count_from(ticket - 1);
  if (character.last_good != nullptr) buffer.follow(*character.last_good);
  character.error = run_plan(*character.plan, running.inputs[c].view(), buffer);
  if (character.error == ErrorCode::ok) character.last_good = &buffer;
}

/// Takes in the newest character; there is room for one more part.
void JobThread::State::add_to_parts(std::size_t c) noexcept {
  if (part_end.empty() || last_part_bytes >= options.part_bytes) part_end.push_back(c), last_part_bytes = 0;
  part_end.back() = c + 1;
  bytes += characters[c]->plan->frame_bytes, last_part_bytes += characters[c]->plan->frame_bytes;
}

/// All characters of a frame appear together, in order; one that failed keeps its last good frame.
void JobThread::State::publish() noexcept {
  ErrorCode first = ErrorCode::ok;
  for (const auto& character : characters) {
    if (character->is_to_run && character->error == ErrorCode::ok) character->slots.publish();
    if (first == ErrorCode::ok) first = character->error;
  }
  error.store(first, std::memory_order_release);
}

JobThread::JobThread(JobThreadOptions options) : state_(std::make_unique<State>(std::move(options))) {}

JobThread::~JobThread() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->stop = true;
  }
  state_->changed.notify_all();
  state_->worker.join();
}

JobThread::Character JobThread::add_character(const Plan& plan) {
  std::pmr::memory_resource* memory = state_->options.frame_memory;
  auto character = std::make_unique<CharacterState>(plan, *memory);
  OwnInput input(plan, memory), other_input(plan, memory);
  std::unique_lock lock(state_->mutex);
  state_->changed.wait(lock, [this] { return state_->idle(); });
  const std::size_t count = state_->characters.size() + 1;
  state_->characters.reserve(count), state_->part_end.reserve(count), state_->queued.inputs.reserve(count),
      state_->running.inputs.reserve(count);
  state_->characters.push_back(std::move(character));  // from here on nothing throws
  state_->queued.inputs.push_back(std::move(input));
  state_->running.inputs.push_back(std::move(other_input));
  state_->add_to_parts(count - 1);
  return static_cast<Character>(count - 1);
}

std::size_t JobThread::character_count() const noexcept { return state_->characters.size(); }

Result<Ticket> JobThread::submit(std::span<const FrameInput> inputs) {
  if (inputs.size() != state_->characters.size()) return tl::unexpected(ErrorCode::size_mismatch);
  Ticket ticket = 0;
  {
    const std::lock_guard lock(state_->mutex);
    if (state_->has_queued) return tl::unexpected(ErrorCode::busy);
    for (std::size_t c = 0; c < inputs.size(); ++c) state_->queued.inputs[c].assign(inputs[c]);
    ticket = state_->queued.ticket = ++state_->last_submitted;
    state_->has_queued = true;
  }
  state_->changed.notify_all();
  return ticket;
}

Ticket JobThread::last_submitted() const noexcept {
  const std::lock_guard lock(state_->mutex);
  return state_->last_submitted;
}

bool JobThread::done(Ticket ticket) const noexcept {
  return state_->finished.load(std::memory_order_acquire) >= ticket;
}

void JobThread::wait(Ticket ticket) const {
  std::unique_lock lock(state_->mutex);
  CONTRACT(ticket <= state_->last_submitted);
  state_->changed.wait(lock, [&] { return done(ticket); });
}

const FrameResult* JobThread::latest(Character character) noexcept {
  CharacterState& shown = *state_->characters[character];
  shown.slots.take_newest();
  return shown.slots.ever_read() ? &shown.buffers[shown.slots.reading()].result() : nullptr;
}

ErrorCode JobThread::last_error() const noexcept { return state_->error.load(std::memory_order_acquire); }

}  // namespace sinew
