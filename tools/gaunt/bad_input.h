// SPDX-License-Identifier: MIT
#ifndef GAUNT_TOOLS_GAUNT_BAD_INPUT_H_
#define GAUNT_TOOLS_GAUNT_BAD_INPUT_H_

#include <stdexcept>
#include <string>

namespace gaunt::tool {

// Ends the command with one line on stderr and kExitBadInput.
class BadInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Of what a library says, which may go on with hints.
inline std::string FirstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_BAD_INPUT_H_
