// What gl.* has, and how it refuses what it is given.
#include <set>

#include "gl_fixture.h"
#include "lua/l_gl.h"

namespace shadowlab::lua {
namespace {

using GlNames = GlScript;
using GlArguments = GlScript;

TEST_F(GlNames, every_function_of_the_list_is_bound) {
  using Use = gl::FunctionDescription::Use;
  for (const auto& function : gl::function_descriptions()) {
    const auto chunk = "return type(rawget(gl, '" + std::string(function.name) + "'))";
    EXPECT_EQ(value(chunk), function.use == Use::core ? "nil" : "function") << function.name;
  }
}

TEST_F(GlNames, every_function_bound_by_hand_is_marked_so_and_bound_once) {
  std::set<gl::FunctionId> seen;
  for (const OwnFunction& own : own_functions()) {
    EXPECT_TRUE(seen.insert(own.function).second) << gl::describe(own.function).name;
    EXPECT_EQ(gl::describe(own.function).use, gl::FunctionDescription::Use::own)
        << gl::describe(own.function).name;
  }
}

TEST_F(GlNames, every_constant_has_its_value) {
  EXPECT_GT(gl::all_constants().size(), 350u);
  for (const gl::Constant& constant : gl::all_constants()) {
    EXPECT_EQ(value("return gl." + std::string(constant.name)), std::to_string(constant.value))
        << constant.name;
  }
}

TEST_F(GlNames, an_unknown_name_names_the_near_one) {
  EXPECT_EQ(error("return gl.ALWYAS"), "gl.ALWYAS does not exist; did you mean gl.ALWAYS?");
  EXPECT_EQ(error("gl.StencilFunk(gl.ALWAYS, 1, 1)"),
            "gl.StencilFunk does not exist; did you mean gl.StencilFunc?");
  EXPECT_EQ(error("return gl.Rumpelstiltskin"), "gl.Rumpelstiltskin does not exist");
}

TEST_F(GlArguments, a_wrong_number_of_them_is_named_with_what_is_taken) {
  EXPECT_EQ(error("gl.StencilFunc(gl.ALWAYS, 1)"),
            "gl.StencilFunc: takes 3 arguments (func, ref, mask); 2 given");
  EXPECT_EQ(error("gl.Enable()"), "gl.Enable: takes 1 argument (cap); 0 given");
  EXPECT_EQ(error("gl.Finish(1)"), "gl.Finish: takes 0 arguments (none); 1 given");
  EXPECT_EQ(error("gl.TexImage2D(1)"),
            "gl.TexImage2D: takes 8 to 9 arguments (target, level, internalformat, width, height, "
            "border, format, type, pixels); 1 given");
}

TEST_F(GlArguments, a_wrong_type_is_named_and_text_is_no_number) {
  EXPECT_EQ(error("gl.StencilFunc(gl.ALWAYS, {}, 1)"),
            "gl.StencilFunc: argument 2 (ref) must be an integer; it is a table");
  EXPECT_EQ(error("gl.StencilFunc(gl.ALWAYS, '1', 1)"),
            "gl.StencilFunc: argument 2 (ref) must be an integer; it is a string");
  EXPECT_EQ(error("gl.ClearDepth('1')"),
            "gl.ClearDepth: argument 1 (depth) must be a finite number; it is a string");
  EXPECT_EQ(error("gl.Clear('16384')").substr(0, 38), "gl.Clear: argument 1 (mask) must be an");
  EXPECT_EQ(error("gl.DepthMask(2)"),
            "gl.DepthMask: argument 1 (flag) must be true, false, gl.TRUE or gl.FALSE; it is 2");
  EXPECT_EQ(error("gl.StencilFunc(gl.ALWAYS, 1.5, 1)"),
            "gl.StencilFunc: argument 2 (ref) must be an integer; it is 1.5");
  EXPECT_EQ(error("gl.Viewport(0, 0, -1, 1)"),
            "gl.Viewport: argument 3 (width) must be a size: an integer that is not negative; it "
            "is -1");
  EXPECT_EQ(value("gl.StencilFunc(gl.ALWAYS, 1.0, 255.0) return gl.GetIntegerv(gl.STENCIL_REF)"),
            "1");
}

TEST_F(GlArguments, a_wrong_name_is_named_with_the_valid_ones_and_the_near_one) {
  EXPECT_EQ(error("gl.DepthFunc(gl.KEEP)"),
            "gl.DepthFunc: argument 1 (func) must be one of gl.NEVER, gl.LESS, gl.EQUAL, "
            "gl.LEQUAL, gl.GREATER, gl.NOTEQUAL, gl.GEQUAL, gl.ALWAYS; it is gl.KEEP");
  EXPECT_EQ(error("gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPEAT)"),
            "gl.StencilOp: argument 3 (dppass) must be one of gl.KEEP, gl.ZERO, gl.REPLACE, "
            "gl.INCR, gl.INCR_WRAP, gl.DECR, gl.DECR_WRAP, gl.INVERT; it is gl.REPEAT");
  EXPECT_EQ(error("gl.PolygonMode(gl.FRONT_AND_BACK, gl.LINEAR)"),
            "gl.PolygonMode: argument 2 (mode) must be one of gl.POINT, gl.LINE, gl.FILL; it is "
            "gl.LINEAR; did you mean gl.LINE?");
  EXPECT_TRUE(error("gl.DepthFunc('GL_LEQAL')").ends_with("it is a string; write gl.LEQUAL"));
  EXPECT_TRUE(error("gl.Enable(gl.DEPTH_TEST + 2^32)").find("gl.Enable: argument 1 (cap)") == 0);
}

TEST_F(GlArguments, of_several_wrong_ones_the_first_is_reported) {
  // Wrong from the last to the first, one more each time: the first wrong one is named.
  const std::pair<const char*, std::vector<std::string>> calls[] = {
      {"StencilFunc", {"gl.ALWAYS", "1", "1"}},
      {"BlitFramebuffer",
       {"0", "0", "1", "1", "0", "0", "1", "1", "gl.COLOR_BUFFER_BIT", "gl.NEAREST"}},
      {"TexImage2D",
       {"gl.TEXTURE_2D", "0", "gl.RGBA8", "4", "4", "0", "gl.RGBA", "gl.UNSIGNED_BYTE"}},
      {"TexStorage2D", {"gl.TEXTURE_2D", "1", "gl.RGBA8", "4", "4"}},
      {"ReadPixels", {"0", "0", "1", "1", "gl.RGBA", "gl.FLOAT"}},
      {"VertexAttribPointer", {"0", "4", "gl.FLOAT", "false", "0", "0"}},
      {"BufferSubData", {"gl.ARRAY_BUFFER", "0", "4", "{1}"}},
      {"DrawElements", {"gl.TRIANGLES", "3", "gl.UNSIGNED_INT", "0"}},
      {"RenderbufferStorage", {"gl.RENDERBUFFER", "gl.RGBA8", "4", "4"}},
      {"GetFramebufferAttachmentParameteriv",
       {"gl.FRAMEBUFFER", "gl.COLOR_ATTACHMENT0", "gl.FRAMEBUFFER_ATTACHMENT_RED_SIZE"}},
      {"FramebufferTexture2D",
       {"gl.FRAMEBUFFER", "gl.COLOR_ATTACHMENT0", "gl.TEXTURE_2D", "0", "0"}},
      {"ClearBufferfv", {"gl.COLOR", "0", "{0, 0, 0, 0}"}},
      {"UniformMatrix4fv", {"0", "1", "false", "mat4()"}},
      {"ClearAccum", {"0", "0", "0", "0"}},
      {"Accum", {"gl.LOAD", "1"}},
  };
  for (auto [function, arguments] : calls) {
    for (std::size_t i = arguments.size(); i-- > 0;) {
      arguments[i] = "print";
      std::string call = std::string("gl.") + function + "(";
      for (const std::string& argument : arguments) call += argument + ",";
      call.back() = ')';
      const std::string sentence = error(call);
      // What GL itself would refuse may be said before a later argument is looked at.
      const auto named = sentence.find("argument " + std::to_string(i + 1) + " ");
      const bool earlier_condition = sentence.find("argument") == std::string::npos;
      EXPECT_TRUE(named != std::string::npos || (earlier_condition && i > 0))
          << call << ": " << sentence;
    }
  }
}

TEST_F(GlArguments, numbers_are_finite_and_fit_the_types_of_gl) {
  for (const char* number : {"0/0", "1/0", "-1/0", "math.huge"}) {
    const std::string n = number;
    EXPECT_TRUE(error("gl.PolygonOffset(" + n + ", 0)").find("must be a finite number") !=
                std::string::npos);
    EXPECT_NE(error("gl.Viewport(0, 0, " + n + ", 1)").find("must be a size"), std::string::npos);
    EXPECT_NE(error("gl.ClearDepth(" + n + ")").find("must be a finite number"), std::string::npos);
    EXPECT_NE(error("gl.StencilFunc(gl.ALWAYS, " + n + ", 1)").find("must be an integer"),
              std::string::npos);
    EXPECT_NE(error("gl.ClearBufferfv(gl.COLOR, 0, {0, 0, 0, " + n + "})").find("finite"),
              std::string::npos);
  }
  EXPECT_NE(error("gl.PolygonOffset(1e39, 0)").find("finite"), std::string::npos);
  EXPECT_NE(error("gl.ClearBufferfv(gl.COLOR, 0, {0, 0, 0, 1e39})").find("finite"),
            std::string::npos);
  EXPECT_NE(error("gl.StencilFunc(gl.ALWAYS, 2^31, 1)").find("integer"), std::string::npos);
  EXPECT_NE(error("gl.StencilMask(2^32)").find("32 bits"), std::string::npos);
  EXPECT_EQ(value("gl.StencilMask(~0) return gl.GetIntegerv(gl.STENCIL_WRITEMASK) & 0xFF"), "255");
  EXPECT_EQ(value("gl.PrimitiveRestartIndex(0xFFFFFFFF)"), "nil");
}

TEST_F(GlArguments, what_gl_refuses_is_a_sentence_with_its_reason) {
  EXPECT_EQ(error("gl.LineWidth(-1)"),
            "gl.LineWidth: a number is out of the range that GL allows (GL_INVALID_VALUE)");
  EXPECT_EQ(error("gl.EndQuery(gl.SAMPLES_PASSED)"),
            "gl.EndQuery: GL does not allow this in its present state (GL_INVALID_OPERATION)");
  EXPECT_EQ(value("return gl.GetError() == gl.NO_ERROR"), "true");
}

TEST_F(GlArguments, buffers_named_in_a_table_are_checked_one_by_one) {
  EXPECT_EQ(error("gl.DrawBuffers(1, {gl.KEEP})").substr(0, 56),
            "gl.DrawBuffers: element 1 of argument 2 (bufs) must be o");
  EXPECT_EQ(error("gl.DrawBuffers(2, {gl.BACK})"), "gl.DrawBuffers: n is 2, but the table has 1");
  EXPECT_EQ(error("gl.DrawBuffers(1, gl.BACK)"),
            "gl.DrawBuffers: argument 2 (bufs) must be a table of buffers; it is gl.BACK");
  EXPECT_EQ(error("gl.NamedFramebufferDrawBuffers(0, 1, {'x'})").substr(0, 71),
            "gl.NamedFramebufferDrawBuffers: element 1 of argument 3 (bufs) must be ");
}

}  // namespace
}  // namespace shadowlab::lua
