#include "measure/table.h"

#include <nlohmann/json.hpp>

#include <array>
#include <string_view>

namespace shadowlab::measure {
namespace {

struct Column {
  std::string_view name;
  const char* pointer;  ///< where a point has it
};

constexpr std::array columns{Column{"scene", "/scene"},
                             Column{"recipe", "/recipe"},
                             Column{"settings", "/settings"},
                             Column{"planned", "/planned"},
                             Column{"truth", "/truth"},
                             Column{"frame_ms_q1", "/frame_ms/q1"},
                             Column{"frame_ms_median", "/frame_ms/median"},
                             Column{"frame_ms_q3", "/frame_ms/q3"},
                             Column{"frames", "/frame_ms/count"},
                             Column{"rmse", "/error/rmse"},
                             Column{"below_bar", "/error/below_bar"},
                             Column{"bar", "/error/bar"},
                             Column{"p99", "/error/p99"},
                             Column{"umbra_rmse", "/error/umbra_rmse"},
                             Column{"penumbra_rmse", "/error/penumbra_rmse"},
                             Column{"lit_rmse", "/error/lit_rmse"},
                             Column{"wrong", "/error/wrong"},
                             Column{"wrong_beyond_edge", "/error/wrong_beyond_edge"},
                             Column{"pixels", "/error/pixels"},
                             Column{"worst", "/error/worst"},
                             Column{"worst_x", "/error/worst_x"},
                             Column{"worst_y", "/error/worst_y"},
                             Column{"flip_mean", "/flip_mean"},
                             Column{"flip_worst", "/flip_worst"},
                             Column{"triangles", "/triangles"},
                             Column{"draws", "/draws"},
                             Column{"mpix", "/mpix"},
                             Column{"upload_bytes", "/upload_bytes"},
                             Column{"gl_bytes", "/gl_bytes"},
                             Column{"peak_bytes", "/peak_bytes"},
                             Column{"left_out", "/left_out"}};

std::string text_of(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_object()) return value.dump();
  std::string text;
  for (const auto& [name, part] : value.items())
    text += (text.empty() ? "" : " ") + name + "=" + text_of(part);
  return text;
}

}  // namespace

std::string csv_field(const std::string& text) {
  if (text.find_first_of("\",\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string csv_of(const Json& report) {
  std::string csv;
  for (const Column& column : columns) csv += (csv.empty() ? "" : ",") + std::string(column.name);
  csv += '\n';
  for (const Json& point : report.at("points")) {
    bool first = true;
    for (const Column& column : columns) {
      const Json::json_pointer at(column.pointer);
      csv += (first ? "" : ",") + csv_field(point.contains(at) ? text_of(point.at(at)) : "");
      first = false;
    }
    csv += '\n';
  }
  return csv;
}

}  // namespace shadowlab::measure
