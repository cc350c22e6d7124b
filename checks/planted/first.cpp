// Mistakes that clang-tidy is to find, each named at the end of its line; no part of the program.
#include <mutex>
#include <string>
#include <utility>
#include <vector>

struct Base {
  virtual int f() const;
  virtual ~Base();
};
struct Derived : Base {
  int f() const;  // modernize-use-override
};

template <typename T>
std::size_t moved(T value) {
  T other = std::move(value);
  return other.size() + value.size();  // bugprone-use-after-move
}
std::size_t instantiates(std::string s) { return moved(std::move(s)); }

std::mutex mutex;
long locked(int a, int b) {
  std::lock_guard<std::mutex>{mutex};  // bugprone-unused-raii
  return a * b;                        // bugprone-implicit-widening-of-multiplication-result
}

int* copies(const std::vector<std::string>& all) {
  for (const auto one : all) {    // performance-for-range-copy
    if (one.size() == 0) return 0;  // readability-container-size-empty modernize-use-nullptr
  }
  return nullptr;
}
