// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "gaunt/gaunt.h"
#include "gaunt/gaunt.hpp"
#include "tests/support/golden.h"
#include "tests/support/operation.h"
#include "tests/support/targets.h"
#include "zh3/constants.h"
#include "zh3/zh3_reference.h"

namespace gaunt::test {
namespace {

const double kPi = std::acos(-1.0);
const uint32_t kModes[] = {GAUNT_ZH3_AXIS_LUMINANCE, GAUNT_ZH3_AXIS_CHANNEL};
const uint32_t kModels[] = {GAUNT_ZH3_MODEL_AMBIENT_DIRECTIONAL, GAUNT_ZH3_MODEL_SPHERICAL_CAP,
                            GAUNT_ZH3_MODEL_CURVE};

bool Shared(uint32_t mode) { return mode == GAUNT_ZH3_AXIS_LUMINANCE; }
size_t AxisPlanes(uint32_t mode) { return Shared(mode) ? 3 : 9; }
std::string Name(uint32_t mode) { return Shared(mode) ? "/luminance" : "/channel"; }

// A light about a direction, in colours, and something else besides; order 2 or 3.
void MakeProbe(Random& random, size_t order, float* out) {
  float d[3];
  random.Direction(d);
  const float root = std::sqrt(5.0f);
  const float band[5] = {root * d[0] * d[1], -root * d[1] * d[2],
                         root * 0.28867513f * (3.0f * d[2] * d[2] - 1.0f), -root * d[2] * d[0],
                         root * 0.5f * (d[0] * d[0] - d[1] * d[1])};
  for (size_t c = 0; c < 3; ++c) {
    float* const f = out + c * order * order;
    random.Fill(f, order * order, -0.2, 0.2);
    const float strength = random.Between(0.3, 1.0);
    f[0] = random.Between(0.5, 1.5);  // ratios beyond sqrt(3) too
    f[1] -= strength * d[1];
    f[2] += strength * d[2];
    f[3] -= strength * d[0];
    for (size_t m = 0; order == 3 && m < 5; ++m) f[4 + m] += strength * band[m];
  }
}

double Norm(const double* f, size_t n) {
  double sum = 0.0;
  for (size_t i = 0; i < n; ++i) sum += f[i] * f[i];
  return std::sqrt(sum);
}

// s of the header: how much of bands 1 is left in their weighted sum.
double Agreement(uint32_t mode, const std::vector<double>& f,
                 const std::vector<double>& weights = {0.2126, 0.7152, 0.0722}) {
  if (!Shared(mode)) return 1.0;
  const size_t stride = f.size() / 3;
  double sum[3] = {}, all = 0.0;
  for (size_t c = 0; c < 3; ++c) {
    for (size_t k = 0; k < 3; ++k) sum[k] += weights[c] * f[c * stride + 1 + k];
    all += weights[c] * Norm(&f[c * stride + 1], 3);
  }
  return Norm(sum, 3) / all;
}

Operation SolveOperation(uint32_t mode, bool axis) {
  Operation operation;
  operation.name = "zh3_solve" + Name(mode) + (axis ? "/axis" : "");
  operation.inputs = {27};
  operation.outputs = {3};
  if (axis) operation.outputs.push_back(AxisPlanes(mode));
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    if (axis && count != 0 && out[1] == nullptr) return gaunt_status{GAUNT_ERROR_NULL};  // allowed
    return gaunt_zh3_solve(mode, count, in[0], out[0], axis ? out[1] : nullptr);
  };
  operation.make = [](Random& random, size_t, float* out) { MakeProbe(random, 3, out); };
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    double found[9];
    zh3::SolveReference(Shared(mode), in[0].data(), out[0].data(), found);
    if (axis) std::copy_n(found, AxisPlanes(mode), out[1].data());
  };
  operation.tolerance = [=](const Operation::Item& in, const Operation::Item&, size_t side,
                            size_t plane) {
    const double s = Agreement(mode, in[0]);
    return (side == 1 ? 2e-7 : 6e-7 * Norm(&in[0][9 * plane + 4], 5)) / s;
  };
  return operation;
}

Operation RefitOperation(uint32_t mode) {
  Operation operation;
  operation.name = "zh3_refit" + Name(mode);
  operation.inputs = {27};
  operation.outputs = {12, 3};
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_zh3_refit(mode, count, in[0], out[0], out[1]);
  };
  operation.make = [](Random& random, size_t, float* out) { MakeProbe(random, 3, out); };
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    zh3::RefitReference(Shared(mode), in[0].data(), out[0].data(), out[1].data());
  };
  // The error is flat where it is least.
  operation.tolerance = [=](const Operation::Item& in, const Operation::Item&, size_t side,
                            size_t plane) {
    return side == 0 && plane % 4 == 0 ? 0.0 : 1e-3 * Norm(in[0].data(), 27);
  };
  return operation;
}

