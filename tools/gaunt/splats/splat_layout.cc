// SPDX-License-Identifier: MIT
#include "splats/splat_layout.h"

#include <fmt/core.h>

#include <algorithm>

namespace gaunt::tool {
namespace {

constexpr std::string_view kRest = "f_rest_";
constexpr uint32_t kMaxOrder = 4;

size_t FindVertices(const PlyHeader& header) {
  size_t index = 0;
  for (const PlyElement& element : header.elements) {
    if (element.has_list && element.name == "vertex") {
      header.Reject("splats with lists cannot be rotated");
    }
    if (element.name == "vertex") return index;
    ++index;
  }
  header.Reject("has no element 'vertex'");
}

class Finder {
 public:
  Finder(const PlyHeader& header, const PlyElement& vertex) : header_(header), vertex_(vertex) {}

  const PlyProperty* Find(std::string_view name) const {
    const auto found = std::find_if(vertex_.properties.begin(), vertex_.properties.end(),
                                    [&](const PlyProperty& one) { return one.name == name; });
    return found == vertex_.properties.end() ? nullptr : &*found;
  }

  void Require(std::string_view name) const {
    if (Find(name) == nullptr) header_.Reject(fmt::format("splats have no property {}", name));
  }

  size_t FloatOffset(std::string_view name) const {
    Require(name);
    const PlyProperty& property = *Find(name);
    if (!IsPlyFloat(property.type)) {
      header_.Reject(fmt::format("property {} is {}, but must be float", name, property.type));
    }
    return property.offset;
  }

  uint32_t Order() const {
    const auto count = static_cast<size_t>(
        std::count_if(vertex_.properties.begin(), vertex_.properties.end(),
                      [](const PlyProperty& one) { return one.name.rfind(kRest, 0) == 0; }));
    for (uint32_t n = 1; n <= kMaxOrder; ++n) {
      if (count == 3 * (size_t{n} * n - 1)) return n;
    }
    header_.Reject(
        fmt::format("has {} properties {}*, but splats have 0, 9, 24 or 45", count, kRest));
  }

 private:
  const PlyHeader& header_;
  const PlyElement& vertex_;
};

}  // namespace

SplatLayout FindSplats(const PlyHeader& header) {
  SplatLayout layout;
  layout.element = FindVertices(header);
  const PlyElement& vertex = header.elements[layout.element];
  const Finder finder(header, vertex);
  layout.count = vertex.count;
  layout.stride = vertex.stride;
  layout.position = {finder.FloatOffset("x"), finder.FloatOffset("y"), finder.FloatOffset("z")};
  // These stay as they are, but without them the vertices are no splats.
  for (const char* name : {"f_dc_0", "f_dc_1", "f_dc_2"}) finder.Require(name);
  layout.order = finder.Order();
  for (size_t k = 0; k < 3 * (size_t{layout.order} * layout.order - 1); ++k) {
    layout.rest.push_back(finder.FloatOffset(fmt::format("{}{}", kRest, k)));
  }
  layout.orientation = {finder.FloatOffset("rot_0"), finder.FloatOffset("rot_1"),
                        finder.FloatOffset("rot_2"), finder.FloatOffset("rot_3")};
  if (finder.Find("nx") != nullptr || finder.Find("ny") != nullptr ||
      finder.Find("nz") != nullptr) {
    for (const char* name : {"nx", "ny", "nz"}) layout.normal.push_back(finder.FloatOffset(name));
  }
  return layout;
}

}  // namespace gaunt::tool
