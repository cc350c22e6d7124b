// What a manifest says, and what is said of one that is wrong.
#include <gmock/gmock.h>

#include "core/error.h"
#include "lab/manifest.h"
#include "lab_fixture.h"

namespace shadowlab::lab {
namespace {

using testing::HasSubstr;

constexpr const char* one_case = "{ name = 'a', set = { light = {0, 4, 0} } }";

// A lab folder whose manifest is this text.
struct LabFolder : Folder {
  explicit LabFolder(std::string_view manifest) {
    write("lab.lua", manifest);
    write("solution.lua", recipe_text(""));
    write("template.lua", "-- floor: 20\n" + recipe_text(""));
  }
  Lab lab(std::uint64_t seed = 1) const { return load_lab(path(), seed); }
  std::string problem() const {
    try {
      lab();
    } catch (const InputError& problem) {
      return problem.what();
    }
    return "";
  }
};

std::string with_cases(const std::string& cases, const std::string& fields = "points = 10") {
  return "return {\n title = 'T', " + fields + ",\n cases = {\n " + cases + "\n } }\n";
}

TEST(Manifest, says_what_is_drawn_and_compared) {
  const LabFolder folder(
      "return { title = 'T', points = 5, size = {320, 200}, scene = 'table', cases = {\n"
      "{ name = 'a', points = 2, set = { light = {0, 4, 0.5}, darkness = 0.3, kind = 'word', "
      "on = true } },\n"
      "{ name = 'b', points = 3, hidden = true, scene = 'tetra',\n"
      "  camera = { eye = {1, 2, 3}, target = {0, 1, 0}, fovy = 40 },\n"
      "  compare = { stencil = 'after the floor', depth = 'x' } } } }");
  const Lab lab = folder.lab();
  EXPECT_EQ(lab.title, "T");
  EXPECT_EQ(lab.points, 5);
  EXPECT_EQ(lab.floor, 20);
  EXPECT_EQ(lab.width, 320);
  EXPECT_EQ(lab.height, 200);
  ASSERT_EQ(lab.cases.size(), 2u);
  const Case& a = lab.cases[0];
  EXPECT_EQ(a.points, 2);
  EXPECT_EQ(*a.shot.scene, "table");
  using Setting = std::pair<std::string, std::string>;
  EXPECT_THAT(a.shot.settings,
              testing::ElementsAre(Setting("darkness", "0.3"), Setting("kind", "word"),
                                   Setting("light", "0,4,0.5"), Setting("on", "true")));
  EXPECT_TRUE(a.compared.color);
  EXPECT_FALSE(a.hidden);
  const Case& b = lab.cases[1];
  EXPECT_TRUE(b.hidden);
  EXPECT_EQ(*b.shot.scene, "tetra");
  EXPECT_EQ(b.shot.camera->eye, glm::dvec3(1, 2, 3));
  EXPECT_FALSE(b.compared.color);
  EXPECT_EQ(*b.compared.stencil, "after the floor");
}

TEST(Manifest, cases_without_points_share_what_the_others_leave) {
  const LabFolder folder(with_cases("{name='a', points=4}, {name='b'}, {name='c'}"));
  const Lab lab = folder.lab();
  EXPECT_EQ(lab.cases[1].points, 3);
  EXPECT_EQ(lab.cases[2].points, 3);
}

TEST(Manifest, random_cases_depend_on_the_seed_alone) {
  const LabFolder folder(with_cases(
      "{ name = 'a', set = { light = random.point({-1, 3, -1}, {1, 4, 1}), "
      "d = random.number(2, 3), n = random.integer(1, 9), w = random.choice{'x', 'y'} }, "
      "camera = random.camera{ around = {0, 1, 0}, distance = {5, 7}, elevation = {20, "
      "50}, fovy = 40 } }"));
  const Lab one = folder.lab(1), again = folder.lab(1), other = folder.lab(2);
  EXPECT_EQ(one.cases[0].shot.settings, again.cases[0].shot.settings);
  EXPECT_EQ(one.cases[0].shot.camera->eye, again.cases[0].shot.camera->eye);
  EXPECT_NE(one.cases[0].shot.settings, other.cases[0].shot.settings);
  EXPECT_NE(one.cases[0].shot.camera->eye, other.cases[0].shot.camera->eye);
}

TEST(Manifest, random_cameras_keep_their_ranges) {
  const LabFolder folder(
      with_cases("{ name = 'a', camera = random.camera{ around = {0, 1, 0}, distance = {5, 7}, "
                 "elevation = {20, 50} } }"));
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto camera = *folder.lab(seed).cases[0].shot.camera;
    const glm::dvec3 toward = camera.eye - camera.target;
    const double elevation = glm::degrees(std::asin(toward.y / glm::length(toward)));
    EXPECT_EQ(camera.target, glm::dvec3(0, 1, 0));
    EXPECT_GE(glm::length(toward), 5 - 1e-9);
    EXPECT_LE(glm::length(toward), 7 + 1e-9);
    EXPECT_GE(elevation, 20 - 1e-9);
    EXPECT_LE(elevation, 50 + 1e-9);
  }
}

TEST(Manifest, without_a_seed_it_is_of_the_labs_files) {
  const LabFolder one(with_cases(one_case)), other(with_cases("{ name = 'b' }"));
  EXPECT_EQ(load_lab(one.path()).seed, load_lab(one.path()).digest);
  EXPECT_NE(load_lab(one.path()).seed, load_lab(other.path()).seed);
}

TEST(Manifest, mistakes_have_hints_by_language) {
  const LabFolder folder(with_cases(one_case));
  folder.write("mistakes/mask.lua",
               "-- hint: The mask is off.\n-- hint.ca: La màscara.\nreturn {}");
  const Lab lab = folder.lab();
  ASSERT_EQ(lab.mistakes.size(), 1u);
  EXPECT_EQ(lab.mistakes[0].name, "mask");
  EXPECT_EQ(lab.mistakes[0].hints.at("en"), "The mask is off.");
  EXPECT_EQ(lab.mistakes[0].hints.at("ca"), "La màscara.");
}

TEST(Manifest, a_mistake_without_a_hint_is_refused) {
  const LabFolder folder(with_cases(one_case));
  folder.write("mistakes/mask.lua", "return {}");
  EXPECT_THAT(folder.problem(), HasSubstr("mask.lua:1: a mistake begins with its hint"));
}

struct Wrong {
  const char* manifest;
  const char* sentence;
};
class WrongManifest : public testing::TestWithParam<Wrong> {};

TEST_P(WrongManifest, is_refused_with_its_line) {
  const LabFolder folder(GetParam().manifest);
  EXPECT_THAT(folder.problem(), HasSubstr(GetParam().sentence));
}

INSTANTIATE_TEST_SUITE_P(
    Each, WrongManifest,
    testing::Values(
        Wrong{"return {\n title = \n}", "lab.lua:3: "},
        Wrong{"return 7", "a lab returns a table with title, points and cases; this file returns"},
        Wrong{"\nerror('no')", "lab.lua:2: no"},
        Wrong{"return { cases = {} }", "lab.lua:1: cases of the lab is a table of one case"},
        Wrong{"return {\n\n ponts = 3, cases = {{name='a'}} }",
              "lab.lua:3: ponts of the lab is nothing that is read; did you mean points?"},
        Wrong{
            "return { cases = {\n{ name = 'a' },\n{ name = 'low', points = 'x' } } }",
            "lab.lua:3: points of the case \"low\" is a number from 0 to 1000000; it is a string"},
        Wrong{"return { cases = { { set = {} } } }", "name of case 1 is missing"},
        Wrong{"return { cases = { {name='a'}, {name='a'} } }", "is another case's already"},
        Wrong{"return { points = 3,\n cases = { {name='a', points=1}, {name='b', points=1} } }",
              "lab.lua:1: points of the lab is 3, and those of the cases add up to 2"},
        Wrong{"return { cases = { {name='a', set={light={1,2}}} } }", "table of 3 numbers"},
        Wrong{"return { cases = { {name='a', set={f=function() end}} } }",
              "is a number, three numbers, true, false or a name; it is a function"},
        Wrong{"return { cases = { {name='a', camera={eye={0,1,0}, target={0,1,0}}} } }", "camera"},
        Wrong{"return { size = {0, 4}, cases = { {name='a'} } }", "is {width, height} in pixels"},
        Wrong{"return { cases = { {name='a', compare={}} } }", "something is compared"},
        Wrong{"return {\n cases = { {name='a', set={d=random.number(3, 2)}} } }",
              "lab.lua:2: random.number: the lowest comes first"},
        Wrong{"return { cases = { {name='a', set={d=random.nmber(3, 2)}} } }",
              "did you mean random.number?"},
        Wrong{"while true do end", "lab.lua:1: "}));

TEST(Manifest, a_folder_that_is_no_lab_is_refused) {
  const Folder folder;
  try {
    load_lab(folder.path());
    FAIL();
  } catch (const InputError& problem) {
    EXPECT_THAT(problem.what(), HasSubstr("is no lab: there is no lab.lua in it"));
  }
}

}  // namespace
}  // namespace shadowlab::lab