Operation HallucinateOperation(uint32_t model, uint32_t mode) {
  Operation operation;
  operation.name = "zh3_hallucinate/model" + std::to_string(model) + Name(mode);
  operation.inputs = {12};
  operation.outputs = {3};
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_zh3_hallucinate(model, mode, count, in[0], out[0]);
  };
  operation.make = [](Random& random, size_t, float* out) { MakeProbe(random, 2, out); };
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    const double root = std::sqrt(5.0 / 3.0);
    const double curve[3][2] = {{root, 0.0}, {-root, 2.0 / 3.0 * std::sqrt(5.0)}, {0.08, 0.6}};
    zh3::HallucinateReference(Shared(mode), curve[model - 1][0], curve[model - 1][1], nullptr,
                              in[0].data(), out[0].data());
  };
  operation.tolerance = [=](const Operation::Item& in, const Operation::Item&, size_t,
                            size_t plane) {
    return 2e-6 * in[0][4 * plane] / Agreement(mode, in[0]);
  };
  return operation;
}

Operation CurveOperation(uint32_t mode) {
  const std::vector<float> weights = {0.5f, 0.25f, 1.0f};
  Operation operation = HallucinateOperation(GAUNT_ZH3_MODEL_CURVE, mode);
  operation.name = "zh3_hallucinate_curve" + Name(mode);
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_zh3_hallucinate_curve(0.375f, 0.5f, weights.data(), mode, count, in[0], out[0]);
  };
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    const std::vector<double> exact(weights.begin(), weights.end());
    zh3::HallucinateReference(Shared(mode), 0.375, 0.5, exact.data(), in[0].data(), out[0].data());
  };
  operation.tolerance = [=](const Operation::Item& in, const Operation::Item&, size_t,
                            size_t plane) {
    const double s = Agreement(mode, in[0], {0.5, 0.25, 1.0});
    return 2e-6 * (0.375 + 0.5) * in[0][4 * plane] / s;
  };
  return operation;
}

void MakeProbeOrK2(Random& random, size_t side, float* out) {
  if (side == 0) return MakeProbe(random, 2, out);
  side == 1 ? random.Fill(out, 3, -1.0, 2.0) : random.Direction(out);
}

Operation ExpandOperation(uint32_t mode) {
  Operation operation;
  operation.name = "zh3_expand" + Name(mode);
  operation.inputs = {12, 3};
  operation.outputs = {27};
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_zh3_expand(mode, count, in[0], in[1], out[0]);
  };
  operation.make = MakeProbeOrK2;
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    zh3::ExpandReference(Shared(mode), in[0].data(), in[1].data(), out[0].data());
  };
  operation.tolerance = [=](const Operation::Item& in, const Operation::Item&, size_t,
                            size_t plane) {
    if (plane % 9 < 4) return 0.0;
    return 5e-7 * std::abs(in[1][plane / 9]) / Agreement(mode, in[0]);
  };
  return operation;
}

Operation IrradianceOperation(uint32_t mode) {
  Operation operation;
  operation.name = "zh3_irradiance" + Name(mode);
  operation.inputs = {12, 3, 3};
  operation.outputs = {3};
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_zh3_irradiance(mode, count, in[0], in[1], in[2], out[0]);
  };
  operation.make = MakeProbeOrK2;
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    zh3::IrradianceReference(Shared(mode), in[0].data(), in[1].data(), in[2].data(), out[0].data());
  };
  operation.tolerance = [=](const Operation::Item& in, const Operation::Item&, size_t,
                            size_t plane) {
    return 2e-7 * (Norm(&in[0][4 * plane], 4) + std::abs(in[1][plane]) / Agreement(mode, in[0]));
  };
  return operation;
}

Operation GeomericsOperation() {
  Operation operation;
  operation.name = "geomerics_irradiance";
  operation.inputs = {12, 3};
  operation.outputs = {3};
  operation.call = [](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_geomerics_irradiance(count, in[0], in[1], out[0]);
  };
  operation.make = [](Random& random, size_t side, float* out) {
    MakeProbeOrK2(random, side == 0 ? 0 : 2, out);
  };
  operation.reference = [](const Operation::Item& in, Operation::Item& out) {
    zh3::GeomericsReference(in[0].data(), in[1].data(), out[0].data());
  };
  operation.tolerance = [](const Operation::Item& in, const Operation::Item&, size_t,
                           size_t plane) { return 7e-7 * in[0][4 * plane]; };
  return operation;
}

std::vector<Operation> Operations() {
  std::vector<Operation> operations = {GeomericsOperation()};
  for (const uint32_t mode : kModes) {
    for (const bool axis : {false, true}) operations.push_back(SolveOperation(mode, axis));
    for (const uint32_t model : kModels) operations.push_back(HallucinateOperation(model, mode));
    operations.push_back(CurveOperation(mode));
    operations.push_back(RefitOperation(mode));
    operations.push_back(ExpandOperation(mode));
    operations.push_back(IrradianceOperation(mode));
  }
  return operations;
}

class Zh3 : public TargetTest {};

TEST_P(Zh3, MatchesTheDefinitionInEveryLayout) {
  for (const Operation& operation : Operations()) TestBatches(operation);
}

