// shadowlab pack: a lab as it is given away.
#include <fmt/format.h>

#include <algorithm>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/labs.h"
#include "core/version.h"
#include "lab/pack.h"

namespace shadowlab::cli {
namespace {

namespace fs = std::filesystem;

struct PackOptions {
  std::string lab, whom, out;
  std::optional<std::uint64_t> seed;
};

std::vector<lab::Packed> packed(const PackOptions& options, const lab::Lab& lab) {
  if (options.whom == "gradescope")
    return lab::pack_for_gradescope(lab, home(), fs::read_symlink("/proc/self/exe"));
  gl::Graphics graphics(context::create(), lab.width, lab.height);
  return lab::pack_for_student(lab, lab::draw_reference(graphics, lab));
}

void pack(const PackOptions& options) {
  const lab::Lab lab = lab::load_lab(find_lab(options.lab), options.seed);
  const fs::path out = options.out.empty()
                           ? fs::path(fmt::format("{}-{}.zip", lab.name, options.whom))
                           : fs::path(options.out);
  expect_writable(out);
  const auto files = packed(options, lab);
  lab::write_zip(out, files);
  fmt::print("{}: {} files\n", out.string(), files.size());
}

}  // namespace

void add_pack(CLI::App& app, Answer& answer) {
  CLI::App* command = app.add_subcommand("pack", "Pack a lab for students or for Gradescope");
  auto options = std::make_shared<PackOptions>();
  command->add_option("lab", options->lab, "The lab: its folder, or the name of one of labs/")
      ->required()
      ->type_name("LAB");
  command
      ->add_option(
          "--for", options->whom,
          "student: without solution, mistakes and hidden cases; gradescope: an autograder")
      ->required()
      ->check(one_of({"student", "gradescope"}))
      ->type_name("student|gradescope");
  command->add_option("-o,--out", options->out, "The archive; else LAB-student.zip and its like")
      ->type_name("ZIP");
  command->add_option("--seed", options->seed, "Of the random cases, as grade takes it")
      ->type_name("NUMBER");
  command->footer("Example:\n  shadowlab pack 06_projected_stencil --for student");
  command->callback([options, &answer] {
    pack(*options);
    answer = Answer::yes;
  });
}

}  // namespace shadowlab::cli
