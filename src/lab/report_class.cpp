// The page of a class.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "lab/report.h"
#include "lab/report_style.h"

namespace shadowlab::lab {
namespace {

// How many submissions reach each tenth of the points.
std::string distribution(std::span<const Result> results) {
  std::array<int, 11> counts{};
  for (const Result& result : results) {
    const double part = result.most > 0 ? result.score / result.most : 0;
    ++counts[static_cast<std::size_t>(std::clamp(part * 10 + 1e-9, 0.0, 10.0))];
  }
  const int most = std::max(1, *std::max_element(counts.begin(), counts.end()));
  std::string svg =
      "<svg viewBox=\"0 0 440 140\" width=\"440\" role=\"img\" aria-label=\"0 – 100 %\">\n";
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double height = 100.0 * counts[i] / most, x = 40.0 * static_cast<double>(i) + 4;
    svg += fmt::format(
        "<rect class=\"bar\" x=\"{}\" y=\"{:.1f}\" width=\"32\" height=\"{:.1f}\"/>"
        "<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>"
        "<text x=\"{}\" y=\"134\" text-anchor=\"middle\">{} %</text>\n",
        x, 118 - height, height, x + 16, 114 - height,
        counts[i] > 0 ? std::to_string(counts[i]) : "", x + 16, 10 * i);
  }
  return svg + "</svg>\n";
}

using Counts = std::map<std::string, int>;

std::string ranking(const Counts& counts, std::size_t all, Language language) {
  std::vector<std::pair<std::string, int>> sorted(counts.begin(), counts.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  if (sorted.empty()) return fmt::format("<p>{}</p>\n", in_html(text(language, Say::none)));
  std::string html = "<table>";
  for (const auto& [name, count] : sorted) {
    html += fmt::format("<tr><td>{}</td><td class=\"number\">{} / {}</td></tr>\n", in_html(name),
                        count, all);
  }
  return html + "</table>\n";
}

std::string link_to(const Result& result) {
  // A name may be anything that a folder may be called.
  std::string address;
  for (const char c : result.submission) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (byte < 128 && std::isalnum(byte) != 0) || c == '-' || c == '_' || c == '.';
    address += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return fmt::format("<a href=\"submissions/{}/report.html\">{}</a>", address,
                     in_html(result.submission));
}

std::string duplicates(std::span<const Result> results, Language language) {
  std::map<std::uint64_t, std::vector<const Result*>> by_trace;
  for (const Result& result : results) {
    if (result.trace != 0) by_trace[result.trace].push_back(&result);
  }
  std::string html;
  for (const auto& [trace, alike] : by_trace) {
    if (alike.size() < 2) continue;
    html += "<li>";
    for (std::size_t i = 0; i < std::min<std::size_t>(alike.size(), 40); ++i)
      html += (i > 0 ? ", " : "") + link_to(*alike[i]);
    html += (alike.size() > 40 ? fmt::format(" … ({})", alike.size()) : "") + "</li>\n";
  }
  return html.empty() ? fmt::format("<p>{}</p>\n", in_html(text(language, Say::none)))
                      : "<ul>" + html + "</ul>\n";
}

std::string all_of(std::span<const Result> results) {
  std::string html = "<table>";
  for (const Result& result : results) {
    html += fmt::format("<tr><td>{}</td><td class=\"number\">{:.4g} / {:.4g}</td><td>",
                        link_to(result), result.score, result.most);
    for (const CaseResult& one : result.cases) {
      html += fmt::format("<span title=\"{}\">{}</span>", in_html(one.name),
                          one.status == Status::passed ? "✓ " : "✗ ");
    }
    html += fmt::format("</td><td>{}</td></tr>\n",
                        in_html(result.verdict == "finished" ? "" : result.verdict));
  }
  return html + "</table>\n";
}

std::string csv_field(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  // A spreadsheet takes what begins like this for a formula.
  if (text.find_first_of("=+-@") == 0) quoted.insert(1, "'");
  return quoted + "\"";
}

}  // namespace

std::string class_page(std::span<const Result> results, Language language) {
  const std::string title = results.empty() ? "" : results.front().title;
  Counts cases, mistakes;
  for (const Result& result : results) {
    std::string mistake;
    for (const CaseResult& one : result.cases) {
      if (one.status != Status::passed) ++cases[one.name];
      if (one.finding && !one.finding->mistake.empty()) mistake = one.finding->mistake;
    }
    if (!mistake.empty()) ++mistakes[mistake];
  }
  const auto heading = [&](Say what) {
    return fmt::format("<h2>{}</h2>\n", in_html(text(language, what)));
  };
  std::string html = page_head(title, language);
  html += fmt::format("<h1>{}</h1>\n", in_html(title));
  html += heading(Say::score) + distribution(results);
  html += heading(Say::most_failed_cases) + ranking(cases, results.size(), language);
  html += heading(Say::most_frequent_mistakes) + ranking(mistakes, results.size(), language);
  html += heading(Say::near_duplicates) + duplicates(results, language);
  html +=
      fmt::format("<h2>{} ({})</h2>\n", in_html(text(language, Say::submissions)), results.size());
  return html + all_of(results) + page_foot();
}

std::string scores_csv(std::span<const Result> results) {
  std::string csv = "submission,score,max_score,verdict";
  if (!results.empty()) {
    for (const CaseResult& one : results.front().cases) csv += "," + csv_field(one.name);
  }
  csv += "\n";
  for (const Result& result : results) {
    csv += fmt::format("{},{},{},{}", csv_field(result.submission), result.score, result.most,
                       csv_field(result.verdict));
    for (const CaseResult& one : result.cases) csv += fmt::format(",{}", one.points);
    csv += "\n";
  }
  return csv;
}

}  // namespace shadowlab::lab
