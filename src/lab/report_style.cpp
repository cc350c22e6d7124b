#include "lab/report_style.h"

#include <fmt/format.h>

#include "lab/report.h"

namespace shadowlab::lab {
namespace {

constexpr std::string_view style = R"css(
:root { color-scheme: light dark; --line: #8886; --good: #2a7d4f; --bad: #b3403a; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 62rem; margin: 1.5rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; margin-bottom: .2rem; } h2 { font-size: 1.15rem; } h4 { margin: .3rem 0; }
.score strong { font-size: 1.3rem; }
.case { border: 1px solid var(--line); border-left: .4rem solid var(--bad); border-radius: .4rem;
        padding: .2rem 1rem 1rem; margin: 1rem 0; }
.case.passed { border-left-color: var(--good); }
.points { font-weight: normal; opacity: .75; } .error { color: var(--bad); }
.tag { font-size: .8rem; border: 1px solid var(--line); border-radius: 1rem; padding: 0 .6rem; }
.compared { margin: .5rem 0; display: inline-block; }
.stack { position: relative; width: fit-content; background: #000; } .stack img { display: block; max-width: 100%; }
.stack img + img { position: absolute; inset: 0; }
img { image-rendering: pixelated; }
label { display: flex; gap: .6rem; align-items: center; } input[type=range] { flex: 1; }
.passes { display: flex; flex-wrap: wrap; gap: 1rem; }
.pass { border: 1px solid var(--line); padding: .3rem .6rem; border-radius: .3rem; }
.pass.departs { border: 2px solid var(--bad); }
pre, code { background: #8882; padding: .1rem .3rem; border-radius: .2rem; overflow-x: auto; }
table { border-collapse: collapse; } td, th { padding: .2rem .8rem .2rem 0; text-align: left; }
td.number { text-align: right; } tr { border-bottom: 1px solid var(--line); }
.bar { fill: #4a78b0; } svg text { fill: currentColor; font-size: 11px; }
)css";

// The slider: 0 is the first picture, 1 the second, 2 the third.
constexpr std::string_view script = R"js(
for (const figure of document.querySelectorAll('.compared')) {
  const slider = figure.querySelector('input');
  const yours = figure.querySelector('.yours'), difference = figure.querySelector('.difference');
  const show = () => {
    const v = Number(slider.value);
    if (yours) yours.style.clipPath = `inset(0 ${100 * Math.max(0, 1 - v)}% 0 0)`;
    if (difference) difference.style.clipPath = `inset(0 ${100 * Math.min(1, 2 - v)}% 0 0)`;
  };
  slider.addEventListener('input', show);
  show();
}
)js";

}  // namespace

std::string page_head(const std::string& title, Language language) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"{}\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>{}</title>\n"
      "<style>{}</style></head><body><main>\n",
      code_of(language), in_html(title), style);
}

std::string page_foot() {
  return fmt::format("</main><script>{}</script></body></html>\n", script);
}

std::string in_html(std::string_view text) {
  std::string html;
  for (const char c : text) {
    if (c == '<') {
      html += "&lt;";
    } else if (c == '>') {
      html += "&gt;";
    } else if (c == '&') {
      html += "&amp;";
    } else if (c == '"') {
      html += "&quot;";
    } else {
      html += static_cast<unsigned char>(c) < ' ' && c != '\n' ? ' ' : c;
    }
  }
  return html;
}

}  // namespace shadowlab::lab
