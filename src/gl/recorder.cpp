#include "gl/recorder.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "gl/functions.h"

namespace shadowlab::gl {
namespace {

constexpr std::size_t kept_bytes =
    256;  // of one array: a matrix, a few names; never whole textures

}  // namespace

std::string escaped(std::string_view text) {
  std::string quoted;
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += {'\\', c};
    } else if (c >= ' ' && c < '\x7f') {
      quoted += c;
    } else {
      quoted += fmt::format("\\{:03o}", static_cast<unsigned char>(c));
    }
  }
  return quoted;
}

std::string TracedCall::as_c() const {
  std::string text = fmt::format("{}({});", function, fmt::join(arguments, ", "));
  if (!comment.empty()) text += fmt::format("  /* {} */", comment);
  return text;
}

void Recorder::begin_pass(std::string name) {
  passes_.push_back(std::move(name));
  pass_ = static_cast<int>(passes_.size()) - 1;
}

void Recorder::clear() {
  calls_.clear();
  words_.clear();
  arrays_.clear();
  comments_.clear();
  passes_.clear();
  pass_ = -1;
}

void Recorder::refuse() {
  throw InputError(fmt::format("a trace holds at most {} calls of GL", most_calls));
}

void Recorder::comment(std::string_view text) {
  if (calls_.empty()) return;
  calls_.back().comment = static_cast<std::int32_t>(comments_.size());
  comments_.emplace_back(text);
}

std::uint64_t Recorder::keep(const void* data, std::size_t bytes, std::size_t count) {
  const std::size_t at = arrays_.size();
  const std::size_t kept = std::min(bytes, kept_bytes);
  const std::uint64_t header[2] = {count, kept};
  arrays_.resize(at + sizeof header + kept);
  std::memcpy(arrays_.data() + at, header, sizeof header);
  if (kept > 0) std::memcpy(arrays_.data() + at + sizeof header, data, kept);
  return at;
}

TracedCall Recorder::call(std::size_t index) const {
  const Call& call = calls_[index];
  const FunctionDescription& function = describe(static_cast<FunctionId>(call.function));
  TracedCall traced;
  traced.function = function.c_name;
  for (std::size_t i = 0; i < function.arity; ++i) {
    traced.arguments.push_back(function.formatters[i](words_[call.first_word + i], arrays_));
  }
  if (call.comment >= 0) {
    traced.comment = escaped(comments_[static_cast<std::size_t>(call.comment)]);
    // A name must not end the comment.
    for (std::size_t at = 0; (at = traced.comment.find("*/", at)) != std::string::npos;)
      traced.comment.insert(at + 1, 1, ' ');
  }
  traced.pass = call.pass;
  return traced;
}

}  // namespace shadowlab::gl