TEST_P(Zh3, RejectsWrongArguments) {
  for (const Operation& operation : Operations()) TestErrors(operation);
  for (const uint32_t mode : {0u, 3u, UINT32_MAX}) {
    EXPECT_EQ(gaunt_zh3_solve(mode, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_RANGE);
    EXPECT_EQ(gaunt_zh3_refit(mode, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_RANGE);
    EXPECT_EQ(gaunt_zh3_hallucinate(1, mode, 0, nullptr, nullptr), GAUNT_ERROR_RANGE);
    EXPECT_EQ(gaunt_zh3_hallucinate_curve(0, 1, nullptr, mode, 0, nullptr, nullptr),
              GAUNT_ERROR_RANGE);
    EXPECT_EQ(gaunt_zh3_expand(mode, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_RANGE);
    EXPECT_EQ(gaunt_zh3_irradiance(mode, 0, nullptr, nullptr, nullptr, nullptr), GAUNT_ERROR_RANGE);
  }
  for (const uint32_t model : {0u, 4u, UINT32_MAX}) {
    EXPECT_EQ(gaunt_zh3_hallucinate(model, 1, 0, nullptr, nullptr), GAUNT_ERROR_RANGE);
  }
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    EXPECT_EQ(gaunt_zh3_hallucinate_curve(bad, 1, nullptr, 1, 0, nullptr, nullptr),
              GAUNT_ERROR_RANGE);
    EXPECT_EQ(gaunt_zh3_hallucinate_curve(1, -bad, nullptr, 1, 0, nullptr, nullptr),
              GAUNT_ERROR_RANGE);
    for (size_t c = 0; c < 3; ++c) {
      float weights[3] = {1, 1, 1};
      weights[c] = bad;
      EXPECT_EQ(gaunt_zh3_hallucinate_curve(1, 1, weights, 1, 0, nullptr, nullptr),
                GAUNT_ERROR_RANGE);
    }
  }
}

TEST(Zh3Bits, AreTheSameOnTargetsOfAClass) {
  for (const Operation& operation : Operations()) TestSameBits(operation);
}

// ---- one probe at a time -----------------------------------------------------------------------

using Floats = std::vector<float>;

gaunt_view Item(const Floats& f) {
  gaunt_view view;
  gaunt_view_interleaved(const_cast<float*>(f.data()), f.size(), &view);
  return view;
}

Floats Solved(uint32_t mode, const Floats& sh3) {
  Floats k2(3, 9.0f);
  Zh3Solve(mode, 1, Item(sh3), OutView(Item(k2)));
  return k2;
}
Floats Axis(uint32_t mode, const Floats& sh3) {
  Floats k2(3), axis(AxisPlanes(mode), 9.0f);
  Zh3Solve(mode, 1, Item(sh3), OutView(Item(k2)), OutView(Item(axis)));
  return axis;
}
Floats Hallucinated(uint32_t model, uint32_t mode, const Floats& sh2) {
  Floats k2(3, 9.0f);
  Zh3Hallucinate(model, mode, 1, Item(sh2), OutView(Item(k2)));
  return k2;
}
Floats Expanded(uint32_t mode, const Floats& sh2, const Floats& k2) {
  Floats sh3(27, 9.0f);
  Zh3Expand(mode, 1, Item(sh2), Item(k2), OutView(Item(sh3)));
  return sh3;
}
Floats Irradiance(uint32_t mode, const Floats& sh2, const Floats& k2, const Floats& normal) {
  Floats out(3, 9.0f);
  Zh3Irradiance(mode, 1, Item(sh2), Item(k2), Item(normal), OutView(Item(out)));
  return out;
}
Floats Geomerics(const Floats& sh2, const Floats& normal) {
  Floats out(3, 9.0f);
  GeomericsIrradiance(1, Item(sh2), Item(normal), OutView(Item(out)));
  return out;
}

struct Fit {
  Floats sh2 = Floats(12, 9.0f);
  Floats k2 = Floats(3, 9.0f);
};
Fit Refitted(uint32_t mode, const Floats& sh3) {
  Fit fit;
  Zh3Refit(mode, 1, Item(sh3), OutView(Item(fit.sh2)), OutView(Item(fit.k2)));
  return fit;
}

std::vector<double> Exact(const Floats& f) { return std::vector<double>(f.begin(), f.end()); }

// The same channel three times.
Floats Grey(const Floats& channel) {
  Floats f;
  for (int c = 0; c < 3; ++c) f.insert(f.end(), channel.begin(), channel.end());
  return f;
}

// Bands 0 and 1.
Floats Order2(const Floats& sh3) {
  Floats f(12);
  for (size_t c = 0; c < 3; ++c) std::copy_n(&sh3[9 * c], 4, &f[4 * c]);
  return f;
}

// A directional light: y_i(d).
Floats Delta(const float d[3]) {
  const double exact[3] = {d[0], d[1], d[2]};
  const double band1[4] = {0.0, -exact[1], exact[2], -exact[0]};
  double y[9];
  y[0] = 1.0 / std::sqrt(4.0 * kPi);
  for (int i = 1; i < 4; ++i) y[i] = std::sqrt(3.0 / (4.0 * kPi)) * band1[i];
  const double root = std::sqrt(15.0 / (4.0 * kPi));
  y[4] = root * exact[0] * exact[1];
  y[5] = -root * exact[1] * exact[2];
  y[6] = root / std::sqrt(12.0) * (3.0 * exact[2] * exact[2] - 1.0);
  y[7] = -root * exact[2] * exact[0];
  y[8] = 0.5 * root * (exact[0] * exact[0] - exact[1] * exact[1]);
  Floats f(9);
  for (size_t i = 0; i < 9; ++i) f[i] = static_cast<float>(y[i]);
  return f;
}

TEST_P(Zh3, MatchesGoldenRatios) {
  for (const auto& row : ReadGolden("zh3_ratio_models.csv")) {
    const double r = std::stod(row[0]);
    if (r > std::sqrt(3.0) * (1.0 + 1e-15)) continue;
    const Floats sh2 = Grey({1.0f, 0.0f, static_cast<float>(r), 0.0f});
    for (const uint32_t mode : kModes) {
      for (const uint32_t model : kModels) {
        const double wanted = std::stod(row[model]);
        EXPECT_NEAR(Hallucinated(model, mode, sh2)[1], wanted, 1e-6) << r;
      }
    }
  }
}

TEST_P(Zh3, MatchesGoldenHallucinations) {
  int tested = 0;
  for (const auto& row : ReadGolden("zh3_hallucination.csv")) {
    const auto number = [&](size_t i) { return std::stod(row[i]); };
    Floats channel, normal;
    for (size_t i = 1; i < 5; ++i) channel.push_back(static_cast<float>(number(i)));
    for (size_t i = 5; i < 8; ++i) normal.push_back(static_cast<float>(number(i)));
    if (number(8) > std::sqrt(3.0)) continue;  // cut off here, not there
    ++tested;
    const double size = number(1) + std::hypot(number(2), number(3), number(4));
    const Floats sh2 = Grey(channel);
    for (const uint32_t mode : kModes) {
      EXPECT_NEAR(Irradiance(mode, sh2, {0, 0, 0}, normal)[0], number(9 + 1), 1e-6 * size);
      for (const uint32_t model : kModels) {
        const Floats k2 = Hallucinated(model, mode, sh2);
        EXPECT_NEAR(k2[0], number(9 + 2 * model), 1e-6 * size);
        EXPECT_NEAR(Irradiance(mode, sh2, k2, normal)[0], number(10 + 2 * model), 1e-6 * size);
      }
    }
  }
  EXPECT_GE(tested, 8);
}

TEST_P(Zh3, MatchesGoldenColours) {
  for (const auto& row : ReadGolden("zh3_hallucination_rgb_lumaxis.csv")) {
    const auto number = [&](size_t i) { return std::stod(row[i]); };
    Floats sh2(12), normal;
    for (size_t c = 0; c < 3; ++c) {
      for (size_t i = 0; i < 4; ++i) sh2[4 * c + i] = static_cast<float>(number(1 + 3 * i + c));
    }
    for (size_t k = 13; k < 16; ++k) normal.push_back(static_cast<float>(number(k)));
    Floats sh3(27);
    for (size_t c = 0; c < 3; ++c) std::copy_n(&sh2[4 * c], 4, &sh3[9 * c]);
    const Floats axis = Axis(GAUNT_ZH3_AXIS_LUMINANCE, sh3);
    for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(axis[k], number(16 + k), 2e-6);
    const double size = Norm(Exact(sh2).data(), 12);
    for (size_t c = 0; c < 3; ++c) {
      if (number(19 + 5 * c) > std::sqrt(3.0)) continue;
      EXPECT_NEAR(Irradiance(GAUNT_ZH3_AXIS_LUMINANCE, sh2, {0, 0, 0}, normal)[c],
                  number(20 + 5 * c), 1e-6 * size);
      for (const uint32_t model : kModels) {
        const Floats k2 = Hallucinated(model, GAUNT_ZH3_AXIS_LUMINANCE, sh2);
        EXPECT_NEAR(Irradiance(GAUNT_ZH3_AXIS_LUMINANCE, sh2, k2, normal)[c],
                    number(20 + 5 * c + model), 4e-6 * size);
      }
    }
  }
}

// ZH3 has all of order 3 of a directional light, and all of a uniform one.
TEST_P(Zh3, ADirectionalLightIsWhole) {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    float d[3];
    random.Direction(d);
    const Floats sh3 = Grey(Delta(d));
    const double norm = Norm(Exact(sh3).data(), 9);
    for (const uint32_t mode : kModes) {
      const Floats k2 = Solved(mode, sh3), back = Expanded(mode, Order2(sh3), k2);
      for (size_t p = 0; p < 27; ++p) EXPECT_NEAR(back[p], sh3[p], 1e-6 * norm);
      const Fit fit = Refitted(mode, sh3);
      const Floats again = Expanded(mode, fit.sh2, fit.k2);
      for (size_t p = 0; p < 27; ++p) EXPECT_NEAR(again[p], sh3[p], 1e-3 * norm);
      EXPECT_LE(zh3::ErrorReference(Shared(mode), Exact(sh3).data(), Exact(fit.sh2).data(),
                                    Exact(fit.k2).data()),
                1e-7 * norm * norm);
      // The ambient and directional model is exact here, the cap too: it is a point.
      for (const uint32_t model : {1u, 2u}) {
        EXPECT_NEAR(Hallucinated(model, mode, Order2(sh3))[0], k2[0], 2e-6 * norm);
      }
    }
    // E/pi of a light of irradiance 1 at its direction, and away from it.
    const Floats peak = Geomerics(Order2(sh3), {d[0], d[1], d[2]});
    const Floats away = Geomerics(Order2(sh3), {-d[0], -d[1], -d[2]});
    EXPECT_NEAR(peak[0], 1.0 / kPi, 4e-7);
    EXPECT_NEAR(away[0], 0.0, 1e-7);
  }
}

TEST_P(Zh3, UniformRadianceIsUniform) {
  const float mean = static_cast<float>(std::sqrt(4.0 * kPi));
  Floats channel(9, 0.0f);
  channel[0] = mean;
  const Floats sh3 = Grey(channel), zero(3, 0.0f);
  Random random(4);
  for (const uint32_t mode : kModes) {
    EXPECT_EQ(Solved(mode, sh3), zero);
    EXPECT_EQ(Axis(mode, sh3), Floats(AxisPlanes(mode), 0.0f));
    const Fit fit = Refitted(mode, sh3);
    EXPECT_EQ(fit.sh2, Order2(sh3));
    EXPECT_EQ(fit.k2, zero);
    EXPECT_EQ(Expanded(mode, Order2(sh3), {1, 1, 1}), sh3);  // about no axis
    for (const uint32_t model : kModels) {
      EXPECT_EQ(Hallucinated(model, mode, Order2(sh3)), zero);
    }
    for (int i = 0; i < 20; ++i) {
      Floats normal(3);
      random.Direction(normal.data());
      EXPECT_NEAR(Irradiance(mode, Order2(sh3), {1, 1, 1}, normal)[0], 1.0, 2e-7);
      EXPECT_NEAR(Geomerics(Order2(sh3), normal)[2], 1.0, 2e-7);  // peers: 1.128
    }
  }
}

// The mean over the sphere is the mean radiance, whatever the shape of the lobe.
TEST_P(Zh3, GeomericsKeepsTheMean) {
  for (const float r : {0.0f, 0.3f, 0.9f, 1.5f, 1.7320508f}) {
    const Floats sh2 = Grey({1.0f, 0.0f, r, 0.0f});
    double mean = 0.0;
    constexpr int kPoints = 2000;
    for (int i = 0; i < kPoints; ++i) {
      const float z = static_cast<float>(-1.0 + (2.0 * i + 1.0) / kPoints);
      mean += Geomerics(sh2, {std::sqrt(1.0f - z * z), 0.0f, z})[0] / kPoints;
    }
    EXPECT_NEAR(mean, 0.5 / std::sqrt(kPi), 1e-6);
  }
}

TEST_P(Zh3, GeomericsIsNeverNegative) {
  Random random(5);
  for (int i = 0; i < 5000; ++i) {
    Floats sh2(12), normal(3);
    random.Fill(sh2.data(), 12, -2.0, 2.0);
    random.Direction(normal.data());
    for (const float value : Geomerics(sh2, normal)) ASSERT_GE(value, 0.0f);
  }
}

// The seed of many shaders divides by L_0 as it is (k2 of 1.5e5 at 1e-6, a NaN at 0).
TEST_P(Zh3, HallucinationIsBoundedByTheMean) {
  for (const float mean : {1.0f, 0.1f, 1e-3f, 1e-6f, 1e-20f, 1e-30f, 0.0f, -0.1f}) {
    const Floats sh2 = Grey({mean, 0.3f, 0.4f, 0.0f});
    for (const uint32_t mode : kModes) {
      for (const uint32_t model : kModels) {
        const float k2 = Hallucinated(model, mode, sh2)[0];
        EXPECT_LE(std::abs(k2), std::max(mean, 0.0f) * std::sqrt(5.0f) * 1.000001f);
        if (mean == 0.1f && model == GAUNT_ZH3_MODEL_CURVE) {
          EXPECT_NEAR(k2, 0.1938564, 1e-6);
        }
      }
    }
  }
}

TEST_P(Zh3, TinyAndHugeProbes) {
  Random random(6);
  Floats sh3(27);
  MakeProbe(random, 3, sh3.data());
  for (const int exponent : {-100, -70, -30, 30, 70, 115}) {
    const float scale = std::ldexp(1.0f, exponent);
    Floats scaled = sh3;
    for (float& value : scaled) value *= scale;
    for (const uint32_t mode : kModes) {
      const Floats k2 = Solved(mode, sh3), scaled_k2 = Solved(mode, scaled);
      const Floats guess = Hallucinated(1, mode, Order2(sh3));
      const Floats scaled_guess = Hallucinated(1, mode, Order2(scaled));
      const Fit fit = Refitted(mode, sh3), scaled_fit = Refitted(mode, scaled);
      for (size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(scaled_k2[c] / scale, k2[c], 1e-6);
        EXPECT_NEAR(scaled_guess[c] / scale, guess[c], 1e-6);
        EXPECT_NEAR(scaled_fit.k2[c] / scale, fit.k2[c], 1e-3);
      }
      for (size_t p = 0; p < 12; ++p) {
        EXPECT_NEAR(scaled_fit.sh2[p] / scale, fit.sh2[p], 1e-3);
      }
      const Floats normal = {0.6f, 0.0f, 0.8f};
      EXPECT_NEAR(Irradiance(mode, Order2(scaled), scaled_k2, normal)[1] / scale,
                  Irradiance(mode, Order2(sh3), k2, normal)[1], 1e-6);
      EXPECT_NEAR(Geomerics(Order2(scaled), normal)[1] / scale, Geomerics(Order2(sh3), normal)[1],
                  1e-6);
    }
  }
}

TEST_P(Zh3, NotANumberHasNoAxis) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  Random random(7);
  for (const float bad : {nan, inf, -inf}) {
    for (size_t p = 1; p < 4; ++p) {
      Floats sh3(27);
      MakeProbe(random, 3, sh3.data());
      const Floats k2 = Solved(GAUNT_ZH3_AXIS_CHANNEL, sh3);
      sh3[9 + p] = bad;
      for (const float value : Axis(GAUNT_ZH3_AXIS_LUMINANCE, sh3)) EXPECT_EQ(value, 0.0f);
      EXPECT_EQ(Solved(GAUNT_ZH3_AXIS_LUMINANCE, sh3), Floats(3, 0.0f));
      const Floats spoilt = Solved(GAUNT_ZH3_AXIS_CHANNEL, sh3);
      EXPECT_EQ(spoilt[0], k2[0]);  // another channel
      EXPECT_EQ(spoilt[1], 0.0f);
      for (const uint32_t model : kModels) {
        EXPECT_EQ(Hallucinated(model, GAUNT_ZH3_AXIS_LUMINANCE, Order2(sh3)), Floats(3, 0.0f));
        EXPECT_EQ(Hallucinated(model, GAUNT_ZH3_AXIS_CHANNEL, Order2(sh3))[1], 0.0f);
      }
      EXPECT_NEAR(Geomerics(Order2(sh3), {0, 0, 1})[1], sh3[9] * 0.28209479, 1e-6);
    }
    // The refit looks at band 2 too.
    for (size_t p = 1; p < 9; ++p) {
      Floats sh3(27);
      MakeProbe(random, 3, sh3.data());
      sh3[9 + p] = bad;
      for (const uint32_t mode : kModes) {
        const Fit fit = Refitted(mode, sh3);
        const Floats sh2 = Order2(sh3);
        EXPECT_EQ(std::memcmp(&fit.sh2[4], &sh2[4], 4 * sizeof(float)), 0);
        EXPECT_EQ(fit.k2[1], 0.0f);
        EXPECT_EQ(fit.k2[0] == 0.0f, Shared(mode));
      }
    }
  }
  // The mean.
  for (const uint32_t model : kModels) {
    EXPECT_EQ(Hallucinated(model, GAUNT_ZH3_AXIS_CHANNEL, Grey({nan, 0, 1, 0})), Floats(3, 0.0f));
  }
  EXPECT_EQ(Geomerics(Grey({nan, 0, 1, 0}), {0, 0, 1}), Floats(3, 0.0f));
}

