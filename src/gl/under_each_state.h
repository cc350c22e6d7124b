// Each draw under many states, so that the driver compiles its shaders for them.
#pragma once

#include <set>
#include <vector>

#include "gl/graphics.h"

namespace shadowlab::gl {

/// What of the state llvmpipe compiles into a fragment shader.
struct CompiledState;

/// While it lives, makes the first draw into each framebuffer with each program and under each
/// state of the lectures' listings too. What it leaves set spoils the rest of the frame, which
/// nobody looks at.
class UnderEachState : private DrawObserver {
 public:
  explicit UnderEachState(Graphics& graphics);
  ~UnderEachState() override;
  UnderEachState(const UnderEachState&) = delete;
  UnderEachState& operator=(const UnderEachState&) = delete;

 private:
  void before_draw(const std::function<void()>& draw) override;

  Graphics& graphics_;
  const std::vector<CompiledState> states_;
  std::set<GLint> framebuffers_;
};

}  // namespace shadowlab::gl
