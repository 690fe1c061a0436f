// SPDX-License-Identifier: MIT
#include "tests/c/engine.h"

#include <stdlib.h>
#include <string.h>

_Static_assert(SINEW_VERSION >> 16 == SINEW_VERSION_MAJOR, "versions are packed");

void engine_free(engine_numbers* numbers) {
  free(numbers->values);
  memset(numbers, 0, sizeof(*numbers));
}

void engine_add(engine_numbers* to, const void* values, size_t count) {
  if (count == 0) return;
  if (to->count + count > to->capacity) {
    to->capacity = 2 * (to->count + count);
    to->values = realloc(to->values, to->capacity * sizeof(float));
    if (to->values == NULL) abort();
  }
  memcpy(to->values + to->count, values, count * sizeof(float));
  to->count += count;
}

static void add_number(engine_numbers* to, double value) {
  const float number = (float)value;
  engine_add(to, &number, 1);
}

static sinew_error read_instances(const sinew_result* result, size_t count, engine_numbers* out) {
  for (uint32_t i = 0; i < count; ++i) {
    sinew_instance_result instance = {.struct_size = sizeof(instance)};
    const sinew_error error = sinew_get_instance_result(result, i, &instance);
    if (error != SINEW_OK) return error;
    engine_add(out, &instance.world_from_mesh, 12);
    engine_add(out, &instance.bounds, 6);
    add_number(out, instance.first_shape);
    add_number(out, instance.mirrored);
    add_number(out, instance.visible);
  }
  return SINEW_OK;
}

static sinew_error read_shapes(const sinew_result* result, size_t count, engine_numbers* out) {
  for (uint32_t s = 0; s < count; ++s) {
    sinew_shape shape = {.struct_size = sizeof(shape)};
    const sinew_error error = sinew_get_shape(result, s, &shape);
    if (error != SINEW_OK) return error;
    add_number(out, shape.instance);
    add_number(out, shape.primitive);
    engine_add(out, shape.positions.data, 3 * shape.positions.count);
    engine_add(out, shape.normals.data, 3 * shape.normals.count);
    engine_add(out, shape.tangents.data, 4 * shape.tangents.count);
    engine_add(out, shape.colors.data, 4 * shape.colors.count);
  }
  return SINEW_OK;
}

sinew_error engine_read(const sinew_result* result, size_t skin_count, engine_numbers* out) {
  sinew_result_info info = {.struct_size = sizeof(info)};
  sinew_error error = sinew_get_result(result, &info);
  if (error != SINEW_OK) return error;
  engine_add(out, info.model.data, 12 * info.model.count);
  engine_add(out, info.weights.data, info.weights.count);
  engine_add(out, info.properties.data, info.properties.count);
  for (size_t j = 0; j < info.hidden.count; ++j) add_number(out, info.hidden.data[j]);
  for (uint32_t skin = 0; skin < skin_count; ++skin) {
    const sinew_joint_matrices palette = sinew_get_palette(result, skin);
    engine_add(out, palette.data, 16 * palette.count);
  }
  error = read_instances(result, info.instance_count, out);
  return error == SINEW_OK ? read_shapes(result, info.shape_count, out) : error;
}

sinew_error engine_play(const sinew_scene* scene, const sinew_needs* needs, const sinew_frame_input* input,
                        const sinew_allocator* allocator, engine_numbers* out) {
  sinew_plan* plan = NULL;
  sinew_frame* frame = NULL;
  sinew_error error = sinew_plan_create(scene, needs, &plan);
  if (error == SINEW_OK) error = sinew_frame_create(plan, allocator, &frame);
  if (error == SINEW_OK) error = sinew_run(frame, input);
  if (error == SINEW_OK) error = engine_read(sinew_frame_result(frame), sinew_skin_count(scene), out);
  sinew_frame_destroy(frame);
  sinew_plan_destroy(plan);
  return error;
}

