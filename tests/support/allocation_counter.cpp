// SPDX-License-Identifier: MIT
#include "tests/support/allocation_counter.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

thread_local std::size_t allocations = 0;
std::atomic<std::size_t> allocations_of_all{0};

void count() noexcept {
  ++allocations;
  allocations_of_all.fetch_add(1, std::memory_order_relaxed);
}

std::atomic<std::size_t> in_use{0}, most_in_use{0};

#ifdef _WIN32  // Windows frees aligned memory by other functions, which cannot tell its size: PeakMemory ignores it
               // there
std::size_t size_of(void* p) noexcept { return p != nullptr ? _msize(p) : 0; }
std::size_t size_of(void*, std::size_t) noexcept { return 0; }
void* allocate_aligned(std::size_t step, std::size_t size) noexcept { return _aligned_malloc(size, step); }
void free_aligned(void* p) noexcept { _aligned_free(p); }
#else
std::size_t size_of(void* p) noexcept { return malloc_usable_size(p); }
std::size_t size_of(void* p, std::size_t) noexcept { return malloc_usable_size(p); }
void* allocate_aligned(std::size_t step, std::size_t size) noexcept { return std::aligned_alloc(step, size); }
void free_aligned(void* p) noexcept { std::free(p); }
#endif

void take(std::size_t size) noexcept {
  const std::size_t now = in_use.fetch_add(size) + size;
  for (std::size_t most = most_in_use.load(); now > most && !most_in_use.compare_exchange_weak(most, now);) {
  }
}

void* allocate(std::size_t size) noexcept {
  count();
  void* const p = std::malloc(size != 0 ? size : 1);
  take(size_of(p));
  return p;
}

void* allocate(std::size_t size, std::align_val_t alignment) noexcept {
  count();
  const auto step = static_cast<std::size_t>(alignment);
  const std::size_t rounded = (size + step - 1) / step * step;
  void* const p = allocate_aligned(step, rounded != 0 ? rounded : step);
  take(size_of(p, step));
  return p;
}

void give_back(void* p) noexcept {
  in_use.fetch_sub(size_of(p));
  std::free(p);
}

void give_back(void* p, std::align_val_t alignment) noexcept {
  in_use.fetch_sub(size_of(p, static_cast<std::size_t>(alignment)));
  free_aligned(p);
}

void* or_throw(void* p) {
  if (p == nullptr) throw std::bad_alloc();
  return p;
}

}  // namespace

std::size_t sinew::test::allocation_count() noexcept { return allocations; }
std::size_t sinew::test::allocation_count_of_all_threads() noexcept { return allocations_of_all.load(); }

sinew::test::PeakMemory::PeakMemory() noexcept : before_(in_use.load()) { most_in_use.store(before_); }
std::size_t sinew::test::PeakMemory::bytes() const noexcept { return most_in_use.load() - before_; }

// The standard library's array and nothrow forms call these. The address sanitizer's nothrow forms do not: without
// these replacements it would report its own new as freed by a foreign delete.
void* operator new(std::size_t size) { return or_throw(allocate(size)); }
void* operator new(std::size_t size, std::align_val_t alignment) { return or_throw(allocate(size, alignment)); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return allocate(size, alignment);
}
void operator delete(void* p) noexcept { give_back(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { give_back(p); }
void operator delete(void* p, std::size_t) noexcept { give_back(p); }
void operator delete(void* p, std::align_val_t alignment) noexcept { give_back(p, alignment); }
void operator delete(void* p, std::align_val_t alignment, const std::nothrow_t&) noexcept { give_back(p, alignment); }
void operator delete(void* p, std::size_t, std::align_val_t alignment) noexcept { give_back(p, alignment); }
