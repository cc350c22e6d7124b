// Buffers and draws: nothing is read past an end.
#include "gl_fixture.h"

namespace shadowlab::lua {
namespace {

using GlBuffers = GlScript;
using GlDraws = GlScript;

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

}  // namespace
}  // namespace shadowlab::lua
