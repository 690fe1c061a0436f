// SPDX-License-Identifier: MIT
#include "runtime/c/jobs.h"

#include <memory>
#include <memory_resource>
#include <vector>

#include "runtime/c/boundary.h"
#include "runtime/c/frame_input.h"
#include "runtime/c/handles.h"
#include "runtime/threads/job_thread.h"

namespace {

using namespace sinew;

/// The engine's allocator as the standard library asks for memory.
class EngineMemory : public std::pmr::memory_resource {
 public:
  explicit EngineMemory(const sinew_allocator& allocator) : allocator_(allocator) {}

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

static_assert(sizeof(JobThread::Task) <= sizeof(sinew_task));

struct Character {
  const sinew_plan* plan;
  c::OwnInputRoom room;
};

}  // namespace

struct sinew_jobs {
  explicit sinew_jobs(const sinew_jobs_options& options)
      : memory(options.allocator),
        thread({.executor = executor_from(options.executor),
                .inline_below_bytes = options.inline_below_bytes,
                .part_bytes = options.part_bytes,
                .frame_memory = options.allocator.allocate != nullptr ? &memory : nullptr,
                .own_thread = options.own_thread != 0,
                .frame_buffers = static_cast<std::uint8_t>(options.frame_buffers)}) {}

  EngineMemory memory;
  std::vector<Character> characters;
  std::vector<FrameInput> inputs;
  JobThread thread;
};

sinew_jobs_options sinew_default_jobs_options(void) {
  const JobThreadOptions defaults;
  return {.struct_size = sizeof(sinew_jobs_options),
          .executor = {nullptr, nullptr},
          .allocator = {nullptr, nullptr, nullptr},
          .inline_below_bytes = defaults.inline_below_bytes,
          .part_bytes = defaults.part_bytes,
          .own_thread = defaults.own_thread,
          .frame_buffers = defaults.frame_buffers};
}

sinew_error sinew_jobs_create(const sinew_jobs_options* options, sinew_jobs** out) {
  if (out == nullptr) return SINEW_NULL_ARGUMENT;
  sinew_jobs_options own = sinew_default_jobs_options();
  if (const sinew_error error = c::read_struct(options, own); error != SINEW_OK) return error;
  if ((own.allocator.allocate == nullptr) != (own.allocator.release == nullptr)) return SINEW_NULL_ARGUMENT;
  if (own.frame_buffers != 2 && own.frame_buffers != 3) return SINEW_UNSUPPORTED;
  return c::guarded([&] {
    *out = new sinew_jobs(own);
    return SINEW_OK;
  });
}

void sinew_jobs_destroy(sinew_jobs* jobs) { delete jobs; }

sinew_error sinew_jobs_add_character(sinew_jobs* jobs, const sinew_plan* plan, std::uint32_t* character) {
  if (jobs == nullptr || plan == nullptr || character == nullptr) return SINEW_NULL_ARGUMENT;
  return c::guarded([&] {
    jobs->inputs.reserve(jobs->characters.size() + 1);
    jobs->characters.push_back({plan, c::OwnInputRoom(*plan)});
    try {
      *character = jobs->thread.add_character(plan->plan);
    } catch (...) {
      jobs->characters.pop_back();
      throw;
    }
    jobs->inputs.emplace_back();
    return SINEW_OK;
  });
}

sinew_error sinew_jobs_submit(sinew_jobs* jobs, const sinew_frame_input* inputs, std::size_t input_count,
                              std::uint64_t* ticket) {
  if (jobs == nullptr || (inputs == nullptr && input_count > 0)) return SINEW_NULL_ARGUMENT;
  if (input_count != jobs->characters.size()) return SINEW_SIZE_MISMATCH;
  for (std::size_t c = 0; c < input_count; ++c) {
    Character& character = jobs->characters[c];
    const sinew_frame_input* input = nullptr;
    sinew_error error = c::element_of(inputs, c, input);
    if (error == SINEW_OK) error = c::read_input(input, *character.plan, character.room.room(), jobs->inputs[c]).error;
    if (error != SINEW_OK) return error;
  }
  return c::guarded([&] {
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
  if (jobs == nullptr) return SINEW_NULL_ARGUMENT;
  if (ticket > jobs->thread.last_submitted()) return SINEW_INDEX_OUT_OF_RANGE;
  jobs->thread.wait(ticket);
  return SINEW_OK;
}

int sinew_jobs_poll(sinew_jobs* jobs) { return jobs != nullptr && jobs->thread.poll(); }

int sinew_jobs_take_task(sinew_jobs* jobs, sinew_task* task) {
  if (jobs == nullptr || task == nullptr) return 0;
  const std::optional<JobThread::Task> taken = jobs->thread.take_task();
  if (!taken) return 0;
  *task = {};
  c::copy_bits(*taken, *task);
  return 1;
}

void sinew_task_run(const sinew_task* task) {
  if (task == nullptr || task->inside[0] == nullptr) return;
  JobThread::Task own;
  c::copy_bits(*task, own);
  own();
}

const sinew_result* sinew_jobs_latest(sinew_jobs* jobs, std::uint32_t character) {
  if (jobs == nullptr || character >= jobs->characters.size()) return nullptr;
  return reinterpret_cast<const sinew_result*>(jobs->thread.latest(character));
}

sinew_error sinew_jobs_last_error(const sinew_jobs* jobs) {
  return jobs != nullptr ? c::error_from(jobs->thread.last_error()) : SINEW_NULL_ARGUMENT;
}