TEST_P(Zh3, SolveWithoutAxis) {
  Random random(8);
  Floats sh3(27), k2(3), with(3), axis(9);
  MakeProbe(random, 3, sh3.data());
  Zh3Solve(GAUNT_ZH3_AXIS_CHANNEL, 1, Item(sh3), OutView(Item(with)), OutView(Item(axis)));
  EXPECT_EQ(Solved(GAUNT_ZH3_AXIS_CHANNEL, sh3), with);
  gaunt_view f = Item(sh3), out = Item(k2), overlapping = Item(k2);
  EXPECT_EQ(gaunt_zh3_solve(GAUNT_ZH3_AXIS_LUMINANCE, 1, &f, &out, &overlapping),
            GAUNT_ERROR_OVERLAP);
}

// ---- refit -------------------------------------------------------------------------------------

// Probes of every kind: random coefficients, with little of band 1, of few and of many lights in
// colours, without any of band 1, and with bands 1 that cancel in luminance.
Floats MakeKind(Random& random, int kind) {
  Floats sh3(27);
  if (kind >= 2 && kind <= 4) {
    const int lights = kind == 2 ? 2 : kind == 3 ? 4 : 12;
    for (int light = 0; light < lights; ++light) {
      float d[3];
      random.Direction(d);
      const Floats y = Delta(d);
      for (size_t p = 0; p < 27; p += 9) {
        const float strength = std::pow(random.Between(0.0, 1.0), 3.0f);
        for (size_t i = 0; i < 9; ++i) sh3[p + i] += strength * y[i];
      }
    }
    return sh3;
  }
  random.Fill(sh3.data(), 27, -1.0, 1.0);
  const float factor = kind == 1 ? 0.1f : kind == 5 ? 0.0f : 1.0f;
  for (size_t p = 0; p < 27; ++p) sh3[p] *= p % 9 >= 1 && p % 9 < 4 ? factor : 1.0f;
  if (kind == 6) {
    for (size_t i = 1; i < 4; ++i) sh3[i] = -sh3[9 + i] * (0.7152f / 0.2126f), sh3[18 + i] = 0.0f;
  }
  return sh3;
}
constexpr int kKinds = 7;

