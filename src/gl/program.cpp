#include "gl/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/error.h"

namespace shadowlab::gl {
namespace {

std::string log_of(const Functions& gl, GLuint name, bool is_program) {
  std::vector<GLchar> log(16384);
  GLsizei length = 0;
  const auto size = static_cast<GLsizei>(log.size());
  if (is_program) {
    gl.GetProgramInfoLog.unrecorded(name, size, {&length, 1}, log);
  } else {
    gl.GetShaderInfoLog.unrecorded(name, size, {&length, 1}, log);
  }
  return {log.data(), static_cast<std::size_t>(length)};
}

// A GL object that is deleted unless it is released.
class Guard {
 public:
  Guard(const Functions& gl, GLuint shader) : gl_(gl), shader_(shader) {}
  ~Guard() { gl_.DeleteShader.unrecorded(shader_); }
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;
  GLuint name() const { return shader_; }

 private:
  const Functions& gl_;
  GLuint shader_;
};

std::unique_ptr<Guard> compile(const Functions& gl, GLenum stage, const StageSource& source) {
  auto shader = std::make_unique<Guard>(gl, gl.CreateShader.unrecorded(stage));
  const char* text = source.text.data();
  const auto length = static_cast<GLint>(source.text.size());
  gl.ShaderSource.unrecorded(shader->name(), 1, {&text, 1}, {&length, 1});
  gl.CompileShader.unrecorded(shader->name());
  GLint compiled = 0;
  gl.GetShaderiv.unrecorded(shader->name(), GL_COMPILE_STATUS, {&compiled, 1});
  if (!compiled)
    throw InputError(
        first_shader_error(log_of(gl, shader->name(), false), source.name, source.included));
  return shader;
}

}  // namespace

Program::Program(const Functions& gl, const ProgramSource& source) : gl_(gl) {
  const auto vertex = compile(gl, GL_VERTEX_SHADER, source.vertex);
  const auto fragment = compile(gl, GL_FRAGMENT_SHADER, source.fragment);
  const auto geometry =
      source.geometry ? compile(gl, GL_GEOMETRY_SHADER, *source.geometry) : nullptr;
  name_ = gl.CreateProgram.unrecorded();
  for (const Guard* shader : {vertex.get(), fragment.get(), geometry.get()}) {
    if (shader) gl.AttachShader.unrecorded(name_, shader->name());
  }
  gl.LinkProgram.unrecorded(name_);
  GLint linked = 0;
  gl.GetProgramiv.unrecorded(name_, GL_LINK_STATUS, {&linked, 1});
  if (!linked) {
    std::string log = log_of(gl, name_, true);
    gl.DeleteProgram.unrecorded(name_);
    throw InputError(fmt::format("{} and {} do not link: {}", source.vertex.name,
                                 source.fragment.name, log.substr(0, log.find('\n'))));
  }
  for (const StageSource* stage :
       {&source.vertex, &source.fragment, source.geometry ? &*source.geometry : nullptr}) {
    if (!stage) continue;
    for (std::string& name : declared_uniforms(stage->text)) {
      if (std::find(declared_.begin(), declared_.end(), name) == declared_.end()) {
        declared_.push_back(std::move(name));
      }
    }
  }
  try {
    reflect();
  } catch (...) {
    gl.DeleteProgram.unrecorded(name_);
    throw;
  }
}

Program::~Program() { gl_.DeleteProgram.unrecorded(name_); }

void Program::reflect() {
  GLint active = 0;
  gl_.GetProgramiv.unrecorded(name_, GL_ACTIVE_UNIFORMS, {&active, 1});
  for (GLuint i = 0; i < static_cast<GLuint>(active); ++i) {
    std::array<GLchar, 256> text{};
    GLsizei length = 0;
    Uniform uniform;
    gl_.GetActiveUniform.unrecorded(name_, i, text.size(), {&length, 1}, {&uniform.count, 1},
                                    {&uniform.type, 1}, text);
    uniform.name.assign(text.data(), static_cast<std::size_t>(length));
    uniform.array = uniform.name.ends_with("[0]");
    if (uniform.array) uniform.name.resize(uniform.name.size() - 3);
    if (uniform.name.starts_with("gl_")) continue;
    uniform.location = gl_.GetUniformLocation.unrecorded(name_, uniform.name.c_str());
    if (uniform.location < 0) continue;  // of a uniform block, whose values are in a buffer
    if (!uniform.supported()) {
      throw InputError(fmt::format(
          "uniform {} is of doubles or of a matrix that is not square; use float, mat2, mat3, mat4",
          uniform.name));
    }
    uniform.first = initial_.size();
    initial_.resize(initial_.size() + uniform.words());
    const std::size_t each = uniform.words() / static_cast<std::size_t>(uniform.count);
    for (GLint k = 0; k < uniform.count; ++k) {
      const std::string element = k == 0 ? uniform.name : fmt::format("{}[{}]", uniform.name, k);
      const GLint location = gl_.GetUniformLocation.unrecorded(name_, element.c_str());
      std::uint32_t* words = initial_.data() + uniform.first + static_cast<std::size_t>(k) * each;
      if (uniform.floating()) {
        std::array<GLfloat, 16> values{};
        gl_.GetUniformfv.unrecorded(name_, location, values);
        std::memcpy(words, values.data(), each * sizeof(GLfloat));
      } else {
        std::array<GLint, 16> values{};
        gl_.GetUniformiv.unrecorded(name_, location, values);
        std::memcpy(words, values.data(), each * sizeof(GLint));
      }
    }
    uniforms_.push_back(std::move(uniform));
  }
}

const Uniform* Program::find(std::string_view uniform) const {
  for (const Uniform& candidate : uniforms_) {
    if (candidate.name == uniform) return &candidate;
  }
  return nullptr;
}

bool Program::declares(std::string_view uniform) const {
  return std::find(declared_.begin(), declared_.end(), uniform) != declared_.end();
}

void Program::use(const UniformValues& values) {
  gl_.UseProgram(name_);
  const std::uint64_t foreign = gl_.UseProgram.shared->foreign_uniforms;
  if (std::exchange(foreign_uniforms_, foreign) != foreign) forget_values();
  for (const Uniform& uniform : uniforms_) {
    const std::uint32_t* words = values.data() + uniform.first;
    const bool same =
        sent_known_ && std::equal(words, words + uniform.words(), sent_.data() + uniform.first);
    if (!same) uniform.send(gl_, words);
  }
  sent_ = values;
  sent_known_ = true;
}

Shader::Shader(std::shared_ptr<Program> program)
    : program_(std::move(program)), values_(program_->initial()), kept_(values_) {}

void Shader::set(const Uniform& uniform, std::span<const double> components) {
  const std::size_t words = uniform.words();
  const std::size_t each = words / static_cast<std::size_t>(uniform.count);
  // What a shader does not read of an array GL leaves out of its length, and ignores when it is
  // given.
  if (uniform.array && components.size() > words && components.size() % each == 0)
    components = components.first(words);
  if (components.empty() || components.size() > words || components.size() % each != 0) {
    throw InputError(fmt::format(
        "uniform {} takes {} number{}{}; {} given", uniform.name, each, each == 1 ? "" : "s",
        uniform.count > 1 ? fmt::format(" for each of {}", uniform.count) : "", components.size()));
  }
  for (std::size_t i = 0; i < components.size(); ++i) {
    const double value = components[i];
    std::uint32_t& word = values_[uniform.first + i];
    if (uniform.floating()) {
      const auto single = static_cast<GLfloat>(value);
      if (!std::isfinite(single)) {
        throw InputError(fmt::format("uniform {} would be {}, which is not a finite float",
                                     uniform.name, value));
      }
      std::memcpy(&word, &single, sizeof word);
    } else {
      if (value != std::floor(value) || value < -2147483648.0 || value > 4294967295.0) {
        throw InputError(fmt::format("uniform {} takes an integer; {} given", uniform.name, value));
      }
      word = static_cast<std::uint32_t>(static_cast<std::int64_t>(value));
    }
  }
}

void Shader::begin_frame() {
  values_ = kept_;
  program_->forget_values();
}

std::shared_ptr<Program> ProgramCache::get(const ProgramSource& source) {
  std::string key = source.vertex.text + '\0' + source.fragment.text;
  if (source.geometry) key += '\0' + source.geometry->text;
  auto found = programs_.find(key);
  if (found == programs_.end()) {
    found = programs_.emplace(std::move(key), std::make_shared<Program>(gl_, source)).first;
  }
  return found->second;
}

void ProgramCache::trim(std::size_t most) {
  if (programs_.size() <= most) return;
  std::erase_if(programs_, [](const auto& known) { return known.second.use_count() == 1; });
}

}  // namespace shadowlab::gl
