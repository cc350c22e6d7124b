// Programs: compiled once for each source, their uniforms each shader's own.
#include "gl_fixture.h"

namespace shadowlab::gl {
namespace {

constexpr const char* position_only = R"(#version 330 core
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }
)";

ProgramSource with_fragment(std::string text) {
  return {{"a.vert", position_only}, {"a.frag", std::move(text)}, {}};
}

const ProgramSource filling = with_fragment(R"(#version 330 core
uniform vec4 color = vec4(0.2, 0.4, 0.6, 0.8);
out vec4 fragment;
void main() { fragment = color; }
)");

class Programs : public GraphicsTest {
 protected:
  void SetUp() override {
    GraphicsTest::SetUp();
    gl().GenVertexArrays(1, array_);
    gl().BindVertexArray(array_[0]);
  }
  void TearDown() override {
    gl().DeleteVertexArrays(1, array_);
    GraphicsTest::TearDown();
  }

  static void set(Shader& shader, const char* name, std::vector<double> value) {
    const Uniform* uniform = shader.program().find(name);
    ASSERT_TRUE(uniform) << name;
    shader.set(*uniform, value);
  }

  // The colour that the frame has once this shader has filled it.
  std::array<std::uint8_t, 4> filled(Shader& shader) {
    gl().BindVertexArray(array_[0]);
    shader.use();
    gl().DrawArrays(GL_TRIANGLES, 0, 3);
    return graphics().frame.read_color().at(0, 0);
  }

  static std::string error(const ProgramSource& source) {
    try {
      graphics().make_shader(source);
    } catch (const InputError& problem) {
      return problem.what();
    }
    return "no error";
  }

 private:
  std::array<GLuint, 1> array_{};
};

using Color = std::array<std::uint8_t, 4>;

TEST_F(Programs, of_the_same_source_are_compiled_once) {
  const auto first = graphics().make_shader(filling);
  const std::size_t before = graphics().programs.size();
  ProgramSource elsewhere = filling;
  elsewhere.fragment.name = "another/name.frag";
  const auto second = graphics().make_shader(elsewhere);
  EXPECT_EQ(&first->program(), &second->program());
  EXPECT_EQ(graphics().programs.size(), before);
  ProgramSource different = filling;
  different.fragment.text += "\n";
  EXPECT_NE(&graphics().make_shader(different)->program(), &first->program());
}

TEST_F(Programs, begin_with_the_values_of_their_text) {
  const auto shader = graphics().make_shader(filling);
  EXPECT_EQ(filled(*shader), (Color{51, 102, 153, 204}));
}

TEST_F(Programs, shared_by_two_shaders_keep_the_values_of_each) {
  const auto one = graphics().make_shader(filling), two = graphics().make_shader(filling);
  set(*one, "color", {1, 0, 0, 1});
  EXPECT_EQ(filled(*one), (Color{255, 0, 0, 255}));
  EXPECT_EQ(filled(*two), (Color{51, 102, 153, 204}));
  set(*two, "color", {0, 1, 0, 1});
  EXPECT_EQ(filled(*one), (Color{255, 0, 0, 255}));
  EXPECT_EQ(filled(*two), (Color{0, 255, 0, 255}));
}

TEST_F(Programs, forget_at_the_end_of_a_frame_what_setup_did_not_set) {
  const auto shader = graphics().make_shader(filling);
  set(*shader, "color", {1, 0, 0, 1});
  graphics().begin_frame();
  EXPECT_EQ(filled(*shader), (Color{51, 102, 153, 204}));
  set(*shader, "color", {0, 0, 1, 1});
  graphics().keep_uniforms();
  set(*shader, "color", {1, 0, 0, 1});
  graphics().begin_frame();
  EXPECT_EQ(filled(*shader), (Color{0, 0, 255, 255}));
}

TEST_F(Programs, send_their_own_values_after_a_recipe_sent_others_by_itself) {
  const auto shader = graphics().make_shader(filling);
  filled(*shader);
  gl().Uniform4f(shader->program().find("color")->location, 1, 1, 1, 1);
  ++graphics().calls().foreign_uniforms;
  EXPECT_EQ(filled(*shader), (Color{51, 102, 153, 204}));
}

TEST_F(Programs, take_every_type_of_uniform_and_arrays_of_it) {
  // Each uniform is to hold 1, 2, 3 …; the picture is white where all do.
  const std::pair<const char*, std::size_t> types[] = {
      {"float", 1}, {"vec2", 2},  {"vec3", 3},  {"vec4", 4},  {"mat2", 4},  {"mat3", 9},
      {"mat4", 16}, {"int", 1},   {"ivec2", 2}, {"ivec3", 3}, {"ivec4", 4}, {"uint", 1},
      {"uvec2", 2}, {"uvec3", 3}, {"uvec4", 4}, {"bool", 1},  {"bvec2", 2}, {"bvec4", 4}};
  for (const auto& [type, components] : types) {
    for (const std::size_t count : {1u, 3u}) {
      const std::string name(type);
      const bool boolean = name[0] == 'b';
      std::string values;
      std::vector<double> numbers;
      std::string wanted;
      for (std::size_t k = 0; k < count; ++k) {
        values.clear();
        for (std::size_t i = 0; i < components; ++i) {
          const double number = boolean ? static_cast<double>((k + i) % 2)
                                        : static_cast<double>(k * components + i + 1);
          numbers.push_back(number);
          values += (i ? ", " : "") + std::to_string(static_cast<int>(number));
        }
        wanted += " && u" + (count > 1 ? "[" + std::to_string(k) + "]" : "") + " == " + name + "(" +
                  values + ")";
      }
      const auto shader = graphics().make_shader(with_fragment(
          "#version 330 core\nuniform " + name + " u" +
          (count > 1 ? "[" + std::to_string(count) + "]" : "") +
          ";\nout vec4 fragment;\nvoid main() { fragment = vec4(true" + wanted + " ? 1 : 0); }\n"));
      set(*shader, "u", numbers);
      EXPECT_EQ(filled(*shader), (Color{255, 255, 255, 255})) << name << " × " << count;
    }
  }
}

