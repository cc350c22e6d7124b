#include "cli/captures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/files.h"
#include "image/buffer_pictures.h"

namespace shadowlab::cli {
namespace {

// Digits of 3 × 5 dots, a row a number, the left dot its highest bit.
constexpr std::array<std::array<std::uint8_t, 5>, 10> digits{{{7, 5, 5, 5, 7},
                                                              {2, 6, 2, 2, 7},
                                                              {7, 1, 7, 4, 7},
                                                              {7, 1, 7, 1, 7},
                                                              {5, 5, 7, 1, 1},
                                                              {7, 4, 7, 1, 7},
                                                              {7, 4, 7, 5, 7},
                                                              {7, 1, 1, 2, 2},
                                                              {7, 5, 7, 5, 7},
                                                              {7, 5, 7, 1, 7}}};

constexpr int dot = 2;                  // pixels of one dot of a digit
constexpr int swatch = 12;              // a legend's square
constexpr int entry_width = 60;         // a square and up to three digits
constexpr int legend_row = swatch + 6;  // with its margin

void fill(image::Image& image, int x, int y, int width, int height,
          std::array<std::uint8_t, 4> color) {
  for (int row = std::max(0, y); row < std::min(image.height, y + height); ++row) {
    for (int column = std::max(0, x); column < std::min(image.width, x + width); ++column)
      image.set(column, row, color);
  }
}

void write_number(image::Image& image, int x, int y, int number) {
  for (const char digit : std::to_string(number)) {
    const auto& rows = digits[static_cast<std::size_t>(digit - '0')];
    for (int row = 0; row < 5; ++row) {
      for (int column = 0; column < 3; ++column) {
        if (rows[static_cast<std::size_t>(row)] >> (2 - column) & 1) {
          fill(image, x + column * dot, y + row * dot, dot, dot, {255, 255, 255, 255});
        }
      }
    }
    x += 4 * dot;
  }
}

}  // namespace

std::string stem_of(std::size_t index, std::string_view pass) {
  std::string stem = fmt::format("{:02}_", index + 1);
  // The number is the stem's already.
  pass.remove_prefix(std::min(pass.find_first_not_of("0123456789. "), pass.size()));
  for (const char c : pass.substr(0, 60)) {
    const bool keep =
        std::isalnum(static_cast<unsigned char>(c)) && static_cast<unsigned char>(c) < 128;
    if (keep) {
      stem += c;
    } else if (stem.back() != '_') {
      stem += '_';
    }
  }
  while (stem.back() == '_') stem.pop_back();
  return stem;
}

image::Image stencil_picture(const std::vector<std::uint8_t>& stencil, int width, int height) {
  std::array<bool, 256> present{};
  for (const std::uint8_t value : stencil) present[value] = true;
  const int entries = static_cast<int>(std::count(present.begin(), present.end(), true));
  const int columns = std::max(1, width / entry_width);
  const int rows = (entries + columns - 1) / columns;
  image::Image picture(width, height + rows * legend_row, {32, 32, 32, 255});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      picture.set(x, y,
                  image::stencil_color(
                      stencil[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                              static_cast<std::size_t>(x)]));
    }
  }
  int entry = 0;
  for (int value = 0; value < 256; ++value) {
    if (!present[static_cast<std::size_t>(value)]) continue;
    const int x = entry % columns * entry_width + 3;
    const int y = height + entry / columns * legend_row + 3;
    fill(picture, x, y, swatch, swatch, image::stencil_color(static_cast<std::uint8_t>(value)));
    write_number(picture, x + swatch + 4, y + 1, value);
    ++entry;
  }
  return picture;
}

Captures::Captures(std::filesystem::path folder, Session& session)
    : folder_(std::move(folder)), session_(session) {
  make_folder(folder_);
  session_.recipe().on_pass_end([this](std::size_t pass) { capture(pass); });
}

Captures::~Captures() { session_.recipe().on_pass_end({}); }

void Captures::capture(std::size_t pass) {
  const gl::MainFrame& frame = session_.graphics().frame;
  const std::string& name = session_.recipe().passes()[pass].name;
  passes_.push_back({name, stem_of(pass, name), frame.read_color()});
  const auto file = [&](const char* ending) { return folder_ / (passes_.back().stem + ending); };
  const auto width = static_cast<std::size_t>(frame.width()),
             height = static_cast<std::size_t>(frame.height());
  const image::Image& color = passes_.back().color;
  write_picture(file(".color.png"), color);
  write_array(file(".color.npy"), std::array<std::size_t, 3>{height, width, 4}, color.rgba);
  const auto depth = frame.read_depth();
  write_picture(file(".depth.png"), image::depth_picture(depth));
  write_array(file(".depth.npy"), std::array<std::size_t, 2>{height, width}, depth.values);
  const auto stencil = frame.read_stencil();
  write_picture(file(".stencil.png"), stencil_picture(stencil, frame.width(), frame.height()));
  write_array(file(".stencil.npy"), std::array<std::size_t, 2>{height, width}, stencil);
}

void Captures::finish() {
  nlohmann::ordered_json index = nlohmann::ordered_json::array();
  for (const Capture& capture : passes_) {
    index.push_back({{"pass", capture.pass},
                     {"color", capture.stem + ".color.png"},
                     {"depth", capture.stem + ".depth.png"},
                     {"stencil", capture.stem + ".stencil.png"},
                     {"raw",
                      {capture.stem + ".color.npy", capture.stem + ".depth.npy",
                       capture.stem + ".stencil.npy"}}});
  }
  // Names of passes may be any bytes; JSON is UTF-8.
  write_text(folder_ / "index.json",
             index.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace shadowlab::cli
