#include <gmock/gmock.h>
#include <png.h>
#include <sys/stat.h>

#include <cstdio>

#include "core/error.h"
#include "image/image.h"
#include "test_folder.h"

namespace shadowlab::image {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

class Png : public InFolder {};

// Every byte value, in every channel; alpha too where `alpha` is not 255.
Image colourful(int width, int height, bool opaque) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto a = static_cast<std::uint8_t>(opaque ? 255 : 3 * x + y);
      image.set(x, y,
                {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(7 * x + 13 * y),
                 static_cast<std::uint8_t>(255 - y), a});
    }
  }
  return image;
}

// Writes what write_png cannot: other colour types and depths, `rows` packed as the type has them.
void write_as(const std::filesystem::path& file, int width, int height, int depth, int type,
              std::vector<std::uint8_t> packed, int interlace = PNG_INTERLACE_NONE) {
  std::FILE* out = std::fopen(file.c_str(), "wb");
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, out);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), depth,
               type, interlace, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  const png_color palette[] = {{255, 0, 0}, {0, 0, 255}};
  if (type == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette, 2);
  png_write_info(png, info);
  std::vector<png_bytep> rows;
  const std::size_t row_bytes = packed.size() / static_cast<std::size_t>(height);
  for (int y = 0; y < height; ++y) {
    rows.push_back(packed.data() + row_bytes * static_cast<std::size_t>(y));
  }
  png_write_image(png, rows.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  std::fclose(out);
}

TEST_F(Png, written_and_read_is_the_same_picture) {
  for (const bool opaque : {true, false}) {
    for (const auto& [width, height] : {std::pair{256, 256}, {1, 1}, {1, 300}, {300, 1}}) {
      const Image image = colourful(width, height, opaque);
      write_png(in_folder("a.png"), image);
      EXPECT_EQ(read_png(in_folder("a.png")), image) << width << " x " << height;
    }
  }
}

TEST_F(Png, of_an_opaque_picture_stores_no_alpha) {
  constexpr std::size_t color_type = 25;
  write_png(in_folder("opaque.png"), colourful(8, 8, true));
  EXPECT_EQ(bytes_of(in_folder("opaque.png"))[color_type], PNG_COLOR_TYPE_RGB);
  write_png(in_folder("clear.png"), colourful(8, 8, false));
  EXPECT_EQ(bytes_of(in_folder("clear.png"))[color_type], PNG_COLOR_TYPE_RGBA);
}

TEST_F(Png, is_the_same_bytes_each_time) {
  write_png(in_folder("a.png"), colourful(64, 64, true));
  write_png(in_folder("b.png"), colourful(64, 64, true));
  EXPECT_EQ(bytes_of(in_folder("a.png")), bytes_of(in_folder("b.png")));
}

TEST_F(Png, replaces_a_file_and_leaves_nothing_beside_it) {
  put(in_folder("a.png"), "what was there before");
  write_png(in_folder("a.png"), colourful(4, 4, true));
  EXPECT_EQ(read_png(in_folder("a.png")), colourful(4, 4, true));
  const auto files = std::distance(std::filesystem::directory_iterator(folder_), {});
  EXPECT_EQ(files, 1);
}

TEST_F(Png, is_written_through_a_link) {
  put(in_folder("real.png"), "");
  std::filesystem::create_symlink("real.png", in_folder("link.png"));
  write_png(in_folder("link.png"), colourful(4, 4, true));
  EXPECT_TRUE(std::filesystem::is_symlink(in_folder("link.png")));
  EXPECT_EQ(read_png(in_folder("real.png")), colourful(4, 4, true));
}

// A rename onto a device would replace it with a file, for everybody where root does so.
TEST_F(Png, written_to_a_device_leaves_it_a_device) {
  write_png("/dev/null", colourful(4, 4, true));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(Png, to_a_missing_folder_names_the_folder) {
  const auto message =
      message_of<InputError>([&] { write_png(in_folder("none/a.png"), Image(1, 1)); });
  EXPECT_THAT(message, HasSubstr(in_folder("none/a.png").string()));
  EXPECT_THAT(message, HasSubstr("there is no folder"));
}

TEST_F(Png, to_a_folder_that_cannot_be_written_says_so) {
  // /proc refuses files even from root.
  const auto message = message_of<InputError>([] { write_png("/proc/a.png", Image(1, 1)); });
  EXPECT_THAT(message, HasSubstr("Cannot write /proc/a.png"));
  EXPECT_THAT(message, EndsWith("."));
}

TEST_F(Png, to_a_full_disk_says_so) {
  const auto message = message_of<InputError>([] { write_png("/dev/full", Image(1, 1)); });
  EXPECT_THAT(message, HasSubstr("Cannot write /dev/full (No space left on device)"));
}

TEST_F(Png, onto_a_folder_says_so) {
  const auto message = message_of<InputError>([&] { write_png(folder_, Image(1, 1)); });
  EXPECT_THAT(message, HasSubstr("it is a folder"));
}

TEST_F(Png, of_no_size_is_refused) {
  const auto message = message_of<InputError>([&] { write_png(in_folder("a.png"), Image(0, 5)); });
  EXPECT_THAT(message, HasSubstr("0 x 5"));
  EXPECT_FALSE(std::filesystem::exists(in_folder("a.png")));
}

TEST_F(Png, that_is_missing_empty_a_folder_or_something_else_is_named_so) {
  put(in_folder("empty.png"), "");
  put(in_folder("text.png"), "GIF89a, not what its name says");
  const auto message = [&](const std::string& name) {
    return message_of<InputError>([&] { read_png(in_folder(name)); });
  };
  EXPECT_THAT(message("missing.png"), HasSubstr("There is no file"));
  EXPECT_THAT(message("empty.png"), HasSubstr("empty.png is empty"));
  EXPECT_THAT(message("text.png"), HasSubstr("text.png is not a PNG"));
  EXPECT_THAT(message_of<InputError>([&] { read_png(folder_); }), HasSubstr("is a folder"));
}

TEST_F(Png, cut_short_anywhere_is_refused) {
  write_png(in_folder("whole.png"), colourful(9, 7, false));
  const std::string whole = bytes_of(in_folder("whole.png"));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    put(in_folder("part.png"), whole.substr(0, size));
    EXPECT_THROW(read_png(in_folder("part.png")), InputError) << size << " bytes";
  }
}

