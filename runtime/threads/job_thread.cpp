// SPDX-License-Identifier: MIT
#include "runtime/threads/job_thread.h"

#include <atomic>
#include <condition_variable>
#include <memory_resource>
#include <mutex>
#include <thread>
#include <utility>

#include "runtime/base/contract.h"
#include "runtime/threads/character_registry.h"
#include "runtime/threads/crowd.h"
#include "runtime/threads/default_executor.h"

namespace sinew {
namespace {

CharacterRegistry registry_for(const JobThreadOptions& options) {
  CONTRACT(check(options) == ErrorCode::ok && "a character has 2 or 3 frame buffers");
  return CharacterRegistry(options.frame_buffers, options.part_bytes,
                           options.frame_memory != nullptr ? *options.frame_memory : *std::pmr::new_delete_resource());
}

}  // namespace

struct JobThread::State {
  explicit State(const JobThreadOptions& options)
      : executor(options.executor),
        double_buffered(options.frame_buffers == 2),
        registry(registry_for(options)),
        crowd(options.inline_below_bytes) {
    if (!options.own_thread) {
      run_one = [this](std::size_t) { run_next_task(); };
      return;
    }
    if (!executor) executor = run_in_parallel;
    run_one = [this](std::size_t task) { (void)crowd.run_task(task); };
    worker = std::thread([this]() noexcept { work(); });
  }

  bool has_own_thread() const noexcept { return worker.joinable(); }
  bool has_task() const noexcept { return in_flight ? !at_cut && next_task < crowd.task_count() : has_queued; }

  void work() noexcept;
  void start_queued() noexcept;
  void run_by_executor();
  void end_tasks() noexcept;
  void finish() noexcept;
  ErrorCode resume() noexcept;
  bool run_next_task() noexcept;
  std::optional<std::size_t> take_task() noexcept;
  bool poll();
  template <class Given>
  Result<Ticket> submit(std::size_t count, const Given& given);
  template <class Condition>
  void wait_until(std::unique_lock<std::mutex>& lock, const Condition& holds);

  Executor executor;
  std::function<void(std::size_t)> run_one;
  const bool double_buffered;
  CharacterRegistry registry;  // used only by the thread that submits
  Crowd crowd;

  std::mutex mutex;
  std::condition_variable changed;  // a frame was queued or finished, or the thread shall stop
  // Guarded by the mutex.
  bool has_queued = false, in_flight = false, stop = false;
  bool at_cut = false;        // the frame in flight waits for resume()
  std::size_t next_task = 0;  // next task of the frame in flight; used without a thread of its own
  Ticket last_submitted = 0, running = 0;

  alignas(64) std::atomic<Ticket> finished{0};
  std::atomic<ErrorCode> error{ErrorCode::ok};
  std::thread worker;
};

void JobThread::State::work() noexcept {
  std::unique_lock lock(mutex);
  for (;;) {
    changed.wait(lock, [this] { return stop || (in_flight ? !at_cut : has_queued); });
    if (stop) return;
    if (!in_flight) start_queued();
    lock.unlock();
    run_by_executor();
    end_tasks();
    lock.lock();
  }
}

/// Call it while holding the mutex.
void JobThread::State::start_queued() noexcept {
  running = last_submitted;  // only one frame waits
  crowd.start(running);
  has_queued = false;
  in_flight = true;
  next_task = 0;
}

void JobThread::State::run_by_executor() {
  const std::size_t count = crowd.task_count();
  if (count == 1)
    (void)crowd.run_task(0);
  else
    executor(count, run_one);
  CONTRACT(crowd.tasks_run() == count);
}

/// Called when all tasks of the frame in flight have ended: it waits at its cut, or is finished.
void JobThread::State::end_tasks() noexcept {
  if (!crowd.stops_at_cut()) return finish();
  const std::lock_guard lock(mutex);
  at_cut = true;
  changed.notify_all();
}

ErrorCode JobThread::State::resume() noexcept {
  const std::lock_guard lock(mutex);
  if (!at_cut) return ErrorCode::no_cut;
  crowd.start_second_half();
  at_cut = false;
  next_task = 0;
  changed.notify_all();
  return ErrorCode::ok;
}

/// Publishes the results. A thread that learns of this by done() may destroy the job
/// thread as soon as the mutex is free.
void JobThread::State::finish() noexcept {
  error.store(crowd.publish(), std::memory_order_release);
  const std::lock_guard lock(mutex);
  in_flight = false;
  finished.store(running, std::memory_order_release);
  changed.notify_all();
}

std::optional<std::size_t> JobThread::State::take_task() noexcept {
  const std::lock_guard lock(mutex);
  if (!has_task()) return std::nullopt;
  if (!in_flight) start_queued();
  return next_task++;
}

bool JobThread::State::run_next_task() noexcept {
  const std::optional<std::size_t> task = take_task();
  if (!task) return false;
  if (crowd.run_task(*task)) end_tasks();
  return true;
}

bool JobThread::State::poll() {
  std::size_t count = 0;
  {
    const std::lock_guard lock(mutex);
    if (!has_task()) return false;
    if (!in_flight) start_queued();
    count = crowd.task_count() - next_task;
  }
  if (executor && count > 1)
    executor(count, run_one);
  else
    for (std::size_t i = 0; i < count; ++i) run_next_task();
  return true;
}

/// in   given  returns the i-th of `count` new inputs
template <class Given>
Result<Ticket> JobThread::State::submit(std::size_t count, const Given& given) {
  Ticket ticket = 0;
  {
    const std::lock_guard lock(mutex);
    for (std::size_t i = 0; i < count; ++i)
      if (const ErrorCode code = registry.check_input(given(i)); code != ErrorCode::ok) return tl::unexpected(code);
    if (has_queued || (double_buffered && (in_flight || !registry.can_write()))) return tl::unexpected(ErrorCode::busy);
    ticket = last_submitted + 1;
    registry.begin_frame(ticket, finished.load(std::memory_order_acquire));
    for (std::size_t i = 0; i < count; ++i) registry.assign_input(given(i));
    crowd.queue(registry.roster());
    last_submitted = ticket;
    has_queued = true;
  }
  changed.notify_all();
  return ticket;
}

/// Waits until the condition holds. Without a thread of its own it runs the pending frame itself.
template <class Condition>
void JobThread::State::wait_until(std::unique_lock<std::mutex>& lock, const Condition& holds) {
  while (!holds()) {
    if (!has_own_thread() && has_task()) {
      lock.unlock();
      poll();
      lock.lock();
    } else {
      changed.wait(lock);
    }
  }
}

ErrorCode check(const JobThreadOptions& options) noexcept {
  return options.frame_buffers == 2 || options.frame_buffers == 3 ? ErrorCode::ok : ErrorCode::unsupported;
}

JobThread::JobThread(JobThreadOptions options) : state_(std::make_unique<State>(options)) {}

JobThread::~JobThread() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->stop = true;
    CONTRACT(state_->has_own_thread() || !state_->in_flight || state_->crowd.tasks_run() == state_->next_task);
  }
  if (!state_->has_own_thread()) return;
  state_->changed.notify_all();
  state_->worker.join();
}

