// A call of a trace, made again from its text.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "gl/functions.h"

namespace shadowlab::gl {

/// Makes the call `c_name` ("glStencilFunc") with the arguments that a trace prints ("GL_EQUAL",
/// "1", "0xFF"), without a trace of its own. Only functions that set state by numbers and names;
/// false, and nothing is called, for any other and for arguments that the function does not take.
bool replay(const Functions& gl, std::string_view c_name, std::span<const std::string> arguments);

}  // namespace shadowlab::gl
