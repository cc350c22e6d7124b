// Mesa's off-screen contexts: no display, no GPU, an accumulation buffer. Mesa 25.1 dropped them.
#include <GL/osmesa.h>

#include <array>
#include <cstdint>
#include <vector>

#include "context/native.h"

namespace shadowlab::context {
namespace {

struct Api {
  decltype(OSMesaCreateContextAttribs)* create_context;
  decltype(OSMesaDestroyContext)* destroy_context;
  decltype(OSMesaMakeCurrent)* make_current;
  decltype(OSMesaGetProcAddress)* get_function;

  Api() {
    const SharedLibrary library("OSMesa", "libOSMesa.so.8", "libosmesa6");
    library.find(create_context, "OSMesaCreateContextAttribs");
    library.find(destroy_context, "OSMesaDestroyContext");
    library.find(make_current, "OSMesaMakeCurrent");
    library.find(get_function, "OSMesaGetProcAddress");
  }
};

class OsMesa final : public Native {
 public:
  explicit OsMesa(Size size)
      : size_(size),
        pixels_(std::size_t{4} * static_cast<std::size_t>(size.width) *
                static_cast<std::size_t>(size.height)) {
    for (const int profile : {OSMESA_COMPAT_PROFILE, OSMESA_CORE_PROFILE}) {
      const std::array<int, 17> attributes = {OSMESA_FORMAT,
                                              OSMESA_RGBA,
                                              OSMESA_DEPTH_BITS,
                                              24,
                                              OSMESA_STENCIL_BITS,
                                              8,
                                              OSMESA_ACCUM_BITS,
                                              16,
                                              OSMESA_PROFILE,
                                              profile,
                                              OSMESA_CONTEXT_MAJOR_VERSION,
                                              3,
                                              OSMESA_CONTEXT_MINOR_VERSION,
                                              3,
                                              0};
      context_ = api_.create_context(attributes.data(), nullptr);
      if (context_) return;
    }
    throw Unavailable("OSMesa: the driver gives no OpenGL 3.3 context");
  }

  ~OsMesa() override { api_.destroy_context(context_); }

  void make_current() override {
    if (!api_.make_current(context_, pixels_.data(), GL_UNSIGNED_BYTE, size_.width, size_.height)) {
      throw Unavailable("OSMesa: the context cannot be made current");
    }
  }

  void release() override { api_.make_current(nullptr, nullptr, 0, 0, 0); }

  Function function(const char* gl_name) const override { return api_.get_function(gl_name); }

  std::string name() const override { return "OSMesa"; }

 private:
  Api api_;
  Size size_;
  std::vector<std::uint8_t> pixels_;  // GL draws here
  OSMesaContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<Native> make_osmesa(Size size) { return std::make_unique<OsMesa>(size); }

}  // namespace shadowlab::context

// OSMesaDestroyContext leaves 160 bytes of its current buffer behind (Mesa 22.3.6).
#ifdef __SANITIZE_ADDRESS__
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa.so"; }
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
#endif
