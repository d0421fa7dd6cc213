// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "basis/basis_reference.h"
#include "convert/convert_reference.h"
#include "evaluate/evaluate_reference.h"
#include "gaunt/gaunt.h"
#include "gaunt/gaunt.hpp"
#include "tests/support/golden.h"
#include "tests/support/operation.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

constexpr uint32_t kEngines = GAUNT_ENGINE_FUMA + 1;
const char* const kNames[kEngines] = {"gaunt",   "d3dx",     "unreal",          "unity", "godot",
                                      "threejs", "filament", "gaussian_splats", "ambix", "fuma"};
// What gaunt.h states: an ulp of the result, or this share of the largest term.
constexpr double kUlps = 1.0;
constexpr double kCancellation = 1e-12;
// Where the definition says 0, the quadrature of the reference leaves this much.
constexpr double kReferenceNoise = 1e-14;

gaunt_convention Preset(uint32_t engine) {
  gaunt_convention convention = {};
  convention.struct_size = sizeof(convention);
  EXPECT_EQ(gaunt_convention_preset(engine, &convention), GAUNT_OK);
  return convention;
}

// For the reference.
convert::Convention Internal(const gaunt_convention& c) {
  convert::Convention convention = {};
  convention.sign = static_cast<convert::Sign>(c.sign);
  convention.coefficients = static_cast<convert::Coefficients>(c.coefficients);
  convention.scale = static_cast<convert::Scale>(c.scale);
  convention.quantity = static_cast<convert::Quantity>(c.quantity);
  for (int k = 0; k < 3; ++k) convention.axes[k] = static_cast<convert::Axis>(c.axes[k]);
  convention.offset = c.offset;
  return convention;
}

std::vector<float> ConvertOne(uint32_t n, const gaunt_convention& from, const gaunt_convention& to,
                              std::vector<float> in) {
  std::vector<float> out(in.size());
  const gaunt::OutView view = gaunt::Interleaved(out.data(), out.size());
  gaunt::Convert(n, 1, 1, from, to, gaunt::Interleaved(in.data(), in.size()), view);
  return out;
}

std::vector<double> Doubles(const std::vector<float>& values) {
  return std::vector<double>(values.begin(), values.end());
}

std::vector<float> RandomCoefficients(Random& random, uint32_t n) {
  std::vector<float> values(n * n);
  random.Fill(values.data(), values.size(), -1.0, 1.0);
  return values;
}

// Every way to lay three axes: 48.
std::vector<std::vector<uint32_t>> AllAxes() {
  std::vector<std::vector<uint32_t>> all;
  for (uint32_t x = 0; x < 6; ++x) {
    for (uint32_t y = 0; y < 6; ++y) {
      for (uint32_t z = 0; z < 6; ++z) {
        if (x / 2 != y / 2 && y / 2 != z / 2 && z / 2 != x / 2) all.push_back({x, y, z});
      }
    }
  }
  return all;
}

gaunt_convention WithAxes(gaunt_convention convention, const std::vector<uint32_t>& axes) {
  std::copy(axes.begin(), axes.end(), convention.axes);
  return convention;
}

bool IsIrradiance(const gaunt_convention& c) {
  return c.quantity == GAUNT_QUANTITY_IRRADIANCE || c.quantity == GAUNT_QUANTITY_IRRADIANCE_OVER_PI;
}

uint32_t MaxOrder(const gaunt_convention& from, const gaunt_convention& to) {
  uint32_t order = from.axes[2] / 2 == to.axes[2] / 2 ? 64 : 16;
  for (const gaunt_convention& c : {from, to}) {
    if (c.scale == GAUNT_SCALE_FUMA || c.coefficients == GAUNT_COEFFICIENTS_FUMA) {
      order = std::min(order, 4u);
    }
    if (c.scale == GAUNT_SCALE_POLYNOMIAL) order = std::min(order, 3u);
  }
  return IsIrradiance(from) && !IsIrradiance(to) ? std::min(order, 3u) : order;
}

double Ulp(double value) {
  const float magnitude = std::max(FLT_MIN, static_cast<float>(std::abs(value)));
  return static_cast<double>(std::nextafter(magnitude, INFINITY)) - static_cast<double>(magnitude);
}

