// SPDX-License-Identifier: MIT
#include "runtime/c/jobs.h"

#include <memory>
#include <memory_resource>
#include <vector>

#include "runtime/c/call.h"
#include "runtime/c/fields.h"
#include "runtime/c/frame_input.h"
#include "runtime/c/handles.h"
#include "runtime/c/input_room.h"
#include "runtime/threads/job_thread.h"

namespace {

using namespace sinew;

/// The engine's allocator as the standard library asks for memory.
class EngineMemory : public std::pmr::memory_resource {
 public:
  explicit EngineMemory(const sinew_allocator& allocator) : allocator_(allocator) {}
  bool is_given() const noexcept { return allocator_.allocate != nullptr; }

 private:
  void* do_allocate(std::size_t byte_count, std::size_t alignment) override {
    void* block = allocator_.allocate(allocator_.context, byte_count, alignment);
    if (block == nullptr) throw std::bad_alloc();
    return block;
  }
  void do_deallocate(void* block, std::size_t byte_count, std::size_t alignment) override {
    allocator_.release(allocator_.context, block, byte_count, alignment);
  }
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }

  sinew_allocator allocator_;
};

Executor executor_from(const sinew_executor& given) {
  if (given.run == nullptr) return {};
  return [given](std::size_t count, const std::function<void(std::size_t)>& body) {
    const auto call = [](void* context, std::size_t i) {
      (*static_cast<const std::function<void(std::size_t)>*>(context))(i);
    };
    given.run(given.context, count, call, const_cast<std::function<void(std::size_t)>*>(&body));
  };
}

constexpr auto kJobOptions =
    c::fields(c::field<&sinew_jobs_options::inline_below_bytes, &JobThreadOptions::inline_below_bytes>(),
              c::field<&sinew_jobs_options::part_bytes, &JobThreadOptions::part_bytes>(),
              c::field<&sinew_jobs_options::own_thread, &JobThreadOptions::own_thread>(),
              c::field<&sinew_jobs_options::frame_buffers, &JobThreadOptions::frame_buffers>());

struct Character {
  const sinew_plan* plan;
  c::OwnRoom<c::InputRoom> room;
};

}  // namespace

template <>
struct sinew::c::Convert<sinew_task, JobThread::Task> : ConvertInside<sinew_task, JobThread::Task> {};

struct sinew_jobs {
  sinew_jobs(const sinew_allocator& allocator, JobThreadOptions options)
      : memory(allocator), thread(with_memory(std::move(options))) {}

  JobThreadOptions with_memory(JobThreadOptions options) noexcept {
    if (memory.is_given()) options.frame_memory = &memory;
    return options;
  }

  EngineMemory memory;
  std::vector<Character> characters;
  std::vector<FrameInput> inputs;
  JobThread thread;
};

sinew_jobs_options sinew_default_jobs_options(void) {
  return c::written<sinew_jobs_options>(kJobOptions, JobThreadOptions{});
}

sinew_error sinew_jobs_create(const sinew_jobs_options* options, sinew_jobs** out) {
  return c::call(c::given(out), [&] {
    sinew_jobs_options known = sinew_default_jobs_options();
    if (const sinew_error error = c::read_struct(options, known)) return error;
    if ((known.allocator.allocate == nullptr) != (known.allocator.release == nullptr)) return SINEW_NULL_ARGUMENT;
    JobThreadOptions own;
    if (const sinew_error error = kJobOptions.read(known, own).error) return error;
    if (const ErrorCode error = check(own); error != ErrorCode::ok) return c::error_from(error);
    own.executor = executor_from(known.executor);
    *out = new sinew_jobs(known.allocator, std::move(own));
    return SINEW_OK;
  });
}

void sinew_jobs_destroy(sinew_jobs* jobs) { delete jobs; }

sinew_error sinew_jobs_add_character(sinew_jobs* jobs, const sinew_plan* plan, std::uint32_t* character) {
  return c::call(c::given(jobs, plan, character), [&] {
    jobs->inputs.reserve(jobs->characters.size() + 1);
    jobs->characters.push_back({plan, c::OwnRoom<c::InputRoom>(*plan)});
    try {
      *character = jobs->thread.add_character(plan->plan);
    } catch (...) {
      jobs->characters.pop_back();
      throw;
    }
    jobs->inputs.emplace_back();
  });
}

sinew_error sinew_jobs_submit(sinew_jobs* jobs, const sinew_frame_input* inputs, std::size_t input_count,
                              std::uint64_t* ticket) {
  return c::call(c::given(jobs, c::Array{inputs, input_count}), [&] {
    if (input_count != jobs->characters.size()) return SINEW_SIZE_MISMATCH;
    for (std::size_t c = 0; c < input_count; ++c) {
      const Character& character = jobs->characters[c];
      const sinew_frame_input* input = nullptr;
      if (const sinew_error error = c::element_of(inputs, c, input)) return error;
      const c::NotRead why = c::read_input(input, *character.plan, character.room.room(), jobs->inputs[c]);
      if (why.error != SINEW_OK) return why.error;
    }
    const auto queued = jobs->thread.submit(jobs->inputs);
    if (!queued) return c::error_from(queued.error());
    if (ticket != nullptr) *ticket = *queued;
    return SINEW_OK;
  });
}

int sinew_jobs_done(const sinew_jobs* jobs, std::uint64_t ticket) {
  return jobs != nullptr && jobs->thread.done(ticket);
}

sinew_error sinew_jobs_wait(const sinew_jobs* jobs, std::uint64_t ticket) {
  return c::call(c::given(jobs), [&] {
    if (ticket > jobs->thread.last_submitted()) return SINEW_INDEX_OUT_OF_RANGE;
    jobs->thread.wait(ticket);
    return SINEW_OK;
  });
}

int sinew_jobs_poll(sinew_jobs* jobs) { return jobs != nullptr && jobs->thread.poll(); }

int sinew_jobs_take_task(sinew_jobs* jobs, sinew_task* task) {
  if (jobs == nullptr || task == nullptr) return 0;
  const std::optional<JobThread::Task> taken = jobs->thread.take_task();
  if (!taken) return 0;
  *task = c::to_c(*taken);
  return 1;
}

void sinew_task_run(const sinew_task* task) {
  if (task == nullptr || task->inside[0] == nullptr) return;
  JobThread::Task own;
  if (c::from_c(*task, own) == SINEW_OK) own();
}

const sinew_result* sinew_jobs_latest(sinew_jobs* jobs, std::uint32_t character) {
  if (jobs == nullptr || character >= jobs->characters.size()) return nullptr;
  return reinterpret_cast<const sinew_result*>(jobs->thread.latest(character));
}

sinew_error sinew_jobs_last_error(const sinew_jobs* jobs) {
  return c::call(c::given(jobs), [&] { return jobs->thread.last_error(); });
}
