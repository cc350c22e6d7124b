// shadowlab grade: submissions against a lab.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <future>
#include <memory>
#include <thread>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/labs.h"
#include "core/error.h"
#include "lab/formats.h"
#include "lab/grade.h"
#include "lab/run.h"
#include "lab/worker.h"

namespace shadowlab::cli {
namespace {

namespace fs = std::filesystem;

// So many submissions win more than it costs to compile for the lectures' states beforehand.
constexpr std::size_t many = 20;

struct GradeCommand {
  std::string lab;
  std::vector<std::string> submissions;
  std::string out = "graded";
  int jobs = 0;
  std::string shard, format = "json", language = "en";
  std::optional<std::uint64_t> seed;
  bool one = false;
  bool show_hidden = false;
};

// Results of one submission, as a platform wants them; nothing where it wants none in a file.
std::string for_platform(lab::Format format, const lab::Result& result, const fs::path& folder) {
  if (format == lab::Format::gradescope) return lab::as_gradescope(result);
  if (format == lab::Format::prairielearn) return lab::as_prairielearn(result, folder);
  return {};
}

class Command {
 public:
  explicit Command(const GradeCommand& options)
      : options_(options),
        format_(lab::format_named(options.format)),
        lab_(lab::load_lab(find_lab(options.lab), options.seed)),
        unpacked_(std::vector<fs::path>(options.submissions.begin(), options.submissions.end())),
        submissions_(lab::find_submissions(
            unpacked_.paths(), options.one ? lab::Folders::of_one : lab::Folders::of_a_class)) {
    for (const lab::Submission& one : submissions_) widest_ = std::max(widest_, one.name.size());
  }

  Answer run() {
    // The worker warms up while the reference is drawn.
    auto starting = std::async(std::launch::async,
                               [this] { return std::make_unique<lab::Worker>(isolation()); });
    gl::Graphics graphics(context::create(), lab_.width, lab_.height);
    const lab::Reference reference = lab::draw_reference(graphics, lab_);
    const std::unique_ptr<lab::Worker> started = starting.get();
    lab::Worker& worker = *started;
    if (const auto missing = lab::names_of(worker.layers(), false); !missing.empty())
      fmt::print(stderr, "Submissions are isolated without {}: this machine has none.\n", missing);
    const lab::DrawSubmission draw = [&](const lab::Job& job, const auto& each) {
      const lab::Outcome outcome = worker.draw(job, each);
      return lab::Drawn{std::string(lab::name_of(outcome.verdict)), outcome.sentence,
                        lab::names_of(outcome.layers)};
    };
    const auto results = lab::run(lab_, reference, submissions_, draw, run_options());
    finish(results);
    const bool all = std::all_of(results.begin(), results.end(),
                                 [](const lab::Result& result) { return result.passed(); });
    return all ? Answer::yes : Answer::no;
  }

 private:
  lab::Isolation isolation() const {
    lab::Isolation isolation;
    isolation.warm = {lab_.start()};  // students have it already
    if (submissions_.size() >= many) isolation.warmth = lab::Warmth::states;
    isolation.width = lab_.width;
    isolation.height = lab_.height;
    return isolation;
  }

  lab::RunOptions run_options() {
    lab::RunOptions run;
    run.out = options_.out;
    run.jobs = options_.jobs > 0
                   ? options_.jobs
                   : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    if (!options_.shard.empty()) {
      run.shard = lab::shard_from(options_.shard);
    } else if (const auto shard = lab::shard_from_environment()) {
      run.shard = *shard;
    }
    run.grade.language = lab::language_named(options_.language);
    run.grade.hidden = options_.show_hidden ? lab::Hidden::shown : lab::Hidden::left_out;
    run.grade.after_case = [this](const lab::Result& result) { write_for_platform(result); };
    run.progress = [this](const lab::Result& result, std::size_t done, std::size_t all) {
      write_for_platform(result);
      if (format_ != lab::Format::autolab || all > 1) print_result(result, widest_);
      if (::isatty(STDERR_FILENO) && all > 1) fmt::print(stderr, "\r{} of {}\r", done, all);
      std::fflush(stdout);
    };
    return run;
  }

  void write_for_platform(const lab::Result& result) const {
    const fs::path folder = fs::path(options_.out) / "submissions" / result.submission;
    const std::string text = for_platform(format_, result, folder);
    if (text.empty()) return;
    write_text((submissions_.size() == 1 ? fs::path(options_.out) : folder) / "results.json", text);
  }

  void finish(const std::vector<lab::Result>& results) const {
    const fs::path out = options_.out;
    write_class(out, results, lab::language_named(options_.language));
    if (format_ == lab::Format::json) write_text(out / "results.json", lab::as_json(results));
    if (format_ == lab::Format::junit) write_text(out / "junit.xml", lab::as_junit(results));
    if (format_ == lab::Format::autolab) {
      for (const lab::Result& result : results) fmt::print("{}", lab::as_autolab(result));
    }
  }

  const GradeCommand& options_;
  const lab::Format format_;
  const lab::Lab lab_;
  const lab::Unpacked unpacked_;
  const std::vector<lab::Submission> submissions_;
  std::size_t widest_ = 0;
};

}  // namespace

void add_grade(CLI::App& app, Answer& answer) {
  CLI::App* command = app.add_subcommand("grade", "Grade submissions of a lab");
  auto options = std::make_shared<GradeCommand>();
  command->add_option("lab", options->lab, "The lab: its folder, or the name of one of labs/")
      ->required()
      ->type_name("LAB");
  command
      ->add_option(
          "submissions", options->submissions,
          "Recipes, folders of them or zip archives of folders: each file and folder in one is one")
      ->required()
      ->type_name("SUBMISSION…");
  command->add_option("-o,--out", options->out, "The folder for results and reports")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_option("--jobs", options->jobs, "How many are drawn at once; else one a processor")
      ->type_name("N")
      ->check(CLI::Range(0, 1024));
  command->add_option("--shard", options->shard, "Only the I-th part of N, as in 2/8")
      ->type_name("I/N");
  command
      ->add_option("--format", options->format, "json, gradescope, prairielearn, autolab or junit")
      ->type_name("FORMAT")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Of the random cases; else of the lab's own files")
      ->type_name("NUMBER");
  command->add_option("--lang", options->language, "Of the sentences: en, ca, es or fr")
      ->type_name("LANGUAGE")
      ->capture_default_str();
  command->add_flag("--one", options->one, "A folder is one submission, with the files beside it");
  command->add_flag("--show-hidden", options->show_hidden,
                    "Reports show hidden cases too: keep them from students");
  command->footer(
      "Example:\n  shadowlab grade 06_projected_stencil handed_in/ -o graded\n"
      "Started again with the same folder, it grades what has no result yet. Ends with 1 where a "
      "submission loses marks.");
  command->callback([options, &answer] { answer = Command(*options).run(); });
}

}  // namespace shadowlab::cli
