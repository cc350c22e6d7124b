// The accumulation buffer in each of its storages, against the formulas of its numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/packing.hpp>

#include "core/error.h"
#include "gl/graphics.h"

namespace shadowlab::gl {
namespace {

constexpr GLfloat factors[] = {0, 1, 1 / 3.f, 0.125f, -0.5f, 2, 1.7f, 100, -1, 0.001f, 1 / 256.f};

class AccumulationStorage : public testing::Test {
 protected:
  static void SetUpTestSuite() { graphics_ = new Graphics(context::create(), 256, 2); }
  static void TearDownTestSuite() {
    delete graphics_;
    graphics_ = nullptr;
  }
  void SetUp() override { graphics_->begin_frame(); }

  Graphics& graphics() { return *graphics_; }
  void choose(AccumStorage storage) { graphics().accumulation.choose(storage); }
  void accum(GLenum operation, GLfloat value) { graphics().accumulation.run(operation, value); }

  // Column x of the frame is the grey x.
  void set_greys() {
    std::vector<std::uint8_t> pixels(256 * 2 * 4);
    for (std::size_t i = 0; i < pixels.size(); ++i)
      pixels[i] = static_cast<std::uint8_t>(i / 4 % 256);
    const Functions& gl = graphics().gl;
    gl.BindTexture(GL_TEXTURE_2D, graphics().frame.color());
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 256, 2, GL_RGBA, GL_UNSIGNED_BYTE,
                     std::as_bytes(std::span(pixels)));
    gl.BindTexture(GL_TEXTURE_2D, 0);
  }

  // What is accumulated in the red channel of the lowest row.
  template <class T>
  std::array<T, 256> accumulated(GLenum format, GLenum type) {
    std::array<T, 256> values{};
    std::vector<T> all(256 * 2);
    const Functions& gl = graphics().gl;
    gl.BindTexture(GL_TEXTURE_2D, graphics().accumulation.texture());
    gl.GetTexImage(GL_TEXTURE_2D, 0, format, type, std::as_writable_bytes(std::span(all)));
    gl.BindTexture(GL_TEXTURE_2D, 0);
    std::copy_n(all.begin(), 256, values.begin());
    return values;
  }
  std::array<GLint, 256> integers() { return accumulated<GLint>(GL_RED_INTEGER, GL_INT); }
  std::array<GLfloat, 256> floats() { return accumulated<GLfloat>(GL_RED, GL_FLOAT); }

