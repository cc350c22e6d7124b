// libpng leaves a call that fails by longjmp, which skips destructors: everything between setjmp
// and a libpng call in this file is trivially destructible, and owners live outside (guarded,
// below).
#include <png.h>

#include <csetjmp>
#include <cstring>
#include <string>

#include "core/error.h"
#include "image/image.h"
#include "image/whole_file.h"

namespace shadowlab::image {
namespace {

constexpr png_uint_32 largest_side = 16384;

void ignore_warning(png_structp, png_const_charp) {}
[[noreturn]] void leave(png_structp png, png_const_charp) { png_longjmp(png, 1); }

/// Runs `steps`, which may call libpng and must own nothing; false when libpng gave up.
template <typename Steps>
bool guarded(png_structp png, const Steps& steps) {
  if (setjmp(png_jmpbuf(png))) return false;
  steps();
  return true;
}

struct Writer {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, leave, ignore_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;

  Writer() = default;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

struct Reader {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, leave, ignore_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;

  Reader() = default;
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

void append(png_structp png, png_bytep bytes, std::size_t count) {
  auto& out = *static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
  out.insert(out.end(), bytes, bytes + count);
}

void take(png_structp png, png_bytep bytes, std::size_t count) {
  auto& rest = *static_cast<std::span<const std::uint8_t>*>(png_get_io_ptr(png));
  if (rest.size() < count) png_error(png, "cut short");
  std::memcpy(bytes, rest.data(), count);
  rest = rest.subspan(count);
}

bool is_opaque(const Image& image) {
  std::uint8_t all = 255;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) all &= image.rgba[i];
  return all == 255;
}

// Level 3 without filters: of all levels, filters and strategies the fastest or within 5% of it on
// shaded scenes, and within a fifth of the smallest file (512²: 2 ms and 49 kB; zlib's default
// level with libpng's choice of filters takes 12 ms).
void encode(const Writer& writer, const Image& image) {
  const auto width = static_cast<png_uint_32>(image.width);
  const auto height = static_cast<png_uint_32>(image.height);
  const bool opaque = is_opaque(image);
  png_set_user_limits(writer.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_set_IHDR(writer.png, writer.info, width, height, 8,
               opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
  png_set_compression_level(writer.png, 3);
  png_write_info(writer.png, writer.info);
  if (opaque) png_set_filler(writer.png, 0, PNG_FILLER_AFTER);
  const std::uint8_t* row = image.rgba.data();
  for (png_uint_32 y = 0; y < height; ++y, row += std::size_t{4} * width) {
    png_write_row(writer.png, row);
  }
  png_write_end(writer.png, nullptr);
}

// Whatever the file holds becomes 8-bit RGBA; values are kept, no gamma is applied.
void ask_for_rgba8(const Reader& reader) {
  png_set_expand(reader.png);
  png_set_scale_16(reader.png);
  png_set_gray_to_rgb(reader.png);
  png_set_add_alpha(reader.png, 255, PNG_FILLER_AFTER);
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
}

[[noreturn]] void broken(const std::filesystem::path& file) {
  throw InputError(file.string() + " is a broken PNG: it is cut short or damaged; write it anew.");
}

}  // namespace

void write_png(const std::filesystem::path& file, const Image& image) {
  Writer writer;
  if (!writer.info) throw MachineError("There is no memory left to write " + file.string() + ".");
  std::vector<std::uint8_t> bytes;
  png_set_write_fn(writer.png, &bytes, append, nullptr);
  if (!guarded(writer.png, [&] { encode(writer, image); })) {
    throw InputError("Cannot write " + file.string() + ": a picture of " +
                     std::to_string(image.width) + " x " + std::to_string(image.height) +
                     " does not fit a PNG.");
  }
  const std::span<const std::uint8_t> parts[] = {bytes};
  write_whole(file, parts);
}

Image read_png(const std::filesystem::path& file) {
  const std::vector<std::uint8_t> bytes = read_whole(file);
  if (bytes.empty()) throw InputError(file.string() + " is empty, and a PNG is needed.");
  constexpr std::size_t signature = 8;
  if (bytes.size() < signature || png_sig_cmp(bytes.data(), 0, signature) != 0) {
    throw InputError(file.string() + " is not a PNG.");
  }
  Reader reader;
  if (!reader.info) throw MachineError("There is no memory left to read " + file.string() + ".");
  std::span<const std::uint8_t> rest = bytes;
  png_set_read_fn(reader.png, &rest, take);
  png_set_user_limits(reader.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  if (!guarded(reader.png, [&] { png_read_info(reader.png, reader.info); })) broken(file);

  const png_uint_32 width = png_get_image_width(reader.png, reader.info);
  const png_uint_32 height = png_get_image_height(reader.png, reader.info);
  if (width > largest_side || height > largest_side) {
    throw InputError(file.string() + " is " + std::to_string(width) + " x " +
                     std::to_string(height) + "; the limit is 16384 x 16384.");
  }
  // zlib packs at most 1032 bytes into one: a header that promises more comes from no whole file,
  // and is refused before memory is taken for it.
  if (png_get_rowbytes(reader.png, reader.info) * height / 1032 > bytes.size()) {
    throw InputError(file.string() + " is a broken PNG: it promises " + std::to_string(width) +
                     " x " + std::to_string(height) + " pixels and cannot hold them.");
  }

  if (!guarded(reader.png, [&] { ask_for_rgba8(reader); })) broken(file);
  Image image(static_cast<int>(width), static_cast<int>(height));
  std::vector<png_bytep> rows(height);
  for (png_uint_32 y = 0; y < height; ++y) rows[y] = image.rgba.data() + std::size_t{4} * width * y;
  const bool whole = guarded(reader.png, [&] {
    png_read_image(reader.png, rows.data());
    png_read_end(reader.png, nullptr);
  });
  if (!whole) broken(file);
  return image;
}

}  // namespace shadowlab::image