// Each result is within the stated error of the definition.
void ExpectStatedAccuracy(const convert::ConversionReference& reference,
                          const std::vector<float>& in, const std::vector<float>& out) {
  for (size_t row = 0; row < reference.planes; ++row) {
    double wanted = reference.constants[row], largest = std::abs(wanted);
    for (size_t i = 0; i < reference.planes; ++i) {
      const double term = reference.Entry(row, i) * static_cast<double>(in[i]);
      wanted += term;
      largest = std::max(largest, std::abs(term));
    }
    ASSERT_LE(std::abs(static_cast<double>(out[row]) - wanted),
              std::max({kUlps * Ulp(wanted), kCancellation * largest, kReferenceNoise}))
        << "coefficient " << row << ": " << out[row] << ", not " << wanted;
  }
}

Operation ConvertOperation(const std::string& name, uint32_t n, uint32_t channels,
                           const gaunt_convention& from, const gaunt_convention& to) {
  const size_t planes = n * n;
  const auto reference = std::make_shared<convert::ConversionReference>(
      Internal(from), Internal(to), static_cast<int>(n));
  Operation operation;
  operation.name =
      "convert/" + name + "/n" + std::to_string(n) + "/channels" + std::to_string(channels);
  operation.inputs = {channels * planes};
  operation.outputs = {channels * planes};
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_convert(n, channels, count, &from, &to, in[0], out[0]);
  };
  operation.make = [=](Random& random, size_t, float* out) {
    random.Fill(out, channels * planes, -1.0, 1.0);
  };
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    for (size_t c = 0; c < channels; ++c) {
      reference->Apply(in[0].data() + c * planes, out[0].data() + c * planes);
    }
  };
  operation.tolerance = [](const Operation::Item&, const Operation::Item& wanted, size_t, size_t) {
    double largest = 0.0;
    for (const double value : wanted[0]) largest = std::max(largest, std::abs(value));
    return kUlps * Ulp(largest);
  };
  operation.in_place = {0};
  return operation;
}

// Pairs that go through every path: moves, factors, turns; small chunks, several, large bands.
std::vector<Operation> Operations() {
  const gaunt_convention gaunt = Preset(GAUNT_ENGINE_GAUNT);
  gaunt_convention sid = Preset(GAUNT_ENGINE_UNREAL);
  sid.coefficients = GAUNT_COEFFICIENTS_SID;
  sid.sign = GAUNT_SIGN_POSITIVE;
  gaunt_convention sn3d = sid;
  sn3d.scale = GAUNT_SCALE_SN3D;
  sn3d.offset = 0.25f;
  const gaunt_convention unity = Preset(GAUNT_ENGINE_UNITY);
  const gaunt_convention splats = Preset(GAUNT_ENGINE_GAUSSIAN_SPLATS);
  return {ConvertOperation("copy", 2, 3, gaunt, gaunt),
          ConvertOperation("order", 3, 3, gaunt, sid),
          ConvertOperation("order", 8, 1, sid, gaunt),
          ConvertOperation("order", 20, 1, gaunt, sid),
          ConvertOperation("scale", 1, 4, gaunt, sn3d),
          ConvertOperation("scale", 5, 2, sn3d, gaunt),
          ConvertOperation("scale", 19, 1, gaunt, sn3d),
          ConvertOperation("to_unity", 3, 3, gaunt, unity),
          ConvertOperation("from_unity", 3, 3, unity, gaunt),
          ConvertOperation("splats", 4, 3, splats, sn3d),
          ConvertOperation("splats", 7, 2, splats, gaunt),
          ConvertOperation("splats", 16, 1, gaunt, splats)};
}

class Convert : public TargetTest {};

TEST_P(Convert, MatchesTheDefinitionInEveryLayout) {
  for (const Operation& operation : Operations()) TestBatches(operation);
}

TEST_P(Convert, EveryPairOfEnginesIsWithinTheStatedAccuracy) {
  Random random(7);
  for (uint32_t a = 0; a < kEngines; ++a) {
    for (uint32_t b = 0; b < kEngines; ++b) {
      const gaunt_convention from = Preset(a), to = Preset(b);
      for (uint32_t n = 1; n <= std::min(MaxOrder(from, to), 6u); ++n) {
        SCOPED_TRACE(std::string(kNames[a]) + " to " + kNames[b] + ", order " + std::to_string(n));
        const convert::ConversionReference reference(Internal(from), Internal(to),
                                                     static_cast<int>(n));
        for (int trial = 0; trial < 20; ++trial) {
          const std::vector<float> in = RandomCoefficients(random, n);
          ExpectStatedAccuracy(reference, in, ConvertOne(n, from, to, in));
        }
      }
    }
  }
}

