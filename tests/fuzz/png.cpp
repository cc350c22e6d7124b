// Any bytes are a picture of its size, or an InputError.
#include <zlib.h>

#include "core/error.h"
#include "image/image.h"
#include "in_memory.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* bytes, std::size_t size, std::size_t most);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* bytes, std::size_t size,
                                               std::size_t most, unsigned seed);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

namespace {

constexpr std::size_t signature = 8, around = 12;  // a chunk has its length, name and sum around it

std::uint32_t big_endian(const std::uint8_t* bytes) {
  return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 |
         std::uint32_t{bytes[2]} << 8 | bytes[3];
}

// Every chunk's sum is set right, or libpng would look no further than the first change.
void mend_sums(std::uint8_t* bytes, std::size_t size) {
  for (std::size_t at = signature; at + around <= size;) {
    const std::size_t length = big_endian(bytes + at);
    if (length > size - at - around) return;
    const auto sum =
        static_cast<std::uint32_t>(::crc32(0, bytes + at + 4, static_cast<unsigned>(length) + 4));
    for (unsigned i = 0; i < 4; ++i)
      bytes[at + 8 + length + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
    at += around + length;
  }
}

// Large pictures are good ones, but take their time.
bool is_large(const std::uint8_t* bytes, std::size_t size) {
  if (size < 24) return false;
  const std::uint64_t width = big_endian(bytes + 16), height = big_endian(bytes + 20);
  return width <= 16384 && height <= 16384 && width * height > 1 << 16;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* bytes, std::size_t size,
                                               std::size_t most, unsigned) {
  const std::size_t changed = LLVMFuzzerMutate(bytes, size, most);
  mend_sums(bytes, changed);
  return changed;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace shadowlab;
  if (is_large(bytes, size)) return 0;
  const fuzz::FileOf file({bytes, size});
  try {
    const image::Image image = image::read_png(file.path());
    if (image.rgba.size() != std::size_t{4} * static_cast<std::size_t>(image.width) *
                                 static_cast<std::size_t>(image.height))
      std::abort();
  } catch (const InputError&) {
  }
  return 0;
}
