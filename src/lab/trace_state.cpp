#include "lab/trace_state.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "lab/digest.h"

namespace shadowlab::lab {
namespace {

constexpr std::size_t most_works = 2000;

// Setters whose first argument says what is set; the others set one thing.
constexpr std::array by_first_argument{"glStencilFuncSeparate", "glStencilOpSeparate",
                                       "glStencilMaskSeparate", "glBlendFunci",
                                       "glBlendFuncSeparatei",  "glBlendEquationi",
                                       "glPolygonMode",         "glBlendEquationSeparatei"};
constexpr std::array of_one{
    "glStencilFunc",   "glStencilOp",     "glStencilMask", "glDepthFunc",         "glDepthMask",
    "glDepthRange",    "glColorMask",     "glCullFace",    "glFrontFace",         "glBlendFunc",
    "glBlendEquation", "glPolygonOffset", "glViewport",    "glScissor",           "glClearColor",
    "glClearDepth",    "glClearStencil",  "glClipControl", "glBlendFuncSeparate", "glBlendColor",
    "glLogicOp",       "glDrawBuffers",   "glDrawBuffer",  "glReadBuffer",        "glActiveTexture",
    "glClearAccum"};
constexpr std::array works{
    "glClear",         "glDrawArrays",          "glDrawElements",      "glDrawArraysInstanced",
    "glAccum",         "glBlitFramebuffer",     "glCopyTexSubImage2D", "glCopyTexImage2D",
    "glClearBufferfv", "glBlitNamedFramebuffer"};

// GL's defaults, where a student who sets them and one who does not draw the same.
const GlState& defaults() {
  static const GlState state{
      {"glStencilFunc", {{"GL_ALWAYS", "0", "0xFFFFFFFF"}}},
      {"glStencilOp", {{"GL_KEEP", "GL_KEEP", "GL_KEEP"}}},
      {"glStencilMask", {{"0xFFFFFFFF"}}},
      {"glDepthFunc", {{"GL_LESS"}}},
      {"glDepthMask", {{"GL_TRUE"}}},
      {"glColorMask", {{"GL_TRUE", "GL_TRUE", "GL_TRUE", "GL_TRUE"}}},
      {"glCullFace", {{"GL_BACK"}}},
      {"glFrontFace", {{"GL_CCW"}}},
      {"glBlendFunc", {{"GL_ONE", "GL_ZERO"}}},
      {"glBlendEquation", {{"GL_FUNC_ADD"}}},
      {"glPolygonOffset", {{"0.0f", "0.0f"}}},
      {"glClearStencil", {{"0"}}},
      {"glClearDepth", {{"1.0"}}},
      {"glClearColor", {{"0.0f", "0.0f", "0.0f", "0.0f"}}},
  };
  return state;
}

template <class List>
bool has(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

// An object's name, "program_3", may be another in another run.
bool is_object(const std::string& argument) {
  const auto at = argument.rfind('_');
  return at != std::string::npos && at + 1 < argument.size() && !argument.starts_with("GL_") &&
         std::all_of(argument.begin() + static_cast<std::ptrdiff_t>(at) + 1, argument.end(),
                     [](char c) { return c >= '0' && c <= '9'; });
}

void set(GlState& state, const Call& call) {
  const std::string& name = call.function;
  const auto& arguments = call.arguments;
  if ((name == "glEnable" || name == "glDisable") && !arguments.empty()) {
    state["glEnable(" + arguments[0] + ")"] = {{name == "glEnable" ? "on" : "off"}};
  } else if (has(of_one, name)) {
    state[name] = {arguments};
    // Setting both sides ends what was set for one.
    for (const char* side : {"(GL_FRONT)", "(GL_BACK)"}) state.erase(name + "Separate" + side);
  } else if (has(by_first_argument, name) && !arguments.empty()) {
    state[name + "(" + arguments[0] + ")"] = {{arguments.begin() + 1, arguments.end()}};
  } else if (name.starts_with("glUniform") && !call.comment.empty() && arguments.size() > 1) {
    state["uniform " + call.comment] = {{arguments.back()}};
  }
}

std::optional<Setting> value(const GlState& state, const std::string& key) {
  if (const auto found = state.find(key); found != state.end()) return found->second;
  if (const auto found = defaults().find(key); found != defaults().end()) return found->second;
  if (key.starts_with("glEnable(")) return Setting{{"off"}};
  return std::nullopt;
}

void add_differences(const GlState& yours, const GlState& theirs, bool uniforms,
                     std::vector<StateDifference>& found) {
  std::set<std::string> keys;
  for (const auto* state : {&yours, &theirs}) {
    for (const auto& [key, setting] : *state) {
      if (key.starts_with("uniform ") == uniforms) keys.insert(key);
    }
  }
  for (const std::string& key : keys) {
    auto mine = value(yours, key), other = value(theirs, key);
    // A uniform that one of them has not got belongs to another shader.
    if (mine == other || (uniforms && (!mine || !other))) continue;
    const bool known = std::any_of(found.begin(), found.end(),
                                   [&](const StateDifference& one) { return one.key == key; });
    if (!known) found.push_back({key, std::move(mine), std::move(other)});
  }
}

std::vector<const Work*> of_pass(std::span<const Work> all, int pass) {
  std::vector<const Work*> found;
  for (const Work& work : all) {
    if (work.pass == pass) found.push_back(&work);
  }
  return found;
}

// The call that sets it.
Change change_of(std::size_t call, const std::string& key, const Setting& setting) {
  const auto bracket = key.find('(');
  if (bracket == std::string::npos) return {call, key, setting.values};
  const std::string first = key.substr(bracket + 1, key.size() - bracket - 2);
  if (key.starts_with("glEnable("))
    return {call, setting.values.front() == "on" ? "glEnable" : "glDisable", {first}};
  Change change{call, key.substr(0, bracket), {first}};
  change.arguments.insert(change.arguments.end(), setting.values.begin(), setting.values.end());
  return change;
}

}  // namespace

std::vector<Work> works_of(std::span<const Call> calls) {
  std::vector<Work> found;
  GlState state;
  for (std::size_t i = 0; i < calls.size() && found.size() < most_works; ++i) {
    if (has(works, calls[i].function)) {
      found.push_back({i, calls[i].pass, state});
    } else {
      set(state, calls[i]);
    }
  }
  return found;
}

std::vector<StateDifference> differences(std::span<const Work> your_works, int yours,
                                         std::span<const Work> their_works, int theirs) {
  const auto mine = of_pass(your_works, yours), others = of_pass(their_works, theirs);
  std::vector<StateDifference> found;
  for (const bool uniforms : {false, true}) {
    for (std::size_t i = 0; i < std::min(mine.size(), others.size()); ++i)
      add_differences(mine[i]->state, others[i]->state, uniforms, found);
  }
  return found;
}

std::vector<Change> changes_to(const StateDifference& difference, std::span<const Work> your_works,
                               int yours, std::span<const Work> their_works, int theirs) {
  const auto mine = of_pass(your_works, yours), others = of_pass(their_works, theirs);
  if (mine.empty() || others.empty() || difference.key.starts_with("uniform ")) return {};
  std::vector<Change> changes;
  const auto add = [&](std::size_t call, const std::optional<Setting>& setting) {
    if (setting) changes.push_back(change_of(call, difference.key, *setting));
    return setting.has_value();
  };
  for (std::size_t i = 0; i < mine.size(); ++i) {
    const Work& other = *others[std::min(i, others.size() - 1)];
    if (!add(mine[i]->call, value(other.state, difference.key))) return {};
  }
  // It holds until the submission sets it anew, as its own value did.
  const auto last = value(mine.back()->state, difference.key);
  for (const Work& after : your_works) {
    const auto now = value(after.state, difference.key);
    if (after.call <= mine.back()->call || now == last) continue;
    if (!add(after.call, now)) return {};
    break;
  }
  return changes;
}

std::string in_words(const Setting& setting) {
  std::string words;
  for (std::string value : setting.values) {
    if (value.starts_with("GL_")) value.erase(0, 3);
    if (value.size() > 60) value = value.substr(0, 57) + "…";
    words += (words.empty() ? "" : " ") + value;
  }
  return words;
}

std::uint64_t digest_of(std::span<const Call> calls, std::uint64_t before) {
  for (const Call& call : calls) {
    before = digest(call.function, before);
    for (const std::string& argument : call.arguments)
      before = digest(is_object(argument) ? "object" : argument, before);
  }
  return before;
}

}  // namespace shadowlab::lab