TEST_F(Png, with_any_byte_changed_is_refused_or_read_but_never_crashes) {
  write_png(in_folder("whole.png"), colourful(9, 7, false));
  const std::string whole = bytes_of(in_folder("whole.png"));
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x5A);
    put(in_folder("damaged.png"), damaged);
    try {
      read_png(in_folder("damaged.png"));
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), EndsWith("."));
    }
  }
}

TEST_F(Png, larger_than_the_limit_is_refused_with_its_size) {
  write_as(in_folder("wide.png"), 16385, 1, 1, PNG_COLOR_TYPE_GRAY,
           std::vector<std::uint8_t>(16385 / 8 + 1));
  EXPECT_THAT(message_of<InputError>([&] { read_png(in_folder("wide.png")); }),
              HasSubstr("16385 x 1; the limit is 16384 x 16384"));
}

TEST_F(Png, that_promises_more_pixels_than_it_can_hold_is_refused_before_memory_is_taken) {
  write_as(in_folder("a.png"), 2, 1, 8, PNG_COLOR_TYPE_GRAY, {1, 2});
  std::string bytes = bytes_of(in_folder("a.png"));
  // IHDR: width at 16, height at 20, big-endian; its checksum at 29, over the 17 bytes from 12.
  bytes.replace(16, 8, std::string("\x00\x00\x40\x00\x00\x00\x40\x00", 8));
  std::uint32_t crc = 0xFFFFFFFFu;
  for (std::size_t i = 12; i < 29; ++i) {
    crc ^= static_cast<std::uint8_t>(bytes[i]);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xEDB88320u : 0u);
  }
  for (std::size_t i = 0; i < 4; ++i) bytes[29 + i] = static_cast<char>(~crc >> (24 - 8 * i));
  put(in_folder("bomb.png"), bytes);
  EXPECT_THAT(message_of<InputError>([&] { read_png(in_folder("bomb.png")); }),
              HasSubstr("promises 16384 x 16384 pixels"));
}

TEST_F(Png, of_other_types_is_read_as_rgba) {
  using Pixel = std::array<std::uint8_t, 4>;
  const auto read = [&](int depth, int type, std::vector<std::uint8_t> packed) {
    write_as(in_folder("t.png"), 2, 1, depth, type, std::move(packed));
    const Image image = read_png(in_folder("t.png"));
    return std::array<Pixel, 2>{image.at(0, 0), image.at(1, 0)};
  };
  using Two = std::array<Pixel, 2>;
  EXPECT_EQ(read(8, PNG_COLOR_TYPE_GRAY, {7, 200}), (Two{{{7, 7, 7, 255}, {200, 200, 200, 255}}}));
  EXPECT_EQ(read(1, PNG_COLOR_TYPE_GRAY, {0x40}), (Two{{{0, 0, 0, 255}, {255, 255, 255, 255}}}));
  EXPECT_EQ(read(8, PNG_COLOR_TYPE_GRAY_ALPHA, {7, 1, 9, 2}), (Two{{{7, 7, 7, 1}, {9, 9, 9, 2}}}));
  EXPECT_EQ(read(1, PNG_COLOR_TYPE_PALETTE, {0x40}), (Two{{{255, 0, 0, 255}, {0, 0, 255, 255}}}));
  EXPECT_EQ(read(8, PNG_COLOR_TYPE_RGB, {1, 2, 3, 4, 5, 6}),
            (Two{{{1, 2, 3, 255}, {4, 5, 6, 255}}}));
  // 16 bits to 8: v·255/65535, rounded. 0x00FF is 0.99 and 0xFF00 is 254.01.
  EXPECT_EQ(read(16, PNG_COLOR_TYPE_GRAY, {0x00, 0xFF, 0xFF, 0x00}),
            (Two{{{1, 1, 1, 255}, {254, 254, 254, 255}}}));
}

TEST_F(Png, that_is_interlaced_is_read_whole) {
  const Image image = colourful(19, 23, false);
  write_as(in_folder("i.png"), 19, 23, 8, PNG_COLOR_TYPE_RGBA, image.rgba, PNG_INTERLACE_ADAM7);
  EXPECT_EQ(read_png(in_folder("i.png")), image);
}

}  // namespace
}  // namespace shadowlab::image
