// Any text is a recipe that draws, or fails with an InputError of one line; and it ends.
#include "recipe/recipe.h"

#include <cstdlib>

#include "core/error.h"
#include "in_memory.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace shadowlab;
  // Kept to the end: what the driver has of it is then no leak.
  static gl::Graphics& graphics = *new gl::Graphics(context::create(), 16, 16);
  recipe::Options options;
  options.limits = {.memory = std::size_t{16} << 20,
                    .instructions = 100'000,
                    .seconds = 0.5,
                    .printed = std::size_t{1} << 12};
  const fuzz::FileOf file({bytes, size});
  try {
    recipe::Recipe recipe(graphics, file.path(), options);
    recipe.draw();
  } catch (const InputError& problem) {
    const std::string_view sentence = problem.what();
    if (sentence.empty() || sentence.find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}
