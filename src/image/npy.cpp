// The format: numpy.org/doc/stable/reference/generated/numpy.lib.format.html
#include <bit>
#include <numeric>
#include <stdexcept>
#include <string>

#include "image/image.h"
#include "image/whole_file.h"

namespace shadowlab::image {
namespace {

static_assert(std::endian::native == std::endian::little);

std::string npy_header(const char* type, std::span<const std::size_t> shape) {
  std::string dimensions;
  for (const std::size_t n : shape) dimensions += std::to_string(n) + ", ";
  std::string fields = std::string("{'descr': '") + type + "', 'fortran_order': False, 'shape': (" +
                       dimensions + "), }";
  // Magic, version and length take 10 bytes; values begin at a multiple of 64, after a line feed.
  const std::size_t end = 10 + fields.size() + 1;
  fields.append((64 - end % 64) % 64, ' ');
  fields += '\n';
  std::string header("\x93NUMPY\x01\x00", 8);
  header += static_cast<char>(fields.size() & 0xFF);
  header += static_cast<char>(fields.size() >> 8);
  return header + fields;
}

void write(const std::filesystem::path& file, const char* type, std::span<const std::size_t> shape,
           std::size_t count, std::span<const std::uint8_t> bytes) {
  if (std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>()) != count) {
    throw std::invalid_argument("write_npy: the shape does not hold that many values");
  }
  const std::string header = npy_header(type, shape);
  const std::span<const std::uint8_t> parts[] = {
      {reinterpret_cast<const std::uint8_t*>(header.data()), header.size()}, bytes};
  write_whole(file, parts);
}

}  // namespace

void write_npy(const std::filesystem::path& file, std::span<const std::size_t> shape,
               std::span<const float> values) {
  write(file, "<f4", shape, values.size(),
        {reinterpret_cast<const std::uint8_t*>(values.data()), values.size_bytes()});
}

void write_npy(const std::filesystem::path& file, std::span<const std::size_t> shape,
               std::span<const std::uint8_t> values) {
  write(file, "|u1", shape, values.size(), values);
}

}  // namespace shadowlab::image
