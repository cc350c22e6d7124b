// What functions.def says, with the kinds of every argument spelt out.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "gl/enums.h"
#include "gl/functions.h"

namespace shadowlab::docs {

/// The values that an argument may take, by name.
struct ValueList {
  std::string name;  ///< "CompareFunction"
  std::span<const gl::Constant> values;
  bool bits = false;  ///< any of them, by |
};

struct Argument {
  std::string name;
  std::string words;       ///< for people: "integer, not negative"
  std::string type;        ///< for editors: "integer", "gl.CompareFunction"
  std::string value_list;  ///< the name of its ValueList, or empty
};

struct GlFunction {
  std::string name;       ///< "StencilFunc"
  std::string signature;  ///< "gl.StencilFunc(func, ref, mask)"
  bool by_hand = false;   ///< whether its signature differs from C
  std::vector<Argument> arguments;
  Argument result;  ///< its type is empty where there is none
};

/// Every function that a recipe can call, in the order of functions.def.
std::vector<GlFunction> gl_functions();

/// Every list of values, in the order in which functions first ask for it.
std::vector<ValueList> value_lists();

}  // namespace shadowlab::docs
