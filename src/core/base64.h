// Bytes as text.
#pragma once

#include <string>
#include <string_view>

namespace shadowlab {

/// `bytes` in base 64, padded (RFC 4648, section 4), as data URLs take them.
std::string base64(std::string_view bytes);

}  // namespace shadowlab
