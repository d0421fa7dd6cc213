// SPDX-License-Identifier: MIT
// Names of the packed probe formats, as commands take and print them.
#ifndef GAUNT_TOOLS_GAUNT_FORMAT_NAME_H_
#define GAUNT_TOOLS_GAUNT_FORMAT_NAME_H_

#include <cstdint>
#include <string>
#include <vector>

#include "gaunt/gaunt.h"

namespace gaunt::tool {

// Of every format, in the order of GAUNT_FORMAT_*.
const std::vector<std::string>& FormatNames();
// Of GAUNT_FORMAT_*; "" of a number that is none.
std::string NameOfFormat(uint32_t format);
// GAUNT_FORMAT_*. Throws BadInput with the names that there are.
uint32_t FormatOfName(const std::string& name);
// Of GAUNT_FORMAT_*; all 0 of a number that is none.
gaunt_format_properties PropertiesOfFormat(uint32_t format);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_FORMAT_NAME_H_