constexpr int kProbes = 40;  // of each kind
struct Refits {
  Floats sh3;
  double nothing;  // the error of no light but the mean
  double least;    // relative to that, as the rest
};

// Found once for all targets.
const std::vector<Refits>& ProbesOf(uint32_t mode) {
  static std::vector<Refits> found[2];
  std::vector<Refits>& probes = found[Shared(mode)];
  if (!probes.empty()) return probes;
  for (int i = 0; i < kKinds * kProbes; ++i) {
    Random random(static_cast<uint64_t>(100 + i));
    Refits probe;
    probe.sh3 = MakeKind(random, i % kKinds);
    std::vector<double> sh2(12), k2(3);
    for (size_t c = 0; c < 3; ++c) sh2[4 * c] = static_cast<double>(probe.sh3[9 * c]);
    const std::vector<double> exact = Exact(probe.sh3);
    probe.nothing = zh3::ErrorReference(Shared(mode), exact.data(), sh2.data(), k2.data());
    probe.least =
        zh3::RefitReference(Shared(mode), exact.data(), sh2.data(), k2.data()) / probe.nothing;
    probes.push_back(probe);
  }
  return probes;
}

double ErrorOf(uint32_t mode, const Refits& probe, const Floats& sh2, const Floats& k2) {
  return zh3::ErrorReference(Shared(mode), Exact(probe.sh3).data(), Exact(sh2).data(),
                             Exact(k2).data()) /
         probe.nothing;
}

