// Objects, sizes and reaches: what GL itself would leave to the driver.
#include "gl_fixture.h"

namespace shadowlab::lua {
namespace {

using GlObjects = GlScript;
using GlTextures = GlScript;
using GlBuffers = GlScript;
using GlDraws = GlScript;
using GlFrames = GlScript;
using GlQueries = GlScript;

// ---- objects

TEST_F(GlObjects, are_values_with_a_name_and_no_number) {
  EXPECT_EQ(value("return tostring((gl.GenTextures(1)))").substr(0, 8), "texture ");
  EXPECT_EQ(value("local a, b = gl.GenBuffers(2) return a == a and a ~= b"), "true");
  EXPECT_EQ(error("return gl.GenTextures(1) + 1").find("attempt to perform arithmetic"), 0u);
  EXPECT_EQ(value("return getmetatable(gl.GenTextures(1))"), "false");
}

TEST_F(GlObjects, of_another_kind_and_bare_integers_are_refused) {
  EXPECT_EQ(error("gl.BindTexture(gl.TEXTURE_2D, gl.GenBuffers(1))"),
            "gl.BindTexture: argument 2 (texture) must be a texture, or 0 for none; it is a "
            "buffer");
  EXPECT_EQ(error("gl.BindTexture(gl.TEXTURE_2D, 1)"),
            "gl.BindTexture: argument 2 (texture) must be a texture, or 0 for none; it is 1");
  EXPECT_EQ(error("gl.BindFramebuffer(gl.FRAMEBUFFER, nil)"),
            "gl.BindFramebuffer: argument 2 (framebuffer) must be a framebuffer, or 0 for the main "
            "frame; it is nil");
  EXPECT_EQ(error("gl.UseProgram(shader.load 'flat')"),
            "gl.UseProgram: argument 1 (program) must be a program, or 0 for none; it is a "
            "shader");
}

TEST_F(GlObjects, deleted_are_refused_also_when_their_place_is_taken_again) {
  EXPECT_EQ(error("local t = gl.GenTextures(1) gl.DeleteTextures(1, t) "
                  "local other = gl.GenTextures(1) gl.BindTexture(gl.TEXTURE_2D, t)"),
            "gl.BindTexture: argument 2 is a texture that was deleted");
}

TEST_F(GlObjects, deleted_twice_and_0_are_ignored_as_gl_ignores_them) {
  run("local a, b = gl.GenTextures(2) gl.DeleteTextures(1, a) gl.DeleteTextures(1, a) "
      "gl.DeleteTextures(3, {b, b, 0}) gl.DeleteTextures(2, 0, a) gl.DeleteTextures(0, {})");
  run("local s = gl.CreateShader(gl.VERTEX_SHADER) gl.DeleteShader(s) gl.DeleteShader(s) "
      "gl.DeleteShader(0) gl.DeleteProgram(0)");
  EXPECT_EQ(error("gl.DeleteTextures(2, 0)"), "gl.DeleteTextures: n is 2, but 1 object is given");
}

TEST_F(GlObjects, are_limited_in_number_and_count_again_when_deleted) {
  EXPECT_EQ(error("for i = 1, 100 do gl.GenQueries(1000) end").find("more than 65536 GL objects"),
            0u);
  stop();
  start({});
  run("for i = 1, 200 do gl.DeleteSamplers(1000, {gl.GenSamplers(1000)}) end");
  EXPECT_NE(error("gl.GenBuffers(1025)").find("0 to 1024"), std::string::npos);
}

TEST_F(GlObjects, of_a_recipe_are_gone_when_it_is_and_those_of_another_stay) {
  State other_state({}, [](std::string_view) {});
  Stage other{other_state, graphics(), nullptr, {}, {}};
  open_all(other);
  const GLuint texture = [&] {
    GLuint name = 0;
    graphics().gl.GenTextures(1, {&name, 1});
    push_object(other, other_state.raw(), gl::ObjectType::texture, name);
    graphics().gl.BindTexture(GL_TEXTURE_2D, name);
    return name;
  }();
  run(covering_triangle);
  EXPECT_EQ(stage().objects.bytes(), 48u);
  graphics().forget(stage().objects);
  EXPECT_EQ(stage().objects.bytes(), 0u);
  EXPECT_TRUE(graphics().gl.IsTexture(texture));
  EXPECT_EQ(error("gl.BindBuffer(gl.ARRAY_BUFFER, corners)"),
            "gl.BindBuffer: argument 2 is a buffer that was deleted");
  graphics().forget(other.objects);
  EXPECT_FALSE(graphics().gl.IsTexture(texture));
}

// ---- textures

TEST_F(GlTextures, need_one_bound_for_what_changes_it) {
  for (const char* call :
       {"TexImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 1, 1, 0, gl.RGBA, gl.FLOAT)",
        "TexSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 1, 1, gl.RGBA, gl.FLOAT, {0,0,0,0})",
        "TexStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, 1, 1)",
        "TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST)",
        "TexParameterf(gl.TEXTURE_2D, gl.TEXTURE_LOD_BIAS, 1)",
        "TexParameterfv(gl.TEXTURE_2D, gl.TEXTURE_BORDER_COLOR, {0,0,0,0})"}) {
    const std::string name(call, std::string_view(call).find('('));
    EXPECT_EQ(error(std::string("gl.") + call),
              "gl." + name + ": no texture is bound to this target; call gl.BindTexture first");
  }
}

TEST_F(GlTextures, take_exactly_the_numbers_of_their_size) {
  run("gl.BindTexture(gl.TEXTURE_2D, gl.GenTextures(1))");
  const std::string image = "gl.TexImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 3, 3, 0, gl.RGB, ";
  EXPECT_EQ(error(image + "gl.UNSIGNED_BYTE, {1, 2, 3})"),
            "gl.TexImage2D: pixels has 3 bytes; this size, format and type take 27");
  EXPECT_EQ(error(image + "gl.FLOAT, string.rep('x', 107))"),
            "gl.TexImage2D: pixels has 107 bytes; this size, format and type take 108");
  EXPECT_EQ(error(image + "gl.UNSIGNED_BYTE, '')"),
            "gl.TexImage2D: pixels has 0 bytes; this size, format and type take 27");
  run(image + "gl.UNSIGNED_BYTE, string.rep('x', 27))");
  run(image + "gl.UNSIGNED_BYTE, nil)");
  run(image + "gl.UNSIGNED_BYTE)");
  EXPECT_NE(error("gl.TexSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 1, 1, gl.RGB, gl.FLOAT, nil)")
                .find("argument 9 (pixels)"),
            std::string::npos);
}

TEST_F(GlTextures, refuse_numbers_that_their_type_does_not_hold) {
  run("gl.BindTexture(gl.TEXTURE_2D, gl.GenTextures(1))");
  const std::string image = "gl.TexImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 1, 1, 0, gl.RED, ";
  EXPECT_EQ(error(image + "gl.UNSIGNED_BYTE, {256})"),
            "gl.TexImage2D: element 1 of argument 9 is 256, which is not an integer from 0 to 255");
  EXPECT_EQ(error(image + "gl.BYTE, {127.5})"),
            "gl.TexImage2D: element 1 of argument 9 is 127.5, which is not an integer from -128 to "
            "127");
  EXPECT_EQ(error(image + "gl.FLOAT, {-1e39})"),
            "gl.TexImage2D: element 1 of argument 9 is -1e+39, which is not a finite float");
  EXPECT_EQ(error(image + "gl.FLOAT, {0/0})"),
            "gl.TexImage2D: argument 9 (pixels) must be finite numbers; it is a table");
}

TEST_F(GlTextures, keep_their_rows_together_whatever_the_alignment) {
  // Three bytes a row, no padding: GL's own default would read past the end.
  run("gl.BindTexture(gl.TEXTURE_2D, gl.GenTextures(1)) "
      "gl.TexImage2D(gl.TEXTURE_2D, 0, gl.RGB8, 1, 4, 0, gl.RGB, gl.UNSIGNED_BYTE, "
      "{1,2,3, 4,5,6, 7,8,9, 10,11,12})");
  std::array<std::uint8_t, 16> pixels{};
  graphics().gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                            std::as_writable_bytes(std::span(pixels)));
  EXPECT_EQ(pixels, (std::array<std::uint8_t, 16>{1, 2, 3, 255, 4, 5, 6, 255, 7, 8, 9, 255, 10, 11,
                                                  12, 255}));
}

TEST_F(GlTextures, of_huge_sizes_are_refused_before_gl_sees_them) {
  run("gl.BindTexture(gl.TEXTURE_2D, gl.GenTextures(1)) "
      "gl.BindTexture(gl.TEXTURE_3D, gl.GenTextures(1))");
  const std::string most = "2147483647";
  EXPECT_EQ(error("gl.TexImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, " + most + ", " + most +
                  ", 0, gl.RGBA, gl.FLOAT, '')"),
            "gl.TexImage2D: a texture is at most 16384 texels wide, high and deep");
  // Sizes whose bytes are 2^64 and more, which is 0 in 64 bits.
  EXPECT_NE(error("gl.TexImage2D(gl.TEXTURE_2D, 1, gl.RGBA8, 2^30, 2^30, 0, gl.RGBA, gl.FLOAT, '')")
                .find("at most 16384"),
            std::string::npos);
  EXPECT_NE(error("gl.TexSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 2^30, 2^30, gl.RGBA, gl.FLOAT, '')")
                .find("at most 16384"),
            std::string::npos);
  EXPECT_NE(error("gl.TexImage3D(gl.TEXTURE_3D, 0, gl.RGBA8, 16384, 16384, 16384, 0, gl.RGBA, "
                  "gl.FLOAT)")
                .find("GL memory"),
            std::string::npos);
  run("gl.BindRenderbuffer(gl.RENDERBUFFER, gl.GenRenderbuffers(1))");
  EXPECT_NE(
      error("gl.RenderbufferStorage(gl.RENDERBUFFER, gl.RGBA8, 2^30, 2^30)").find("at most 16384"),
      std::string::npos);
  EXPECT_NE(error("gl.RenderbufferStorageMultisample(gl.RENDERBUFFER, 2^30, gl.RGBA8, 4, 4)")
                .find("at most 64 samples"),
            std::string::npos);
  EXPECT_NE(error("gl.ReadPixels(0, 0, 2^31-1, 2^31-1, gl.RGBA, gl.FLOAT)").find("16 million"),
            std::string::npos);
}

TEST_F(GlTextures, count_against_the_memory_of_the_recipe_whichever_level_is_large) {
  // 4096² of 16 bytes with their mipmaps are 341 MiB: the fourth is too much.
  for (const char* image :
       {"gl.TexImage2D(gl.TEXTURE_2D, 0, gl.R8, 4096, 4096, 0, gl.RED, gl.FLOAT)",
        "gl.TexImage2D(gl.TEXTURE_2D, 1, gl.R8, 2048, 2048, 0, gl.RED, gl.FLOAT)",
        "gl.TexStorage2D(gl.TEXTURE_2D, 1, gl.R8, 4096, 4096)",
        "gl.CopyTexImage2D(gl.TEXTURE_2D, 1, gl.R8, 0, 0, 2048, 2048, 0)"}) {
    const std::string chunk = std::string(
                                  "for i = 1, 4 do gl.BindTexture(gl.TEXTURE_2D, "
                                  "gl.GenTextures(1)) made = i ") +
                              image + " end";
    EXPECT_NE(error(chunk).find("this texture would bring the recipe's GL memory to 1365 MiB"),
              std::string::npos)
        << image;
    EXPECT_EQ(value("return made"), "4") << image;
    stop();
    start({});
  }
  // A small level afterwards does not make the large one forgotten.
  run("gl.BindTexture(gl.TEXTURE_2D, gl.GenTextures(1)) "
      "gl.TexImage2D(gl.TEXTURE_2D, 1, gl.R8, 2048, 2048, 0, gl.RED, gl.FLOAT) "
      "gl.TexImage2D(gl.TEXTURE_2D, 0, gl.R8, 1, 1, 0, gl.RED, gl.FLOAT)");
  EXPECT_EQ(stage().objects.bytes(), 4096ull * 4096 * 16 * 4 / 3);
}

// ---- buffers

TEST_F(GlBuffers, need_one_bound_and_an_array_for_indices) {
  EXPECT_EQ(error("gl.BufferData(gl.ARRAY_BUFFER, 4, nil, gl.STATIC_DRAW)"),
            "gl.BufferData: no buffer is bound to this target; call gl.BindBuffer first");
  EXPECT_EQ(error("gl.BindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.GenBuffers(1))"),
            "gl.ELEMENT_ARRAY_BUFFER belongs to a vertex array; call gl.BindVertexArray first");
  EXPECT_EQ(error("gl.VertexAttribPointer(0, 4, gl.FLOAT, false, 0, 0)"),
            "gl.VertexAttribPointer needs a vertex array; call gl.BindVertexArray first");
}

TEST_F(GlBuffers, take_exactly_the_bytes_that_are_announced) {
  run("gl.BindBuffer(gl.ARRAY_BUFFER, gl.GenBuffers(1))");
  EXPECT_EQ(error("gl.BufferData(gl.ARRAY_BUFFER, 8, {1}, gl.STATIC_DRAW)"),
            "gl.BufferData: size is 8, but the data has 4 bytes");
  EXPECT_NE(error("gl.BufferData(gl.ARRAY_BUFFER, 2^28 + 1, nil, gl.STATIC_DRAW)").find("256 MiB"),
            std::string::npos);
  run("gl.BufferData(gl.ARRAY_BUFFER, 8, {1, 2}, gl.STATIC_DRAW)");
  EXPECT_EQ(error("gl.BufferSubData(gl.ARRAY_BUFFER, 5, 4, {1})"),
            "bytes 5 to 9 do not fit into the buffer of 8");
  run("gl.BufferSubData(gl.ARRAY_BUFFER, 4, 4, {1})");
}

// ---- draws

TEST_F(GlDraws, need_a_program_and_a_vertex_array) {
  EXPECT_EQ(error("gl.DrawArrays(gl.TRIANGLES, 0, 3)"),
            "gl.DrawArrays: no program is in use; call gl.UseProgram or shader:use first");
  run(fill_program);
  EXPECT_EQ(error("gl.DrawArrays(gl.TRIANGLES, 0, 3)"),
            "a draw needs a vertex array; call gl.BindVertexArray first");
}

class GlReach : public GlScript {
 protected:
  void SetUp() override {
    GlScript::SetUp();
    run(fill_program);
    run(covering_triangle);
    run("gl.Uniform4f(gl.GetUniformLocation(program, 'color'), 1, 0, 0, 1)");
  }
  std::array<std::uint8_t, 4> corner() { return graphics().frame.read_color().at(0, 0); }
};

TEST_F(GlReach, draws_what_its_buffers_hold) {
  run("gl.DrawArrays(gl.TRIANGLES, 0, 3)");
  EXPECT_EQ(corner(), (std::array<std::uint8_t, 4>{255, 0, 0, 255}));
}

TEST_F(GlReach, ends_at_the_end_of_an_attributes_buffer) {
  const std::string past =
      "vertex 3 of attribute 0 ends at byte 64, past its buffer's 48 bytes; "
      "draw fewer vertices or upload more";
  EXPECT_EQ(error("gl.DrawArrays(gl.TRIANGLES, 0, 4)"), past);
  EXPECT_EQ(error("gl.DrawArrays(gl.TRIANGLES, 3, 1)"), past);
  EXPECT_EQ(error("gl.DrawArraysInstanced(gl.TRIANGLES, 0, 4, 2)"), past);
  EXPECT_NE(error("gl.DrawArrays(gl.TRIANGLES, 2^31-1, 1)").find("past its buffer's"),
            std::string::npos);
  EXPECT_EQ(error("gl.DrawArrays(gl.TRIANGLES, -1, 1)"), "the first vertex is not negative");
  EXPECT_EQ(error("gl.DrawArrays(gl.TRIANGLES, 0, 2^31-1)"),
            "gl.DrawArrays: draws at most 50 million vertices");
  run("gl.DrawArrays(gl.TRIANGLES, 3, 0)");
  run("gl.VertexAttribPointer(0, 4, gl.FLOAT, false, 16, 32)");
  EXPECT_NE(
      error("gl.DrawArrays(gl.TRIANGLES, 0, 2)").find("vertex 1 of attribute 0 ends at byte 64"),
      std::string::npos);
  run("gl.BufferData(gl.ARRAY_BUFFER, 16, nil, gl.STATIC_DRAW)");
  EXPECT_NE(error("gl.DrawArrays(gl.TRIANGLES, 0, 1)").find("past its buffer's 16 bytes"),
            std::string::npos);
}

TEST_F(GlReach, ends_at_the_end_of_the_indices_and_of_what_they_name) {
  run("gl.BindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.GenBuffers(1)) "
      "gl.BufferData(gl.ELEMENT_ARRAY_BUFFER, 16, {0, 1, 2, 3}, gl.STATIC_DRAW)");
  run("gl.DrawElements(gl.TRIANGLES, 3, gl.UNSIGNED_INT, 0)");
  EXPECT_EQ(corner(), (std::array<std::uint8_t, 4>{255, 0, 0, 255}));
  EXPECT_NE(error("gl.DrawElements(gl.TRIANGLES, 4, gl.UNSIGNED_INT, 0)").find("vertex 3 of"),
            std::string::npos);
  EXPECT_EQ(error("gl.DrawElements(gl.TRIANGLES, 5, gl.UNSIGNED_INT, 0)"),
            "5 indices from byte 0 end past the buffer's 16 bytes");
  EXPECT_EQ(error("gl.DrawElements(gl.TRIANGLES, 3, gl.UNSIGNED_INT, 8)"),
            "3 indices from byte 8 end past the buffer's 16 bytes");
  EXPECT_EQ(error("gl.DrawElements(gl.TRIANGLES, 1, gl.UNSIGNED_INT, 17)"),
            "1 indices from byte 17 end past the buffer's 16 bytes");
}

TEST_F(GlReach, counts_no_vertex_for_the_index_that_restarts_a_primitive) {
  run("gl.BindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.GenBuffers(1)) "
      "gl.BufferData(gl.ELEMENT_ARRAY_BUFFER, 16, {0, 1, 0xFFFFFFFF, 2}, gl.STATIC_DRAW)");
  const char* draw = "gl.DrawElements(gl.TRIANGLE_STRIP, 4, gl.UNSIGNED_INT, 0)";
  EXPECT_NE(error(draw).find("vertex 4294967295"), std::string::npos);
  run("gl.Enable(gl.PRIMITIVE_RESTART) gl.PrimitiveRestartIndex(0xFFFFFFFF)");
  run(draw);
}

TEST_F(GlReach, follows_gl_and_not_a_call_that_was_refused) {
  // GL keeps the pointer with the wide stride: the refused ones must not be what is checked.
  run("gl.VertexAttribPointer(0, 4, gl.FLOAT, false, 2048, 0)");
  EXPECT_NE(error("gl.VertexAttribPointer(0, 1, gl.FLOAT, 'x', 0, 0)").find("argument 4"),
            std::string::npos);
  EXPECT_EQ(error("gl.VertexAttribPointer(0, 1, gl.FLOAT, false, 2049, 0)"),
            "the stride of an attribute is at most 2048 bytes");
  EXPECT_EQ(error("gl.VertexAttribPointer(0, 5, gl.FLOAT, false, 0, 0)"),
            "an attribute has 1 to 4 components");
  EXPECT_NE(
      error("gl.VertexAttribPointer(16, 4, gl.FLOAT, false, 0, 0)").find("argument 1 (index)"),
      std::string::npos);
  EXPECT_NE(error("gl.DrawArrays(gl.TRIANGLES, 0, 2)").find("ends at byte 2064"),
            std::string::npos);
}

TEST_F(GlReach, loses_a_deleted_buffer_even_if_its_name_is_given_out_again) {
  run("gl.BindVertexArray(0) gl.DeleteBuffers(1, corners) "
      "local new = gl.GenBuffers(1) gl.BindBuffer(gl.ARRAY_BUFFER, new) "
      "gl.BufferData(gl.ARRAY_BUFFER, 100000, nil, gl.STATIC_DRAW) gl.BindVertexArray(vertices)");
  EXPECT_NE(error("gl.DrawArrays(gl.TRIANGLES, 0, 100)").find("past its buffer's 0 bytes"),
            std::string::npos);
}

TEST_F(GlReach, leaves_the_arrays_of_meshes_alone) {
  // A mesh's draw binds its own vertex array; nothing of the script's may change that one.
  run("mesh.quad():draw(shader.load 'flat', {})");
  EXPECT_EQ(error("gl.EnableVertexAttribArray(3)"),
            "this needs a vertex array; call gl.BindVertexArray first");
  EXPECT_NE(error("gl.BindBuffer(gl.ELEMENT_ARRAY_BUFFER, corners)").find("gl.BindVertexArray"),
            std::string::npos);
  EXPECT_NE(error("gl.DrawArrays(gl.TRIANGLES, 0, 3)").find("gl.BindVertexArray"),
            std::string::npos);
  run("gl.UseProgram(program) gl.BindVertexArray(vertices) gl.DrawArrays(gl.TRIANGLES, 0, 3)");
  EXPECT_EQ(corner(), (std::array<std::uint8_t, 4>{255, 0, 0, 255}));
}

// ---- framebuffers

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
