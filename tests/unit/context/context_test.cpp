#include "context/context.h"

#include <GL/gl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <optional>
#include <thread>

#include "context/native.h"
#include "core/error.h"

namespace shadowlab::context {
namespace {

using Pixel = std::array<GLubyte, 4>;

bool has_display() { return std::getenv("DISPLAY") != nullptr; }

// One plain sentence: a capital or a name first, one stop last, no line break.
void expect_a_sentence(const std::string& text) {
  EXPECT_THAT(text, testing::EndsWith("."));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("\n")));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("std::")));
}

void clear_to(const Context& context, float red, float green, float blue) {
  reinterpret_cast<void (*)(GLfloat, GLfloat, GLfloat, GLfloat)>(context.function("glClearColor"))(
      red, green, blue, 1);
  reinterpret_cast<void (*)(GLbitfield)>(context.function("glClear"))(GL_COLOR_BUFFER_BIT);
}

Pixel pixel_of(const Context& context) {
  Pixel pixel{};
  reinterpret_cast<void (*)(GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void*)>(
      context.function("glReadPixels"))(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  return pixel;
}

// A framebuffer object of one pixel, since EGL's contexts have no default framebuffer.
void bind_own_framebuffer(const Context& context) {
  GLuint name = 0;
  const auto gen = [&](const char* function) {
    reinterpret_cast<void (*)(GLsizei, GLuint*)>(context.function(function))(1, &name);
    return name;
  };
  constexpr GLenum framebuffer = 0x8D40, renderbuffer = 0x8D41, color_attachment = 0x8CE0;
  reinterpret_cast<void (*)(GLenum, GLuint)>(context.function("glBindFramebuffer"))(
      framebuffer, gen("glGenFramebuffers"));
  const GLuint color = gen("glGenRenderbuffers");
  reinterpret_cast<void (*)(GLenum, GLuint)>(context.function("glBindRenderbuffer"))(renderbuffer,
                                                                                     color);
  reinterpret_cast<void (*)(GLenum, GLenum, GLsizei, GLsizei)>(
      context.function("glRenderbufferStorage"))(renderbuffer, GL_RGBA8, 8, 8);
  reinterpret_cast<void (*)(GLenum, GLenum, GLenum, GLuint)>(context.function(
      "glFramebufferRenderbuffer"))(framebuffer, color_attachment, renderbuffer, color);
}

class EachBackend : public testing::TestWithParam<Backend> {
 protected:
  void SetUp() override {
    if (GetParam() == Backend::glfw && !has_display()) {
      GTEST_SKIP() << "GLFW needs a display, and DISPLAY is not set: run with xvfb-run";
    }
  }
  // Empty where this machine cannot; the reason is then a sentence.
  static std::optional<Context> make() {
    try {
      return create(GetParam());
    } catch (const MachineError& error) {
      expect_a_sentence(error.what());
      return std::nullopt;
    }
  }
};

TEST_P(EachBackend, works_or_says_why_not_in_a_sentence) {
  const auto context = make();
  if (!context) return;
  EXPECT_EQ(context->backend, GetParam());
  EXPECT_GE(context->major * 10 + context->minor, 33);
  EXPECT_THAT(context->version, testing::StartsWith(std::to_string(context->major)));
  EXPECT_FALSE(context->name.empty());
  EXPECT_FALSE(context->renderer.empty());
  EXPECT_FALSE(context->vendor.empty());
  EXPECT_NE(context->function("glClear"), nullptr);
}

TEST_P(EachBackend, draws_to_a_framebuffer_object_and_reads_back) {
  const auto context = make();
  if (!context) return;
  bind_own_framebuffer(*context);
  clear_to(*context, 1, 0, 1);
  EXPECT_EQ(pixel_of(*context), (Pixel{255, 0, 255, 255}));
}

TEST_P(EachBackend, stays_usable_beside_an_osmesa_context) {
  const auto context = make();
  if (!context) return;
  bind_own_framebuffer(*context);
  std::optional<Context> other;
  try {
    other.emplace(create(Backend::osmesa));
  } catch (const MachineError&) {
    GTEST_SKIP() << "OSMesa is not installed";
  }
  clear_to(*other, 0, 1, 0);
  context->make_current();
  clear_to(*context, 1, 0, 0);
  EXPECT_EQ(pixel_of(*context), (Pixel{255, 0, 0, 255}));
  other->make_current();
  EXPECT_EQ(pixel_of(*other), (Pixel{0, 255, 0, 255}));
  context->make_current();
  EXPECT_EQ(pixel_of(*context), (Pixel{255, 0, 0, 255}));
}

TEST_P(EachBackend, two_contexts_of_one_backend_live_and_end_independently) {
  const auto first = make();
  if (!first) return;
  bind_own_framebuffer(*first);
  {
    const Context second = create(GetParam());
    bind_own_framebuffer(second);
    clear_to(second, 0, 0, 1);
    EXPECT_EQ(pixel_of(second), (Pixel{0, 0, 255, 255}));
  }
  first->make_current();
  clear_to(*first, 1, 1, 0);
  EXPECT_EQ(pixel_of(*first), (Pixel{255, 255, 0, 255}));
}

INSTANTIATE_TEST_SUITE_P(Context, EachBackend,
                         testing::Values(Backend::osmesa, Backend::egl, Backend::glfw),
                         [](const auto& backend) { return std::string(name_of(backend.param)); });

class OsMesa : public testing::Test {
 protected:
  void SetUp() override {
    try {
      create(Backend::osmesa);
    } catch (const MachineError& error) {
      GTEST_SKIP() << error.what();
    }
  }
};

TEST_F(OsMesa, offers_depth_stencil_and_accumulation) {
  const Context context = create(Backend::osmesa);
  EXPECT_EQ(context.name, "OSMesa");
  EXPECT_EQ(context.depth_bits, 24);
  EXPECT_EQ(context.stencil_bits, 8);
  EXPECT_EQ(context.accum_bits, 16);
}

TEST_F(OsMesa, two_side_by_side_keep_their_own_default_framebuffers) {
  const Context red = create(Backend::osmesa, {32, 8});
  clear_to(red, 1, 0, 0);
  const Context blue = create(Backend::osmesa);
  clear_to(blue, 0, 0, 1);
  red.make_current();
  EXPECT_EQ(pixel_of(red), (Pixel{255, 0, 0, 255}));
  blue.make_current();
  EXPECT_EQ(pixel_of(blue), (Pixel{0, 0, 255, 255}));
}

TEST_F(OsMesa, its_default_framebuffer_has_the_size_asked_for) {
  const Context context = create(Backend::osmesa, {37, 11});
  std::array<GLint, 4> viewport{};
  reinterpret_cast<void (*)(GLenum, GLint*)>(context.function("glGetIntegerv"))(GL_VIEWPORT,
                                                                                viewport.data());
  EXPECT_EQ(viewport, (std::array<GLint, 4>{0, 0, 37, 11}));
}

TEST_F(OsMesa, moving_a_context_keeps_it_current_and_its_successor_replaces_it) {
  Context first = create(Backend::osmesa);
  Context moved = std::move(first);
  clear_to(moved, 0, 1, 0);
  EXPECT_EQ(pixel_of(moved), (Pixel{0, 255, 0, 255}));
  moved = create(Backend::osmesa);
  clear_to(moved, 1, 0, 0);
  EXPECT_EQ(pixel_of(moved), (Pixel{255, 0, 0, 255}));
}

TEST_F(OsMesa, can_be_handed_to_another_thread) {
  const Context context = create(Backend::osmesa);
  context.release();
  Pixel seen{};
  std::thread([&] {
    context.make_current();
    clear_to(context, 0, 1, 1);
    seen = pixel_of(context);
    context.release();
  }).join();
  EXPECT_EQ(seen, (Pixel{0, 255, 255, 255}));
}

// Mesa says on standard error that it cannot make this folder, and goes on without a cache.
TEST_F(OsMesa, is_silent_where_there_is_no_place_for_a_shader_cache) {
  testing::internal::CaptureStderr();
  const int status = std::system(
      "XDG_CACHE_HOME=/proc/none /proc/$PPID/exe --gtest_filter=OsMesa.offers* 1>/dev/null");
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_EQ(status, 0);
  EXPECT_EQ(said, "");
}

TEST(Glfw, without_a_display_is_a_sentence) {
  if (has_display()) GTEST_SKIP() << "DISPLAY is set";
  try {
    create(Backend::glfw);
    ADD_FAILURE() << "GLFW made a window without a display";
  } catch (const MachineError& error) {
    expect_a_sentence(error.what());
    EXPECT_THAT(error.what(), testing::StartsWith("GLFW: "));
  }
}

TEST(SharedLibrary, that_is_missing_names_the_package_to_install) {
  try {
    SharedLibrary("OSMesa", "libOSMesa.so.0815", "libosmesa6");
    ADD_FAILURE() << "there is no such library";
  } catch (const MachineError& error) {
    EXPECT_STREQ(error.what(),
                 "OSMesa: libOSMesa.so.0815 is not installed; install it with apt-get install "
                 "libosmesa6.");
  }
}

TEST(Survey, reports_each_backend_once_with_its_package) {
  const auto reports = survey();
  ASSERT_EQ(reports.size(), 3u);
  for (const Report& report : reports) {
    EXPECT_FALSE(report.package.empty());
    EXPECT_EQ(report.works, report.why_not.empty());
    EXPECT_EQ(report.works, !report.version.empty());
    if (!report.works) expect_a_sentence(report.why_not);
  }
  EXPECT_EQ(reports[0].package, "libosmesa6");
}

TEST(BackendName, is_read_back_as_the_same_backend) {
  for (const Backend backend : {Backend::automatic, Backend::osmesa, Backend::egl, Backend::glfw}) {
    EXPECT_EQ(backend_named(name_of(backend)), backend);
  }
}

TEST(BackendName, misspelt_names_the_nearest) {
  try {
    backend_named("osmsea");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("did you mean osmesa?"));
  }
}

}  // namespace
}  // namespace shadowlab::context
