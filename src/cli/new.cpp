// shadowlab new: a recipe or a lab to begin with.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "cli/beginnings.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "core/error.h"

namespace shadowlab::cli {
namespace {

// "my_shadow" becomes "My shadow".
std::string title_of(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

void expect_name(const std::string& name, const std::string& given) {
  const bool good = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-';
  });
  if (!good)
    throw InputError(fmt::format("\"{}\" is no name: names have letters, digits, _ and -", given));
}

void new_recipe(const std::string& given) {
  std::filesystem::path file(given);
  if (file.extension() == ".lua") file.replace_extension();
  const std::string name = file.filename().string();
  expect_name(name, given);
  file += ".lua";
  std::error_code none;
  if (std::filesystem::exists(file, none))
    throw InputError(file.string() + " exists already; choose another name");
  expect_writable(file);
  write_text(file, recipe_to_begin_with(file.string(), title_of(name)), Existing::refuse);
  fmt::print("{} is a recipe; draw it: shadowlab run {}\n", file.string(), file.string());
}

void new_lab(const std::string& given) {
  const std::filesystem::path folder(given);
  const std::string name = folder.filename().string();
  expect_name(name, given);
  std::error_code none;
  if (std::filesystem::exists(folder, none))
    throw InputError(folder.string() + " exists already; choose another name");
  const auto files = lab_to_begin_with(title_of(name));
  make_folder(folder / "mistakes");
  for (const auto& [file, text] : files) write_text(folder / file, text, Existing::refuse);
  fmt::print("{0} is a lab; grade its template: shadowlab grade {0} {0}/template.lua\n",
             folder.string());
}

}  // namespace

void add_new(CLI::App& app, Answer& answer) {
  CLI::App* command = app.add_subcommand("new", "Write a recipe or a lab to begin with");
  struct Options {
    std::string what, name;
  };
  auto options = std::make_shared<Options>();
  command->add_option("what", options->what, "recipe or lab")
      ->required()
      ->check(one_of({"recipe", "lab"}))
      ->type_name("recipe|lab");
  command->add_option("name", options->name, "Its name; NAME.lua or the folder NAME must not exist")
      ->required()
      ->type_name("NAME");
  command->footer("Example:\n  shadowlab new recipe my_shadow && shadowlab run my_shadow.lua");
  command->callback([options, &answer] {
    options->what == "lab" ? new_lab(options->name) : new_recipe(options->name);
    answer = Answer::yes;
  });
}

}  // namespace shadowlab::cli
