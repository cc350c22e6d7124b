// A signature of the documentation, as its parts: "shadow.planar(plane, light) -> mat4".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace shadowlab::docs {

struct Signature {
  std::string callee;                  ///< "shadow.planar"; "v:dot"
  std::vector<std::string> arguments;  ///< names that Lua takes for parameters; "..." at the end
  std::vector<std::string> results;    ///< types as editors know them; "any" where none fits
};

/// The first of the forms that a signature shows.
Signature parse(std::string_view signature);

}  // namespace shadowlab::docs
