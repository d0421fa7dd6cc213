// SPDX-License-Identifier: MIT
// Real panoramas: the eight of Debian's blender-data (CC0, by Greg Zaal), where they are installed.
#ifndef GAUNT_TESTS_SUPPORT_PANORAMA_H_
#define GAUNT_TESTS_SUPPORT_PANORAMA_H_

#include <string>
#include <vector>

#include "gaunt/gaunt.h"

namespace gaunt::test {

struct Panorama {
  std::string name;
  std::vector<float> texels;  // RGB, row by row
  gaunt_image image;
};

// All of them, read once; empty where they are not installed. A file that is there and cannot be
// read ends the program.
const std::vector<Panorama>& Panoramas();

}  // namespace gaunt::test

#endif  // GAUNT_TESTS_SUPPORT_PANORAMA_H_
