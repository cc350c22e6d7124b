// The accumulation buffer, over a texture of our own.
//
// glAccum left GL with version 3.1, and framebuffer objects never had it; the lectures need it. The
// main frame's colour is accumulated as OpenGL 2.1, section 4.2.4, says, in a storage that the
// recipe chooses, since the storage is what the banding lecture is about.
#pragma once

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "gl/main_frame.h"
#include "gl/program.h"

namespace shadowlab::gl {

/// snorm16 is the classic one: 16-bit integers for [-1, 1] that truncate and wrap around, bit for
/// bit as Mesa's own glAccum. snorm8 is the same with 8 bits. The floats neither round to a grid
/// nor wrap.
enum class AccumStorage { snorm8, snorm16, float16, float32 };

/// "snorm16"; and back, throwing InputError for another word.
const char* name_of(AccumStorage storage);
AccumStorage accum_storage_named(std::string_view name);

/// The bits of one channel, as GL_ACCUM_RED_BITS gives them.
int bits_of(AccumStorage storage);

class Accumulation {
 public:
  Accumulation(const Functions& gl, CallContext& context, const MainFrame& frame,
               ProgramCache& programs);
  ~Accumulation();
  Accumulation(const Accumulation&) = delete;
  Accumulation& operator=(const Accumulation&) = delete;

  /// Chooses the storage; what was accumulated is gone (all zero).
  void choose(AccumStorage storage);
  AccumStorage storage() const { return storage_; }

  void set_clear_value(std::array<GLfloat, 4> value) { clear_value_ = value; }
  /// glClear of it: within the scissor box in force; nothing unless the main frame is bound.
  void clear();

  /// GL_ACCUM, GL_LOAD, GL_ADD, GL_MULT or GL_RETURN with `value`, within the scissor box in force;
  /// RETURN honours the colour mask. Throws InputError unless the main frame is bound for drawing
  /// and reading (nothing else has an accumulation buffer), and while a query that would count the
  /// core's own drawing is under way.
  void run(GLenum operation, GLfloat value);

  /// Back to GL's defaults at the start of a frame: snorm16, clear value 0. The content is kept as
  /// GL keeps it, until the storage changes.
  void begin_frame();

  /// Its content is all zero again, as when it was new.
  void release();

  GLuint texture() const { return textures_[current_]; }

 private:
  bool integral() const {
    return storage_ == AccumStorage::snorm8 || storage_ == AccumStorage::snorm16;
  }
  void allocate();
  void set_scissor(const std::array<GLint, 4>& box);
  void upload_table(GLfloat value);
  void accumulate(GLenum operation, GLfloat value, std::array<GLint, 4> box);
  void give_back(GLfloat value);
  using Values = std::vector<std::pair<const char*, std::vector<double>>>;
  void draw(const ProgramSource& source, const Values& values);

  const Functions& gl_;
  CallContext& context_;
  const MainFrame& frame_;
  ProgramCache& programs_;
  AccumStorage storage_ = AccumStorage::snorm16;
  std::array<GLfloat, 4> clear_value_{};
  std::array<GLuint, 2> textures_{};      ///< read one, write the other
  std::array<GLuint, 2> framebuffers_{};  ///< one for each
  std::size_t current_ = 0;
  GLuint table_ = 0;  ///< 256 × 1: what each 8-bit colour adds
  GLuint vertex_array_ = 0;
};

}  // namespace shadowlab::gl
