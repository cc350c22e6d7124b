#include "values_fixture.h"

namespace shadowlab::lua {
namespace {

TEST_F(Values, a_matrix_prints_its_rows_aligned) {
  EXPECT_EQ(value("mat4.translate(10, 0.5, -3)"),
            "mat4.rows(\n"
            "  1, 0, 0,  10,\n"
            "  0, 1, 0, 0.5,\n"
            "  0, 0, 1,  -3,\n"
            "  0, 0, 0,   1)");
}

TEST_F(Values, matrices_are_made_column_by_column_or_row_by_row) {
  run("m = mat4(1,2,3,4, 5,6,7,8, 9,10,11,12, 13,14,15,16)");
  EXPECT_EQ(value("m[2]"), "vec4(5, 6, 7, 8)");
  EXPECT_EQ(number("m[2][3]"), 7);
  EXPECT_EQ(value("m:column(2)"), "vec4(5, 6, 7, 8)");
  EXPECT_EQ(value("m:row(2)"), "vec4(2, 6, 10, 14)");
  holds("m == mat4(vec4(1,2,3,4), vec4(5,6,7,8), vec4(9,10,11,12), vec4(13,14,15,16))");
  holds("m == mat4{1,2,3,4, 5,6,7,8, 9,10,11,12, 13,14,15,16}");
  holds("m:transpose() == mat4.rows(1,2,3,4, 5,6,7,8, 9,10,11,12, 13,14,15,16)");
  holds("m == mat4.rows(m:row(1), m:row(2), m:row(3), m:row(4))");
  holds("mat4(1) == mat4.identity() and mat3(1) == mat3.identity()");
  holds("mat4(mat3(2)) == mat4.scale(2) and mat3(mat4.scale(1, 2, 3)) == mat3.scale(1, 2, 3)");
  holds("m:mat3() == mat3(1,2,3, 5,6,7, 9,10,11) and #m == 4 and #mat3(1) == 3");
  EXPECT_EQ(value("mat3.rows(1,2,3, 4,5,6, 7,8,9)[1]"), "vec3(1, 4, 7)");
}

TEST_F(Values, matrices_refuse_the_wrong_elements_and_places) {
  refuses("mat4(1, 2)", "mat4 takes 16 numbers, which vectors may bring; it got 2");
  refuses("mat3.rows(1)", "mat3.rows takes 9 numbers, which vectors may bring; it got 1");
  refuses("mat4('a')",
          "argument 1 of mat4 must be a mat4, or a table of 16 numbers; it is a "
          "string");
  refuses("mat4(1)[5]", "a mat4 has columns 1 to 4; it has no [5]");
  refuses("mat3(1):row(0)", "mat3.row: a mat3 has rows 1 to 3; there is no row 0");
  refuses("mat3(1):column(1.5)", "mat3.column: a mat3 has columns 1 to 3; there is no column 1.5");
}

TEST_F(Values, matrix_arithmetic_is_linear_algebra) {
  run("m = mat3.rows(1,2,3, 4,5,6, 7,8,10)");
  EXPECT_EQ(value("m * vec3(1, 0, -1)"), "vec3(-2, -2, -3)");
  holds("m * mat3(1) == m and (m + m) == 2 * m and (m * 4) / 2 == m * 2 and m - m == mat3(0)");
  holds("-m == m * -1");
  holds("mat4.translate(1, 2, 3) * mat4.scale(2) * vec4(1, 1, 1, 1) == vec4(3, 4, 5, 1)");
  holds("mat4.scale(2) * mat4.translate(1, 2, 3) * vec4(1, 1, 1, 1) == vec4(4, 6, 8, 1)");
  EXPECT_EQ(number("m:determinant()"), -3);
  EXPECT_EQ(number("mat4.scale(2):determinant()"), 8);
}

TEST_F(Values, pairs_without_a_meaning_say_what_to_write) {
  refuses("mat4(1) * vec3(1)",
          "cannot multiply a mat4 by a vec3; use m * vec4(v, 1), m:transform_point(v) or "
          "m:transform_direction(v)");
  refuses("vec4(1) * mat4(1)",
          "cannot multiply a vec4 by a mat4; write the vector on the right: m * v");
  refuses("mat4(1) * mat3(1)",
          "cannot multiply a mat4 by a mat3; m:mat3() and mat4(m) turn one into the other");
  refuses("mat3(1) / mat3(1)", "cannot divide a mat3 by a mat3; multiply by m:inverse()");
  refuses("vec3(1) + vec4(1)", "cannot add a vec3 and a vec4");
  refuses("vec3(1) + 'a'", "cannot add a vec3 and a string");
  refuses("nil * vec3(1)", "cannot multiply nil by a vec3");
  refuses("mat4(1) + 1", "cannot add a mat4 and a number");
}

TEST_F(Values, an_inverse_undoes_the_matrix) {
  holds("mat4.translate(1, 2, 3):inverse() == mat4.translate(-1, -2, -3)");
  holds("mat3.scale(2, 4, 8):inverse() == mat3.scale(0.5, 0.25, 0.125)");
  // Triangular, so its determinant is exact however large the translation.
  holds("mat4.translate(1e17, 0, 0):inverse() == mat4.translate(-1e17, 0, 0)");
  run("m = mat4.perspective(50, 1.5, 0.1, 100); i = m * m:inverse() - mat4(1)");
  for (int c = 1; c <= 4; ++c) {
    for (int r = 1; r <= 4; ++r) {
      const std::string element = "i[" + std::to_string(c) + "][" + std::to_string(r) + "]";
      // The matrix's condition number is about 1e3: far below 1e-12 in double precision.
      EXPECT_NEAR(number(element), 0, 1e-12) << element;
    }
  }
}

TEST_F(Values, a_singular_matrix_has_no_inverse) {
  const std::string why =
      "the matrix is singular (its determinant is 0 up to round-off), so it has no inverse";
  refuses("mat4.scale(1, 0, 1):inverse()", "mat4.inverse: " + why);
  refuses("mat3.rows(1,2,3, 4,5,6, 7,8,9):inverse()", "mat3.inverse: " + why);
  // A rank of 2 whose computed determinant is round-off, not 0.
  refuses("mat3.rows(0.1,0.2,0.3, 0.4,0.5,0.6, 0.7,0.8,0.9):inverse()", "mat3.inverse: " + why);
  refuses("mat4(0/0):inverse()",
          "mat4.inverse: the matrix holds numbers that are not finite or too large");
}

TEST_F(Values, quarter_turns_are_exact) {
  holds("mat4.rotate(90, 0, 0, 1) * vec4(1, 0, 0, 1) == vec4(0, 1, 0, 1)");
  holds("mat4.rotate(90, vec3(0, 1, 0)) * vec4(0, 0, 1, 0) == vec4(1, 0, 0, 0)");
  holds("mat3.rotate(90, 1, 0, 0) * vec3(0, 1, 0) == vec3(0, 0, 1)");
  holds("mat3.rotate(-90, 0, 0, 9) * vec3(0, 1, 0) == vec3(1, 0, 0)");
  holds("mat3.rotate(180, {0, 0, 1}) == mat3.scale(-1, -1, 1)");
  holds("mat3.rotate(3600000000, 1, 2, 3) == mat3(1)");
  EXPECT_EQ(number("mat3.rotate(60, 0, 0, 1)[1][1]"), 0.5);
  EXPECT_EQ(number("mat3.rotate(-150, 0, 0, 1)[1][2]"), -0.5);
}

TEST_F(Values, rotation_turns_counter_clockwise_around_any_axis) {
  // 120 degrees around (1, 1, 1) permutes the axes: x to y, y to z, z to x.
  run("v = mat3.rotate(120, 1, 1, 1) * vec3(1, 2, 3)");
  // A few roundings of numbers below 3.
  EXPECT_NEAR(number("v.x"), 3, 4e-15);
  EXPECT_NEAR(number("v.y"), 1, 4e-15);
  EXPECT_NEAR(number("v.z"), 2, 4e-15);
  refuses("mat4.rotate(10, 0, 0, 0)", "mat4.rotate: the axis has length 0, so it has no direction");
}

TEST_F(Values, look_at_takes_the_eye_to_the_origin_and_the_target_down_minus_z) {
  run("m = mat4.look_at({3, 0, 0}, {0, 0, 0}, {0, 1, 0})");
  holds("m:transform_point{3, 0, 0} == vec3(0)");
  holds("m:transform_point{0, 0, 0} == vec3(0, 0, -3)");
  holds("m:transform_direction{0, 1, 0} == vec3(0, 1, 0)");
  holds("m:transform_direction{0, 0, -1} == vec3(1, 0, 0)");
  refuses("mat4.look_at({1, 2, 3}, {1, 2, 3}, {0, 1, 0})",
          "mat4.look_at: the eye and the target are the same point; move one of them");
  refuses("mat4.look_at({0, 0, 0}, {0, -5, 0}, {0, 1, 0})",
          "mat4.look_at: up is along the way from the eye to the target; take another up");
  refuses("mat4.look_at({0, 0, 0}, {0, 0, -1}, {0, 0, 0})",
          "mat4.look_at: up has length 0, so it has no direction");
}

TEST_F(Values, projections_take_their_bounds_to_the_cube) {
  run("p = mat4.perspective(90, 2, 1, 3)");
  holds("p:transform_point{2, 1, -1} == vec3(1, 1, -1)");
  holds("p:transform_point{-6, -3, -3} == vec3(-1, -1, 1)");
  run("f = mat4.frustum(-1, 3, -2, 2, 1, 3)");
  holds("f:transform_point{-1, -2, -1} == vec3(-1, -1, -1)");
  holds("f:transform_point{9, 6, -3} == vec3(1, 1, 1)");
  run("o = mat4.ortho(-1, 3, -2, 2, 1, 3)");
  holds("o:transform_point{-1, -2, -1} == vec3(-1, -1, -1)");
  holds("o:transform_point{3, 2, -3} == vec3(1, 1, 1)");
}

TEST_F(Values, projections_refuse_empty_volumes) {
  refuses("mat4.perspective(0, 1, 1, 2)",
          "mat4.perspective: the field of view must lie between 0 and 180 degrees; it is 0");
  refuses(
      "mat4.perspective(45, 0, 1, 2)",
      "mat4.perspective: the aspect, width / height, must be greater than 0 and finite; it is 0");
  refuses("mat4.perspective(45, 1, 0, 2)",
          "mat4.perspective: near must be greater than 0; it is 0");
  refuses("mat4.perspective(45, 1, 2, 2)",
          "mat4.perspective: far must be greater than near; they are 2 and 2");
  refuses("mat4.perspective(45, 1, 2, math.huge)",
          "mat4.perspective: far must be finite; for a far plane at infinity use "
          "shadow.infinite_perspective");
  refuses("mat4.perspective(45, 1, 0/0, 2)",
          "mat4.perspective: near must be greater than 0; it is nan");
  refuses("mat4.ortho(2, 2, 0, 1, 0, 1)", "mat4.ortho: left and right must differ; both are 2");
  refuses("mat4.ortho(0, 1, 0, 1, 5, 5)", "mat4.ortho: near and far must differ; both are 5");
  refuses("mat4.frustum(0, 1, 3, 3, 1, 2)", "mat4.frustum: bottom and top must differ; both are 3");
  refuses("mat4.frustum(0, 1/0, 0, 1, 1, 2)",
          "mat4.frustum: left and right must be finite; they are 0 and inf");
}

TEST_F(Values, a_point_at_infinity_is_refused) {
  refuses("mat4.perspective(90, 1, 1, 3):transform_point{1, 1, 0}",
          "mat4.transform_point: the point goes to infinity (its w is 0); m * vec4(v, 1) gives its "
          "direction there");
}

TEST_F(Values, quaternions_rotate_as_their_matrices_do) {
  run("q = quat.axis_angle(120, 1, 1, 1)");
  run("d = q * vec3(1, 2, 3) - vec3(3, 1, 2); e = q:mat3() * vec3(1, 2, 3) - vec3(3, 1, 2)");
  // A few roundings of numbers below 3.
  EXPECT_LT(number("d:length()"), 4e-15);
  EXPECT_LT(number("e:length()"), 4e-15);
  holds("mat4(q:mat3()) == q:mat4()");
  holds("quat.axis_angle(180, 0, 1, 0) * quat.axis_angle(180, 1, 0, 0) == quat(0, 0, 0, -1)");
  holds("quat.axis_angle(180, 0, 0, 5) == quat(0, 0, 0, 1)");
  holds(
      "quat(1, 2, 3, 4):inverse() * quat(1, 2, 3, 4) == quat.identity() or "
      "(quat(1, 2, 3, 4):inverse() * quat(1, 2, 3, 4) - quat.identity()):length() < 1e-15");
  holds("quat(1, 2, 3, 4):conjugate() == quat(1, -2, -3, -4)");
  EXPECT_EQ(value("quat{1, 2, 3, 4}"), "quat(1, 2, 3, 4)");
  EXPECT_EQ(value("quat{w = 1, x = 2, y = 3, z = 4}"), "quat(1, 2, 3, 4)");
  EXPECT_EQ(number("quat(1, 2, 3, 4).w * 10 + quat(1, 2, 3, 4).z"), 14);
  EXPECT_EQ(number("quat(2, 4, 5, 6):length()"), 9);
  EXPECT_EQ(number("quat(1, 2, 3, 4):dot(quat(1, 1, 1, 1))"), 10);
}

TEST_F(Values, slerp_goes_the_shorter_way_at_constant_speed) {
  run("a, b = quat.identity(), quat.axis_angle(90, 0, 0, 1)");
  run("d = a:slerp(b, 1 / 3) - quat.axis_angle(30, 0, 0, 1)");
  run("e = a:slerp(-b, 1 / 3) - quat.axis_angle(30, 0, 0, 1)");
  // The arc cosine and the sines of one angle: a few roundings of numbers up to 1.
  EXPECT_LT(number("d:length()"), 1e-15);
  EXPECT_LT(number("e:length()"), 1e-15);
  const std::string why = "the quaternion has length 0, so it has no direction";
  refuses("quat(0, 0, 0, 0):slerp(quat.identity(), 0)", "quat.slerp: " + why);
  refuses("quat(0, 0, 0, 0):inverse()", "quat.inverse: " + why);
  refuses("quat.axis_angle(10, vec3(0))",
          "quat.axis_angle: the axis has length 0, so it has no direction");
}

}  // namespace
}  // namespace shadowlab::lua