static int all_are(const unsigned char* bytes, size_t count, unsigned char value) {
  for (size_t i = 0; i < count; ++i)
    if (bytes[i] != value) return 0;
  return 1;
}

sinew_error engine_play_in_block(const sinew_scene* scene, const sinew_needs* needs, const sinew_frame_input* input,
                                 engine_numbers* out) {
  enum { guard = 256, guard_byte = 0xa5 };
  sinew_plan* plan = NULL;
  sinew_frame* frame = NULL;
  sinew_error error = sinew_plan_create(scene, needs, &plan);
  if (error != SINEW_OK) return error;
  const size_t size = sinew_plan_frame_bytes(plan);
  unsigned char* memory = malloc(size + 2 * guard + SINEW_FRAME_ALIGNMENT);
  if (memory == NULL) abort();
  memset(memory, guard_byte, size + 2 * guard + SINEW_FRAME_ALIGNMENT);
  unsigned char* block = memory + guard;
  while ((uintptr_t)block % SINEW_FRAME_ALIGNMENT != 0) ++block;

  if (sinew_frame_create_in(plan, block, size - 1, &frame) != SINEW_SIZE_MISMATCH ||
      sinew_frame_create_in(plan, block + 8, size, &frame) != SINEW_SIZE_MISMATCH)
    error = SINEW_UNSUPPORTED;
  if (error == SINEW_OK) error = sinew_frame_create_in(plan, block, size, &frame);
  if (error == SINEW_OK) error = sinew_run(frame, input);
  if (error == SINEW_OK) error = engine_read(sinew_frame_result(frame), sinew_skin_count(scene), out);
  sinew_frame_destroy(frame);
  if (!all_are(memory, (size_t)(block - memory), guard_byte) || !all_are(block + size, guard, guard_byte))
    error = SINEW_OVERLAPPING_BUFFERS;
  free(memory);
  sinew_plan_destroy(plan);
  return error;
}

static void* allocate(void* context, size_t byte_count, size_t alignment) {
  engine_memory* memory = context;
  if (memory->allocations == memory->refuse_after) return NULL;
  memory->allocations += 1;
  memory->bytes_in_use += byte_count;
  if (memory->bytes_in_use > memory->most_bytes) memory->most_bytes = memory->bytes_in_use;
  if (alignment < sizeof(void*)) alignment = sizeof(void*);
  return aligned_alloc(alignment, (byte_count + alignment - 1) / alignment * alignment);
}

static void release(void* context, void* block, size_t byte_count, size_t alignment) {
  engine_memory* memory = context;
  (void)alignment;
  memory->bytes_in_use -= byte_count;
  free(block);
}

sinew_allocator engine_allocator(engine_memory* memory) {
  const sinew_allocator allocator = {memory, allocate, release};
  return allocator;
}

static void run_backwards(void* context, size_t count, void (*body)(void*, size_t), void* body_context) {
  engine_executor_log* log = context;
  log->calls += 1;
  log->indices += count;
  for (size_t i = count; i-- > 0;) body(body_context, i);
}

sinew_executor engine_executor(engine_executor_log* log) {
  const sinew_executor executor = {log, run_backwards};
  return executor;
}

size_t engine_events(double duration_s, uint32_t mode, double dt_s, int steps, const double* times_s, size_t count,
                     uint32_t* events, size_t capacity, double* end_s) {
  sinew_clock clock;
  size_t crossed = 0;
  if (sinew_clock_init(&clock, duration_s, mode, 1.0) != SINEW_OK) abort();
  for (int i = 0; i < steps; ++i) {
    sinew_step step;
    if (sinew_clock_advance(&clock, dt_s, &step) != SINEW_OK) abort();
    const size_t room = crossed < capacity ? capacity - crossed : 0;
    crossed += sinew_crossed_events(&step, times_s, count, events + (capacity - room), room);
  }
  *end_s = sinew_clock_time_s(&clock);
  return crossed;
}
