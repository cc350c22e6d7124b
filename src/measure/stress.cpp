#include "measure/stress.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <map>

#include "core/error.h"
#include "measure/page.h"
#include "measure/table.h"

namespace shadowlab::measure {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> lua_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".lua") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// Whether a file's text registers facts: others there are recipes that facts draw with.
bool has_rows(const fs::path& file) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("row{") || line.starts_with("row {")) return true;
  }
  return false;
}

// What each fact of one file came to; each is run once, however many rows it is of.
class Outcomes {
 public:
  explicit Outcomes(FactFile& file) : file_(file) {}

  void add(const std::string& name, StressRow& row) {
    auto found = outcomes_.find(name);
    if (found == outcomes_.end()) found = outcomes_.emplace(name, outcome(name)).first;
    const Outcome& outcome = found->second;
    row.naive.insert(row.naive.end(), outcome.naive.begin(), outcome.naive.end());
    row.ours.insert(row.ours.end(), outcome.ours.begin(), outcome.ours.end());
    if (row.failure.empty() && !outcome.failure.empty())
      row.failure = fmt::format("{}: {}", name, outcome.failure);
  }

 private:
  struct Outcome {
    std::vector<Note> naive, ours;
    std::string failure;
  };

  Outcome outcome(const std::string& name) {
    const auto fact = std::find_if(file_.facts().begin(), file_.facts().end(),
                                   [&](const Fact& each) { return each.name == name; });
    Outcome outcome;
    try {
      file_.run(*fact);
    } catch (const InputError& problem) {
      outcome.failure = problem.what();
    }
    outcome.naive = file_.naive();
    outcome.ours = file_.ours();
    return outcome;
  }

  FactFile& file_;
  std::map<std::string, Outcome> outcomes_;
};

bool has_picture(const std::vector<Note>& notes) {
  return std::ranges::any_of(notes, [](const Note& note) { return note.picture.has_value(); });
}

std::string joined(const std::vector<Note>& notes) {
  std::vector<std::string> told;
  std::string text;
  for (const Note& note : notes) {
    if (std::find(told.begin(), told.end(), note.words) != told.end()) continue;
    text += (text.empty() ? "" : "; ") + note.words;
    told.push_back(note.words);
  }
  return text;
}

std::string write_first(const std::vector<Note>& notes, const fs::path& folder,
                        const std::string& name) {
  for (const Note& note : notes) {
    if (!note.picture) continue;
    fs::create_directories(folder / "pictures");
    image::Image opaque = *note.picture;
    for (std::size_t i = 3; i < opaque.rgba.size(); i += 4) opaque.rgba[i] = 255;
    image::write_png(folder / name, opaque);
    return name;
  }
  return "";
}

}  // namespace

std::vector<StressRow> stress(const fs::path& folder, std::span<const int> wanted,
                              const std::function<void(const Progress&)>& progress) {
  std::vector<std::pair<fs::path, HardCase>> found;
  for (const fs::path& path : lua_files(folder)) {
    if (!has_rows(path)) continue;
    const FactFile file(path);
    for (const HardCase& hard : file.cases()) {
      if (wanted.empty() || std::count(wanted.begin(), wanted.end(), hard.number) > 0)
        found.emplace_back(path, hard);
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.second.number < b.second.number; });
  for (std::size_t i = 1; i < found.size(); ++i) {
    if (found[i].second.number == found[i - 1].second.number)
      throw InputError(fmt::format("there are two rows {}", found[i].second.number));
  }
  for (const int number : wanted) {
    if (std::none_of(found.begin(), found.end(),
                     [&](const auto& each) { return each.second.number == number; }))
      throw InputError(fmt::format("there is no row {}", number));
  }
  // File by file, since a file's contexts and programs serve all of its facts.
  std::map<fs::path, std::vector<HardCase>> by_file;
  for (auto& [path, hard] : found) by_file[path].push_back(hard);
  std::vector<StressRow> rows;
  for (const auto& [path, cases] : by_file) {
    FactFile file(path);
    Outcomes outcomes(file);
    for (const HardCase& hard : cases) {
      if (progress) progress({rows.size(), found.size(), hard.title});
      StressRow row{hard, path.stem().string(), {}, {}, ""};
      for (const std::string& fact : hard.facts) outcomes.add(fact, row);
      if (row.passes() && !row.naive.empty() && !(has_picture(row.naive) && has_picture(row.ours)))
        row.failure =
            "it tells how the listing fails and does not show it: give one naive(…) and one "
            "ours(…) of its facts a picture";
      rows.push_back(std::move(row));
    }
  }
  std::stable_sort(rows.begin(), rows.end(), [](const StressRow& a, const StressRow& b) {
    return a.hard.number < b.hard.number;
  });
  return rows;
}

std::string naive_words(const StressRow& row) {
  if (!row.naive.empty()) return joined(row.naive);
  return row.hard.without;
}

std::string our_words(const StressRow& row) {
  if (!row.passes()) return row.failure;
  return row.ours.empty() ? "as expected" : joined(row.ours);
}

RowPictures write_pictures(const StressRow& row, const fs::path& folder) {
  return {write_first(row.naive, folder, fmt::format("pictures/{:02}_naive.png", row.hard.number)),
          write_first(row.ours, folder, fmt::format("pictures/{:02}_ours.png", row.hard.number))};
}

Json record_of(const StressRow& row, const RowPictures& pictures) {
  return {{"case", row.hard.number},
          {"title", row.hard.title},
          {"expected", row.hard.expected},
          {"naive", naive_words(row)},
          {"naive_fails", !row.naive.empty()},
          {"ours", our_words(row)},
          {"pass", row.passes()},
          {"file", row.file},
          {"facts", row.hard.facts},
          {"naive_picture", pictures.naive},
          {"our_picture", pictures.ours}};
}

std::string stress_csv(const Json& rows) {
  std::string csv = "case,title,expected,naive,ours,pass,file\n";
  for (const Json& row : rows) {
    csv += fmt::format(
        "{},{},{},{},{},{},{}\n", row.at("case").get<int>(),
        csv_field(row.at("title").get<std::string>()),
        csv_field(row.at("expected").get<std::string>()),
        csv_field(row.at("naive").get<std::string>()), csv_field(row.at("ours").get<std::string>()),
        row.at("pass").get<bool>() ? "pass" : "fail", csv_field(row.at("file").get<std::string>()));
  }
  return csv;
}

std::string stress_page(const Json& rows, const fs::path& folder) {
  Json pictures = Json::object();
  for (const Json& row : rows) {
    for (const char* which : {"naive_picture", "our_picture"}) {
      const auto name = row.at(which).get<std::string>();
      if (!name.empty()) pictures[name] = data_url(folder / name);
    }
  }
  return filled(page_file("stress.html"),
                {{"rows", script_text(rows)}, {"pictures", script_text(pictures)}});
}

}  // namespace shadowlab::measure
