#include "lab/filled_heap.h"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>

namespace shadowlab::lab {
namespace {

// AddressSanitizer has a heap of its own.
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
constexpr bool is_glibcs = true;
#else
constexpr bool is_glibcs = false;
#endif

constexpr std::size_t page = 4096, largest = std::size_t{4} << 20;
constexpr std::size_t most_fillings = 4096;  // the list must not make holes of its own

std::uintptr_t address_of(const void* place) { return reinterpret_cast<std::uintptr_t>(place); }

void give_pages_back(void* block, std::size_t bytes) {
  const std::uintptr_t begin = (address_of(block) + page - 1) / page * page;
  const std::uintptr_t end = (address_of(block) + bytes) / page * page;
  if (begin < end)
    ::madvise(static_cast<char*>(block) + (begin - address_of(block)), end - begin, MADV_DONTNEED);
}

}  // namespace

FilledHeap::FilledHeap() {
  if (!is_glibcs) return;
  fillings_.reserve(most_fillings);
  ::malloc_trim(0);
  const std::uintptr_t end = address_of(::sbrk(0));
  for (std::size_t size = largest; size >= page; size /= 2) {
    while (fillings_.size() < most_fillings) {
      std::unique_ptr<void, Free> filling(std::malloc(size));
      if (!filling || address_of(filling.get()) >= end) break;  // the heap grows: no hole is left
      give_pages_back(filling.get(), size);
      fillings_.push_back(std::move(filling));
    }
  }
  ::malloc_trim(0);
}

}  // namespace shadowlab::lab
