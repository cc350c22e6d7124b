#include "cli/explain.h"

#include <fmt/format.h>

#include <string>

#include "gl/held.h"

namespace shadowlab::cli {
namespace {

std::string counted(std::uint64_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string size_of(std::uint64_t bytes) {
  if (bytes < 1024) return counted(bytes, "byte", "bytes");
  if (bytes < (std::uint64_t{1} << 20)) return fmt::format("{:.1f} KiB", double(bytes) / 1024);
  return fmt::format("{:.1f} MiB", double(bytes) / (1 << 20));
}

std::string sentence_of(const gl::Work& work) {
  std::string text = "Draws nothing";
  if (work.draws > 0) {
    text = fmt::format("{} of {}", counted(work.draws, "draw", "draws"),
                       counted(work.triangles, "triangle", "triangles"));
  }
  if (work.uploads == 0) return text + "; uploads nothing.";
  return text + fmt::format("; {} of {}.", counted(work.uploads, "upload", "uploads"),
                            size_of(work.upload_bytes));
}

std::string sentence_of(const gl::Held& held) {
  const auto part = [](const gl::Holding& holding, const char* one, const char* many) {
    return fmt::format("{} of {}", counted(holding.count, one, many), size_of(holding.bytes));
  };
  return fmt::format("GL holds {}, {} and {}; the picture itself is among the textures.",
                     part(held.buffers, "buffer", "buffers"),
                     part(held.textures, "texture", "textures"),
                     part(held.renderbuffers, "renderbuffer", "renderbuffers"));
}

}  // namespace

void print_explanation(Session& session, std::FILE* to) {
  const recipe::Recipe& recipe = session.recipe();
  const auto print_why = [&](const std::string& pass) {
    for (const lua::Explanation& why : recipe.explanations()) {
      if (why.pass == pass) fmt::print(to, "  {}\n", why.text);
    }
  };
  fmt::print(to, "before and between the passes\n");
  print_why("");
  gl::Work between = recipe.work();
  for (const auto& pass : recipe.passes()) between = between - pass.work;
  fmt::print(to, "  {}\n", sentence_of(between));
  for (const auto& pass : recipe.passes()) {
    fmt::print(to, "{}\n", pass.name);
    print_why(pass.name);
    fmt::print(to, "  {}\n", sentence_of(pass.work));
  }
  fmt::print(to, "the whole frame\n  {}\n  {}\n", sentence_of(recipe.work()),
             sentence_of(gl::held(session.graphics().gl)));
}

}  // namespace shadowlab::cli
