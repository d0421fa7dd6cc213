// SPDX-License-Identifier: MIT
// One frame through the C++ face: probes are packed, blended for two objects, and turned into
// constants.
#include <cstdio>
#include <gaunt/gaunt.hpp>
#include <vector>

int main() {
  constexpr size_t kProbes = 8, kObjects = 2;
  std::vector<float> probes(kProbes * 27);
  for (size_t p = 0; p < kProbes; ++p) {
    for (size_t c = 0; c < 3; ++c) probes[27 * p + 9 * c] = 1.0f + static_cast<float>(p);
  }
  std::vector<unsigned char> packed(kProbes * gaunt::FormatInfo(GAUNT_FORMAT_SH3_28).bytes);
  const float* const unpacked = probes.data();
  gaunt::ProbeEncode(GAUNT_FORMAT_SH3_28, kProbes, gaunt::Interleaved(unpacked, 27), packed.data(),
                     28);

  std::vector<uint32_t> indices;
  for (size_t i = 0; i < kObjects; ++i) {
    for (uint32_t t = 0; t < 8; ++t) indices.push_back(t);
  }
  const std::vector<float> weights(kObjects * 8, 0.125f);
  std::vector<float> radiance(16 * 27), constants(kObjects * 28);
  gaunt::ProbeGather(GAUNT_FORMAT_SH3_28, 3, kObjects, 8, indices.data(), weights.data(),
                     packed.data(), kProbes, 28, gaunt::Tiled(radiance.data(), 27));
  gaunt::IrradianceConstants(3, kObjects, gaunt::Tiled(radiance.data(), 27),
                             gaunt::Interleaved(constants.data(), 28));
  std::printf("E/pi of both objects: %.4f %.4f\n", constants[3], constants[31]);

  try {
    gaunt::BasisEval(99, 0, gaunt::Broadcast(unpacked), gaunt::Tiled(radiance.data(), 27));
  } catch (const gaunt::Error& error) {
    std::printf("%s\n", error.what());
    return error.status() == GAUNT_ERROR_ORDER ? 0 : 1;
  }
  return 1;
}
