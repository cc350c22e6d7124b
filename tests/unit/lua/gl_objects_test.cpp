// Objects and textures: what GL itself would leave to the driver.
#include "gl_fixture.h"

namespace shadowlab::lua {
namespace {

using GlObjects = GlScript;
using GlTextures = GlScript;

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
       {"gl.TexImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, 4096, 4096, 0, gl.RED, gl.FLOAT)",
        "gl.TexImage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, 2048, 2048, 0, gl.RED, gl.FLOAT)",
        "gl.TexStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, 4096, 4096)",
        "gl.CopyTexImage2D(gl.TEXTURE_2D, 6, gl.RGBA32F, 0, 0, 64, 64, 0)"}) {
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
  EXPECT_EQ(stage().objects.bytes(), 4096ull * 4096 * 4 * 4 / 3);
}

TEST_F(GlTextures, count_the_bytes_of_their_format) {
  run("gl.BindTexture(gl.TEXTURE_2D, gl.GenTextures(1)) "
      "gl.TexStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT24, 60, 32)");
  EXPECT_EQ(stage().objects.bytes(), 60ull * 32 * 4 * 4 / 3);
  run("gl.BindTexture(gl.TEXTURE_2D, gl.GenTextures(1)) "
      "gl.TexStorage2D(gl.TEXTURE_2D, 1, gl.RGBA16F, 60, 32)");
  EXPECT_EQ(stage().objects.bytes(), 60ull * 32 * (4 + 8) * 4 / 3);
  run("gl.BindRenderbuffer(gl.RENDERBUFFER, gl.GenRenderbuffers(1)) "
      "gl.RenderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, 60, 32)");
  EXPECT_EQ(stage().objects.bytes(), 60ull * 32 * (4 + 8) * 4 / 3 + 60 * 32 * 4);
}

}  // namespace
}  // namespace shadowlab::lua
