// The files of the pages, as bytes of the program: the assembler reads them while it is built.
#include <fmt/format.h>

#include "core/error.h"
#include "measure/page.h"

// SHADOWLAB_PAGE, the folder page/, and SHADOWLAB_CHART, Chart.js, come from src/CMakeLists.txt.
// NOLINTBEGIN(bugprone-macro-parentheses): a declared name stands in none
#define SHADOWLAB_BYTES(NAME, FILE)                                                    \
  asm(".pushsection .rodata\nshadowlab_page_" #NAME ":\n.incbin \"" FILE               \
      "\"\nshadowlab_page_" #NAME "_end:\n.byte 0\n.popsection\n");                    \
  [[gnu::visibility("hidden")]] extern const char NAME[] asm("shadowlab_page_" #NAME); \
  [[gnu::visibility("hidden")]] extern const char NAME##_end[] asm("shadowlab_page_" #NAME "_end")
// NOLINTEND(bugprone-macro-parentheses)

namespace shadowlab::measure {

SHADOWLAB_BYTES(page_css, SHADOWLAB_PAGE "/page.css");
SHADOWLAB_BYTES(measure_html, SHADOWLAB_PAGE "/measure.html");
SHADOWLAB_BYTES(measure_js, SHADOWLAB_PAGE "/measure.js");
SHADOWLAB_BYTES(measure_schema, SHADOWLAB_PAGE "/measure.schema.json");
SHADOWLAB_BYTES(stress_html, SHADOWLAB_PAGE "/stress.html");
SHADOWLAB_BYTES(stress_js, SHADOWLAB_PAGE "/stress.js");
SHADOWLAB_BYTES(chart_js, SHADOWLAB_CHART);

std::string_view page_file(std::string_view name) {
  const auto bytes = [](const char* begin, const char* end) {
    return std::string_view(begin, static_cast<std::size_t>(end - begin));
  };
  if (name == "page.css") return bytes(page_css, page_css_end);
  if (name == "measure.html") return bytes(measure_html, measure_html_end);
  if (name == "measure.js") return bytes(measure_js, measure_js_end);
  if (name == "measure.schema.json") return bytes(measure_schema, measure_schema_end);
  if (name == "stress.html") return bytes(stress_html, stress_html_end);
  if (name == "stress.js") return bytes(stress_js, stress_js_end);
  if (name == "chart.js") return bytes(chart_js, chart_js_end);
  throw InputError(fmt::format("there is no page file {}", name));
}

}  // namespace shadowlab::measure
