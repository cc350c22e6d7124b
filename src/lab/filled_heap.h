// Fresh memory for processes that are forked: internal to this floor.
#pragma once

#include <cstdlib>
#include <memory>
#include <vector>

namespace shadowlab::lab {

/// What this process has freed are holes in its heap, and when a forked one puts something there
/// the kernel copies each page of it first. While this lives the holes are in use, and their pages
/// given back: a forked process begins at the heap's end, where memory is fresh, and comes by two
/// megabytes at a time if the heap asks for that (GLIBC_TUNABLES=glibc.malloc.hugetlb=1). Of
/// glibc's heap alone; with another one it is nothing.
class FilledHeap {
 public:
  FilledHeap();

 private:
  struct Free {
    void operator()(void* block) const { std::free(block); }
  };
  std::vector<std::unique_ptr<void, Free>> fillings_;
};

}  // namespace shadowlab::lab
