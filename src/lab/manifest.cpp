#include "lab/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/error.h"
#include "lab/digest.h"
#include "lab/manifest_table.h"
#include "lab/random.h"
#include "lab/text_file.h"
#include "lua/value.h"

namespace shadowlab::lab {
namespace {

namespace fs = std::filesystem;

constexpr int largest_side = 2048;  // pixels: ten thousand submissions are to be kept and shown

std::vector<fs::path> scripts_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (entry.path().extension() == ".lua" && entry.is_regular_file(none))
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// What "-- KEY: rest" of the file's first comment lines say, by their keys.
std::map<std::string, std::string> remarks(const fs::path& file) {
  std::map<std::string, std::string> found;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line) && line.starts_with("--");) {
    const auto colon = line.find(':');
    if (colon == std::string::npos) continue;
    const auto begin = line.find_first_not_of("- ");
    const auto after = line.find_first_not_of(' ', colon + 1);
    if (begin >= colon || after == std::string::npos) continue;
    found.emplace(line.substr(begin, colon - begin),
                  line.substr(after, line.find_last_not_of("\r ") + 1 - after));
  }
  return found;
}

std::vector<Mistake> mistakes_in(const fs::path& folder) {
  std::vector<Mistake> mistakes;
  for (const fs::path& file : scripts_in(folder)) {
    Mistake mistake{file.stem().string(), file, {}};
    for (const auto& [key, text] : remarks(file)) {
      if (key == "hint") mistake.hints["en"] = text;
      if (key.starts_with("hint.")) mistake.hints[key.substr(5)] = text;
    }
    if (!mistake.hints.contains("en")) {
      throw InputError(
          fmt::format("{}:1: a mistake begins with its hint: a line \"-- hint: what to look at\"",
                      file.string()));
    }
    mistakes.push_back(std::move(mistake));
  }
  return mistakes;
}

double floor_of(const fs::path& file) {
  const auto said = remarks(file);
  const auto floor = said.find("floor");
  if (floor == said.end()) return 0;
  char* end = nullptr;
  const double percent = std::strtod(floor->second.c_str(), &end);
  if (end == floor->second.c_str() || *end != '\0' || !(percent >= 0 && percent <= 100)) {
    throw InputError(fmt::format("{}: \"-- floor:\" takes a percentage, 0 to 100; \"{}\" given",
                                 file.string(), floor->second));
  }
  return percent;
}

std::uint64_t digest_of(const Lab& lab) {
  std::uint64_t sum = digest(lab.name);
  for (const fs::path& file : {lab.folder / "lab.lua", lab.solution(), lab.start()})
    sum = digest(read_text(file), sum);
  for (const Mistake& mistake : lab.mistakes) sum = digest(read_text(mistake.file), sum);
  return sum;
}

// A parameter's value as --set takes it.
std::string setting(const Table& settings, const std::string& name) {
  lua_State* L = settings.raw();
  switch (lua_type(L, -1)) {
    case LUA_TNUMBER:
      return fmt::format("{}", lua_tonumber(L, -1));
    case LUA_TBOOLEAN:
      return lua_toboolean(L, -1) ? "true" : "false";
    case LUA_TSTRING:
      return lua_tostring(L, -1);
    default:
      break;
  }
  const auto kind = lua::kind_of(L, -1);
  const bool three = lua_type(L, -1) == LUA_TTABLE || kind == lua::Kind::vec3;
  if (!three) settings.refuse(name, "is a number, three numbers, true, false or a name", -1);
  const auto v = lua::read<glm::dvec3>(L, -1, settings.title(name).c_str());
  return fmt::format("{},{},{}", v.x, v.y, v.z);
}

scene::Camera camera_of(const Table& table) {
  table.expect_fields({"eye", "target", "up", "fovy", "near", "far"});
  scene::Camera camera;
  camera.eye = table.three("eye", camera.eye);
  camera.target = table.three("target", camera.target);
  camera.up = table.three("up", camera.up);
  camera.fovy = table.number("fovy", camera.fovy, 1, 170);
  camera.near = table.number("near", camera.near, 1e-6, 1e9);
  camera.far = table.number("far", camera.far, 1e-6, 1e12);
  if (camera.far <= camera.near) table.refuse("far", "is beyond near");
  camera.view();  // throws where it looks nowhere
  return camera;
}