TEST_P(Zh3, RefitFindsTheLeastError) {
  double gained = 0.0;
  for (const uint32_t mode : kModes) {
    for (const Refits& probe : ProbesOf(mode)) {
      const Fit fit = Refitted(mode, probe.sh3);
      const double error = ErrorOf(mode, probe, fit.sh2, fit.k2);
      const double solved = ErrorOf(mode, probe, Order2(probe.sh3), Solved(mode, probe.sh3));
      EXPECT_LE(error, probe.least + 1e-5);
      EXPECT_LE(error, solved + 1e-6);
      for (size_t c = 0; c < 3; ++c) EXPECT_EQ(fit.sh2[4 * c], probe.sh3[9 * c]);
      gained += solved - error;
    }
  }
  EXPECT_GT(gained, 0.05 * 2 * kKinds * kProbes);
}

// The reduction to a search over axes leaves nothing out: no change of the nine coefficients of
// bands 1, in double precision, has less error.
TEST_P(Zh3, RefitIsTheLeastOfNineUnknowns) {
  Random random(9);
  for (const uint32_t mode : kModes) {
    for (size_t i = 0; i < 2 * kKinds; ++i) {
      const Refits& probe = ProbesOf(mode)[i];
      const std::vector<double> wanted = Exact(probe.sh3);
      const auto error = [&](const std::vector<double>& sh3) {  // band 1 of it, the best k2
        std::vector<double> sh2(12), k2(3), axis(9), other = wanted;
        for (size_t c = 0; c < 3; ++c) {
          std::copy_n(&sh3[9 * c], 4, &sh2[4 * c]);
          std::copy_n(&sh3[9 * c], 4, &other[9 * c]);
        }
        zh3::SolveReference(Shared(mode), other.data(), k2.data(), axis.data());
        return zh3::ErrorReference(Shared(mode), wanted.data(), sh2.data(), k2.data()) /
               probe.nothing;
      };
      const Fit fit = Refitted(mode, probe.sh3);
      const double found = ErrorOf(mode, probe, fit.sh2, fit.k2);
      for (int start = 0; start < 4; ++start) {
        std::vector<double> here = wanted;
        for (size_t c = 0; c < 3; ++c) {
          for (size_t k = 1; k < 4; ++k) {
            if (start == 1) here[9 * c + k] = static_cast<double>(fit.sh2[4 * c + k]);
            if (start > 1) here[9 * c + k] = static_cast<double>(random.Between(-1.0, 1.0));
          }
        }
        double least = error(here);
        for (double step = 0.5; step > 1e-6; step *= 0.9) {
          for (int turn = 0; turn < 12; ++turn) {
            std::vector<double> next = here;
            for (size_t c = 0; c < 3; ++c) {
              for (size_t k = 1; k < 4; ++k) {
                next[9 * c + k] += step * static_cast<double>(random.Between(-1.0, 1.0));
              }
            }
            const double e = error(next);
            if (e < least) here = next, least = e;
          }
        }
        EXPECT_LE(found, least + 1e-5) << i << " from " << start;
      }
    }
  }
}

