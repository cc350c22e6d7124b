// Pictures in memory, and how they reach a file.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace shadowlab::image {

/// 8-bit RGBA, rows from the top, as a PNG has them. (GL's rows start at the bottom: gl/ turns
/// them.)
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< 4 × width × height

  Image() = default;
  Image(int w, int h, std::array<std::uint8_t, 4> fill = {0, 0, 0, 255});
  std::array<std::uint8_t, 4> at(int x, int y) const;
  void set(int x, int y, std::array<std::uint8_t, 4> color);
  bool operator==(const Image&) const = default;
};

/// A single-channel picture of floats, rows from the top: depth, visibility, error.
struct FloatImage {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

/// Writes a PNG through a temporary file in the same folder, so that nobody ever reads half of one.
/// Throws InputError when the folder cannot be written.
void write_png(const std::filesystem::path& file, const Image& image);
/// Reads any PNG as 8-bit RGBA. Limit: 16384 × 16384. Throws InputError for a broken file.
Image read_png(const std::filesystem::path& file);

/// NumPy's .npy, version 1.0, little-endian, C order; shape {height, width} or {height, width, n}.
void write_npy(const std::filesystem::path& file, std::span<const std::size_t> shape,
               std::span<const float> values);
void write_npy(const std::filesystem::path& file, std::span<const std::size_t> shape,
               std::span<const std::uint8_t> values);

}  // namespace shadowlab::image