TEST_P(Convert, EveryScaleQuantityAndOrderOfCoefficientsIsWithinTheStatedAccuracy) {
  Random random(8);
  const gaunt_convention gaunt = Preset(GAUNT_ENGINE_GAUNT);
  for (uint32_t scale = 0; scale <= GAUNT_SCALE_POLYNOMIAL; ++scale) {
    for (uint32_t quantity = 0; quantity <= GAUNT_QUANTITY_IRRADIANCE_OVER_PI; ++quantity) {
      for (uint32_t order = 0; order <= GAUNT_COEFFICIENTS_FUMA; ++order) {
        gaunt_convention a = Preset(GAUNT_ENGINE_THREEJS), b = gaunt;
        a.scale = scale;
        a.quantity = b.quantity = quantity;
        b.coefficients = order;
        if (scale != GAUNT_SCALE_POLYNOMIAL) a.quantity = GAUNT_QUANTITY_RADIANCE;
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
          const uint32_t n = std::min(MaxOrder(from, to), 9u);
          SCOPED_TRACE("scale " + std::to_string(scale) + ", quantity " + std::to_string(quantity) +
                       ", coefficients " + std::to_string(order));
          const std::vector<float> in = RandomCoefficients(random, n);
          ExpectStatedAccuracy({Internal(from), Internal(to), static_cast<int>(n)}, in,
                               ConvertOne(n, from, to, in));
        }
      }
    }
  }
}

TEST_P(Convert, EveryChangeOfAxesIsWithinTheStatedAccuracy) {
  Random random(9);
  const gaunt_convention gaunt = Preset(GAUNT_ENGINE_GAUNT);
  const std::vector<std::vector<uint32_t>> all = AllAxes();
  ASSERT_EQ(all.size(), 48u);
  for (const auto& axes : all) {
    // The order in which all that can go wrong with signs has, and once the highest.
    for (const uint32_t n : axes == std::vector<uint32_t>{1, 3, 4} ? std::vector<uint32_t>{6, 16}
                                                                   : std::vector<uint32_t>{6}) {
      SCOPED_TRACE("axes " + std::to_string(axes[0]) + std::to_string(axes[1]) +
                   std::to_string(axes[2]) + ", order " + std::to_string(n));
      const gaunt_convention to = WithAxes(gaunt, axes);
      const std::vector<float> in = RandomCoefficients(random, n);
      ExpectStatedAccuracy({Internal(gaunt), Internal(to), static_cast<int>(n)}, in,
                           ConvertOne(n, gaunt, to, in));
      ExpectStatedAccuracy({Internal(to), Internal(gaunt), static_cast<int>(n)}, in,
                           ConvertOne(n, to, gaunt, in));
    }
  }
}

// At every order, by the values of the two functions.
TEST_P(Convert, FunctionsStayWhatTheyAreAtHighOrders) {
  Random random(10);
  const gaunt_convention gaunt = Preset(GAUNT_ENGINE_GAUNT);
  for (const auto& axes : AllAxes()) {
    gaunt_convention to = WithAxes(gaunt, axes);
    to.sign = GAUNT_SIGN_POSITIVE;
    to.coefficients = GAUNT_COEFFICIENTS_SID;
    to.scale = axes[0] % 2 == 0 ? GAUNT_SCALE_SN3D : GAUNT_SCALE_ORTHONORMAL;
    const uint32_t n = MaxOrder(gaunt, to);
    const std::vector<float> in = RandomCoefficients(random, n);
    const std::vector<float> out = ConvertOne(n, gaunt, to, in);
    for (int trial = 0; trial < 5; ++trial) {
      float d[3];
      random.Direction(d);
      const double direction[3] = {d[0], d[1], d[2]};
      const int order = static_cast<int>(n);
      const auto value = [&](const gaunt_convention& c, const std::vector<float>& f) {
        return convert::ValueReference(Internal(c), convert::Quantity::kRadiance, order,
                                       Doubles(f).data(), direction);
      };
      // Rounded coefficients, times functions whose squares add up to n^2 / (4 pi).
      EXPECT_NEAR(value(gaunt, in), value(to, out), 1e-7 * n);
    }
  }
}

