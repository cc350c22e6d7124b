// Leaks are looked for when the last test is over and its threads with it. LeakSanitizer would look
// at exit, while libraries' static objects end their threads: stopping one that is just ending
// crashes it now and then.
#include <gtest/gtest.h>

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/lsan_interface.h>

namespace {

class NoLeaks : public testing::Environment {
  void TearDown() override { __lsan_do_leak_check(); }
};

[[maybe_unused]] const testing::Environment* const no_leaks =
    testing::AddGlobalTestEnvironment(new NoLeaks);

}  // namespace
#endif
