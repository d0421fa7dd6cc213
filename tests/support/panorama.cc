// SPDX-License-Identifier: MIT
#include "tests/support/panorama.h"

#include <OpenImageIO/imageio.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>

namespace gaunt::test {
namespace {

constexpr const char* kFolder = "/usr/share/blender/datafiles/studiolights/world/";
constexpr const char* kNames[] = {"city",  "courtyard", "forest",  "interior",
                                  "night", "studio",    "sunrise", "sunset"};

Panorama Read(const std::string& name) {
  const std::string path = kFolder + name + ".exr";
  Panorama panorama;
  panorama.name = name;
  const auto input = OIIO::ImageInput::open(path);
  if (input) {
    const OIIO::ImageSpec& spec = input->spec();
    const auto width = static_cast<uint32_t>(spec.width),
               height = static_cast<uint32_t>(spec.height);
    panorama.texels.resize(size_t{3} * width * height);
    panorama.image = {panorama.texels.data(), width,          height, 12,
                      ptrdiff_t{12} * width,  GAUNT_TEXEL_F32};
    if (input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, panorama.texels.data())) {
      return panorama;
    }
  }
  std::cerr << "cannot read " << path << "\n";
  std::abort();
}

}  // namespace

const std::vector<Panorama>& Panoramas() {
  static const std::vector<Panorama> panoramas = [] {
    std::vector<Panorama> all;
    if (!std::filesystem::exists(kFolder)) return all;
    for (const char* name : kNames) all.push_back(Read(name));
    return all;
  }();
  return panoramas;
}

}  // namespace gaunt::test