// Bits of results are those of inputs, and the inverse gives the input back.
TEST_P(Convert, MovesAndSignsAreExact) {
  Random random(11);
  const gaunt_convention gaunt = Preset(GAUNT_ENGINE_GAUNT);
  int tested = 0;
  for (const auto& axes : AllAxes()) {
    if (axes[2] / 2 != gaunt.axes[2] / 2) continue;
    for (uint32_t sign = 0; sign <= GAUNT_SIGN_POSITIVE; ++sign) {
      for (uint32_t order = 0; order <= GAUNT_COEFFICIENTS_SID; ++order) {
        gaunt_convention to = WithAxes(gaunt, axes);
        to.sign = sign;
        to.coefficients = order;
        for (const uint32_t n : {4u, 7u, 64u}) {
          std::vector<float> in = RandomCoefficients(random, n);
          in[1] = std::numeric_limits<float>::denorm_min();
          in[3] = FLT_MAX;
          const std::vector<float> out = ConvertOne(n, gaunt, to, in);
          for (uint32_t l = 0; l < n; ++l) {
            std::multiset<float> a, b;
            for (uint32_t i = l * l; i < (l + 1) * (l + 1); ++i) {
              a.insert(std::abs(in[i]));
              b.insert(std::abs(out[i]));
            }
            ASSERT_EQ(a, b) << "band " << l;
          }
          ASSERT_EQ(ConvertOne(n, to, gaunt, out), in);
          ASSERT_EQ(ConvertOne(n, to, to, in), in);
          ++tested;
        }
      }
    }
  }
  EXPECT_EQ(tested, 16 * 4 * 3);
}

// A batch goes from each engine to each other one and back.
TEST_P(Convert, RoundTripsBetweenAllEngines) {
  Random random(12);
  constexpr uint32_t kOrder = 3, kItems = 37, kPlanes = 27;
  std::vector<float> in(kItems * kPlanes), there(in.size()), back(in.size());
  random.Fill(in.data(), in.size(), -1.0, 1.0);
  for (uint32_t a = 0; a < kEngines; ++a) {
    for (uint32_t b = 0; b < kEngines; ++b) {
      SCOPED_TRACE(std::string(kNames[a]) + " to " + kNames[b]);
      const gaunt_convention from = Preset(a), to = Preset(b);
      gaunt::Convert(kOrder, 3, kItems, from, to,
                     gaunt::Interleaved(std::as_const(in).data(), kPlanes),
                     gaunt::Interleaved(there.data(), kPlanes));
      gaunt::Convert(kOrder, 3, kItems, to, from,
                     gaunt::Interleaved(std::as_const(there).data(), kPlanes),
                     gaunt::Interleaved(back.data(), kPlanes));
      // Rounded once on the way, and mixed again with the rest of the band and the offset.
      for (size_t i = 0; i < in.size(); ++i) ASSERT_NEAR(in[i], back[i], 5e-7);
    }
  }
}

// ---- engines, by their own formulas -------------------------------------------------------------

// A direction along forward, left and up, in the axes that an engine documents.
void ToEngine(uint32_t engine, const double d[3], double own[3]) {
  const double forward = d[0], left = d[1], up = d[2];
  const auto set = [&](double x, double y, double z) { own[0] = x, own[1] = y, own[2] = z; };
  switch (engine) {
    case GAUNT_ENGINE_UNREAL: return set(forward, -left, up);
    case GAUNT_ENGINE_UNITY: return set(-left, up, forward);
    case GAUNT_ENGINE_GODOT:
    case GAUNT_ENGINE_THREEJS:
    case GAUNT_ENGINE_FILAMENT: return set(-left, up, -forward);
    case GAUNT_ENGINE_GAUSSIAN_SPLATS: return set(-left, -up, forward);
    default: return set(forward, left, up);
  }
}

