#include "cli/gallery_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/captures.h"
#include "core/version.h"
#include "image/buffer_pictures.h"

namespace shadowlab::cli {
namespace {

constexpr std::string_view style = R"css(
:root {
  color-scheme: light dark;
  --ground: #fbfbf9; --card: #ffffff; --text: #1d2126; --quiet: #5b6470; --line: #dcdfe3;
  --link: #1756a9; --bad: #a3261b; --bad-ground: #fdf0ee; --code: #f2f3f1;
}
@media (prefers-color-scheme: dark) {
  :root {
    --ground: #15181c; --card: #1d2126; --text: #e4e7ea; --quiet: #9aa4b0; --line: #343a42;
    --link: #8ab8f5; --bad: #ff9d8f; --bad-ground: #38201d; --code: #171a1e;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0 auto; max-width: 76rem; padding: 1.5rem 1rem 4rem;
  background: var(--ground); color: var(--text);
  font: 1rem/1.5 system-ui, "DejaVu Sans", sans-serif; overflow-wrap: anywhere;
}
h1 { font-size: 1.6rem; margin: 0; }
h2 { font-size: 1.2rem; line-height: 1.3; margin: 0; }
h2 a { color: inherit; text-decoration: none; }
h2 a:hover { text-decoration: underline; }
p { margin: .25rem 0; }
a { color: var(--link); }
:focus-visible { outline: 3px solid var(--link); outline-offset: 2px; }
.quiet { color: var(--quiet); font-size: .875rem; }
nav ol { columns: 18rem; margin: 1rem 0 0; padding: 0; }
nav li { break-inside: avoid; margin-left: 2rem; }  /* for the number, in each column */
article {
  margin-top: 1.5rem; padding: 1.25rem; scroll-margin-top: 1rem;
  background: var(--card); border: 1px solid var(--line); border-radius: .5rem;
}
.drawn { display: grid; grid-template-columns: minmax(0, 26rem) minmax(0, 1fr); gap: 1.25rem; margin-top: 1rem; }
img { display: block; width: 100%; height: auto; border-radius: .25rem; background: #20202010; }
.picture { align-self: start; }
.passes {
  display: grid; grid-template-columns: repeat(auto-fill, minmax(8.5rem, 1fr)); gap: 1rem .75rem;
  align-content: start; list-style: none; margin: 0; padding: 0;
}
figure { margin: 0; }
figcaption { font-size: .8125rem; line-height: 1.35; margin-top: .35rem; }
.stencil { display: block; margin-top: .35rem; }
.stencil img { aspect-ratio: var(--shape); object-fit: cover; object-position: top; }
.legend { display: flex; flex-wrap: wrap; gap: 0 .6rem; font-size: .75rem; color: var(--quiet); }
.legend i { display: inline-block; width: .7em; height: .7em; margin-right: .3em; border: 1px solid var(--line); }
.error { background: var(--bad-ground); color: var(--bad); border-radius: .25rem; padding: .5rem .75rem; margin-top: .75rem; }
.time { font-variant-numeric: tabular-nums; white-space: nowrap; }
code, pre { font-family: ui-monospace, "DejaVu Sans Mono", monospace; font-size: .8125rem; }
details { margin-top: 1rem; }
summary { cursor: pointer; width: fit-content; }
pre { background: var(--code); border: 1px solid var(--line); border-radius: .25rem; padding: .75rem; overflow: auto; max-height: 32rem; overflow-wrap: normal; }
@media (max-width: 44rem) {
  .drawn { grid-template-columns: minmax(0, 1fr); }
  article { padding: .875rem; }
  .passes { grid-template-columns: repeat(auto-fill, minmax(7.5rem, 1fr)); }
}
)css";

std::string picture(std::string_view file, std::string_view alt, const Gallery& gallery) {
  return fmt::format(
      R"(<a href="{0}"><img src="{0}" alt="{1}" width="{2}" height="{3}" loading="lazy"></a>)",
      link_to(file), escaped(alt), gallery.width, gallery.height);
}

std::string legend_of(const ShownPass& pass) {
  std::string html;
  for (const std::uint8_t value : pass.stencil_values) {
    const auto color = image::stencil_color(value);
    html += fmt::format(R"(<span><i style="background:#{:02x}{:02x}{:02x}"></i>{}</span>)",
                        color[0], color[1], color[2], value);
  }
  return html;
}

std::string item_of(const ShownPass& pass, bool with_stencil, const Gallery& gallery) {
  std::string html = "<li><figure>\n" + picture(pass.color, "Colour after " + pass.name, gallery);
  if (with_stencil) {
    html += fmt::format(
        "\n<span class=\"stencil\">{}</span>\n"
        "<span class=\"legend\"><span>stencil</span>{}</span>",
        picture(pass.stencil, "Stencil after " + pass.name, gallery), legend_of(pass));
  }
  return html + fmt::format("\n<figcaption>{}</figcaption>\n</figure></li>\n", escaped(pass.name));
}

std::string time_of(const ShownRecipe& recipe) {
  return recipe.milliseconds < 100 ? fmt::format("{:.1f} ms", recipe.milliseconds)
                                   : fmt::format("{:.0f} ms", recipe.milliseconds);
}

std::string drawn(const ShownRecipe& recipe, const Gallery& gallery) {
  // Stencils are worth a picture where a pass tells pixels apart by them.
  const bool with_stencil =
      std::any_of(recipe.passes.begin(), recipe.passes.end(),
                  [](const ShownPass& pass) { return pass.stencil_values.size() > 1; });
  std::string html = "<div class=\"drawn\">\n<div class=\"picture\">" +
                     picture(recipe.picture, recipe.title, gallery) + "</div>\n";
  if (!recipe.passes.empty()) {
    html += "<ol class=\"passes\">\n";
    for (const ShownPass& pass : recipe.passes) html += item_of(pass, with_stencil, gallery);
    html += "</ol>\n";
  }
  return html + "</div>\n";
}

std::string article_of(const ShownRecipe& recipe, const Gallery& gallery) {
  std::string html = fmt::format("<article id=\"{0}\">\n<h2><a href=\"#{0}\">{1}</a></h2>\n",
                                 link_to(recipe.name), escaped(recipe.title));
  if (!recipe.lecture.empty())
    html += fmt::format("<p class=\"quiet\">{}</p>\n", escaped(recipe.lecture));
  if (recipe.error.empty()) {
    html += fmt::format(
        "<p class=\"quiet\"><span class=\"time\">{} a frame</span>{}; drawn by "
        "<code>shadowlab run {}</code></p>\n",
        time_of(recipe), recipe.scene.empty() ? "" : ", scene " + escaped(recipe.scene),
        escaped(recipe.name));
    html += drawn(recipe, gallery);
  } else {
    html += fmt::format("<p class=\"error\">Not drawn: {}</p>\n", escaped(recipe.error));
  }
  return html +
         fmt::format(
             "<details><summary>Source</summary>\n<p class=\"quiet\"><a href=\"{}\">{}</a></p>\n"
             "<pre tabindex=\"0\"><code>{}</code></pre></details>\n</article>\n",
             link_to(recipe.source_file), escaped(recipe.source_file), escaped(recipe.source));
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      case '\'':
        html += "&#39;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string link_to(std::string_view path) {
  std::string link;
  for (const char c : path) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("/._-~").find(c) != std::string_view::npos;
    link += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return link;
}

std::string page_of(const Gallery& gallery) {
  std::string contents, articles;
  for (const ShownRecipe& recipe : gallery.recipes) {
    contents +=
        fmt::format("<li><a href=\"#{}\">{}</a> <span class=\"quiet time\">{}</span></li>\n",
                    link_to(recipe.name), escaped(recipe.title),
                    recipe.error.empty() ? time_of(recipe) : "not drawn");
    articles += article_of(recipe, gallery);
  }
  return fmt::format(
      R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>shadowlab gallery</title>
<style>{}</style>
</head>
<body style="--shape:{}/{}">
<header>
<h1>shadowlab gallery</h1>
<p class="quiet">Every recipe of scripts/, with the colour after each pass, and the stencil where a pass uses it.
Times are medians of warm frames at {} × {} on {}; shadowlab {}.</p>
<nav aria-label="Recipes"><ol>
{}</ol></nav>
</header>
<main>
{}</main>
</body>
</html>
)",
      style, gallery.width, gallery.height, gallery.width, gallery.height,
      escaped(gallery.renderer), version(), contents, articles);
}

}  // namespace shadowlab::cli