 private:
  static inline Graphics* graphics_ = nullptr;
};

TEST_F(AccumulationStorage, snorm8_truncates_to_127ths_and_wraps_at_8_bits) {
  choose(AccumStorage::snorm8);
  for (const GLfloat factor : factors) {
    set_greys();
    accum(GL_LOAD, factor);
    accum(GL_ACCUM, 0.5f);
    const auto got = integers();
    for (int grey = 0; grey < 256; ++grey) {
      const GLfloat color = static_cast<GLfloat>(grey) * (1 / 255.f);
      const int loaded = static_cast<std::int8_t>(static_cast<int>(color * (factor * 127)));
      const int added = static_cast<int>(color * (0.5f * 127));
      EXPECT_EQ(got[static_cast<std::size_t>(grey)], static_cast<std::int8_t>(loaded + added))
          << grey << " × " << factor;
    }
  }
}

TEST_F(AccumulationStorage, snorm8_adds_multiplies_and_returns) {
  choose(AccumStorage::snorm8);
  set_greys();
  accum(GL_LOAD, 1);
  accum(GL_ADD, 0.25f);   // 31 units
  accum(GL_MULT, -1.5f);  // wraps around past 85 units
  const auto got = integers();
  accum(GL_RETURN, -1);
  const auto picture = graphics().frame.read_color();
  for (int grey = 0; grey < 256; ++grey) {
    const auto x = static_cast<std::size_t>(grey);
    const int loaded = static_cast<int>(static_cast<GLfloat>(grey) * (1 / 255.f) * 127.f);
    const int sum = static_cast<std::int8_t>(loaded + 31);
    const int product =
        static_cast<std::int8_t>(static_cast<int>(static_cast<GLfloat>(sum) * -1.5f));
    ASSERT_EQ(got[x], product) << grey;
    const GLfloat back = std::clamp(static_cast<GLfloat>(product) * (-1 / 127.f), 0.f, 1.f);
    EXPECT_EQ(picture.rgba[x * 4], static_cast<int>(std::nearbyint(back * 255))) << grey;
  }
}

TEST_F(AccumulationStorage, float32_is_the_sum_within_the_rounding_of_each_step) {
  choose(AccumStorage::float32);
  for (const GLfloat factor : factors) {
    set_greys();
    accum(GL_LOAD, factor);
    accum(GL_ACCUM, 0.3f);
    accum(GL_ADD, -0.7f);
    accum(GL_MULT, 1.1f);
    const auto got = floats();
    for (int grey = 0; grey < 256; ++grey) {
      // Eight roundings of 24 bits: two of the sampler's colour, three products, two sums and the
      // last product; none exceeds the first product and 1.
      const double color = grey / 255.0;
      const double exact = (color * factor + color * 0.3f - 0.7f) * 1.1f;
      EXPECT_NEAR(got[static_cast<std::size_t>(grey)], exact,
                  8 * std::ldexp(1.0 + std::abs(color * factor), -24))
          << grey << " × " << factor;
    }
  }
}

TEST_F(AccumulationStorage, float16_is_the_sum_rounded_to_11_bits_each_time) {
  choose(AccumStorage::float16);
  for (const GLfloat factor : factors) {
    set_greys();
    accum(GL_LOAD, factor);
    accum(GL_ACCUM, 0.3f);
    const auto got = floats();
    for (int grey = 0; grey < 256; ++grey) {
      const GLfloat value = got[static_cast<std::size_t>(grey)];
      EXPECT_EQ(value, glm::unpackHalf1x16(glm::packHalf1x16(value))) << "it is a half";
      const double color = grey / 255.0;
      // Two roundings of 11 bits, each by at most a unit in the last place (OpenGL 4.5, section
      // 2.3.4.1, leaves the direction to the driver), subnormal below 2^-14.
      const double sum = std::abs(color * factor) + std::abs(color * 0.3);
      EXPECT_NEAR(value, color * factor + color * 0.3f,
                  2 * std::ldexp(sum, -10) + std::ldexp(1, -24))
          << grey << " × " << factor;
    }
  }
}

TEST_F(AccumulationStorage, floats_neither_clamp_nor_wrap_until_they_return) {
  for (const AccumStorage storage : {AccumStorage::float16, AccumStorage::float32}) {
    choose(storage);
    set_greys();
    accum(GL_ACCUM, 1);
    accum(GL_ACCUM, 1);
    accum(GL_RETURN, 0.5f);
    const auto picture = graphics().frame.read_color();
    for (std::size_t x = 0; x < 256; ++x) EXPECT_EQ(picture.rgba[x * 4], x) << name_of(storage);
    accum(GL_RETURN, 1);
    EXPECT_EQ(graphics().frame.read_color().rgba[200 * 4], 255);
  }
}

TEST_F(AccumulationStorage, float16_loses_what_float32_keeps_of_1024_samples) {
  // A grey of 200 added 1024 times by 1/1024: halves near 0.7 lie 2^-11 apart, a half of what is
  // added each time there; floats lose less than a level.
  const auto returned = [&](AccumStorage storage) {
    choose(storage);
    set_greys();
    accum(GL_LOAD, 0);
    for (int i = 0; i < 1024; ++i) accum(GL_ACCUM, 1 / 1024.f);
    accum(GL_RETURN, 1);
    return int{graphics().frame.read_color().rgba[200 * 4]};
  };
  EXPECT_EQ(returned(AccumStorage::float32), 200);
  EXPECT_LT(returned(AccumStorage::float16), 200);
  // N · trunc(32767 · c / N) / 32767: 25 of 25.09 units each time.
  EXPECT_EQ(returned(AccumStorage::snorm16), std::lround(1024 * 25 / 32767.0 * 255));
}

TEST_F(AccumulationStorage, is_zero_when_it_is_new_and_when_its_storage_changes) {
  set_greys();
  accum(GL_LOAD, 1);
  for (const AccumStorage storage : {AccumStorage::float32, AccumStorage::snorm8,
                                     AccumStorage::float16, AccumStorage::snorm16}) {
    choose(storage);
    accum(GL_RETURN, 1);
    EXPECT_EQ(graphics().frame.read_color(), image::Image(256, 2, {0, 0, 0, 0}))
        << name_of(storage);
    set_greys();
    accum(GL_LOAD, 1);
  }
}

TEST_F(AccumulationStorage, keeps_its_content_when_the_same_storage_is_chosen_again) {
  choose(AccumStorage::float32);
  set_greys();
  accum(GL_LOAD, 1);
  choose(AccumStorage::float32);
  EXPECT_NEAR(floats()[255], 1, 1e-6);
}

TEST_F(AccumulationStorage, belongs_to_the_main_frame_alone) {
  const Functions& gl = graphics().gl;
  std::array<GLuint, 1> frame{};
  gl.GenFramebuffers(1, frame);
  for (const GLenum target : {GL_DRAW_FRAMEBUFFER, GL_READ_FRAMEBUFFER, GL_FRAMEBUFFER}) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.BindFramebuffer(target, frame[0]);
    EXPECT_THROW(accum(GL_LOAD, 1), InputError);
    // What was bound still is.
    GLint bound = 0;
    gl.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, {&bound, 1});
    EXPECT_EQ(static_cast<GLuint>(bound) == frame[0], target != GL_DRAW_FRAMEBUFFER);
  }
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  set_greys();
  accum(GL_LOAD, 1);
  // A framebuffer object has no accumulation buffer, so its Clear leaves the main frame's alone.
  gl.BindFramebuffer(GL_FRAMEBUFFER, frame[0]);
  graphics().accumulation.clear();
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  EXPECT_EQ(integers()[255], 32767);
  gl.DeleteFramebuffers(1, frame);
}

TEST_F(AccumulationStorage, is_refused_inside_a_query_that_would_count_it) {
  const Functions& gl = graphics().gl;
  std::array<GLuint, 1> query{};
  gl.GenQueries(1, query);
  gl.BeginQuery(GL_SAMPLES_PASSED, query[0]);
  EXPECT_THROW(accum(GL_LOAD, 1), InputError);
  gl.EndQuery(GL_SAMPLES_PASSED);
  EXPECT_NO_THROW(accum(GL_LOAD, 1));
  gl.DeleteQueries(1, query);
}

TEST(AccumStorageNames, are_read_back) {
  for (const char* name : {"snorm8", "snorm16", "float16", "float32"})
    EXPECT_STREQ(name_of(accum_storage_named(name)), name);
  EXPECT_THROW(accum_storage_named("snorm32"), InputError);
}

}  // namespace
}  // namespace shadowlab::gl