TEST_F(Programs, refuse_values_that_do_not_fit) {
  const auto shader = graphics().make_shader(with_fragment(R"(#version 330 core
uniform vec3 v; uniform int i; uniform float a[4];
out vec4 fragment;
void main() { fragment = vec4(v, i) * a[3]; })"));
  EXPECT_THROW(set(*shader, "v", {1, 2}), InputError);
  EXPECT_THROW(set(*shader, "v", {}), InputError);
  EXPECT_THROW(set(*shader, "v", {1, 2, 3, 4}), InputError);
  EXPECT_THROW(set(*shader, "v", {1, 2, NAN}), InputError);
  EXPECT_THROW(set(*shader, "v", {1, 2, 1e39}), InputError);
  EXPECT_THROW(set(*shader, "i", {1.5}), InputError);
  EXPECT_THROW(set(*shader, "i", {1e10}), InputError);
  EXPECT_NO_THROW(set(*shader, "a", {1, 2}));
  // GL tells of an array no more than what the shader reads, and ignores what is beyond.
  EXPECT_NO_THROW(set(*shader, "a", {1, 2, 3, 4, 5}));
}

TEST_F(Programs, with_uniform_blocks_leave_no_error_behind) {
  const auto shader = graphics().make_shader(with_fragment(R"(#version 330 core
uniform Block { vec4 inside; };
uniform vec4 outside;
out vec4 fragment;
void main() { fragment = inside + outside; })"));
  EXPECT_FALSE(shader->program().find("inside"));
  EXPECT_TRUE(shader->program().find("outside"));
}

TEST_F(Programs, name_file_and_line_of_their_first_error) {
  EXPECT_EQ(error(with_fragment("#version 330 core\nout vec4 f;\nvoid main() {\n  f = nothing;\n}"))
                .substr(0, 9),
            "a.frag:4:");
  ProgramSource wrong = filling;
  wrong.vertex = {"b.vert", "#version 330 core\nvoid main() { gl_Position = 1 }"};
  EXPECT_EQ(error(wrong).substr(0, 9), "b.vert:2:");
  wrong = filling;
  wrong.geometry = StageSource{"c.geom", "#version 330 core\n\n\nwhat?"};
  EXPECT_EQ(error(wrong).substr(0, 9), "c.geom:4:");
}

TEST_F(Programs, that_do_not_link_name_their_stages_and_the_reason) {
  ProgramSource source = with_fragment(
      "#version 330 core\nin vec3 between;\nout vec4 f;\nvoid main() { f = vec4(between, 1); }");
  source.vertex.text =
      "#version 330 core\nout vec4 between;\nvoid main() { gl_Position = between = vec4(1); }";
  const std::string sentence = error(source);
  EXPECT_EQ(sentence.find("a.vert and a.frag do not link: "), 0u) << sentence;
  EXPECT_NE(sentence.find("between"), std::string::npos) << sentence;
  EXPECT_EQ(sentence.find('\n'), std::string::npos);
}

TEST_F(Programs, of_doubles_or_of_oblong_matrices_are_refused) {
  EXPECT_NE(error(with_fragment("#version 330 core\nuniform mat2x3 m;\nout vec4 f;\nvoid main() { "
                                "f = vec4(m[1], 1); }"))
                .find("uniform m is of doubles or of a matrix that is not square"),
            std::string::npos);
}

TEST_F(Programs, declare_uniforms_that_the_driver_dropped) {
  const auto shader = graphics().make_shader(with_fragment(R"(#version 330 core
uniform vec3 dropped;  // uniform vec3 commented;
/* uniform vec3 commented_too; */
layout(location = 0) out vec4 fragment;
uniform highp float a, b[2], c = 1.0;
void main() { fragment = vec4(a, b[0], b[1], c); })"));
  EXPECT_FALSE(shader->program().find("dropped"));
  EXPECT_TRUE(shader->program().declares("dropped"));
  for (const char* name : {"a", "b", "c"}) EXPECT_TRUE(shader->program().declares(name)) << name;
  EXPECT_FALSE(shader->program().declares("commented"));
  EXPECT_FALSE(shader->program().declares("commented_too"));
  EXPECT_FALSE(shader->program().declares("vec3"));
}

TEST(ShaderErrors, of_every_driver_give_the_line_and_the_words) {
  const std::pair<const char*, const char*> logs[] = {
      {"0:12(5): error: `x' undeclared\n0:13(1): error: more\n", "f.frag:12: `x' undeclared"},
      {"0:3(10): warning: unused\n0:7(1): error: here\n", "f.frag:7: here"},
      {"0(12) : error C1008: undefined variable \"x\"\n",
       "f.frag:12: error C1008: undefined variable \"x\""},
      {"0(2) : warning C7050: maybe\n0(4) : error C0000: syntax error\n",
       "f.frag:4: error C0000: syntax error"},
      {"ERROR: 0:12: 'x' : undeclared identifier\nERROR: 1 compilation errors.\n",
       "f.frag:12: 'x' : undeclared identifier"},
      {"something else entirely\n", "f.frag: something else entirely"},
      {"", "f.frag: "}};
  for (const auto& [log, sentence] : logs) EXPECT_EQ(first_shader_error(log, "f.frag"), sentence);
}

}  // namespace
}  // namespace shadowlab::gl
