// One context for all tests of a suite.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <memory>

#include "core/error.h"
#include "gl/graphics.h"

namespace shadowlab::gl {

inline constexpr int frame_size = 32;

class GraphicsTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    graphics_ = std::make_unique<Graphics>(context::create(), frame_size, frame_size);
  }
  static void TearDownTestSuite() { graphics_.reset(); }
  void SetUp() override { graphics_->begin_frame(); }
  void TearDown() override { EXPECT_EQ(gl().GetError.pointer(), GLenum{GL_NO_ERROR}); }

  static Graphics& graphics() { return *graphics_; }
  static const Functions& gl() { return graphics_->gl; }

 private:
  static inline std::unique_ptr<Graphics> graphics_;
};

}  // namespace shadowlab::gl
