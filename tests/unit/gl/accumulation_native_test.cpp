// The accumulation buffer against Mesa's own glAccum, bit for bit.
//
// Native OSMesa contexts have a default framebuffer with a 16-bit accumulation buffer. Both sides
// are given the same 256 colours and the same operations; what RETURN gives back must be equal.
#include <gtest/gtest.h>

#include <random>

#include "gl/graphics.h"
#include "gl/state.h"

namespace shadowlab::gl {
namespace {

constexpr int width = 256, height = 16;
constexpr std::size_t bytes = std::size_t{width} * height * 4;
using Pixels = std::vector<std::uint8_t>;

class NativeAccumulation : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    graphics_ =
        new Graphics(context::create(context::Backend::osmesa, {width, height}), width, height);
  }
  static void TearDownTestSuite() {
    delete graphics_;
    graphics_ = nullptr;
  }

  void SetUp() override {
    ASSERT_EQ(graphics_->context().accum_bits, 16);
    graphics_->begin_frame();
    load(bind_native_, "glBindFramebuffer");
    load(accum_, "glAccum");
    load(clear_accum_, "glClearAccum");
    load(clear_, "glClear");
    both(GL_LOAD, 0);
    set_colors(0);
  }

  Graphics& graphics() { return *graphics_; }
  const Functions& gl() { return graphics_->gl; }

  // Runs `calls` with the native framebuffer bound, then binds the main frame again.
  template <class Calls>
  void natively(Calls calls) {
    bind_native_(GL_FRAMEBUFFER, 0);
    calls();
    gl().BindFramebuffer(GL_FRAMEBUFFER, 0);
  }

  void both(GLenum operation, GLfloat value) {
    natively([&] { accum_(operation, value); });
    graphics().accumulation.run(operation, value);
  }

  void clear_both(std::array<GLfloat, 4> value) {
    natively([&] {
      clear_accum_(value[0], value[1], value[2], value[3]);
      clear_(GL_ACCUM_BUFFER_BIT);
    });
    graphics().accumulation.set_clear_value(value);
    graphics().accumulation.clear();
  }

  // All 256 values in every channel of every row, in an order that `seed` turns.
  void set_colors(unsigned seed) {
    Pixels pixels(bytes);
    for (std::size_t i = 0; i < pixels.size(); ++i)
      pixels[i] = static_cast<std::uint8_t>(i / 4 * (2 * seed + 1) + i % 4 * 67 + seed);
    const SavedState saved(gl());
    gl().BindTexture(GL_TEXTURE_2D, graphics().frame.color());
    gl().TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE,
                       std::as_bytes(std::span(pixels)));
    // A blit between RGBA8 buffers copies bytes; ours is the one to read.
    gl().BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    bind_native_(GL_DRAW_FRAMEBUFFER, 0);
    gl().BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl().BindFramebuffer(GL_FRAMEBUFFER, 0);
    expect_equal("the colours to begin with");
  }

  Pixels read() {
    Pixels pixels(bytes);
    gl().ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE,
                    std::as_writable_bytes(std::span(pixels)));
    return pixels;
  }

  testing::AssertionResult equal() {
    const Pixels ours = read();
    Pixels native;
    natively([&] { native = read(); });
    for (std::size_t i = 0; i < bytes; ++i) {
      if (ours[i] != native[i]) {
        return testing::AssertionFailure()
               << "pixel " << i / 4 % width << ", " << i / 4 / width << " channel " << i % 4
               << ": ours " << int{ours[i]} << ", native " << int{native[i]};
      }
    }
    return testing::AssertionSuccess();
  }
  void expect_equal(const std::string& what) { EXPECT_TRUE(equal()) << what; }

  // Adds to both exactly this many units of 1/32767.
  void add_units(int units) { both(GL_ADD, (static_cast<float>(units) + 0.5f) / 32767.0f); }

  // What is accumulated, to its last bit: RETURN tells units apart only near 0, so the values are
  // moved past it, each row beginning elsewhere on their circle.
  void expect_all_bits_equal(const std::string& what) {
    constexpr int step = 128, row_step = 65536 / height;
    gl().Enable(GL_SCISSOR_TEST);
    for (int row = 1; row < height; ++row) {
      gl().Scissor(0, row, width, height - row);
      add_units(row_step);
    }
    gl().Disable(GL_SCISSOR_TEST);
    for (int moved = 0; moved < row_step; moved += step) {
      both(GL_RETURN, 200.0f);  // 1.56 levels a unit, up to 164 units
      ASSERT_TRUE(equal()) << what << ", moved by " << moved;
      add_units(step);
    }
  }

 private:
  template <class F>
  void load(F& pointer, const char* name) {
    pointer = reinterpret_cast<F>(graphics_->context().function(name));
    ASSERT_TRUE(pointer) << name;
  }

  static inline Graphics* graphics_ = nullptr;
  void (*bind_native_)(GLenum, GLuint) = nullptr;
  void (*accum_)(GLenum, GLfloat) = nullptr;
  void (*clear_accum_)(GLfloat, GLfloat, GLfloat, GLfloat) = nullptr;
  void (*clear_)(GLbitfield) = nullptr;
};

// Thirds and tenths are no floats, 1/32767 is one unit, 2 and 100 wrap around, 70000 and 1e10
// exceed 32 bits once scaled.
constexpr GLfloat values[] = {0,     1,        1.0f / 3, 0.125f,      -0.5f,  2,       1.7f,
                              100,   -1,       0.1f,     1 / 32767.f, 1e-6f,  -1e-6f,  0.999f,
                              -3.3f, 1 / 16.f, 255.0f,   -100,        70000., -70000., 1e10f};

