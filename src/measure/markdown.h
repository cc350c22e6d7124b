// The figures of a report as Markdown: what docs/figures.md has of it.
#pragma once

#include <string>

#include "measure/record.h"

namespace shadowlab::measure {

/// Tables of the fastest points under each error, the Pareto fronts, the exponents, how far passes
/// are from their limits, what the plan saves, and the truth's rays; of a report as sweep() gives
/// it.
std::string markdown_of(const Json& report);

}  // namespace shadowlab::measure