Compared compared_of(const Table& table) {
  table.expect_fields({"color", "stencil", "depth"});
  Compared compared;
  compared.color = table.flag("color", false);
  compared.stencil = table.text("stencil");
  compared.depth = table.text("depth");
  if (!compared.color && !compared.stencil && !compared.depth)
    table.refuse("color", "is true, or stencil or depth name a pass: something is compared");
  return compared;
}

// A case without points has -1 of them.
Case case_of(const Table& table, const std::optional<std::string>& scene) {
  table.expect_fields({"name", "scene", "set", "camera", "points", "hidden", "compare"});
  Case a_case;
  a_case.name = table.required_text("name");
  a_case.shot.scene = table.text("scene");
  if (!a_case.shot.scene) a_case.shot.scene = scene;
  a_case.points = table.number("points", -1, 0, 1e6);
  a_case.hidden = table.flag("hidden", false);
  table.each("set", [&](const Table& settings, const std::string& name) {
    a_case.shot.settings.emplace_back(name, setting(settings, name));
  });
  std::sort(a_case.shot.settings.begin(), a_case.shot.settings.end());
  if (const auto camera = table.table("camera")) a_case.shot.camera = camera_of(*camera);
  if (const auto compare = table.table("compare")) a_case.compared = compared_of(*compare);
  return a_case;
}

// Cases without points share what the others leave; all together are worth what the lab is.
void share_points(Lab& lab, const Table& table, bool given) {
  double sum = 0;
  int open = 0;
  for (const Case& a_case : lab.cases) {
    if (a_case.points < 0) ++open;
    sum += std::max(0.0, a_case.points);
  }
  if (!given) lab.points = open > 0 ? sum + open : sum;
  if (open > 0 && lab.points <= sum)
    table.refuse("points", fmt::format("leaves nothing for {} of the cases", open));
  for (Case& a_case : lab.cases) {
    if (a_case.points < 0) a_case.points = (lab.points - sum) / open;
  }
  if (open == 0 && std::abs(lab.points - sum) > 1e-9) {
    table.refuse("points",
                 fmt::format("is {}, and those of the cases add up to {}", lab.points, sum));
  }
}

void read_lab(Lab& lab, const Table& table) {
  table.expect_fields({"title", "points", "size", "scene", "cases"});
  lab.title = table.text("title").value_or(lab.name);
  const auto [width, height] = table.size("size", {256, 256}, largest_side);
  lab.width = width;
  lab.height = height;
  const auto scene = table.text("scene");
  table.each_of("cases", [&](const Table& one) {
    Case a_case = case_of(one, scene);
    for (const Case& other : lab.cases) {
      if (other.name == a_case.name) one.refuse("name", "is another case's already");
    }
    lab.cases.push_back(std::move(a_case));
  });
  if (lab.cases.empty()) table.refuse("cases", "is a table of one case or more");
  const double points = table.number("points", -1, 0, 1e6);
  lab.points = points;
  share_points(lab, table, points >= 0);
}

}  // namespace

Lab load_lab(const fs::path& folder, std::optional<std::uint64_t> seed) {
  Lab lab;
  std::error_code none;
  lab.folder = folder;
  lab.name = fs::weakly_canonical(folder, none).filename().string();
  for (const fs::path& file : {folder / "lab.lua", lab.solution(), lab.start()}) {
    if (!fs::is_regular_file(file, none)) {
      throw InputError(fmt::format("{} is no lab: there is no {} in it", folder.string(),
                                   file.filename().string()));
    }
  }
  lab.floor = floor_of(lab.start());
  lab.mistakes = mistakes_in(folder / "mistakes");
  lab.alternatives = scripts_in(folder / "alternatives");
  lab.digest = digest_of(lab);
  lab.seed = seed.value_or(lab.digest);

  const fs::path file = folder / "lab.lua";
  const std::string source = read_text(file);
  std::mt19937_64 generator(digest(lab.name, empty_digest ^ lab.seed));
  lua::Limits limits;
  limits.seconds = 5;
  limits.memory = std::size_t{64} << 20;
  lua::State state(limits, [](std::string_view) {});
  state.run([&](lua_State* L) {
    lua::open_values(L);
    open_random(L, generator);
    if (const auto problem = state.try_load_file(L, file)) throw InputError(*problem);
    lua_call(L, 0, 1);
    read_lab(lab, Table::returned(L, {file.string(), source}));
  });
  return lab;
}

}  // namespace shadowlab::lab
