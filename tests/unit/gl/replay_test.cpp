// Calls made again from the text of a trace.
#include "gl/replay.h"

#include <gtest/gtest.h>

#include "gl_fixture.h"

namespace shadowlab::gl {
namespace {

using Replay = GraphicsTest;

GLint integer(const Functions& gl, GLenum name) {
  GLint value = 0;
  gl.GetIntegerv(name, {&value, 1});
  return value;
}

TEST_F(Replay, sets_what_the_call_of_that_text_set) {
  Recorder recorder;
  graphics().trace_into(&recorder);
  gl().StencilFunc(GL_EQUAL, 3, 0xF0);
  gl().PolygonOffset(-1.5f, 2);
  gl().DepthMask(GL_FALSE);
  gl().Enable(GL_BLEND);
  graphics().trace_into(nullptr);
  graphics().begin_frame();
  for (std::size_t i = 0; i < recorder.size(); ++i) {
    const TracedCall call = recorder.call(i);
    EXPECT_TRUE(replay(gl(), call.function, call.arguments)) << call.as_c();
  }
  EXPECT_EQ(integer(gl(), GL_STENCIL_FUNC), GL_EQUAL);
  EXPECT_EQ(integer(gl(), GL_STENCIL_REF), 3);
  EXPECT_EQ(integer(gl(), GL_STENCIL_VALUE_MASK), 0xF0);
  EXPECT_EQ(integer(gl(), GL_POLYGON_OFFSET_UNITS), 2);
  EXPECT_EQ(integer(gl(), GL_DEPTH_WRITEMASK), 0);
  EXPECT_TRUE(gl().IsEnabled(GL_BLEND));
}

TEST_F(Replay, calls_nothing_for_what_the_function_does_not_take) {
  using Texts = std::vector<std::string>;
  EXPECT_FALSE(replay(gl(), "glDepthFunc", Texts{"GL_KEEP"}));
  EXPECT_FALSE(replay(gl(), "glDepthFunc", Texts{}));
  EXPECT_FALSE(replay(gl(), "glStencilFunc", Texts{"GL_EQUAL", "1", "-1"}));
  EXPECT_FALSE(replay(gl(), "glPolygonOffset", Texts{"inf", "0"}));
  EXPECT_FALSE(replay(gl(), "glViewport", Texts{"0", "0", "-1", "1"}));
  EXPECT_FALSE(replay(gl(), "glDeleteTextures", Texts{"1", "texture_1"}));
  EXPECT_FALSE(replay(gl(), "glNothing", Texts{"1"}));
  EXPECT_EQ(integer(gl(), GL_DEPTH_FUNC), GL_LESS);
}

}  // namespace
}  // namespace shadowlab::gl