// What an engine's code makes of its coefficients of order 3 in a direction of its own.
double EngineValue(uint32_t engine, const double* c, const double d[3]) {
  const double x = d[0], y = d[1], z = d[2], pi = std::acos(-1.0);
  const double k0 = 0.5 * std::sqrt(1.0 / pi), k1 = 0.5 * std::sqrt(3.0 / pi);
  const double k2 = 0.5 * std::sqrt(15.0 / pi), k3 = 0.25 * std::sqrt(5.0 / pi), k4 = 0.5 * k2;
  const double with_phase = k0 * c[0] - k1 * y * c[1] + k1 * z * c[2] - k1 * x * c[3] +
                            k2 * x * y * c[4] - k2 * y * z * c[5] +
                            k3 * (3.0 * z * z - 1.0) * c[6] - k2 * x * z * c[7] +
                            k4 * (x * x - y * y) * c[8];
  switch (engine) {
    case GAUNT_ENGINE_UNITY: {
      // unity_SHA, unity_SHB and unity_SHC of SphericalHarmonicsL2, and the shader.
      const double a[4] = {c[3], c[1], c[2], c[0] - c[6]};
      const double b[4] = {c[4], c[5], 3.0 * c[6], c[7]};
      return a[0] * x + a[1] * y + a[2] * z + a[3] + b[0] * x * y + b[1] * y * z + b[2] * z * z +
             b[3] * z * x + c[8] * (x * x - y * y);
    }
    case GAUNT_ENGINE_GODOT: {
      const double g[5] = {k0 * pi, k1 * pi * 2.0 / 3.0, k2 * pi / 4.0, k3 * pi / 4.0,
                           k4 * pi / 4.0};
      return g[0] * c[0] + g[1] * (c[1] * y + c[2] * z + c[3] * x) +
             g[2] * (c[4] * x * y + c[5] * y * z + c[7] * x * z) +
             g[3] * c[6] * (3.0 * z * z - 1.0) + g[4] * c[8] * (x * x - y * y);
    }
    case GAUNT_ENGINE_THREEJS:
      return k0 * c[0] + k1 * (y * c[1] + z * c[2] + x * c[3]) +
             k2 * (x * y * c[4] + y * z * c[5] + x * z * c[7]) + k3 * (3.0 * z * z - 1.0) * c[6] +
             k4 * (x * x - y * y) * c[8];
    case GAUNT_ENGINE_FILAMENT:
      return c[0] + c[1] * y + c[2] * z + c[3] * x + c[4] * y * x + c[5] * y * z +
             c[6] * (3.0 * z * z - 1.0) + c[7] * z * x + c[8] * (x * x - y * y);
    case GAUNT_ENGINE_GAUSSIAN_SPLATS: return 0.5 + with_phase;
    default: return with_phase;
  }
}

bool ShowsIrradiance(uint32_t engine) {
  return engine == GAUNT_ENGINE_UNITY || engine == GAUNT_ENGINE_GODOT ||
         engine == GAUNT_ENGINE_FILAMENT;
}

// The engine shows what gaunt's coefficients say, in the same physical direction.
TEST_P(Convert, EnginesShowTheSameFunction) {
  Random random(13);
  for (uint32_t engine = 0; engine <= GAUNT_ENGINE_GAUSSIAN_SPLATS; ++engine) {
    SCOPED_TRACE(kNames[engine]);
    for (int trial = 0; trial < 50; ++trial) {
      const std::vector<float> radiance = RandomCoefficients(random, 3);
      const std::vector<float> coefficients =
          ConvertOne(3, Preset(GAUNT_ENGINE_GAUNT), Preset(engine), radiance);
      float d[3];
      random.Direction(d);
      const double direction[3] = {d[0], d[1], d[2]};
      double own[3];
      ToEngine(engine, direction, own);
      const double wanted =
          ShowsIrradiance(engine)
              ? evaluate::IrradianceReference(3, Doubles(radiance).data(), direction)
              : evaluate::ShReference(3, Doubles(radiance).data(), direction);
      ASSERT_NEAR(EngineValue(engine, Doubles(coefficients).data(), own), wanted, 1e-6);
    }
  }
}

