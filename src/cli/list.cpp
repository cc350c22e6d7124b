// shadowlab list: what there is to draw.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "cli/commands.h"
#include "cli/labs.h"
#include "cli/session.h"
#include "core/error.h"
#include "core/version.h"
#include "lua/stage.h"

namespace shadowlab::cli {
namespace {

namespace fs = std::filesystem;

struct Entry {
  std::string name;
  std::string title;  ///< or why it does not load
};

void print(const std::vector<Entry>& entries) {
  std::size_t widest = 0;
  for (const Entry& entry : entries) widest = std::max(widest, entry.name.size());
  for (const Entry& entry : entries) fmt::print("{:<{}}  {}\n", entry.name, widest, entry.title);
}

std::vector<fs::path> files_of(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (entry.path().extension() == ".lua") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<Entry> recipes(gl::Graphics& graphics) {
  std::vector<Entry> entries;
  for (const fs::path& file : all_recipes()) {
    Entry entry{file.stem().string(), {}};
    try {
      entry.title = recipe::Recipe(graphics, file).description().title;
    } catch (const InputError& problem) {
      entry.title = fmt::format("does not load: {}", problem.what());
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

// A scene's file is Lua too: it is loaded as a recipe loads it.
std::string title_of_scene(gl::Graphics& graphics, const std::string& name) {
  std::string title;
  lua::State state({}, [&title](std::string_view text) { title += text; });
  const auto scripts = home() / "scripts";
  state.search_in({scripts});
  lua::Stage stage{state, graphics, nullptr, {}, {scripts, home() / "shaders"}};
  lua::open_all(stage);
  state.load_text(fmt::format("print(scene.load(\"{}\").title)", name), "scene");
  state.call(0, 0);
  return title.substr(0, title.find_last_not_of('\n') + 1);
}

std::vector<Entry> scenes(gl::Graphics& graphics) {
  std::vector<Entry> entries;
  for (const fs::path& file : files_of(home() / "scripts" / "scenes")) {
    Entry entry{file.stem().string(), {}};
    try {
      entry.title = title_of_scene(graphics, entry.name);
    } catch (const InputError& problem) {
      entry.title = fmt::format("does not load: {}", problem.what());
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::vector<Entry> labs() {
  std::vector<Entry> entries;
  for (const fs::path& folder : all_labs()) {
    Entry entry{folder.filename().string(), {}};
    try {
      entry.title = lab::load_lab(folder).title;
    } catch (const InputError& problem) {
      entry.title = fmt::format("does not load: {}", problem.what());
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

void list(const std::string& what) {
  if (what == "labs") {
    const auto found = labs();
    if (found.empty()) fmt::print(stderr, "There are no labs yet.\n");
    return print(found);
  }
  // A recipe speaks of gl as it loads, so it needs a context, though no picture.
  gl::Graphics graphics(context::create(), 16, 16);
  if (what == "recipes") return print(recipes(graphics));
  if (what == "scenes") return print(scenes(graphics));
  fmt::print("Recipes (shadowlab run NAME):\n");
  print(recipes(graphics));
  fmt::print("\nScenes (--scene NAME):\n");
  print(scenes(graphics));
  fmt::print("\nLabs (shadowlab grade NAME):\n");
  print(labs());
}

}  // namespace

void add_list(CLI::App& app, Answer& answer) {
  CLI::App* command = app.add_subcommand("list", "List recipes, scenes or labs with their titles");
  auto what = std::make_shared<std::string>();
  command->add_option("what", *what, "One of them alone, without a heading")
      ->check(one_of({"recipes", "scenes", "labs"}))
      ->type_name("recipes|scenes|labs");
  command->footer("Example:\n  shadowlab list recipes");
  command->callback([what, &answer] {
    list(*what);
    answer = Answer::yes;
  });
}

}  // namespace shadowlab::cli
