#include "lab/grade.h"

#include <fmt/format.h>

#include "core/clock.h"
#include "core/error.h"
#include "lab/digest.h"
#include "lab/grade_pictures.h"

namespace shadowlab::lab {
namespace {

constexpr std::size_t most_tried = 6;       // states that are replaced, one after the other
constexpr std::size_t most_printed = 2000;  // bytes that a report shows

void replace_all(std::string& text, const std::string& old, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += by.size())
    text.replace(at, old.size(), by);
}

std::vector<std::string> settings_of(const Shot& shot) {
  std::vector<std::string> settings;
  for (const auto& [name, value] : shot.settings)
    settings.push_back(fmt::format("{}={}", name, value));
  return settings;
}

// One submission on its way to its result.
class Grading {
 public:
  Grading(const Lab& lab, const Reference& reference, const Submission& submission,
          const GradeOptions& options)
      : lab_(lab), reference_(reference), options_(options) {
    result_.submission = submission.name;
    result_.file = submission.file.filename().string();
    result_.lab = lab.name;
    result_.title = lab.title;
    result_.most = lab.points;
    for (const Case& a_case : lab.cases) {
      CaseResult one;
      one.name = a_case.name;
      one.most = a_case.points;
      one.hidden = a_case.hidden;
      if (!a_case.hidden || options.hidden == Hidden::shown)
        one.settings = settings_of(a_case.shot);
      one.says = {std::string(text(options.language, Say::not_drawn))};
      result_.cases.push_back(std::move(one));
    }
  }

  Result run(const Submission& submission, const DrawSubmission& draw) {
    const double began = now_ms();
    try {
      const Staged staged(submission);
      result_.digest = staged.digest();
      if (!submission.problem.empty()) throw InputError(submission.problem);
      draw_all(staged, draw);
      explain(staged, draw);
    } catch (const InputError& problem) {
      result_.verdict = "recipe error";
      result_.error = problem.what();
      for (CaseResult& one : result_.cases)
        one.says = {say(options_.language, Say::recipe_fails, result_.error)};
    }
    result_.seconds = (now_ms() - began) / 1000;
    return std::move(result_);
  }

 private:
  void draw_all(const Staged& staged, const DrawSubmission& draw) {
    std::vector<Shot> shots;
    for (const Case& a_case : lab_.cases) shots.push_back(a_case.shot);
    Job job = job_of(staged, std::move(shots));
    job.calls = true;
    const std::string folder = staged.folder().string() + "/";
    result_.trace = empty_digest;
    const Drawn drawn = draw(job, [&](std::size_t i, Drawing drawing) {
      if (i != drawings_.size() || i >= lab_.cases.size()) return;  // never trusted
      if (drawing.error) replace_all(*drawing.error, folder, "");
      take(i, drawing);
      drawings_.push_back(std::move(drawing));
      if (options_.after_case) options_.after_case(result_);
    });
    result_.verdict = drawn.verdict;
    result_.layers = drawn.layers;
    std::string sentence = drawn.sentence;
    replace_all(sentence, folder, "");
    if (result_.error.empty()) result_.error = sentence;
    if (drawings_.size() < lab_.cases.size() && !sentence.empty()) {
      result_.cases[drawings_.size()].says = {say(options_.language, Say::recipe_fails, sentence)};
    }
  }

  void take(std::size_t i, const Drawing& drawing) {
    CaseResult& one = result_.cases[i];
    one.milliseconds = drawing.milliseconds;
    one.says.clear();
    result_.trace = digest_of(drawing.calls, result_.trace);
    if (result_.printed.size() < most_printed)
      result_.printed += drawing.printed.substr(0, most_printed - result_.printed.size());
    if (drawing.error) {
      if (result_.error.empty()) result_.error = *drawing.error;
      one.says = {say(options_.language, Say::recipe_fails, *drawing.error)};
      return;
    }
    const CaseVerdict verdict = verdict_of(lab_.cases[i], reference_.cases[i], drawing);
    one.compared = verdict.compared;
    one.differing = verdict.judgement.differing;
    one.forgiven = verdict.judgement.forgiven;
    one.budget = verdict.judgement.budget;
    one.status = verdict.right() ? Status::passed : Status::failed;
    if (verdict.right()) {
      one.points = one.most;
      result_.score += one.most;
      one.says = {std::string(text(options_.language, Say::right))};
      return;
    }
    const auto wrong = one.differing - one.forgiven;
    if (verdict.pass_missing) {
      one.says = {say(options_.language, Say::pass_missing, verdict.pass)};
    } else {
      const Say what = verdict.compared == "stencil" ? Say::stencil_differs
                       : verdict.compared == "depth" ? Say::depth_differs
                                                     : Say::picture_differs;
      one.says = {say(options_.language, what, wrong, one.budget, verdict.pass)};
    }
  }

  // Once all is drawn: a mistake is known by all of its pictures.
  void explain(const Staged& staged, const DrawSubmission& draw) {
    if (result_.passed()) return;
    const auto mistake = matching_mistake(lab_, reference_, drawings_);
    look_closer(staged, draw);
    bool shown = false;  // one case is shown pass by pass: the others would say the same
    bool tried = mistake.has_value();  // and in one other states are tried
    for (std::size_t i = 0; i < drawings_.size(); ++i) {
      CaseResult& one = result_.cases[i];
      if (one.status == Status::passed) continue;
      if (one.status == Status::failed) {
        const Diagnosis diagnosis = explain(i, mistake);
        if (!tried) say_state_of(one, i, diagnosis, staged, draw);
        tried = true;
      }
      const bool told = !one.hidden || options_.hidden == Hidden::shown;
      if (!told) {
        one.says.resize(1);
        one.says.emplace_back(text(options_.language, Say::hidden_case));
        if (one.finding) one.finding = without_hints(*one.finding);
      } else if (!options_.pictures.empty()) {
        write_case_pictures(one, i, reference_.cases[i], drawings_[i], options_.pictures,
                            shown ? Passes::left_out : Passes::written);
        shown = true;
      }
    }
  }

