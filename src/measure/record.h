// Measurements as JSON: what the journal and the report are made of.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "measure/fill.h"
#include "measure/ground_truth.h"
#include "measure/measurement.h"
#include "measure/statistics.h"

namespace shadowlab::measure {

using Json = nlohmann::json;

Json record_of(const Look& look);
/// What record_of gave. Throws nlohmann::json::exception for anything else.
Look look_of(const Json& record);

Json record_of(const Round& round);
Round round_of(const Json& record);

Json record_of(const FillLimit& limit);
FillLimit limit_of(const Json& record);

/// A job with its look and all of its rounds: a point of the report (measure.schema.json).
Json point_of(const Job& job, const Look& look, std::span<const Round> rounds,
              const FillLimit& limit);

/// The truth's part of a scene, without its pictures.
Json record_of(const TracedTruth& truth, double radius);

}  // namespace shadowlab::measure