TEST_P(Zh3, RefitKeepsWhatIsZh3) {
  for (const uint32_t mode : kModes) {
    for (const Refits& probe : ProbesOf(mode)) {
      const Fit fit = Refitted(mode, probe.sh3);
      const Floats whole = Expanded(mode, fit.sh2, fit.k2);
      const Fit again = Refitted(mode, whole);
      const double size = Norm(Exact(probe.sh3).data(), 27);
      const std::vector<double> exact = Exact(whole);
      EXPECT_LE(zh3::ErrorReference(Shared(mode), exact.data(), Exact(again.sh2).data(),
                                    Exact(again.k2).data()),
                1e-6 * size * size);
    }
  }
}

// ---- the curve of one's own --------------------------------------------------------------------

struct Curves {
  float linear = 9.0f;
  float quadratic = 9.0f;
};

gaunt_status FitCurve(uint32_t mode, const Floats& sh3, Curves* curve) {
  gaunt_view view;
  gaunt_view_interleaved(const_cast<float*>(sh3.data()), 27, &view);
  return gaunt_zh3_fit_curve(mode, sh3.size() / 27, &view, &curve->linear, &curve->quadratic);
}

TEST(Zh3FitCurve, FindsTheCurveOfHallucinatedProbes) {
  Random random(10);
  for (const uint32_t mode : kModes) {
    Floats probes;
    for (int i = 0; i < 100; ++i) {
      Floats sh2(12), k2(3);
      MakeProbe(random, 2, sh2.data());
      Zh3HallucinateCurve({0.371f, 0.524f}, nullptr, mode, 1, Item(sh2), OutView(Item(k2)));
      const Floats sh3 = Expanded(mode, sh2, k2);
      probes.insert(probes.end(), sh3.begin(), sh3.end());
    }
    Curves curve;
    ASSERT_EQ(FitCurve(mode, probes, &curve), GAUNT_OK);
    EXPECT_NEAR(curve.linear, 0.371, 1e-6);
    EXPECT_NEAR(curve.quadratic, 0.524, 1e-6);
  }
}

