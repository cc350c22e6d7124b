#include "lab/text_file.h"

#include <array>
#include <fstream>
#include <iterator>
#include <span>

#include "image/whole_file.h"

namespace shadowlab::lab {

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write_text(const std::filesystem::path& file, std::string_view text) {
  const std::array parts{
      std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size())};
  image::write_whole(file, parts);
}

}  // namespace shadowlab::lab
