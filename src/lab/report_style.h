// What all pages share: internal to reports.
#pragma once

#include <string>

#include "lab/sentences.h"

namespace shadowlab::lab {

std::string page_head(const std::string& title, Language language);
std::string page_foot();

}  // namespace shadowlab::lab