TEST(Zh3FitCurve, MatchesTheDefinitionInEveryLayout) {
  Random random(11);
  constexpr size_t kCount = 67;
  for (const uint32_t mode : kModes) {
    Floats probes(27 * kCount), planar(27 * kCount), tiled(27 * 80);
    for (size_t i = 0; i < kCount; ++i) MakeProbe(random, 3, &probes[27 * i]);
    for (size_t i = 0; i < kCount; ++i) {
      for (size_t p = 0; p < 27; ++p) {
        planar[p * kCount + i] = probes[27 * i + p];
        tiled[i / 16 * 27 * 16 + p * 16 + i % 16] = probes[27 * i + p];
      }
    }
    double linear, quadratic;
    zh3::FitCurveReference(Shared(mode), kCount, Exact(probes).data(), &linear, &quadratic);
    Curves first;
    ASSERT_EQ(FitCurve(mode, probes, &first), GAUNT_OK);
    EXPECT_NEAR(first.linear, linear, 1e-6);
    EXPECT_NEAR(first.quadratic, quadratic, 1e-6);
    gaunt_view views[2];
    gaunt_view_planar(planar.data(), 4 * kCount, &views[0]);
    gaunt_view_tiled(tiled.data(), 27, &views[1]);
    for (const gaunt_view& view : views) {
      const Zh3Curve other = Zh3FitCurve(mode, kCount, view);
      EXPECT_EQ(other.linear, first.linear);
      EXPECT_EQ(other.quadratic, first.quadratic);
    }
    // What cannot be used is left out.
    Floats more = probes;
    for (const float bad : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity()}) {
      const Floats black(27, bad);
      more.insert(more.end(), black.begin(), black.end());
    }
    Curves same;
    ASSERT_EQ(FitCurve(mode, more, &same), GAUNT_OK);
    EXPECT_EQ(same.linear, first.linear);
    EXPECT_EQ(same.quadratic, first.quadratic);
  }
}

TEST(Zh3FitCurve, RejectsWrongArguments) {
  Random random(12);
  Floats sh3(27), uniform(54, 0.0f), alike;
  MakeProbe(random, 3, sh3.data());
  for (size_t p = 0; p < 54; p += 9) uniform[p] = 1.0f;
  for (int i = 0; i < 5; ++i) {  // one ratio
    const Floats probe = Grey({1, 0.5f, 0, 0, 0.1f, 0.2f, 0.3f, 0.4f, 0.5f});
    alike.insert(alike.end(), probe.begin(), probe.end());
  }
  Curves curve;
  for (const uint32_t mode : kModes) {
    for (const Floats& probes : {uniform, alike, Floats(27, 0.0f), Floats()}) {
      EXPECT_EQ(FitCurve(mode, probes, &curve), GAUNT_ERROR_RANGE);
    }
  }
  EXPECT_EQ(FitCurve(0, sh3, &curve), GAUNT_ERROR_RANGE);
  EXPECT_EQ(FitCurve(3, sh3, &curve), GAUNT_ERROR_RANGE);
  gaunt_view view = Item(sh3);
  EXPECT_EQ(gaunt_zh3_fit_curve(1, 1, nullptr, &curve.linear, &curve.quadratic), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_zh3_fit_curve(1, 1, &view, nullptr, &curve.quadratic), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_zh3_fit_curve(1, 1, &view, &curve.linear, nullptr), GAUNT_ERROR_NULL);
  view.plane_stride = 6;
  EXPECT_EQ(gaunt_zh3_fit_curve(1, 1, &view, &curve.linear, &curve.quadratic), GAUNT_ERROR_LAYOUT);
  EXPECT_EQ(curve.linear, 9.0f);
  EXPECT_EQ(curve.quadratic, 9.0f);
}

GAUNT_INSTANTIATE_TARGETS(Zh3);

}  // namespace
}  // namespace gaunt::test
