// Its mutex is of the name of first.cpp's, so it is read alone.
#include <mutex>

namespace {
std::recursive_mutex mutex;
}
int locked(int a) {
  std::lock_guard<std::recursive_mutex>{mutex};  // bugprone-unused-raii
  return a;
}
