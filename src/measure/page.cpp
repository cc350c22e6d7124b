#include "measure/page.h"

#include <nlohmann/json.hpp>

#include <array>
#include <fstream>
#include <iterator>

#include "core/base64.h"
#include "measure/sweep.h"

namespace shadowlab::measure {

std::string script_text(const Json& json) {
  // "</script" and "<!--" would end or change the element; \u003c is the same character in JSON.
  std::string text;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace))
    text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

std::string data_url(const std::filesystem::path& png) {
  std::ifstream in(png, std::ios::binary);
  if (!in) return "";
  return "data:image/png;base64," + base64(std::string(std::istreambuf_iterator<char>(in), {}));
}

std::string filled(std::string_view page, const std::map<std::string, std::string>& given) {
  std::string text;
  while (true) {
    const auto begin = page.find("{{");
    if (begin == std::string_view::npos) break;
    const auto end = page.find("}}", begin);
    const std::string name(page.substr(begin + 2, end - begin - 2));
    text += page.substr(0, begin);
    const auto found = given.find(name);
    text += found != given.end() ? std::string_view(found->second) : page_file(name);
    page.remove_prefix(end + 2);
  }
  return text += page;
}

std::string measure_page(const Json& report, const std::filesystem::path& folder) {
  Json shown = report, pictures = Json::object();
  const auto show = [&](const std::string& name) {
    if (!pictures.contains(name)) {
      std::string url = data_url(folder / name);
      if (!url.empty()) pictures[name] = std::move(url);
    }
    return name;
  };
  for (Json& point : shown.at("points")) {
    // The planned ones' are those of all casters, or the table says how far they are from them.
    if (point.contains("left_out") || point.at("planned").get<bool>()) continue;
    const PictureNames names = pictures_of(point.at("name").get<std::string>());
    const bool soft = point.at("truth") == "soft";
    point["pictures"] = {
        {"visibility", show(names.visibility)},
        {"error", show(names.error)},
        {"truth", show(truth_picture_of(point.at("scene").get<std::string>(), soft))}};
  }
  return filled(page_file("measure.html"),
                {{"report", script_text(shown)}, {"pictures", script_text(pictures)}});
}

}  // namespace shadowlab::measure
