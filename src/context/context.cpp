#include "context/context.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <malloc.h>

#include <array>
#include <utility>

#include "context/driver_silence.h"
#include "context/native.h"
#include "context/window.h"
#include "core/near_names.h"

namespace shadowlab::context {
namespace {

constexpr std::array<std::string_view, 4> names = {"automatic", "osmesa", "egl", "glfw"};
constexpr std::array<Backend, 3> in_order = {Backend::osmesa, Backend::egl, Backend::glfw};

// GL's own notion of a current context is the thread's, and the backends share parts of it without
// knowing of each other: whichever context is current must be released by its own backend first.
thread_local Native* current = nullptr;

void release_current() {
  if (current) std::exchange(current, nullptr)->release();
}

std::unique_ptr<Native> make_native(Backend backend, Size size) {
  switch (backend) {
    case Backend::osmesa:
      return make_osmesa(size);
    case Backend::egl:
      return make_egl(size);
    case Backend::glfw:
    case Backend::automatic:
      break;
  }
  return make_glfw(size);
}

template <typename F>
F* load(const Context& context, const char* name) {
  if (const Function found = context.function(name)) return reinterpret_cast<F*>(found);
  throw Unavailable(context.name + ": its driver has no " + name);
}

struct DefaultFramebufferBits {
  int depth, stencil, accum;
};

// A core profile has no GL_DEPTH_BITS; there, the default framebuffer's attachments are asked.
DefaultFramebufferBits default_framebuffer_bits(const Context& context) {
  const auto get_integer = load<void(GLenum, GLint*)>(context, "glGetIntegerv");
  const auto get_error = load<GLenum()>(context, "glGetError");
  GLint profile = 0;
  get_integer(GL_CONTEXT_PROFILE_MASK, &profile);
  DefaultFramebufferBits bits{0, 0, 0};
  if (profile & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) {
    get_integer(GL_DEPTH_BITS, &bits.depth);
    get_integer(GL_STENCIL_BITS, &bits.stencil);
    get_integer(GL_ACCUM_RED_BITS, &bits.accum);
  } else {
    const auto status = load<GLenum(GLenum)>(context, "glCheckFramebufferStatus");
    const auto attachment = load<void(GLenum, GLenum, GLenum, GLint*)>(
        context, "glGetFramebufferAttachmentParameteriv");
    if (status(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) {
      attachment(GL_FRAMEBUFFER, GL_DEPTH, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, &bits.depth);
      attachment(GL_FRAMEBUFFER, GL_STENCIL, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE, &bits.stencil);
    }
  }
  get_error();
  return bits;
}

void describe(Context& context) {
  const auto get_integer = load<void(GLenum, GLint*)>(context, "glGetIntegerv");
  const auto get_string = load<const GLubyte*(GLenum)>(context, "glGetString");
  const auto string = [&](GLenum what) {
    const GLubyte* found = get_string(what);
    return std::string(found ? reinterpret_cast<const char*>(found) : "");
  };
  context.version = string(GL_VERSION);
  context.renderer = string(GL_RENDERER);
  context.vendor = string(GL_VENDOR);
  get_integer(GL_MAJOR_VERSION, &context.major);
  get_integer(GL_MINOR_VERSION, &context.minor);
  if (context.major < 3 || (context.major == 3 && context.minor < 3)) {
    throw Unavailable(context.name + ": " + context.renderer + " gives OpenGL " + context.version +
                      ", and 3.3 is needed");
  }
  const auto bits = default_framebuffer_bits(context);
  context.depth_bits = bits.depth;
  context.stencil_bits = bits.stencil;
  context.accum_bits = bits.accum;
}

// A software driver allocates what it sorts of a frame, some megabytes, and frees it at the frame's
// end. By default glibc gives such a piece of the heap back to the kernel at once, and each frame
// faults its pages in again: 6 to 12 % of a frame's time.
void keep_heap() {
#ifdef __GLIBC__
  constexpr int kept = 32 << 20;  // bytes; as large a piece may be of the heap at all
  mallopt(M_TRIM_THRESHOLD, kept);
  mallopt(M_MMAP_THRESHOLD, kept);
#endif
}

Context create_automatic(Size size) {
  std::string reasons;
  for (const Backend backend : in_order) {
    try {
      return create(backend, size);
    } catch (const Unavailable& unavailable) {
      reasons += (reasons.empty() ? "" : "; ") + unavailable.reason;
    }
  }
  throw MachineError("No OpenGL context can be made here (" + reasons +
                     "): apt-get install libosmesa6 brings one that needs no display and no GPU.");
}

}  // namespace

std::string_view name_of(Backend backend) { return names[static_cast<std::size_t>(backend)]; }

Backend backend_named(std::string_view name) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return static_cast<Backend>(i);
  }
  throw InputError("There is no context '" + std::string(name) +
                   "': it is osmesa, egl, glfw or automatic" + did_you_mean(name, names) +
                   (nearest_name(name, names) ? "" : "."));
}

Unavailable::Unavailable(std::string why, std::string what_to_do)
    : MachineError(why + (what_to_do.empty() ? "." : "; " + what_to_do + ".")),
      reason(std::move(why)),
      remedy(std::move(what_to_do)) {}

Context::Context(Backend made_by, std::unique_ptr<Native> native)
    : backend(made_by), native_(std::move(native)) {}

Context::Context(Context&& other) noexcept = default;

Context& Context::operator=(Context&& other) noexcept {
  // The swap leaves this context's old self to `other`, whose destructor releases it.
  Context moved(std::move(other));
  std::swap(backend, moved.backend);
  name.swap(moved.name);
  version.swap(moved.version);
  renderer.swap(moved.renderer);
  vendor.swap(moved.vendor);
  major = moved.major;
  minor = moved.minor;
  depth_bits = moved.depth_bits;
  stencil_bits = moved.stencil_bits;
  accum_bits = moved.accum_bits;
  native_.swap(moved.native_);
  return *this;
}

Context::~Context() {
  if (native_) release();
}

Function Context::function(const char* gl_name) const { return native_->function(gl_name); }

void Context::make_current() const {
  if (current != native_.get()) release_current();
  native_->make_current();
  current = native_.get();
}

void Context::release() const {
  if (current == native_.get()) release_current();
}

Window* Context::window() const { return native_->window(); }

Context create(Backend backend, Size size) {
  if (backend == Backend::automatic) return create_automatic(size);
  release_current();
  keep_heap();
  const DriverSilence silence;
  Context context(backend, make_native(backend, size));
  context.make_current();
  context.name = context.native_->name();
  describe(context);
  return context;
}

Context create_window(const WindowOptions& options) {
  release_current();
  const DriverSilence silence;
  Context context(Backend::glfw, make_glfw_window(options));
  context.make_current();
  context.name = context.native_->name();
  describe(context);
  return context;
}

}  // namespace shadowlab::context
