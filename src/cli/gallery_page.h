// The gallery's page: HTML of what was drawn, with nothing fetched from elsewhere.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace shadowlab::cli {

/// File names are relative to the page, as the file system has them.
struct ShownPass {
  std::string name;
  std::string color;                         ///< picture after the pass
  std::string stencil;                       ///< likewise
  std::vector<std::uint8_t> stencil_values;  ///< those present, ascending
};

struct ShownRecipe {
  std::string name;  ///< "projected_stencil"
  std::string title;
  std::string lecture;
  std::string scene;
  std::string source_file;
  std::string source;
  std::string picture;
  std::vector<ShownPass> passes;
  double milliseconds = 0;  ///< a frame
  std::string error;        ///< why it was not drawn; empty where it was
};

struct Gallery {
  std::vector<ShownRecipe> recipes;
  int width = 0, height = 0;  ///< of the pictures
  std::string renderer;       ///< "llvmpipe …"
};

std::string page_of(const Gallery& gallery);

/// Text as HTML shows it, within elements and quoted attributes.
std::string escaped(std::string_view text);

/// A relative path as a link has it: bytes that mean something in a URL become %XX.
std::string link_to(std::string_view path);

}  // namespace shadowlab::cli
