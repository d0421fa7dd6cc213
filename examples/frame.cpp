// SPDX-License-Identifier: MIT
// One frame through the C++ face: probes are packed, and two objects lit from them in one call.
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
  std::vector<float> history(16 * 27), constants(kObjects * 28), lights(kObjects * 9);
  const float alpha = 1.0f;  // the first frame: nothing is taken over

  gaunt_frame_job job = gaunt::FrameJob();
  const auto history_view = gaunt::Tiled(history.data(), 27);
  const auto alpha_view = gaunt::Broadcast(&alpha);
  const auto constants_view = gaunt::Interleaved(constants.data(), 28);
  const auto direction_view = gaunt::Interleaved(lights.data(), 9);
  job.taps = 8;
  job.indices = indices.data();
  job.weights = weights.data();
  job.packed = packed.data();
  job.packed_count = kProbes;
  job.stride = 28;
  job.history = history_view.get();
  job.alpha = alpha_view.get();
  job.directions = direction_view.get();
  job.constants = constants_view.get();
  gaunt::FrameLight(GAUNT_FORMAT_SH3_28, kObjects, job);
  std::printf("E/pi of both objects: %.4f %.4f\n", constants[3], constants[31]);

  try {
    gaunt::BasisEval(99, 0, gaunt::Broadcast(unpacked), gaunt::Tiled(history.data(), 27));
  } catch (const gaunt::Error& error) {
    std::printf("%s\n", error.what());
    return error.status() == GAUNT_ERROR_ORDER ? 0 : 1;
  }
  return 1;
}
