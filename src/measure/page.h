// Pages that stand alone: everything that they need is in them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "measure/record.h"

namespace shadowlab::measure {

/// report.html of a report whose pictures are in `folder`. A picture that is missing is left out.
std::string measure_page(const Json& report, const std::filesystem::path& folder);

/// A file of src/measure/page, or Chart.js, as this program was built with it. Throws InputError
/// for another name.
std::string_view page_file(std::string_view name);

/// JSON as the text of a script element.
std::string script_text(const Json& json);

/// A PNG as a data: URL; "" where the file cannot be read.
std::string data_url(const std::filesystem::path& png);

/// `page` with each {{name}} replaced by page_file(name), or by what `given` has of that name.
std::string filled(std::string_view page, const std::map<std::string, std::string>& given);

}  // namespace shadowlab::measure
