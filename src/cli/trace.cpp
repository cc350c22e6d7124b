// shadowlab trace: every GL call of a frame, pass by pass.
#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/session.h"
#include "gl/recorder.h"

namespace shadowlab::cli {
namespace {

struct TraceOptions {
  DrawOptions draw;
  bool json = false;
};

// What stands in a C comment must not end it, nor the line.
std::string in_comment(std::string text) {
  for (std::size_t at = 0; (at = text.find("*/", at)) != std::string::npos;)
    text.insert(at + 1, " ");
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return text;
}

std::string pass_of(const gl::Recorder& recorder, const gl::TracedCall& call) {
  return call.pass < 0 ? "" : recorder.passes()[static_cast<std::size_t>(call.pass)];
}

void print_as_c(const gl::Recorder& recorder) {
  int pass = -1;
  for (std::size_t i = 0; i < recorder.size(); ++i) {
    gl::TracedCall call = recorder.call(i);
    if (call.pass != pass) {
      fmt::print("{}", i > 0 ? "\n" : "");
      if (call.pass >= 0) fmt::print("/* {} */\n", in_comment(pass_of(recorder, call)));
    }
    pass = call.pass;
    call.comment = in_comment(call.comment);
    fmt::print("{}{}\n", pass >= 0 ? "  " : "", call.as_c());
  }
}

void print_as_json(const gl::Recorder& recorder, const recipe::Recipe& recipe,
                   const std::string& given) {
  using Json = nlohmann::ordered_json;
  Json calls = Json::array();
  for (std::size_t i = 0; i < recorder.size(); ++i) {
    const gl::TracedCall call = recorder.call(i);
    Json entry = {{"pass", nullptr}, {"function", call.function}, {"arguments", call.arguments}};
    if (call.pass >= 0) entry["pass"] = pass_of(recorder, call);
    if (!call.comment.empty()) entry["comment"] = call.comment;
    calls.push_back(std::move(entry));
  }
  Json passes = Json::array();
  for (const std::string& name : recorder.passes()) passes.push_back(name);
  const Json document = {{"recipe", given},
                         {"title", recipe.description().title},
                         {"passes", std::move(passes)},
                         {"calls", std::move(calls)}};
  // A recipe's names may be any bytes; JSON is UTF-8.
  fmt::print("{}\n", document.dump(1, ' ', false, Json::error_handler_t::replace));
}

void trace(const TraceOptions& options) {
  recipe::Options recipe_options;
  // The trace alone is on standard output, so that C stays C and JSON stays JSON.
  recipe_options.print = [](std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
  };
  Session session(options.draw, std::move(recipe_options));
  gl::Recorder recorder;
  session.graphics().trace_into(&recorder);
  try {
    session.recipe().draw();
  } catch (...) {
    // Which calls came before the fault is what one wants to know.
    session.graphics().trace_into(nullptr);
    if (!options.json) print_as_c(recorder);
    throw;
  }
  session.graphics().trace_into(nullptr);
  if (options.json) {
    print_as_json(recorder, session.recipe(), options.draw.recipe);
  } else {
    print_as_c(recorder);
  }
}

}  // namespace

void add_trace(CLI::App& app, Answer& answer) {
  CLI::App* command =
      app.add_subcommand("trace", "List every GL call of a frame, pass by pass, as C");
  auto options = std::make_shared<TraceOptions>();
  add_draw_options(*command, options->draw);
  command->add_flag("--json", options->json,
                    "As data: pass, function, arguments and comment of each call");
  command->footer(
      "Example:\n  shadowlab trace projected_stencil\n"
      "Calls of setup are not listed; those of a mesh or a shader are those that it makes.");
  command->callback([options, &answer] {
    trace(*options);
    answer = Answer::yes;
  });
}

}  // namespace shadowlab::cli
