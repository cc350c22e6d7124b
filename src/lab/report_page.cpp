// One submission's page.
#include <fmt/format.h>

#include <algorithm>

#include "lab/report.h"
#include "lab/report_style.h"

namespace shadowlab::lab {
namespace {

// Two pictures one over the other; the slider says how much of the upper one is seen. At its right
// end it is the difference.
std::string compared(const std::string& expected, const std::string& yours,
                     const std::string& difference, Language language) {
  const std::string_view names[] = {text(language, Say::expected), text(language, Say::yours),
                                    text(language, Say::difference)};
  std::string html = "<figure class=\"compared\"><div class=\"stack\">";
  const auto picture = [&](const std::string& file, std::string_view name, const char* layer) {
    if (!file.empty()) {
      html += fmt::format("<img class=\"{}\" src=\"{}\" alt=\"{}\">", layer, in_html(file),
                          in_html(name));
    }
  };
  picture(expected, names[0], "expected");
  picture(yours, names[1], "yours");
  picture(difference, names[2], "difference");
  html += "</div>";
  const double most = difference.empty() ? 1 : 2;
  html += fmt::format(
      "<label>{} <input type=\"range\" min=\"0\" max=\"{}\" step=\"0.01\" value=\"1\" "
      "aria-label=\"{} – {}{}\"> {}</label></figure>\n",
      in_html(names[0]), most, in_html(names[0]), in_html(names[1]),
      difference.empty() ? "" : " – " + in_html(names[2]),
      difference.empty() ? in_html(names[1])
                         : fmt::format("{} · {}", in_html(names[1]), in_html(names[2])));
  return html;
}

std::string picture_of(const CaseResult& one, const std::string& role) {
  const auto found = one.pictures.find(role);
  return found == one.pictures.end() ? "" : found->second;
}

std::string expected_file(const std::string& name) { return "../../expected/" + name; }

std::string passes_of(const CaseResult& one, std::size_t index, Language language) {
  std::string html;
  for (std::size_t pass = 0; pass < 16; ++pass) {
    for (const char* buffer : {"color", "stencil"}) {
      const std::string mine = picture_of(one, fmt::format("pass-{}-{}", pass + 1, buffer));
      if (mine.empty()) continue;
      const bool departs = one.finding && one.finding->pass_number == static_cast<int>(pass) + 1;
      html += fmt::format(
          "<div class=\"pass{}\"><h4>{} · {}</h4>{}</div>\n", departs ? " departs" : "", pass + 1,
          in_html(text(language, buffer[0] == 'c' ? Say::color : Say::stencil)),
          compared(expected_file(expected_pass_name(index, pass, buffer)), mine, "", language));
    }
  }
  if (html.empty()) return "";
  return fmt::format(
      "<details open><summary>{}</summary><div class=\"passes\">\n{}</div></details>\n",
      in_html(text(language, Say::passes)), html);
}

std::string draw_command(const Result& result, const CaseResult& one) {
  std::string command = "shadowlab run " + result.file;
  for (const std::string& setting : one.settings) command += " --set " + setting;
  return command;
}

std::string case_section(const Result& result, std::size_t index, Language language,
                         Hidden hidden) {
  const CaseResult& one = result.cases[index];
  const bool told = !one.hidden || hidden == Hidden::shown;
  const char* status = one.status == Status::passed   ? "passed"
                       : one.status == Status::failed ? "failed"
                                                      : "error";
  std::string html = fmt::format(
      "<section class=\"case {}\"><h2>{}. {} <span class=\"points\">{:.4g} / {:.4g} {}</span>{}"
      "</h2>\n",
      status, index + 1, in_html(one.name), one.points, one.most,
      in_html(text(language, Say::points)),
      one.hidden
          ? fmt::format(" <span class=\"tag\">{}</span>", in_html(text(language, Say::hidden)))
          : "");
  html += "<ul>";
  for (const std::string& sentence : one.says)
    html += fmt::format("<li>{}</li>", in_html(sentence));
  html += "</ul>\n";
  if (!told) return html + "</section>\n";
  if (!one.settings.empty() && one.status != Status::passed) {
    html += fmt::format(
        "<p>{}</p>\n",
        say(language, Say::draw_it, "<code>" + in_html(draw_command(result, one)) + "</code>"));
  }
  const std::string yours = picture_of(one, "yours");
  if (yours.empty()) {
    html +=
        fmt::format("<img src=\"{}\" alt=\"{}\">\n", in_html(expected_file(expected_name(index))),
                    in_html(text(language, Say::expected)));
  } else {
    html += compared(expected_file(expected_name(index)), yours, picture_of(one, "difference"),
                     language);
  }
  return html + passes_of(one, index, language) + "</section>\n";
}

}  // namespace

std::string report_page(const Result& result, Language language, Hidden hidden) {
  std::string html = page_head(fmt::format("{} · {}", result.submission, result.title), language);
  html += fmt::format(
      "<h1>{}</h1>\n<p class=\"score\">{}: <strong>{:.4g} / {:.4g}</strong> · "
      "{}</p>\n",
      in_html(result.title), in_html(text(language, Say::score)), result.score, result.most,
      in_html(result.submission));
  if (!result.error.empty())
    html += fmt::format("<p class=\"error\">{}</p>\n",
                        in_html(say(language, Say::recipe_fails, result.error)));
  for (std::size_t i = 0; i < result.cases.size(); ++i)
    html += case_section(result, i, language, hidden);
  if (!result.printed.empty()) {
    html += fmt::format("<h3>{}</h3><pre>{}</pre>\n", in_html(text(language, Say::printed)),
                        in_html(result.printed));
  }
  return html + page_foot();
}

}  // namespace shadowlab::lab
