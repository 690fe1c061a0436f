// SPDX-License-Identifier: MIT
#include "runtime/c/jobs.h"

#include <memory>
#include <memory_resource>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "runtime/c/frame_input.h"
#include "runtime/c/glue/call.h"
#include "runtime/c/glue/fields.h"
#include "runtime/c/glue/pose_span.h"
#include "runtime/c/glue/struct_versions.h"
#include "runtime/c/handles.h"
#include "runtime/c/input_room.h"
#include "runtime/threads/job_thread.h"

namespace sinew::c {

template <>
inline constexpr auto kEnum<FollowKind> =
    enum_values<FollowKind, sinew_follow_kind>({{FollowKind::root, SINEW_FOLLOW_ROOT},
                                                {FollowKind::joint_override, SINEW_FOLLOW_JOINT_OVERRIDE},
                                                {FollowKind::procedure, SINEW_FOLLOW_PROCEDURE}});

}  // namespace sinew::c

namespace {

using namespace sinew;

/// Lets the standard library allocate with the engine's allocator.
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

/// in   given  null = the root
sinew_error read_place(const sinew_follow_place* given, FollowPlace& own) noexcept {
  sinew_follow_place known = {sizeof(known), SINEW_FOLLOW_ROOT, 0, 0, nullptr};
  if (const sinew_error error = c::read_struct(given, known)) return error;
  if (const sinew_error error = c::from_c(known.kind, own.kind)) return error;
  own.list = known.list;
  own.entry = known.entry;
  own.matrix = reinterpret_cast<Affine*>(known.matrix);
  return SINEW_OK;
}

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

  /// Queues the inputs of `count` characters.
  /// in   read  read(i, given) writes the i-th character and its input, and returns an error code
  template <class Read>
  sinew_error submit(std::size_t count, const Read& read, std::uint64_t* ticket) {
    inputs.clear();
    for (std::size_t i = 0; i < count; ++i) {
      sinew_character_input given = {};
      if (const sinew_error error = read(i, given)) return error;
      const auto found = characters.find(given.character);
      if (found == characters.end()) return SINEW_UNKNOWN_CHARACTER;
      JobThread::CharacterInput& own = inputs.emplace_back();
      own.character = found->first;
      own.ops_before_cut = given.ops_before_cut;
      const c::NotRead why = c::read_input(given.input, *found->second->plan, found->second->room.room(), own.input);
      if (why.error != SINEW_OK) return why.error;
    }
    const auto queued = thread.submit(inputs);
    if (!queued) return c::error_from(queued.error());
    if (ticket != nullptr) *ticket = *queued;
    return SINEW_OK;
  }

  EngineMemory memory;
  std::unordered_map<std::uint32_t, std::unique_ptr<const Character>> characters;
  std::vector<JobThread::CharacterInput> inputs;
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
    std::unique_ptr<const Character> own(new Character{plan, c::OwnRoom<c::InputRoom>(*plan)});
    const std::uint32_t id = jobs->thread.add_character(plan->plan);
    try {
      jobs->characters.emplace(id, std::move(own));
    } catch (...) {
      (void)jobs->thread.remove_character(id);
      throw;
    }
    *character = id;
  });
}

sinew_error sinew_jobs_remove_character(sinew_jobs* jobs, std::uint32_t character) {
  return c::call(c::given(jobs), [&] {
    const ErrorCode error = jobs->thread.remove_character(character);
    if (error == ErrorCode::ok) jobs->characters.erase(character);
    return error;
  });
}

sinew_error sinew_jobs_replace_plan(sinew_jobs* jobs, std::uint32_t character, const sinew_plan* plan) {
  return c::call(c::given(jobs, plan), [&] {
    std::unique_ptr<const Character> own(new Character{plan, c::OwnRoom<c::InputRoom>(*plan)});
    const ErrorCode error = jobs->thread.replace_plan(character, plan->plan);
    if (error == ErrorCode::ok) jobs->characters.find(character)->second = std::move(own);
    return error;
  });
}