  // Draws once more what is explained, with all that an explanation looks at: the cases that are
  // wrong, and one that fails if it is the first. Marks are given by then; and what is drawn
  // otherwise now than it was explains nothing.
  void look_closer(const Staged& staged, const DrawSubmission& draw) {
    closely_.resize(drawings_.size(), false);
    Job job = job_of(staged, {});
    job.frame = job.passes = everything;
    job.calls = true;
    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < drawings_.size(); ++i) {
      const Status status = result_.cases[i].status;
      if (status != Status::failed && (status != Status::error || !wrong.empty())) continue;
      wrong.push_back(i);
      job.shots.push_back(lab_.cases[i].shot);
    }
    if (wrong.empty()) return;
    draw(job, [&](std::size_t shot, Drawing drawing) {
      if (shot >= wrong.size()) return;
      Drawing& judged = drawings_[wrong[shot]];
      if (drawing.error.has_value() != judged.error.has_value() ||
          drawing.frame.color != judged.frame.color)
        return;
      judged = std::move(drawing);
      closely_[wrong[shot]] = true;
    });
  }

  Diagnosis explain(std::size_t i, std::optional<std::size_t> mistake) {
    CaseResult& one = result_.cases[i];
    Diagnosis diagnosis;
    if (closely_[i]) diagnosis = diagnose(reference_.cases[i], drawings_[i], options_.language);
    one.finding = diagnosis.finding;
    if (mistake) {
      const Mistake& known = lab_.mistakes[*mistake];
      const auto hint = known.hints.find(std::string(code_of(options_.language)));
      one.finding->mistake = known.name;
      one.finding->hint = hint == known.hints.end() ? known.hints.at("en") : hint->second;
      one.says.push_back(one.finding->hint);
    }
    one.says.insert(one.says.end(), diagnosis.says.begin(), diagnosis.says.end());
    return diagnosis;
  }

  // Of the states that differ, the one without which the picture would be right; where there is
  // none, the first.
  void say_state_of(CaseResult& one, std::size_t i, const Diagnosis& diagnosis,
                    const Staged& staged, const DrawSubmission& draw) {
    if (diagnosis.states.empty()) return;
    Job job = job_of(staged, {});
    const auto mine = works_of(drawings_[i].calls),
               theirs = works_of(reference_.cases[i].drawing().calls);
    std::vector<std::size_t> tried;
    for (std::size_t s = 0; s < diagnosis.states.size() && tried.size() < most_tried; ++s) {
      Shot shot = lab_.cases[i].shot;
      shot.changes =
          changes_to(diagnosis.states[s], mine, diagnosis.yours, theirs, diagnosis.theirs);
      if (shot.changes.empty()) continue;
      job.shots.push_back(std::move(shot));
      tried.push_back(s);
    }
    std::optional<std::size_t> mending;
    if (!tried.empty()) {
      draw(job, [&](std::size_t shot, const Drawing& drawing) {
        const bool right = shot < tried.size() && !drawing.error &&
                           verdict_of(lab_.cases[i], reference_.cases[i], drawing).right();
        if (right && !mending) mending = tried[shot];
      });
    }
    const StateDifference& state = diagnosis.states[mending.value_or(0)];
    one.finding->state = say_state(state, one.finding->pass, options_.language);
    one.finding->mended = mending.has_value();
    one.says.push_back(one.finding->state);
    if (!tried.empty())
      one.says.emplace_back(text(options_.language, mending ? Say::mended : Say::not_mended));
  }

  // Keeps what is compared and no more: alike for all cases of a lab, so that it tells a submission
  // nothing of those that are hidden.
  Job job_of(const Staged& staged, std::vector<Shot> shots) const {
    Job job;
    job.recipe = staged.recipe();
    job.beside = staged.beside();
    job.width = lab_.width;
    job.height = lab_.height;
    job.frame = {.color = true};
    for (const Case& a_case : lab_.cases) {
      job.passes.stencil |= a_case.compared.stencil.has_value();
      job.passes.depth |= a_case.compared.depth.has_value();
    }
    job.shots = std::move(shots);
    return job;
  }

  // Of a hidden case the instructor is told the mistake, and a student's report nothing.
  static Finding without_hints(Finding finding) {
    finding.state.clear();
    finding.hint.clear();
    return finding;
  }

  const Lab& lab_;
  const Reference& reference_;
  const GradeOptions& options_;
  Result result_;
  std::vector<Drawing> drawings_;
  std::vector<bool> closely_;  // of which of them everything is there
};

}  // namespace

Result grade(const Lab& lab, const Reference& reference, const Submission& submission,
             const DrawSubmission& draw, const GradeOptions& options) {
  return Grading(lab, reference, submission, options).run(submission, draw);
}

std::uint64_t digest_of(const Submission& submission) {
  try {
    return Staged(submission).digest();
  } catch (const InputError&) {  // too much, or not readable: graded anew, to the same sentence
    return 0;
  }
}

}  // namespace shadowlab::lab
