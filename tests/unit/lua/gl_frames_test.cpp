// Framebuffers and queries: what the main frame allows, what is read back.
#include "gl_fixture.h"

namespace shadowlab::lua {
namespace {

using GlFrames = GlScript;
using GlQueries = GlScript;

TEST_F(GlFrames, the_main_one_takes_no_attachments) {
  for (const char* call :
       {"FramebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, 0, 0)",
        "FramebufferTexture(gl.DRAW_FRAMEBUFFER, gl.DEPTH_ATTACHMENT, 0, 0)",
        "FramebufferTextureLayer(gl.READ_FRAMEBUFFER, gl.COLOR_ATTACHMENT0, 0, 0, 0)",
        "FramebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, 0)",
        "NamedFramebufferTexture(0, gl.COLOR_ATTACHMENT0, 0, 0)",
        "NamedFramebufferRenderbuffer(0, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, 0)"}) {
    const std::string name(call, std::string_view(call).find('('));
    EXPECT_EQ(error(std::string("gl.") + call),
              "gl." + name +
                  ": the main frame takes no attachments; bind a framebuffer of your own first");
  }
}

TEST_F(GlFrames, name_the_colour_buffers_that_are_theirs) {
  EXPECT_EQ(error("gl.DrawBuffer(gl.COLOR_ATTACHMENT0)"),
            "gl.DrawBuffer: the main frame is bound, whose colour buffer is gl.BACK; "
            "gl.COLOR_ATTACHMENTi belong to framebuffer objects");
  EXPECT_EQ(error("gl.ReadBuffer(gl.BACK_RIGHT)"),
            "gl.ReadBuffer: the main frame is not stereo: it has no right buffer");
  EXPECT_EQ(error("gl.BindFramebuffer(gl.FRAMEBUFFER, gl.GenFramebuffers(1)) "
                  "gl.DrawBuffers(1, {gl.BACK})"),
            "gl.DrawBuffers: a framebuffer object is bound, whose colour buffers are "
            "gl.COLOR_ATTACHMENT0 …; gl.BACK and its like belong to the main frame");
  EXPECT_EQ(
      error("gl.NamedFramebufferReadBuffer(gl.CreateFramebuffers(1), gl.FRONT)").substr(0, 62),
      "gl.NamedFramebufferReadBuffer: a framebuffer object is bound, ");
  run("gl.BindFramebuffer(gl.FRAMEBUFFER, 0) gl.DrawBuffer(gl.FRONT_AND_BACK) "
      "gl.DrawBuffer(gl.NONE) gl.ReadBuffer(gl.FRONT) gl.NamedFramebufferDrawBuffer(0, gl.BACK)");
}

TEST_F(GlFrames, tell_the_main_ones_buffer_by_its_own_name) {
  EXPECT_EQ(value("return gl.GetIntegerv(gl.DRAW_BUFFER) == gl.BACK and "
                  "gl.GetIntegerv(gl.READ_BUFFER) == gl.BACK"),
            "true");
  EXPECT_EQ(value("gl.DrawBuffer(gl.NONE) return gl.GetIntegerv(gl.DRAW_BUFFER) == gl.NONE"),
            "true");
  EXPECT_EQ(value("gl.BindFramebuffer(gl.FRAMEBUFFER, gl.GenFramebuffers(1)) "
                  "return gl.GetIntegerv(gl.DRAW_BUFFER) == gl.COLOR_ATTACHMENT0"),
            "true");
}

TEST_F(GlFrames, deleted_while_bound_leave_the_main_one_bound) {
  run("local f = gl.GenFramebuffers(1) gl.BindFramebuffer(gl.FRAMEBUFFER, f) "
      "gl.DeleteFramebuffers(1, f) gl.ClearColor(0, 1, 0, 1) gl.Clear(gl.COLOR_BUFFER_BIT) "
      "gl.Accum(gl.LOAD, 1)");
  EXPECT_EQ(graphics().frame.read_color().at(0, 0), (std::array<std::uint8_t, 4>{0, 255, 0, 255}));
}

TEST_F(GlFrames, that_are_not_complete_are_named_so) {
  EXPECT_EQ(error("gl.BindFramebuffer(gl.FRAMEBUFFER, gl.GenFramebuffers(1)) "
                  "gl.Clear(gl.COLOR_BUFFER_BIT)"),
            "gl.Clear: the framebuffer is not complete "
            "(gl.FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT) (GL_INVALID_FRAMEBUFFER_OPERATION)");
  run("gl.BindFramebuffer(gl.FRAMEBUFFER, 0)");
  EXPECT_EQ(error("fbo.color(4, 4, gl.DEPTH24_STENCIL8)"),
            "fbo.color: this context cannot draw to that format");
  // What GL said of that is not said of the next call.
  run("gl.Finish()");
}

TEST_F(GlFrames, are_read_row_by_row_from_the_lowest) {
  run("gl.ClearColor(0.2, 0.4, 0.6, 0.8) gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT) "
      "gl.Enable(gl.SCISSOR_TEST) gl.Scissor(1, 0, 1, 1) gl.ClearColor(1, 1, 1, 1) "
      "gl.Clear(gl.COLOR_BUFFER_BIT)");
  EXPECT_EQ(value("return table.concat(gl.ReadPixels(0, 0, 2, 2, gl.RGB, gl.UNSIGNED_BYTE), ' ')"),
            "51 102 153 255 255 255 51 102 153 51 102 153");
  EXPECT_EQ(value("return gl.ReadPixels(0, 0, 1, 1, gl.DEPTH_COMPONENT, gl.FLOAT)[1]"), "1.0");
  EXPECT_EQ(value("return #gl.ReadPixels(0, 0, 0, 5, gl.RGBA, gl.FLOAT)"), "0");
  EXPECT_NE(
      error("gl.ReadPixels(0, 0, 1, 1, gl.DEPTH_STENCIL, gl.UNSIGNED_INT_24_8)").find("one by one"),
      std::string::npos);
}

TEST_F(GlQueries, count_the_samples_of_what_is_drawn) {
  run(fill_program);
  run(covering_triangle);
  EXPECT_EQ(value("local q = gl.GenQueries(1) gl.BeginQuery(gl.SAMPLES_PASSED, q) "
                  "gl.DrawArrays(gl.TRIANGLES, 0, 3) gl.EndQuery(gl.SAMPLES_PASSED) "
                  "return gl.GetQueryObjectuiv(q, gl.QUERY_RESULT)"),
            std::to_string(frame_size * frame_size));
}

TEST_F(GlQueries, tell_the_bits_of_the_main_frame) {
  EXPECT_EQ(
      value("return table.concat({gl.GetIntegerv(gl.RED_BITS), gl.GetIntegerv(gl.DEPTH_BITS), "
            "gl.GetIntegerv(gl.STENCIL_BITS), gl.GetIntegerv(gl.ACCUM_RED_BITS)}, ' ')"),
      "8 24 8 16");
  EXPECT_EQ(value("fbo.accumulation 'float32' return gl.GetIntegerv(gl.ACCUM_ALPHA_BITS)"), "32");
  EXPECT_EQ(value("return select('#', gl.GetIntegerv(gl.VIEWPORT))"), "4");
  EXPECT_EQ(error("gl.GetIntegerv(gl.CURRENT_PROGRAM)"),
            "gl.GetIntegerv: names of objects are not integers here; keep the object you bound");
}

}  // namespace
}  // namespace shadowlab::lua
