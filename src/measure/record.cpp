#include "measure/record.h"

#include <nlohmann/json.hpp>

namespace shadowlab::measure {
namespace {

Json number_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

std::optional<double> optional_number(const Json& value) {
  if (value.is_null()) return {};
  return value.get<double>();
}

Json record_of(const Quartiles& quartiles) {
  return {{"q1", quartiles.low},
          {"median", quartiles.median},
          {"q3", quartiles.high},
          {"count", quartiles.count}};
}

Json record_of(const Errors& errors) {
  return {{"pixels", errors.pixels},
          {"bar", errors.bar},
          {"rmse", errors.rmse},
          {"p99", errors.p99},
          {"wrong", errors.wrong},
          {"wrong_beyond_edge", errors.wrong_beyond_edge},
          {"umbra_rmse", number_or_null(errors.umbra)},
          {"penumbra_rmse", number_or_null(errors.penumbra)},
          {"lit_rmse", number_or_null(errors.lit)},
          {"worst", errors.worst},
          {"worst_x", errors.worst_x},
          {"worst_y", errors.worst_y}};
}

Errors errors_in(const Json& record) {
  Errors errors;
  record.at("pixels").get_to(errors.pixels);
  record.at("bar").get_to(errors.bar);
  record.at("rmse").get_to(errors.rmse);
  record.at("p99").get_to(errors.p99);
  record.at("wrong").get_to(errors.wrong);
  record.at("wrong_beyond_edge").get_to(errors.wrong_beyond_edge);
  errors.umbra = optional_number(record.at("umbra_rmse"));
  errors.penumbra = optional_number(record.at("penumbra_rmse"));
  errors.lit = optional_number(record.at("lit_rmse"));
  record.at("worst").get_to(errors.worst);
  record.at("worst_x").get_to(errors.worst_x);
  record.at("worst_y").get_to(errors.worst_y);
  return errors;
}

// An error as it may be reported: never below what the truth itself can be off by.
Json reported(double error, double bar) { return std::max(error, bar); }
Json reported(const std::optional<double>& error, double bar) {
  return error ? Json(std::max(*error, bar)) : Json();
}

Json reported(const Errors& errors) {
  Json record = record_of(errors);
  record["rmse"] = reported(errors.rmse, errors.bar);
  record["p99"] = reported(errors.p99, errors.bar);
  record["umbra_rmse"] = reported(errors.umbra, errors.bar);
  record["penumbra_rmse"] = reported(errors.penumbra, errors.bar);
  record["lit_rmse"] = reported(errors.lit, errors.bar);
  record["below_bar"] = errors.below_bar();
  return record;
}

Json passes_of(const Look& look, std::span<const Round> rounds, const FillLimit& limit) {
  Json list = Json::array();
  for (std::size_t i = 0; i < look.passes.size(); ++i) {
    const PassFill& pass = look.passes[i];
    std::vector<double> times;
    for (const Round& round : rounds) {
      if (i < round.passes.size())
        times.insert(times.end(), round.passes[i].begin(), round.passes[i].end());
    }
    const Quartiles ms = quartiles(times);
    Json row = {{"name", pass.name},
                {"count", pass.count},
                {"ms", record_of(ms)},
                {"triangles", pass.triangles},
                {"mpix", pass.covered()},
                {"fill_limit_ms", pass.least(limit)},
                {"limit_ms", pass.least_in_all(limit)}};
    list.push_back(std::move(row));
  }
  return list;
}

}  // namespace

Json record_of(const Look& look) {
  Json passes = Json::array();
  for (const PassFill& pass : look.passes) {
    passes.push_back({{"name", pass.name},
                      {"mpix", pass.mpix},
                      {"triangles", pass.triangles},
                      {"count", pass.count}});
  }
  return {{"left_out", look.left_out ? Json(*look.left_out) : Json()},
          {"title", look.title},
          {"soft", look.soft},
          {"on_receivers", look.on_receivers},
          {"errors", record_of(look.errors)},
          {"flip_mean", look.flip_mean},
          {"flip_worst", look.flip_worst},
          {"triangles", look.triangles},
          {"draws", look.draws},
          {"upload_bytes", look.upload_bytes},
          {"gl_bytes", look.gl_bytes},
          {"peak_bytes", look.peak_bytes},
          {"first_frame", look.first_frame},
          {"passes", std::move(passes)}};
}

Look look_of(const Json& record) {
  Look look;
  if (!record.at("left_out").is_null()) look.left_out = record.at("left_out").get<std::string>();
  record.at("title").get_to(look.title);
  record.at("soft").get_to(look.soft);
  record.at("on_receivers").get_to(look.on_receivers);
  look.errors = errors_in(record.at("errors"));
  record.at("flip_mean").get_to(look.flip_mean);
  record.at("flip_worst").get_to(look.flip_worst);
  record.at("triangles").get_to(look.triangles);
  record.at("draws").get_to(look.draws);
  record.at("upload_bytes").get_to(look.upload_bytes);
  record.at("gl_bytes").get_to(look.gl_bytes);
  record.at("peak_bytes").get_to(look.peak_bytes);
  record.at("first_frame").get_to(look.first_frame);
  for (const Json& row : record.at("passes")) {
    PassFill pass;
    row.at("name").get_to(pass.name);
    row.at("mpix").get_to(pass.mpix);
    row.at("triangles").get_to(pass.triangles);
    row.at("count").get_to(pass.count);
    look.passes.push_back(std::move(pass));
  }
  return look;
}

Json record_of(const Round& round) { return {{"frames", round.frames}, {"passes", round.passes}}; }

Round round_of(const Json& record) {
  return {record.at("frames").get<std::vector<double>>(),
          record.at("passes").get<std::vector<std::vector<double>>>()};
}

Json record_of(const FillLimit& limit) {
  Json layers;
  for (std::size_t kind = 0; kind < layer_count; ++kind)
    layers[name_of(static_cast<Layer>(kind))] = limit.layer[kind];
  return {{"ms_per_mpix", std::move(layers)},
          {"ns_per_triangle", limit.triangle},
          {"ms_per_pass", limit.pass}};
}

FillLimit limit_of(const Json& record) {
  FillLimit limit;
  for (std::size_t kind = 0; kind < layer_count; ++kind)
    record.at("ms_per_mpix").at(name_of(static_cast<Layer>(kind))).get_to(limit.layer[kind]);
  record.at("ns_per_triangle").get_to(limit.triangle);
  record.at("ms_per_pass").get_to(limit.pass);
  return limit;
}

Json point_of(const Job& job, const Look& look, std::span<const Round> rounds,
              const FillLimit& limit) {
  Json settings = Json::object();
  for (const auto& [name, value] : job.settings) settings[name] = value;
  Json point = {
      {"name", job.name()}, {"recipe", job.recipe.stem().string()}, {"title", look.title},
      {"scene", job.scene}, {"settings", std::move(settings)},      {"planned", job.planned()}};
  if (look.left_out) {
    point["left_out"] = *look.left_out;
    return point;
  }
  std::vector<double> frames;
  for (const Round& round : rounds)
    frames.insert(frames.end(), round.frames.begin(), round.frames.end());
  double mpix = 0;
  for (const PassFill& pass : look.passes) mpix += pass.covered();
  point["truth"] = look.soft ? "soft" : "hard";
  point["on_receivers"] = look.on_receivers;
  point["frame_ms"] = record_of(quartiles(frames));
  point["passes"] = passes_of(look, rounds, limit);
  point["error"] = reported(look.errors);
  point["flip_mean"] = look.flip_mean;
  point["flip_worst"] = look.flip_worst;
  point["triangles"] = look.triangles;
  point["draws"] = look.draws;
  point["mpix"] = mpix;
  point["upload_bytes"] = look.upload_bytes;
  point["gl_bytes"] = look.gl_bytes;
  point["peak_bytes"] = look.peak_bytes;
  return point;
}

Json record_of(const TracedTruth& truth, double radius) {
  return {{"radius", radius},
          {"bar", truth.bar},
          {"rays", truth.rays},
          {"milliseconds", truth.milliseconds},
          {"unconverged", truth.unconverged}};
}

}  // namespace shadowlab::measure
