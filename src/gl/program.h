// Programs: compiled once for each source, with what their uniforms hold.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gl/functions.h"

namespace shadowlab::gl {

/// One stage's text and what to call it in a message: "shaders/phong.frag".
struct StageSource {
  std::string name;
  std::string text;
  /// What `text` includes: source string i + 1 of its #line directives is file i.
  std::vector<std::string> included = {};
};

struct ProgramSource {
  StageSource vertex;
  StageSource fragment;
  std::optional<StageSource> geometry;
};

/// An active uniform. Its value is `components` × `count` numbers of 4 bytes each: floats, or ints
/// for integers, booleans and samplers.
struct Uniform {
  std::string name;  ///< "light"; an array without its [0]
  GLenum type = 0;   ///< GL_FLOAT_VEC3 …
  GLint location = -1;
  GLint count = 1;
  bool array = false;     ///< declared as one; count is then only as far as the shader reads it
  std::size_t first = 0;  ///< where its words begin in a program's values
  std::size_t words() const;
  bool floating() const;
  bool supported() const;
  /// To the program in use.
  void send(const Functions& gl, const std::uint32_t* values) const;
};

/// The words of all uniforms of one program, one after the other.
using UniformValues = std::vector<std::uint32_t>;

/// One linked program. GL keeps its uniforms' values; `use` sends only those that differ.
class Program {
 public:
  /// Compiles and links. Throws InputError with the stage, the file and the line of the first
  /// error, in the driver's words.
  Program(const Functions& gl, const ProgramSource& source);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  GLuint name() const { return name_; }
  std::span<const Uniform> uniforms() const { return uniforms_; }
  const Uniform* find(std::string_view uniform) const;
  /// The uniform of that name is declared by a stage, though the driver may have dropped it.
  bool declares(std::string_view uniform) const;
  const std::vector<std::string>& declared() const { return declared_; }
  /// What the uniforms hold after linking.
  const UniformValues& initial() const { return initial_; }

  /// Makes it current with these values.
  void use(const UniformValues& values);
  /// Forgets what GL holds, so that the next `use` sends (and traces) every uniform.
  void forget_values() { sent_known_ = false; }

 private:
  void reflect();

  const Functions& gl_;
  GLuint name_ = 0;
  std::vector<Uniform> uniforms_;
  std::vector<std::string> declared_;
  UniformValues initial_;
  UniformValues sent_;  ///< what GL holds, where that is known
  bool sent_known_ = false;
  std::uint64_t foreign_uniforms_ = 0;  ///< as of `sent_`
};

/// A program with uniform values of its own: what a recipe holds as a shader. Two recipes that load
/// the same source share the program and not the values.
class Shader {
 public:
  explicit Shader(std::shared_ptr<Program> program);

  const Program& program() const { return *program_; }
  /// Sets a uniform's components, converted to its type. Throws InputError where the number of
  /// components does not fit, a number is not finite, or an integer is asked for.
  void set(const Uniform& uniform, std::span<const double> components);
  void use() { program_->use(values_); }

  /// The values now are those that every frame begins with.
  void keep_values() { kept_ = values_; }
  void begin_frame();

 private:
  std::shared_ptr<Program> program_;
  UniformValues values_;
  UniformValues kept_;
};

/// Programs by source: every new program object would compile anew, which dominates small frames.
class ProgramCache {
 public:
  explicit ProgramCache(const Functions& gl) : gl_(gl) {}
  std::shared_ptr<Program> get(const ProgramSource& source);
  std::size_t size() const { return programs_.size(); }
  /// Tells `told` of each program.
  template <class Told>
  void each(const Told& told) const {
    for (const auto& [source, program] : programs_) told(*program);
  }
  /// Where there are more than `most`, those that nobody holds go.
  void trim(std::size_t most);

 private:
  const Functions& gl_;
  std::map<std::string, std::shared_ptr<Program>, std::less<>> programs_;
};

/// The first error of a driver's log as "NAME:LINE: …", from the forms "0:12(5): error: …" (Mesa),
/// "0(12) : error …" (NVIDIA) and "ERROR: 0:12: …" (others). Source strings beyond 0 are
/// `included`.
std::string first_shader_error(std::string_view log, std::string_view source_name,
                               std::span<const std::string> included = {});

/// The uniforms that a GLSL text declares, comments aside.
std::vector<std::string> declared_uniforms(std::string_view glsl);

}  // namespace shadowlab::gl
