// Recipes: what is wrong with one is said in a sentence; their parameters.
#include "recipe_fixture.h"

namespace shadowlab::recipe {
namespace {

using RecipeErrors = RecipeTest;
using RecipeParameters = RecipeTest;
using RecipePoints = RecipeTest;

// ---- errors

TEST_F(RecipeErrors, name_file_line_and_pass) {
  EXPECT_EQ(error("local recipe = {}\nfunction recipe.draw(r)\n  pass('1. all of it', function()\n"
                  "    gl.Enable(gl.DEBTH_TEST)\n  end)\nend\nreturn recipe"),
            "F:4: in pass \"1. all of it\": gl.DEBTH_TEST does not exist; did you mean "
            "gl.DEPTH_TEST?");
  EXPECT_EQ(error(drawing("\n\n error 'mine'")), "F:4: mine");
  EXPECT_EQ(error("local recipe = {\n  draw = 1,,\n}"), "F:2: unexpected symbol near ','");
  EXPECT_EQ(error("\nerror('at once')"), "F:2: at once");
  EXPECT_EQ(error("return { setup = function()\n local x = nil + 1 end, draw = print }"),
            "F:2: attempt to perform arithmetic on a nil value");
  // The pass of a frame that failed is not named in the next.
  const RecipeFile file(
      "local n = 0 " +
      drawing("n = n + 1 if n == 1 then pass('first', function() error 'x' end) end "
              "error 'y'"));
  Recipe recipe(graphics(), file.path());
  EXPECT_THROW(recipe.draw(), InputError);
  try {
    recipe.draw();
    FAIL();
  } catch (const InputError& problem) {
    EXPECT_EQ(std::string(problem.what()), file.path().string() + ":2: y");
  }
}

TEST_F(RecipeErrors, say_what_a_recipe_is) {
  EXPECT_EQ(error("return 1"),
            "F: a recipe returns a table with a function draw; this file returns a number");
  EXPECT_EQ(error(""), "F: a recipe returns a table with a function draw; this file returns nil");
  EXPECT_EQ(error("return {}"),
            "F: the recipe has no function draw; write function recipe.draw(r) … end");
  EXPECT_EQ(error("return { draw = 1 }"),
            "F: the recipe has no function draw; write function recipe.draw(r) … end");
}

TEST_F(RecipeErrors, of_a_missing_scene_name_the_near_one) {
  EXPECT_EQ(error(drawing("", "scene = 'tabel'")), "there is no scene tabel; did you mean table?");
  Options options;
  options.scene = "nowhere";
  EXPECT_EQ(error(drawing(""), options), "there is no scene nowhere");
}

TEST_F(RecipeErrors, in_the_metamethods_of_its_table_are_errors_of_the_recipe) {
  EXPECT_EQ(error("return setmetatable({}, { __index = function() error 'no field' end })"),
            "F:1: no field");
  const std::string lazy =
      "return setmetatable({}, { __index = function(_, key) if key == 'draw' then return "
      "function() "
      "end end end })";
  EXPECT_EQ(error(lazy), "no error");
}

TEST_F(RecipeErrors, of_an_overwritten_module_do_not_reach_the_core) {
  EXPECT_EQ(error("scene = nil gl = nil " + drawing("", "scene = 'table'")), "no error");
  EXPECT_EQ(error("scene = setmetatable({}, { __index = function() while true do end end }) " +
                  drawing("", "scene = 'table'")),
            "no error");
}

TEST_F(RecipeErrors, of_an_endless_recipe_come_from_its_budget) {
  Options options;
  options.limits.instructions = 200'000;
  const char* const endless = "while true do end";
  for (const std::string& text :
       {std::string(endless), drawing(endless),
        std::string("return { draw = print, setup = "
                    "function() while true do end end }"),
        std::string("return setmetatable({}, { __index = function() while true do end end })"),
        drawing("pass('p', function() while true do end end)"),
        drawing("while true do pcall(error) end"), drawing("while true do gl.Finish() end")}) {
    EXPECT_NE(error(text, options).find("in one go; does a loop never end?"), std::string::npos)
        << text << ": " << error(text, options);
  }
  EXPECT_EQ(error(drawing(""), options), "no error");
}

TEST_F(RecipeErrors, of_too_little_memory_are_sentences_wherever_they_are) {
  Options options;
  for (std::size_t memory = 200'000; memory < 2'000'000; memory += 40'000) {
    options.limits.memory = memory;
    const std::string sentence = error(stencil_blend_accum, options);
    EXPECT_TRUE(sentence == "no error" || sentence.find("memory") != std::string::npos) << sentence;
  }
}

TEST_F(RecipeErrors, of_too_many_passes_end_the_frame) {
  EXPECT_EQ(error(drawing("for i = 1, 20000 do pass('p', function() end) end")),
            "F:2: a frame has at most 10000 passes");
  EXPECT_EQ(error(drawing("pass('a', function() pass('b', print) end)")),
            "F:2: in pass \"a\": pass \"b\" begins inside pass \"a\"; passes follow one another");
}

TEST_F(RecipeErrors, in_making_it_leave_nothing_behind) {
  std::array<GLuint, 1> last{};
  graphics().gl.GenBuffers(1, last);
  graphics().gl.DeleteBuffers(1, last);
  EXPECT_EQ(
      error("for i = 1, 7 do gl.BindBuffer(gl.ARRAY_BUFFER, gl.GenBuffers(1)) end error 'no'"),
      "F:1: no");
  const auto is_buffer =
      reinterpret_cast<GLboolean (*)(GLuint)>(graphics().context().function("glIsBuffer"));
  for (GLuint name = last[0]; name < last[0] + 20; ++name) EXPECT_FALSE(is_buffer(name)) << name;
}

// ---- parameters

constexpr const char* parameterised = R"lua(
local recipe = { params = { light = param.point(1, 2, 3), sun = param.direction(0, 1, 0),
  amount = param.number(0.5, 0, 1), count = param.integer(3, 1, 9), kind = param.choice("silhouette", "all"),
  on = param.toggle(true), tint = param.color(1, 0, 0) } }
function recipe.draw(r)
  local p = r.params
  print(p.light, p.sun, p.amount, p.count, p.kind, p.on, p.tint)
end
return recipe
)lua";

TEST_F(RecipeParameters, reach_the_recipe_as_values_of_their_kind) {
  const RecipeFile file(parameterised);
  std::string printed;
  Options options;
  options.print = [&](std::string_view line) { printed += line; };
  Recipe recipe(graphics(), file.path(), options);
  recipe.draw();
  EXPECT_EQ(printed,
            "vec4(1, 2, 3, 1)\tvec4(0, 1, 0, 0)\t0.5\t3\tsilhouette\ttrue\tvec3(1, 0, 0)\n");
  printed.clear();
  for (const auto& [name, value] :
       {std::pair("light", " 4, 5,6 "), std::pair("sun", "1,0,0"), std::pair("amount", "1e-1"),
        std::pair("count", "9"), std::pair("kind", "all"), std::pair("on", "false"),
        std::pair("tint", "0,0,1")}) {
    recipe.set(name, value);
  }
  recipe.draw();
  EXPECT_EQ(printed, "vec4(4, 5, 6, 1)\tvec4(1, 0, 0, 0)\t0.1\t9\tall\tfalse\tvec3(0, 0, 1)\n");
}

TEST_F(RecipeParameters, tell_whether_the_time_was_asked_for) {
  const RecipeFile file(drawing("if r.params.on then print(r.time, r.none) end",
                                "params = { on = param.toggle(false) }"));
  Options options;
  std::string printed;
  options.print = [&printed](std::string_view text) { printed += text; };
  Recipe recipe(graphics(), file.path(), options);
  recipe.draw(1.5);
  EXPECT_FALSE(recipe.read_time());
  recipe.set("on", "true");
  recipe.draw(2.5);
  EXPECT_TRUE(recipe.read_time());
  EXPECT_EQ(printed, "2.5\tnil\n");
  recipe.set("on", "false");
  recipe.draw(3.5);
  EXPECT_FALSE(recipe.read_time());
}

TEST_F(RecipeParameters, tell_which_of_them_setup_asked_for) {
  const auto asked = [&](const std::string& setup) {
    const RecipeFile file(
        "local recipe = { params = { a = param.number(1, 0, 2), b = param.toggle(true) } }\n"
        "function recipe.setup(r) " +
        setup +
        " end\n"
        "function recipe.draw(r) print(r.params.a, r.params.b) end\nreturn recipe");
    Options options;
    std::string printed;
    options.print = [&printed](std::string_view text) { printed += text; };
    Recipe recipe(graphics(), file.path(), options);
    recipe.draw();
    return printed + (recipe.was_set_up_for("a") ? "a" : "") +
           (recipe.was_set_up_for("b") ? "b" : "");
  };
  EXPECT_EQ(asked(""), "1.0\ttrue\n");
  EXPECT_EQ(asked("r.a = r.params.a"), "1.0\ttrue\na");
  EXPECT_EQ(asked("print(r.params.c)"), "nil\n1.0\ttrue\n");
  EXPECT_EQ(asked("for name, value in pairs(r.params) do print(name, value) end"),
            "a\t1.0\nb\ttrue\n1.0\ttrue\nab");
}

TEST_F(RecipeParameters, refuse_values_of_another_kind_with_what_they_take) {
  const RecipeFile file(parameterised);
  Recipe recipe(graphics(), file.path());
  const auto refusal = [&](const char* name, const char* value) {
    try {
      recipe.set(name, value);
    } catch (const InputError& problem) {
      return std::string(problem.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(refusal("light", "1,2"),
            "parameter light takes three numbers, as in --set light=2,4,1; \"1,2\" given");
  EXPECT_EQ(refusal("light", "1,2,nan").find("parameter light takes"), 0u);
  EXPECT_EQ(refusal("light", "1,2,3,").find("parameter light takes"), 0u);
  EXPECT_EQ(refusal("sun", "0,0,0"),
            "parameter sun takes a direction that is not 0,0,0; \"0,0,0\" given");
  EXPECT_EQ(refusal("amount", "2"), "parameter amount takes a number from 0 to 1; \"2\" given");
  EXPECT_EQ(refusal("amount", "x"), "parameter amount takes a number from 0 to 1; \"x\" given");
  EXPECT_EQ(refusal("count", "1.5"), "parameter count takes an integer from 1 to 9; \"1.5\" given");
  EXPECT_EQ(refusal("kind", "silhuette"),
            "parameter kind is one of silhouette, all; \"silhuette\" given; did you mean "
            "silhouette?");
  EXPECT_EQ(refusal("on", "2"), "parameter on takes true or false; \"2\" given");
  EXPECT_EQ(refusal("ligth", "1,2,3"),
            file.path().string() + " has no parameter ligth; did you mean light?");
}

TEST_F(RecipeParameters, of_the_wrong_kind_in_the_table_are_named) {
  EXPECT_EQ(error(drawing("", "params = { light = 1 }")),
            "F: params.light must be made by param.point, param.number and their like; it is a "
            "number");
  EXPECT_EQ(error(drawing("", "params = 7")), "F: params must be a table; it is a number");
}

// ---- what it says of itself

TEST_F(RecipeParameters, bound_its_error_by_its_function_limit) {
  const RecipeFile plain(drawing(""));
  EXPECT_EQ(Recipe(graphics(), plain.path()).limit().across, 0);
  const RecipeFile bounded(
      "local recipe = { params = { size = param.integer(4, 1, 9) }, draw = print }\n"
      "function recipe.limit(r) return { across = 1 / r.params.size, eye_units = 3 } end\n"
      "return recipe");
  Recipe recipe(graphics(), bounded.path());
  EXPECT_EQ(recipe.limit().across, 0.25);
  EXPECT_EQ(recipe.limit().eye_units, 3);
  const RecipeFile wrong("return { limit = function() return { acros = 1 } end, draw = print }");
  try {
    Recipe(graphics(), wrong.path()).limit();
    FAIL();
  } catch (const InputError& problem) {
    EXPECT_NE(std::string(problem.what()).find("limit gives no number \"acros\""),
              std::string::npos);
  }
}

TEST_F(RecipePoints, are_what_its_function_points_gives) {
  const RecipeFile plain("return { draw = print }");
  EXPECT_TRUE(Recipe(graphics(), plain.path()).points().empty());
  const RecipeFile averages(
      "local recipe = { params = { light = param.point(1, 2, 3) }, draw = print }\n"
      "function recipe.points(r) return { r.params.light, vec4(4, 5, 6, 1) } end\n"
      "return recipe");
  Recipe recipe(graphics(), averages.path());
  EXPECT_EQ(recipe.points(), (std::vector<glm::dvec4>{{1, 2, 3, 1}, {4, 5, 6, 1}}));
  for (const auto& [given, words] :
       {std::pair{"7", "points gives no list of points"},
        std::pair{"{ vec4(1, 2, 3, 1), 'x' }", "a point of the recipe's points"}}) {
    const RecipeFile wrong(
        fmt::format("return {{ points = function() return {} end, draw = print }}", given));
    try {
      Recipe(graphics(), wrong.path()).points();
      FAIL() << given;
    } catch (const InputError& problem) {
      EXPECT_NE(std::string(problem.what()).find(words), std::string::npos) << problem.what();
    }
  }
}

}  // namespace
}  // namespace shadowlab::recipe
