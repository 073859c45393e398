// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces operator new in the whole test program. No other file may see these definitions inline.
#include "count_allocations.h"

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

thread_local int count = 0;

void* allocate(std::size_t size, std::size_t alignment) {
  ++count;
  void* const memory = std::aligned_alloc(alignment, (size + alignment) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
// std::stable_sort takes its buffer by this one. Without it the library's own would be paired with our delete.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return operator new(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

int wirewarp::num_allocations() { return count; }