TEST_F(NativeAccumulation, accumulates_every_colour_times_every_value) {
  for (const GLfloat value : values) {
    both(GL_LOAD, 0);
    set_colors(1);
    both(GL_ACCUM, value);
    set_colors(3);
    both(GL_ACCUM, 0.5f);
    expect_all_bits_equal("ACCUM " + std::to_string(value));
  }
}

TEST_F(NativeAccumulation, loads_every_colour_times_every_value) {
  for (const GLfloat value : values) {
    set_colors(2);
    both(GL_LOAD, value);
    expect_all_bits_equal("LOAD " + std::to_string(value));
  }
}

TEST_F(NativeAccumulation, adds_and_multiplies_by_every_value) {
  for (const GLenum operation : {GL_ADD, GL_MULT}) {
    for (const GLfloat value : values) {
      set_colors(4);
      both(GL_LOAD, 0.9f);
      both(operation, value);
      expect_all_bits_equal((operation == GL_ADD ? "ADD " : "MULT ") + std::to_string(value));
    }
  }
}

TEST_F(NativeAccumulation, returns_times_every_value) {
  for (const GLfloat value : values) {
    set_colors(5);
    both(GL_LOAD, 1);
    both(GL_RETURN, value);
    expect_equal("RETURN " + std::to_string(value));
  }
}

TEST_F(NativeAccumulation, clears_to_every_value) {
  for (const GLfloat value : values) {
    clear_both({value, -value, value / 2, 0.3f});
    expect_all_bits_equal("ClearAccum " + std::to_string(value));
  }
}

TEST_F(NativeAccumulation, twice_white_wraps_around_to_nothing) {
  gl().ClearColor(1, 1, 1, 1);
  gl().Clear(GL_COLOR_BUFFER_BIT);
  natively([&] { gl().Clear(GL_COLOR_BUFFER_BIT); });
  both(GL_ACCUM, 1);
  both(GL_ACCUM, 1);
  both(GL_RETURN, 0.5f);
  expect_equal("RETURN 0.5");
  EXPECT_EQ(read(), Pixels(bytes, 0));
}

TEST_F(NativeAccumulation, honours_scissor_and_colour_mask_as_native_does) {
  set_colors(7);
  gl().Enable(GL_SCISSOR_TEST);
  gl().ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
  const std::array<GLint, 4> boxes[] = {
      {3, 1, 100, 5}, {200, 4, 500, 500}, {-20, -3, 60, 6}, {0, 0, 0, 0}, {300, 2, 10, 10}};
  for (const auto& box : boxes) {
    gl().Scissor(box[0], box[1], box[2], box[3]);
    for (const GLenum operation : {GL_LOAD, GL_ACCUM, GL_ADD, GL_MULT, GL_RETURN})
      both(operation, operation == GL_RETURN ? 1.0f : 0.4f);
    expect_equal("the operations");
    clear_both({0.1f, 0.2f, 0.3f, 0.4f});
    both(GL_RETURN, 1);
    expect_equal("the clear");
  }
  gl().Disable(GL_SCISSOR_TEST);
  gl().ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  expect_all_bits_equal("what is accumulated outside of the boxes");
}

TEST_F(NativeAccumulation, does_nothing_where_native_does_nothing) {
  set_colors(8);
  both(GL_LOAD, 0.75f);
  gl().Enable(GL_RASTERIZER_DISCARD);
  for (const GLenum operation : {GL_LOAD, GL_ACCUM, GL_ADD, GL_MULT, GL_RETURN})
    both(operation, 0.5f);
  clear_both({1, 1, 1, 1});
  gl().Disable(GL_RASTERIZER_DISCARD);
  expect_equal("the colours under RASTERIZER_DISCARD");

  const auto read_from = [&](GLenum main, GLenum native) {
    gl().ReadBuffer(main);
    natively([&] { gl().ReadBuffer.pointer(native); });
  };
  read_from(GL_NONE, GL_NONE);
  for (const GLenum operation : {GL_LOAD, GL_ACCUM}) both(operation, 0.5f);
  read_from(GL_BACK, GL_FRONT);
  both(GL_RETURN, 1);
  expect_equal("LOAD and ACCUM without a buffer to read");
  expect_all_bits_equal("what is accumulated");
}

TEST_F(NativeAccumulation, follows_native_through_random_operations) {
  std::mt19937 random(20240607);
  const auto up_to = [&](int most) { return static_cast<int>(random() % (most + 1u)); };
  const auto value = [&] {
    if (up_to(1)) return values[static_cast<std::size_t>(up_to(std::size(values) - 1))];
    return std::uniform_real_distribution<GLfloat>(-2, 2)(random);
  };
  constexpr GLenum operations[] = {GL_ACCUM, GL_LOAD, GL_ADD, GL_MULT, GL_RETURN};
  for (int i = 0; i < 600; ++i) {
    const GLenum operation = operations[up_to(4)];
    const GLfloat factor = value();
    switch (up_to(9)) {
      case 0:
        set_colors(static_cast<unsigned>(up_to(1000)));
        break;
      case 1:
        clear_both({value(), value(), value(), value()});
        break;
      case 2:
        gl().Enable(GL_SCISSOR_TEST);
        gl().Scissor(up_to(200), up_to(10), up_to(200), up_to(10));
        break;
      case 3:
        gl().Disable(GL_SCISSOR_TEST);
        break;
      case 4:
        gl().ColorMask(up_to(1) != 0, up_to(1) != 0, up_to(1) != 0, up_to(1) != 0);
        break;
      default:
        both(operation, factor);
        ASSERT_TRUE(equal()) << "step " << i << ", operation " << operation << " by " << factor;
    }
  }
  graphics().begin_frame();
  expect_all_bits_equal("after all");
}

}  // namespace
}  // namespace shadowlab::gl
