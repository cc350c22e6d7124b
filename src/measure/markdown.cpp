#include "measure/markdown.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "measure/statistics.h"

namespace shadowlab::measure {
namespace {

std::string label_of(const Json& point) {
  std::string label = "`" + point.at("recipe").get<std::string>() + "`";
  for (const auto& [name, value] : point.at("settings").items())
    label +=
        fmt::format(" {}={}", name, value.is_string() ? value.get<std::string>() : value.dump());
  return label;
}

double milliseconds(const Json& point) { return point.at("frame_ms").at("median").get<double>(); }
double rmse(const Json& point) { return point.at("error").at("rmse").get<double>(); }

std::string error_of(const Json& point) {
  return fmt::format("{}{:.3g}", point.at("error").at("below_bar").get<bool>() ? "≤ " : "",
                     rmse(point));
}

using Points = std::vector<const Json*>;

// Those that were measured without a plan, by scene and kind of light, in the report's order.
std::vector<std::pair<std::string, Points>> groups_of(const Json& report) {
  std::vector<std::pair<std::string, Points>> groups;
  for (const char* truth : {"hard", "soft"}) {
    for (const Json& point : report.at("points")) {
      if (point.contains("left_out") || point.at("planned").get<bool>() ||
          point.at("truth") != truth)
        continue;
      const std::string name = fmt::format("{}, {}", point.at("scene").get<std::string>(), truth);
      auto group = std::ranges::find(groups, name, &std::pair<std::string, Points>::first);
      if (group == groups.end()) group = groups.insert(groups.end(), {name, {}});
      group->second.push_back(&point);
    }
  }
  for (auto& [name, points] : groups) {
    std::ranges::stable_sort(points, {}, [](const Json* point) { return milliseconds(*point); });
  }
  return groups;
}

std::string fastest(const std::vector<std::pair<std::string, Points>>& groups) {
  std::string text = "| scene, light | 1/255 | 1 % | 5 % |\n|---|---|---|---|\n";
  for (const auto& [name, points] : groups) {
    text += "| " + name;
    for (const double limit : {1.0 / 255, 0.01, 0.05}) {
      const auto best =
          std::ranges::find_if(points, [&](const Json* point) { return rmse(*point) <= limit; });
      text += best == points.end() ? " | none"
                                   : fmt::format(" | {} {:.3g} ms, {}", label_of(**best),
                                                 milliseconds(**best), error_of(**best));
    }
    text += " |\n";
  }
  return text;
}

std::string fronts(const std::vector<std::pair<std::string, Points>>& groups) {
  std::string text =
      "| scene, light | Pareto front | ms (quartiles) | RMSE | wrong beyond an edge | FLIP |\n"
      "|---|---|---|---|---|---|\n";
  for (const auto& [name, points] : groups) {
    std::vector<Point> places;
    for (const Json* point : points) places.push_back({milliseconds(*point), rmse(*point)});
    std::string shown = name;
    for (const std::size_t i : pareto_front(places)) {
      const Json& point = *points[i];
      text += fmt::format(
          "| {} | {} | {:.3g} ({:.3g}, {:.3g}) | {} | {} | {:.2g} |\n", shown, label_of(point),
          milliseconds(point), point.at("frame_ms").at("q1").get<double>(),
          point.at("frame_ms").at("q3").get<double>(), error_of(point),
          point.at("error").at("wrong_beyond_edge").dump(), point.at("flip_mean").get<double>());
      shown.clear();
    }
  }
  return text;
}

std::string exponents(const Json& report) {
  std::map<std::string, std::vector<std::string>> by_varied;
  for (const Json& curve : report.at("curves")) {
    if (curve.at("exponent").is_null()) continue;
    by_varied[curve.at("of").get<std::string>()].push_back(
        fmt::format("`{}` {:.2f} ({:.0f} %)", curve.at("recipe").get<std::string>(),
                    curve.at("exponent").get<double>(), 100 * curve.at("explained").get<double>()));
  }
  std::string text = "| time over | exponent (explained) |\n|---|---|\n";
  for (const auto& [varied, recipes] : by_varied)
    text += fmt::format("| {} | {} |\n", varied, fmt::join(recipes, ", "));
  return text;
}

std::string limits(const std::vector<std::pair<std::string, Points>>& groups) {
  std::map<std::string, std::array<std::vector<double>, 2>> over;
  for (const auto& [name, points] : groups) {
    for (const Json* point : points) {
      if (!point->at("settings").empty()) continue;
      for (const Json& pass : point->at("passes")) {
        auto& [fill, all] = over[point->at("recipe").get<std::string>()];
        const double ms = pass.at("ms").at("median").get<double>();
        if (ms == 0) continue;  // of a map that is kept: drawn in the first frame alone
        if (pass.at("fill_limit_ms").get<double>() > 0)
          fill.push_back(ms / pass.at("fill_limit_ms").get<double>());
        if (pass.at("limit_ms").get<double>() > 0)
          all.push_back(ms / pass.at("limit_ms").get<double>());
      }
    }
  }
  std::string text =
      "| recipe | passes | over the fill limit (quartiles) | over pixels, triangles and the price "
      "of a pass |\n|---|---|---|---|\n";
  for (const auto& [recipe, both] : over) {
    const Quartiles fill = quartiles(both[0]), all = quartiles(both[1]);
    text +=
        fmt::format("| `{}` | {} | {:.2g} ({:.2g}, {:.2g}) | {:.2g} ({:.2g}, {:.2g}) |\n", recipe,
                    all.count, fill.median, fill.low, fill.high, all.median, all.low, all.high);
  }
  return text;
}

std::string savings(const Json& report) {
  std::string text =
      "| scene | recipe | ms | Mpix | triangles | MiB held | RMSE "
      "|\n|---|---|---|---|---|---|---|\n";
  for (const Json& planned : report.at("points")) {
    if (planned.contains("left_out") || !planned.at("planned").get<bool>()) continue;
    const auto whole = std::ranges::find_if(report.at("points"), [&](const Json& point) {
      return !point.contains("left_out") && !point.at("planned").get<bool>() &&
             point.at("settings").empty() && point.at("recipe") == planned.at("recipe") &&
             point.at("scene") == planned.at("scene");
    });
    if (whole == report.at("points").end()) continue;
    const auto both = [&](const char* name, double unit) {
      return fmt::format("{:.3g} → {:.3g}", whole->at(name).get<double>() / unit,
                         planned.at(name).get<double>() / unit);
    };
    const double change = rmse(planned) - rmse(*whole);
    text +=
        fmt::format("| {} | `{}` | {:.3g} → {:.3g} | {} | {} → {} | {} | {} |\n",
                    planned.at("scene").get<std::string>(), planned.at("recipe").get<std::string>(),
                    milliseconds(*whole), milliseconds(planned), both("mpix", 1),
                    whole->at("triangles").dump(), planned.at("triangles").dump(),
                    both("gl_bytes", 1 << 20), change == 0 ? "0" : fmt::format("{:+.2g}", change));
  }
  return text;
}

std::string truths(const Json& report) {
  std::string text =
      "| scene | radius | error bar | rays | million rays/s |\n|---|---|---|---|---|\n";
  for (const Json& truth : report.at("truths")) {
    const auto rays = truth.at("rays").get<double>();
    text += fmt::format("| {} | {:.3g} | {:.3g} | {:.0f} | {:.2f} |\n",
                        truth.at("scene").get<std::string>(), truth.at("radius").get<double>(),
                        truth.at("bar").get<double>(), rays,
                        rays / truth.at("milliseconds").get<double>() / 1000);
  }
  return text;
}

}  // namespace

std::string markdown_of(const Json& report) {
  const auto groups = groups_of(report);
  const Json& machine = report.at("machine");
  return fmt::format(
      "{}, {} cores, load {:.1f}; {}, driver threads {}; {} × {} pixels.\n\n{}\n{}\n{}\n{}\n{}\n{}",
      machine.at("processor").get<std::string>(), machine.at("cores").dump(),
      machine.at("load").get<double>(), machine.at("renderer").get<std::string>(),
      machine.at("driver_threads").get<std::string>(), report.at("options").at("width").dump(),
      report.at("options").at("height").dump(), fastest(groups), fronts(groups), exponents(report),
      limits(groups), savings(report), truths(report));
}

}  // namespace shadowlab::measure
