// Options of the sanitized build, a part of each of its programs.

/// GCC 12's run-time takes a thread's block of dynamic TLS that malloc happened to place 16 bytes
/// into a page for one with the header of glibc 2.24, reads an address from the bytes before it,
/// and LeakSanitizer crashes there: one program in 256. Without the interceptor nothing is guessed.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() { return "intercept_tls_get_addr=0"; }
