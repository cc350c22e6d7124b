// The points of a report as a table of comma-separated values.
#pragma once

#include <string>

#include "measure/record.h"

namespace shadowlab::measure {

/// A line of names, then one for each point of `report`, those that were left out among them; a
/// field that says nothing is empty (RFC 4180, but for line ends, which are LF).
std::string csv_of(const Json& report);

/// Text as a field: in quotes where it has to be.
std::string csv_field(const std::string& text);

}  // namespace shadowlab::measure
