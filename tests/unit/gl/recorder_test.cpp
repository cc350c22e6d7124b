// What a trace says of calls: C, with GL's own names.
#include "gl_fixture.h"

namespace shadowlab::gl {
namespace {

class Trace : public GraphicsTest {
 protected:
  void SetUp() override {
    GraphicsTest::SetUp();
    graphics().trace_into(&recorder_);
  }
  void TearDown() override {
    graphics().trace_into(nullptr);
    // Some calls here are only to be printed: no program is in use.
    while (gl().GetError.pointer() != GL_NO_ERROR) {
    }
  }
  Recorder& recorder() { return recorder_; }
  std::string last() { return recorder_.call(recorder_.size() - 1).as_c(); }

 private:
  Recorder recorder_;
};

TEST_F(Trace, prints_names_numbers_and_masks_as_the_lecture_writes_them) {
  gl().StencilFunc(GL_ALWAYS, 1, 0xFF);
  EXPECT_EQ(last(), "glStencilFunc(GL_ALWAYS, 1, 0xFF);");
  gl().StencilMask(~0u);
  EXPECT_EQ(last(), "glStencilMask(0xFFFFFFFF);");
  gl().ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
  EXPECT_EQ(last(), "glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);");
  gl().Viewport(-1, 2, 3, 4);
  EXPECT_EQ(last(), "glViewport(-1, 2, 3, 4);");
  gl().Clear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  EXPECT_EQ(last(), "glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);");
  gl().Clear(0);
  EXPECT_EQ(last(), "glClear(0);");
  gl().BlendFunc(GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
  EXPECT_EQ(last(), "glBlendFunc(GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);");
  gl().Finish();
  EXPECT_EQ(last(), "glFinish();");
  gl().ActiveTexture(GL_TEXTURE3);
  EXPECT_EQ(last(), "glActiveTexture(GL_TEXTURE3);");
  gl().PrimitiveRestartIndex(0xFFFFFFFF);
  EXPECT_EQ(last(), "glPrimitiveRestartIndex(4294967295);");
}

TEST_F(Trace, prints_floats_and_doubles_as_short_as_they_read_back) {
  const std::pair<GLfloat, const char*> floats[] = {
      {1, "1.0f"},        {0.1f, "0.1f"},
      {-0.0f, "-0.0f"},   {1 / 3.f, "0.33333334f"},
      {1e-10f, "1e-10f"}, {3.4028235e38f, "3.4028235e+38f"}};
  for (const auto& [value, text] : floats) {
    gl().PolygonOffset(value, 2);
    EXPECT_EQ(last(), std::string("glPolygonOffset(") + text + ", 2.0f);");
  }
  gl().DepthRange(0.1, 1);
  EXPECT_EQ(last(), "glDepthRange(0.1, 1.0);");
}

TEST_F(Trace, prints_arrays_as_compound_literals_and_none_as_null) {
  gl().DrawBuffers(1, std::array<GLenum, 1>{GL_BACK});
  EXPECT_EQ(last(), "glDrawBuffers(1, (const GLenum[]){GL_BACK});");
  gl().ClearBufferfv(GL_COLOR, 0, std::array<GLfloat, 4>{0, 0.5f, 1, 1});
  EXPECT_EQ(last(), "glClearBufferfv(GL_COLOR, 0, (const GLfloat[]){0.0f, 0.5f, 1.0f, 1.0f});");
  gl().ClearBufferiv(GL_STENCIL, 0, std::array<GLint, 1>{-1});
  EXPECT_EQ(last(), "glClearBufferiv(GL_STENCIL, 0, (const GLint[]){-1});");
  gl().Uniform1uiv(-1, 1, std::array<GLuint, 1>{4000000000u});
  EXPECT_EQ(last(), "glUniform1uiv(-1, 1, (const GLuint[]){4000000000});");
  gl().Uniform1fv(-1, 0, {});
  EXPECT_EQ(last(), "glUniform1fv(-1, 0, NULL);");
}

TEST_F(Trace, prints_objects_by_their_kind_and_results_by_where_they_go) {
  std::array<GLuint, 2> names{};
  gl().GenTextures(1, std::span(names).first(1));
  const std::string texture = "texture_" + std::to_string(names[0]);
  EXPECT_EQ(last(), "glGenTextures(1, &" + texture + ");");
  gl().BindTexture(GL_TEXTURE_2D, names[0]);
  EXPECT_EQ(last(), "glBindTexture(GL_TEXTURE_2D, " + texture + ");");
  gl().BindTexture(GL_TEXTURE_2D, 0);
  EXPECT_EQ(last(), "glBindTexture(GL_TEXTURE_2D, 0);");
  gl().BindFramebuffer(GL_FRAMEBUFFER, 0);
  EXPECT_EQ(last(), "glBindFramebuffer(GL_FRAMEBUFFER, 0);");
  gl().DeleteTextures(1, std::span(names).first(1));
  EXPECT_EQ(last(), "glDeleteTextures(1, (const GLuint[]){" + texture + "});");
  gl().GenBuffers(2, names);
  EXPECT_EQ(last(), "glGenBuffers(2, (const GLuint[]){buffer_" + std::to_string(names[0]) +
                        ", buffer_" + std::to_string(names[1]) + "});");
  gl().DeleteBuffers(2, names);
  std::array<GLint, 1> value{};
  gl().GetIntegerv(GL_STENCIL_REF, value);
  EXPECT_EQ(last(), "glGetIntegerv(GL_STENCIL_REF, result);");
  gl().DrawElements(GL_TRIANGLES, 0, GL_UNSIGNED_INT, 12);
  EXPECT_EQ(last(), "glDrawElements(GL_TRIANGLES, 0, GL_UNSIGNED_INT, (void*)12);");
}

TEST_F(Trace, never_keeps_whole_images) {
  std::array<GLuint, 1> texture{};
  gl().GenTextures(1, texture);
  gl().BindTexture(GL_TEXTURE_2D, texture[0]);
  const std::vector<std::byte> pixels(64 * 64 * 4);
  gl().TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  EXPECT_EQ(last(),
            "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, "
            "data /* 16384 bytes */);");
  gl().TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, {});
  EXPECT_TRUE(last().ends_with("GL_UNSIGNED_BYTE, NULL);")) << last();
  gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  EXPECT_EQ(last(), "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);");
  gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 3);
  EXPECT_EQ(last(), "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 3);");
  const std::vector<GLfloat> many(100, 0.5f);
  gl().Uniform1fv(-1, 100, many);
  EXPECT_TRUE(last().ends_with("0.5f /* … 100 in all */});")) << last();
  gl().DeleteTextures(1, texture);
}

TEST_F(Trace, escapes_what_a_script_may_call_its_things) {
  const GLuint program = gl().CreateProgram();
  gl().BindAttribLocation(program, 0, "a\"\\\n\xFF*/");
  EXPECT_TRUE(last().ends_with(", 0, \"a\\\"\\\\\\012\\377*/\");")) << last();
  recorder().comment("*/ \n\xC3");
  EXPECT_TRUE(last().ends_with("  /* * / \\012\\303 */")) << last();
  gl().DeleteProgram(program);
}

TEST_F(Trace, puts_calls_into_their_passes) {
  gl().Finish();
  recorder().begin_pass("1. the receiver");
  gl().Finish();
  recorder().end_pass();
  for (int i = 0; i < 40000; ++i) recorder().begin_pass("many");
  gl().Finish();
  EXPECT_EQ(recorder().call(0).pass, -1);
  EXPECT_EQ(recorder().call(1).pass, 0);
  EXPECT_EQ(recorder().call(2).pass, 40000);
  EXPECT_EQ(recorder().passes()[0], "1. the receiver");
  recorder().clear();
  EXPECT_EQ(recorder().size(), 0u);
  EXPECT_TRUE(recorder().passes().empty());
}

TEST_F(Trace, leaves_out_what_the_core_does_on_its_own_account) {
  graphics().begin_frame();
  graphics().accumulation.run(GL_LOAD, 1);
  graphics().accumulation.clear();
  graphics().frame.read_color();
  graphics().frame.read_stencil();
  EXPECT_EQ(recorder().size(), 0u);
}

TEST_F(Trace, ends_with_a_sentence_when_a_frame_never_does) {
  for (std::size_t i = 0; i < Recorder::most_calls; ++i) gl().DepthMask(GL_TRUE);
  EXPECT_THROW(gl().DepthMask(GL_TRUE), InputError);
}

}  // namespace
}  // namespace shadowlab::gl