// A source in one direction gets the gains that encoders of ambisonics give it.
TEST_P(Convert, AmbisonicsHaveTheGainsOfTheirEncoders) {
  Random random(14);
  const double r3 = std::sqrt(3.0), r5 = std::sqrt(5.0), r15 = std::sqrt(15.0);
  for (int trial = 0; trial < 50; ++trial) {
    float d[3];
    random.Direction(d);
    const double direction[3] = {d[0], d[1], d[2]};
    const double azimuth = std::atan2(direction[1], direction[0]);
    const double elevation = std::atan2(direction[2], std::hypot(direction[0], direction[1]));
    std::vector<double> y(16);
    basis::EvalReference(4, direction, y.data());
    const std::vector<float> light(y.begin(), y.end());
    const double ca = std::cos(azimuth), sa = std::sin(azimuth), c2a = std::cos(2.0 * azimuth);
    const double s2a = std::sin(2.0 * azimuth), c3a = std::cos(3.0 * azimuth);
    const double s3a = std::sin(3.0 * azimuth);
    const double ce = std::cos(elevation), se = std::sin(elevation),
                 s2e = std::sin(2.0 * elevation);
    const double l = std::sqrt(135.0 / 256.0) * ce * (5.0 * se * se - 1.0);
    const double n = std::sqrt(27.0 / 4.0) * se * ce * ce, p = ce * ce * ce;
    // W X Y Z R S T U V K L M N O P Q
    const double fuma[16] = {std::sqrt(0.5),
                             ca * ce,
                             sa * ce,
                             se,
                             0.5 * (3.0 * se * se - 1.0),
                             ca * s2e,
                             sa * s2e,
                             c2a * ce * ce,
                             s2a * ce * ce,
                             0.5 * se * (5.0 * se * se - 3.0),
                             ca * l,
                             sa * l,
                             c2a * n,
                             s2a * n,
                             c3a * p,
                             s3a * p};
    // ACN, SN3D
    const double ambix[16] = {1.0,
                              sa * ce,
                              se,
                              ca * ce,
                              0.5 * r3 * s2a * ce * ce,
                              0.5 * r3 * sa * s2e,
                              0.5 * (3.0 * se * se - 1.0),
                              0.5 * r3 * ca * s2e,
                              0.5 * r3 * c2a * ce * ce,
                              std::sqrt(5.0 / 8.0) * s3a * p,
                              0.5 * r15 * s2a * se * ce * ce,
                              std::sqrt(3.0 / 8.0) * sa * ce * (5.0 * se * se - 1.0),
                              0.5 * se * (5.0 * se * se - 3.0),
                              std::sqrt(3.0 / 8.0) * ca * ce * (5.0 * se * se - 1.0),
                              0.5 * r15 * c2a * se * ce * ce,
                              r5 / std::sqrt(8.0) * c3a * p};
    const gaunt_convention gaunt = Preset(GAUNT_ENGINE_GAUNT);
    const std::vector<float> a = ConvertOne(4, gaunt, Preset(GAUNT_ENGINE_AMBIX), light);
    const std::vector<float> f = ConvertOne(4, gaunt, Preset(GAUNT_ENGINE_FUMA), light);
    for (size_t i = 0; i < 16; ++i) {
      ASSERT_NEAR(a[i], ambix[i], 3e-7) << i;
      ASSERT_NEAR(f[i], fuma[i], 3e-7) << i;
    }
  }
}

// engines.csv: the coefficients that each engine has for one radiance.
TEST_P(Convert, MatchesGoldenCoefficientsOfEngines) {
  std::map<std::string, std::map<int, double>> golden;
  for (const auto& row : ReadGolden("engines.csv")) {
    golden[row[0]][std::stoi(row[1])] = std::stod(row[2]);
  }
  ASSERT_EQ(golden.size(), size_t{kEngines});
  const auto values = [&golden](const std::string& name) {
    std::vector<float> coefficients;
    for (const auto& entry : golden[name]) coefficients.push_back(static_cast<float>(entry.second));
    return coefficients;
  };
  const gaunt_convention gaunt = Preset(GAUNT_ENGINE_GAUNT);
  for (uint32_t engine = 0; engine < kEngines; ++engine) {
    SCOPED_TRACE(kNames[engine]);
    ASSERT_EQ(golden[kNames[engine]].size(), 9u);
    const std::vector<float> there = ConvertOne(3, gaunt, Preset(engine), values("gaunt"));
    for (int i = 0; i < 9; ++i) {
      const double wanted = golden[kNames[engine]][i];
      ASSERT_NEAR(there[static_cast<size_t>(i)], wanted, kUlps * Ulp(wanted)) << i;
    }
    // The golden values are rounded to float before they come back.
    const std::vector<float> back = ConvertOne(3, Preset(engine), gaunt, values(kNames[engine]));
    for (int i = 0; i < 9; ++i) {
      ASSERT_NEAR(back[static_cast<size_t>(i)], golden["gaunt"][i], 5e-7) << i;
    }
  }
}

// ---- views and bits -----------------------------------------------------------------------------

TEST_P(Convert, RejectsWrongViews) {
  const gaunt_convention gaunt = Preset(GAUNT_ENGINE_GAUNT);
  TestErrors(ConvertOperation("to_unity", 3, 3, gaunt, Preset(GAUNT_ENGINE_UNITY)));
  TestErrors(ConvertOperation("copy", 1, 1, gaunt, gaunt));
}

TEST(ConvertBits, AreTheSameOnTargetsOfAClass) {
  for (const Operation& operation : Operations()) TestSameBits(operation);
}

GAUNT_INSTANTIATE_TARGETS(Convert);

}  // namespace
}  // namespace gaunt::test
