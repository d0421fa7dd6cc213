// SPDX-License-Identifier: MIT
#include "bench/support.h"

namespace gaunt::bench {
namespace {

gaunt_convention Preset(uint32_t engine) {
  gaunt_convention convention;
  convention.struct_size = sizeof(convention);
  gaunt_convention_preset(engine, &convention);
  return convention;
}

void Register(const std::string& name, uint32_t n, const std::string& variant,
              const gaunt_convention& from, const gaunt_convention& to) {
  BatchBenchmark batch;
  batch.name = "convert/" + name + "/n" + std::to_string(n);
  batch.operations = OperationsOf("convert", std::to_string(n), variant);
  batch.inputs = {3 * n * n};
  batch.outputs = {3 * n * n};
  batch.call = [=](size_t count, const BatchBenchmark::Views& in,
                   const BatchBenchmark::Views& out) {
    return gaunt_convert(n, 3, count, &from, &to, in[0], out[0]);
  };
  RegisterBatch(batch);
}

}  // namespace

GAUNT_BENCHMARKS(convert) {
  const gaunt_convention gaunt = Preset(GAUNT_ENGINE_GAUNT), unity = Preset(GAUNT_ENGINE_UNITY);
  const gaunt_convention threejs = Preset(GAUNT_ENGINE_THREEJS);
  gaunt_convention positive = gaunt;
  positive.sign = GAUNT_SIGN_POSITIVE;
  gaunt_convention sn3d = positive;
  sn3d.scale = GAUNT_SCALE_SN3D;
  Register("from_unity", 3, "rgb from Unity", unity, gaunt);
  Register("to_unity", 3, "rgb to Unity", gaunt, unity);
  Register("sign", 3, "rgb sign", gaunt, positive);
  for (const uint32_t n : {3u, 6u}) {
    Register("scale", n, "rgb scale", gaunt, sn3d);
    Register("z_to_y_up", n, "rgb z to y up", gaunt, threejs);
  }
}

}  // namespace gaunt::bench