sinew_error sinew_jobs_follow(sinew_jobs* jobs, std::uint32_t follower, std::uint32_t leader, std::uint32_t joint) {
  return c::call(c::given(jobs), [&] { return jobs->thread.follow(follower, leader, joint); });
}

sinew_error sinew_jobs_follow_at(sinew_jobs* jobs, std::uint32_t follower, std::uint32_t leader, std::uint32_t joint,
                                 const sinew_follow_place* place) {
  return c::call(c::given(jobs), [&] {
    FollowPlace own;
    if (const sinew_error error = read_place(place, own)) return error;
    if (own.kind == FollowKind::procedure && own.matrix == nullptr) return SINEW_NULL_ARGUMENT;
    return c::error_from(jobs->thread.follow(follower, leader, joint, own));
  });
}

sinew_error sinew_jobs_stop_following_at(sinew_jobs* jobs, std::uint32_t follower, const sinew_follow_place* place) {
  return c::call(c::given(jobs), [&] {
    FollowPlace own;
    if (const sinew_error error = read_place(place, own)) return error;
    return c::error_from(jobs->thread.stop_following(follower, own));
  });
}

sinew_error sinew_jobs_stop_following(sinew_jobs* jobs, std::uint32_t follower) {
  return c::call(c::given(jobs), [&] { return jobs->thread.stop_following(follower); });
}

sinew_indices sinew_jobs_characters(const sinew_jobs* jobs) {
  if (jobs == nullptr) return {nullptr, 0};
  const std::span<const JobThread::Character> ids = jobs->thread.characters();
  return {ids.data(), ids.size()};
}

sinew_error sinew_jobs_submit(sinew_jobs* jobs, const sinew_frame_input* inputs, std::size_t input_count,
                              std::uint64_t* ticket) {
  return c::call(c::given(jobs, c::Array{inputs, input_count}), [&] {
    const std::span<const JobThread::Character> ids = jobs->thread.characters();
    if (input_count != ids.size()) return SINEW_SIZE_MISMATCH;
    const auto read = [&](std::size_t i, sinew_character_input& given) {
      given.character = ids[i];
      return c::element_of(inputs, i, given.input);
    };
    return jobs->submit(input_count, read, ticket);
  });
}

sinew_error sinew_jobs_submit_changed(sinew_jobs* jobs, const sinew_character_input* changed, std::size_t count,
                                      std::uint64_t* ticket) {
  return c::call(c::given(jobs, c::Array{changed, count}), [&] {
    const auto read = [&](std::size_t i, sinew_character_input& given) {
      given = changed[i];
      return given.input != nullptr ? SINEW_OK : SINEW_NULL_ARGUMENT;
    };
    return jobs->submit(count, read, ticket);
  });
}

int sinew_jobs_done(const sinew_jobs* jobs, std::uint64_t ticket) {
  return jobs != nullptr && jobs->thread.done(ticket);
}

sinew_error sinew_jobs_wait(const sinew_jobs* jobs, std::uint64_t ticket) {
  return c::call(c::given(jobs), [&] {
    if (ticket > jobs->thread.last_submitted()) return SINEW_INDEX_OUT_OF_RANGE;
    (void)jobs->thread.wait(ticket);
    return SINEW_OK;
  });
}

sinew_error sinew_jobs_cut_pose(const sinew_jobs* jobs, std::uint32_t character, sinew_cut_pose* pose) {
  return c::call(c::given(jobs, pose), [&] {
    const CutPose* cut = jobs->thread.cut_pose(character);
    if (cut == nullptr) return SINEW_NO_CUT;
    return c::write_struct({.struct_size = 0, .local = c::to_c(cut->local), .model = c::to_c(cut->model)}, pose);
  });
}

sinew_error sinew_jobs_resume(sinew_jobs* jobs) {
  return c::call(c::given(jobs), [&] { return jobs->thread.resume(); });
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
  if (jobs == nullptr || jobs->characters.count(character) == 0) return nullptr;
  return reinterpret_cast<const sinew_result*>(jobs->thread.latest(character));
}

sinew_error sinew_jobs_last_error(const sinew_jobs* jobs) {
  return c::call(c::given(jobs), [&] { return jobs->thread.last_error(); });
}
