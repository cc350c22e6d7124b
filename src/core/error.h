// What can go wrong, in the user's words.
//
// Every message is one plain sentence: what is wrong, where, and what to do about it. Nothing of
// the C++ (type names, function names, stacks) belongs in it.
#pragma once

#include <stdexcept>
#include <string>

namespace shadowlab {

/// Wrong usage or bad input: the user can mend it. The program ends with exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The machine cannot: a library or a GL context is missing. The program ends with exit code 3.
class MachineError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace shadowlab
