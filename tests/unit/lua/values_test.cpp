#include <cmath>
#include <limits>

#include "core/error.h"
#include "values_fixture.h"

namespace shadowlab::lua {
namespace {

using testing::HasSubstr;

TEST_F(Values, vectors_are_made_from_components_vectors_and_tables) {
  EXPECT_EQ(value("vec3(1, 2.5, 3)"), "vec3(1, 2.5, 3)");
  EXPECT_EQ(value("vec2(7)"), "vec2(7, 7)");
  EXPECT_EQ(value("vec3(vec2(1, 2), 3)"), "vec3(1, 2, 3)");
  EXPECT_EQ(value("vec3(1, vec2(2, 3))"), "vec3(1, 2, 3)");
  EXPECT_EQ(value("vec4(vec3(1, 2, 3), 4)"), "vec4(1, 2, 3, 4)");
  EXPECT_EQ(value("vec4(vec2(1, 2), vec2(3, 4))"), "vec4(1, 2, 3, 4)");
  EXPECT_EQ(value("vec3(vec4(1, 2, 3, 4))"), "vec3(1, 2, 3)");
  EXPECT_EQ(value("vec2(vec3(1, 2, 3))"), "vec2(1, 2)");
  EXPECT_EQ(value("vec3(vec3(1, 2, 3))"), "vec3(1, 2, 3)");
  EXPECT_EQ(value("vec3{1, 2, 3}"), "vec3(1, 2, 3)");
  EXPECT_EQ(value("vec3{z = 3, x = 1, y = 2}"), "vec3(1, 2, 3)");
}

TEST_F(Values, vectors_refuse_the_wrong_components) {
  refuses("vec3()", "vec3 takes 3 numbers, which vectors may bring; it got 0");
  refuses("vec3(1, 2)", "vec3 takes 3 numbers, which vectors may bring; it got 2");
  refuses("vec3(1, 2, 3, 4)", "vec3 takes 3 numbers, which vectors may bring; it got 4");
  refuses("vec3(vec2(1, 2))", "vec3 takes 3 numbers, which vectors may bring; it got 2");
  refuses("vec3(vec4(1), 2)", "vec3 takes 3 numbers, which vectors may bring; it got 5");
  refuses("vec3(1, '2', 3)",
          "vec3 takes 3 numbers, which vectors may bring; argument 2 is a string");
  refuses("vec3(mat3(1))", "vec3 takes 3 numbers, which vectors may bring; argument 1 is a mat3");
}

TEST_F(Values, components_are_read_by_name_by_number_and_in_any_order) {
  run("v = vec4(1, 2, 3, 4)");
  EXPECT_EQ(number("v.x * 1000 + v.y * 100 + v.z * 10 + v.w"), 1234);
  EXPECT_EQ(number("v.r * 1000 + v.g * 100 + v.b * 10 + v.a"), 1234);
  EXPECT_EQ(number("v[1] * 1000 + v[2] * 100 + v[3] * 10 + v[4]"), 1234);
  EXPECT_EQ(value("v.xy"), "vec2(1, 2)");
  EXPECT_EQ(value("v.zyx"), "vec3(3, 2, 1)");
  EXPECT_EQ(value("v.bgra"), "vec4(3, 2, 1, 4)");
  EXPECT_EQ(value("v.wwww"), "vec4(4, 4, 4, 4)");
  EXPECT_EQ(number("#v + #vec3(1) * 10 + #vec2(1) * 100"), 234);
}

TEST_F(Values, an_unknown_field_names_the_near_one) {
  refuses("vec3(1):lenght()", "a vec3 has no lenght; did you mean length?");
  refuses("vec2(1).z", "a vec2 has no z");
  refuses("vec4(1).xr", "a vec4 has no xr");
  refuses("vec4(1).xyzwx", "a vec4 has no xyzwx");
  refuses("vec3(1)[0]", "a vec3 has no [0]");
  refuses("vec3(1)[4]", "a vec3 has no [4]");
  refuses("vec3(1)[1.5]", "a vec3 has no [1.5]");
  refuses("vec3(1)[{}]", "a vec3 has no [a table]");
  refuses("vec3.lenght", "vec3.lenght does not exist; did you mean vec3.length?");
  refuses("mat4.lookat()", "mat4.lookat does not exist; did you mean mat4.look_at?");
  refuses("mat4(1):invrese()", "a mat4 has no invrese; did you mean inverse?");
  refuses("quat(1, 0, 0, 0).v", "a quat has no v");
  EXPECT_THAT(value("vec3(1)[('x'):rep(1e6)]"), testing::SizeIs(testing::Lt(100)));
}

TEST_F(Values, a_value_never_changes) {
  EXPECT_EQ(
      run("local v = vec3(1); v.x = 2"),
      "script:1: a vec3 cannot be changed, so x cannot be assigned; build a new vec3 instead");
  EXPECT_THAT(run("local m = mat4(1); m[1] = vec4(0)"),
              HasSubstr("a mat4 cannot be changed, so [1]"));
  EXPECT_THAT(run("local q = quat.identity(); q.w = 2"), HasSubstr("a quat cannot be changed"));
}

TEST_F(Values, metatables_are_out_of_reach) {
  for (const char* one : {"vec2(1)", "vec3(1)", "vec4(1)", "mat3(1)", "mat4(1)", "quat.identity()",
                          "vec2", "vec3", "vec4", "mat3", "mat4", "quat"}) {
    EXPECT_EQ(value(std::string("getmetatable(") + one + ")"), "locked");
  }
  EXPECT_THAT(run("setmetatable(vec3, {})"), HasSubstr("protected metatable"));
}

TEST_F(Values, a_metamethod_called_on_another_type_refuses_it) {
  // Through the debug library, which the sandbox does not have.
  for (const char* kind : {"vec3(1)", "mat4(1)", "quat.identity()"}) {
    const std::string meta = std::string("debug.getmetatable(") + kind + ")";
    for (const char* method : {"__index", "__newindex", "__add", "__unm", "__tostring"}) {
      EXPECT_THAT(value(meta + "." + method + "(io.stdout, {}, 1)"), HasSubstr("script:1: "));
    }
    EXPECT_EQ(value(meta + ".__eq(io.stdout, 1)"), "false");
  }
}

TEST_F(Values, vector_arithmetic_goes_component_by_component) {
  run("v, u = vec3(1, 2, 4), vec3(2, 4, 8)");
  EXPECT_EQ(value("v + u"), "vec3(3, 6, 12)");
  EXPECT_EQ(value("v - u"), "vec3(-1, -2, -4)");
  EXPECT_EQ(value("v * u"), "vec3(2, 8, 32)");
  EXPECT_EQ(value("u / v"), "vec3(2, 2, 2)");
  EXPECT_EQ(value("v * 2"), "vec3(2, 4, 8)");
  EXPECT_EQ(value("2 * v"), "vec3(2, 4, 8)");
  EXPECT_EQ(value("v / 2"), "vec3(0.5, 1, 2)");
  EXPECT_EQ(value("4 / v"), "vec3(4, 2, 1)");
  EXPECT_EQ(value("v + 1"), "vec3(2, 3, 5)");
  EXPECT_EQ(value("1 - v"), "vec3(0, -1, -3)");
  EXPECT_EQ(value("-v"), "vec3(-1, -2, -4)");
  holds("v == vec3(1, 2, 4) and v ~= u and vec3(1) ~= vec4(1)");
  EXPECT_EQ(value("vec2(1, 2) * vec2(3, 4)"), "vec2(3, 8)");
  EXPECT_EQ(value("vec4(1, 2, 3, 4) + vec4(1)"), "vec4(2, 3, 4, 5)");
}

TEST_F(Values, vector_functions_give_their_definitions) {
  EXPECT_EQ(number("vec3(1, 2, 3):dot(vec3(4, 5, 6))"), 32);
  EXPECT_EQ(number("vec3.dot(vec3(1, 2, 3), {4, 5, 6})"), 32);
  EXPECT_EQ(value("vec3(1, 0, 0):cross(vec3(0, 1, 0))"), "vec3(0, 0, 1)");
  EXPECT_EQ(number("vec3(2, 3, 6):length()"), 7);
  EXPECT_EQ(value("vec2(3, 4):normalize()"), "vec2(0.6, 0.8)");
  EXPECT_EQ(number("vec4(1, 1, 1, 1):distance(vec4(2, 2, 2, 2))"), 2);
  EXPECT_EQ(value("vec3(0, 1, 2):lerp(vec3(4, 5, 6), 0.25)"), "vec3(1, 2, 3)");
  EXPECT_EQ(value("vec3(0.1):lerp(vec3(0.7), 1)"), "vec3(0.7, 0.7, 0.7)");
  EXPECT_EQ(value("vec3(1, 5, 3):min(vec3(4, 2, 6))"), "vec3(1, 2, 3)");
  EXPECT_EQ(value("vec3(1, 5, 3):max(vec3(4, 2, 6))"), "vec3(4, 5, 6)");
  EXPECT_EQ(value("vec3(-1, 2, -3):abs()"), "vec3(1, 2, 3)");
  EXPECT_EQ(value("vec3(1, -1, 0):reflect(vec3(0, 2, 0))"), "vec3(1, 1, 0)");
}

TEST_F(Values, lengths_neither_overflow_nor_underflow) {
  EXPECT_EQ(number("vec2(3 * 2^600, 4 * 2^600):length()"), std::ldexp(5, 600));
  EXPECT_EQ(number("vec2(3 * 2^-1072, 4 * 2^-1072):length()"), std::ldexp(5, -1072));
  EXPECT_EQ(number("vec3(0):length()"), 0);
  EXPECT_EQ(number("vec2(1/0, 1):length()"), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(number("vec2(0/0, 1):length()")));
  EXPECT_EQ(value("(vec2(3, 4) * 2^-1072):normalize()"), "vec2(0.6, 0.8)");
  EXPECT_EQ(value("(vec4(1) * 2^1023):normalize()"), "vec4(0.5, 0.5, 0.5, 0.5)");
  EXPECT_EQ(value("(quat(0, 0, 3, 4) * 2^600):normalize()"), "quat(0, 0, 0.6, 0.8)");
}

TEST_F(Values, vectors_without_a_direction_are_refused) {
  refuses("vec3(0):normalize()", "vec3.normalize: the vector has length 0, so it has no direction");
  refuses("vec3(1/0):normalize()",
          "vec3.normalize: the vector has length inf, so it has no direction; make its components "
          "finite");
  refuses("vec2(1):reflect(vec2(0))",
          "vec2.reflect: the normal has length 0, so it has no direction");
}

TEST_F(Values, arguments_are_refused_by_place_and_name) {
  refuses("vec3(1):dot('a')",
          "argument 2 of vec3.dot must be a vec3, or a table of 3 numbers; it is a string");
  refuses("vec3(1):dot()",
          "argument 2 of vec3.dot must be a vec3, or a table of 3 numbers; it is missing");
  refuses("vec3(1):lerp(vec3(2), '1')", "argument 3 of vec3.lerp must be a number; it is a string");
  refuses("vec3(1):dot(vec2(1))",
          "argument 2 of vec3.dot must be a vec3, or a table of 3 numbers; it is a vec2");
  refuses("mat4.translate(1, 2)", "argument 3 of mat4.translate must be a number; it is missing");
}

TEST_F(Values, text_reads_back_as_the_same_numbers) {
  EXPECT_EQ(value("vec3(0.1, 1/3, 1e300)"), "vec3(0.1, 0.3333333333333333, 1e+300)");
  EXPECT_EQ(value("vec2(-0.0, 5e-324)"), "vec2(0, 5e-324)");
  EXPECT_EQ(value("vec3(1/0, -1/0, 0/0)"), "vec3(inf, -inf, nan)");
  for (const char* one :
       {"vec2(0.1, 1/3)", "vec4(1e22, 2^53, math.pi, -1e-7)", "quat.axis_angle(20, 1, 2, 3)",
        "mat3.rotate(20, 1, 2, 3)", "mat4.perspective(50, 1.7, 0.1, 1e5)"}) {
    holds(std::string("load('return ' .. tostring(") + one + "))() == " + one);
  }
}

TEST_F(Values, cpp_reads_what_a_script_gives) {
  run("return vec3(1, 2, 3)");
  lua_settop(L(), 1);
  ASSERT_NE(test<glm::dvec3>(L(), 1), nullptr);
  EXPECT_EQ(*test<glm::dvec3>(L(), -1), glm::dvec3(1, 2, 3));
  EXPECT_EQ(test<glm::dvec4>(L(), 1), nullptr);
  EXPECT_EQ(test<glm::dvec3>(L(), 2), nullptr);
  EXPECT_EQ(kind_of(L(), 1), Kind::vec3);
  push(L(), glm::dquat(1, 2, 3, 4));
  EXPECT_EQ(read<glm::dquat>(L(), -1, "the turn"), glm::dquat(1, 2, 3, 4));
  run("return setmetatable({0, 4, 0}, {__index = error, __len = error, __pairs = error})");
  lua_settop(L(), 1);
  EXPECT_EQ(read<glm::dvec3>(L(), -1, "the light"), glm::dvec3(0, 4, 0));
  EXPECT_EQ(lua_gettop(L()), 1);
}

TEST_F(Values, cpp_refuses_what_is_not_the_value) {
  const auto refusal = [&](const std::string& expression) -> std::string {
    value(expression);
    lua_settop(L(), 1);
    try {
      read<glm::dvec3>(L(), 1, "the light");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const std::string must = "the light must be a vec3, or a table of 3 numbers; it is ";
  EXPECT_EQ(refusal("'a'"), must + "a string");
  EXPECT_EQ(refusal("nil"), must + "nil");
  EXPECT_EQ(refusal("vec4(1)"), must + "a vec4");
  EXPECT_EQ(refusal("{1, 2}"), must + "a table of 2 elements");
  EXPECT_EQ(refusal("{1, 2, 3, 4}"), must + "a table of more than 3 elements");
  EXPECT_EQ(refusal("{1, '2', 3}"), must + "a table whose element 2 is a string");
  EXPECT_EQ(refusal("{x = 1, y = 2, w = 3}"), must + "a table whose z is nil");
  EXPECT_EQ(refusal("{x = 1, y = 2, z = 3, w = 4}"), must + "a table of more than 3 elements");
  // What only a metamethod would give is not there.
  EXPECT_EQ(refusal("setmetatable({x = 1, y = 2, w = 3}, {__index = {z = 3}})"),
            must + "a table whose z is nil");
  EXPECT_EQ(refusal("setmetatable({1, 2, w = 3}, {__index = {[3] = 3}})"),
            must + "a table whose element 3 is nil");
  EXPECT_EQ(refusal("io.stdout"), must + "a FILE*");
}

TEST(ValueModules, every_operation_is_documented) {
  for (const Module& module : value_modules()) {
    EXPECT_GT(module.entries.size(), 10u) << module.name;
    for (const Entry& entry : module.entries) {
      EXPECT_STRNE(entry.signature, "") << module.name << "." << entry.name;
      EXPECT_EQ(std::string(entry.text).back(), '.') << module.name << "." << entry.name;
      EXPECT_NE(entry.function, nullptr) << module.name << "." << entry.name;
    }
  }
}

}  // namespace
}  // namespace shadowlab::lua