JobThread::Character JobThread::add_character(const Plan& plan) {
  CONTRACT(plan.is_compiled() && "a character needs a plan that compile_plan made");
  {
    const std::lock_guard lock(state_->mutex);
    state_->crowd.make_room(character_count() + 1, state_->registry.link_count());
  }
  return state_->registry.add(plan);
}

ErrorCode JobThread::remove_character(Character character) { return state_->registry.remove(character); }

ErrorCode JobThread::replace_plan(Character character, const Plan& plan) {
  CONTRACT(plan.is_compiled() && "a character needs a plan that compile_plan made");
  return state_->registry.replace(character, plan);
}

ErrorCode JobThread::follow(Character follower, Character leader, std::uint32_t joint, const FollowPlace& place) {
  {
    const std::lock_guard lock(state_->mutex);
    state_->crowd.make_room(character_count(), state_->registry.link_count() + 1);
  }
  return state_->registry.follow(follower, leader, joint, place);
}

ErrorCode JobThread::stop_following(Character follower, const FollowPlace& place) {
  return state_->registry.stop_following(follower, place);
}

std::span<const JobThread::Character> JobThread::characters() const noexcept { return state_->registry.ids(); }

Result<Ticket> JobThread::submit(std::span<const FrameInput> inputs) {
  const std::span<const Character> ids = characters();
  if (inputs.size() != ids.size()) return tl::unexpected(ErrorCode::size_mismatch);
  return state_->submit(inputs.size(), [&](std::size_t i) {
    return CharacterRegistry::GivenInput{ids[i], inputs[i], 0};
  });
}

Result<Ticket> JobThread::submit(std::span<const CharacterInput> changed) {
  return state_->submit(changed.size(), [&](std::size_t i) {
    return CharacterRegistry::GivenInput{changed[i].character, changed[i].input, changed[i].ops_before_cut};
  });
}

Ticket JobThread::last_submitted() const noexcept {
  const std::lock_guard lock(state_->mutex);
  return state_->last_submitted;
}

bool JobThread::done(Ticket ticket) const noexcept {
  return state_->finished.load(std::memory_order_acquire) >= ticket;
}

bool JobThread::wait(Ticket ticket) const {
  std::unique_lock lock(state_->mutex);
  CONTRACT(ticket <= state_->last_submitted);
  state_->wait_until(lock, [&] { return done(ticket) || state_->at_cut; });
  return done(ticket);
}

const CutPose* JobThread::cut_pose(Character character) const noexcept {
  const std::lock_guard lock(state_->mutex);
  return state_->at_cut ? state_->registry.cut_pose(character) : nullptr;
}

ErrorCode JobThread::resume() noexcept { return state_->resume(); }

void JobThread::Task::operator()() const noexcept {
  if (state_->crowd.run_task(index_)) state_->end_tasks();
}

std::optional<JobThread::Task> JobThread::take_task() noexcept {
  if (state_->has_own_thread()) return std::nullopt;
  const std::optional<std::size_t> task = state_->take_task();
  return task ? std::optional(Task(*state_, *task)) : std::nullopt;
}

bool JobThread::poll() { return !state_->has_own_thread() && state_->poll(); }

const FrameResult* JobThread::latest(Character character) noexcept {
  CONTRACT(state_->registry.was_given(character) && "latest() is asked for a character that add_character() returned");
  return state_->registry.latest(character);
}

ErrorCode JobThread::last_error() const noexcept { return state_->error.load(std::memory_order_acquire); }

}  // namespace sinew
