// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "ambient_cube/ambient_cube_reference.h"
#include "evaluate/evaluate_reference.h"
#include "gaunt/gaunt.h"
#include "gaunt/gaunt.hpp"
#include "tests/support/golden.h"
#include "tests/support/operation.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

const double kPi = std::acos(-1.0);
constexpr size_t kPlanes = GAUNT_AMBIENT_CUBE_PLANES;
constexpr uint32_t kOrders[] = {1, 2, 3, 4, 5, 6};
constexpr uint32_t kModes[] = {GAUNT_AMBIENT_CUBE_LEAST_SQUARES, GAUNT_AMBIENT_CUBE_SAMPLED};

double Norm(const double* f, size_t n) {
  double sum = 0.0;
  for (size_t i = 0; i < n; ++i) sum += f[i] * f[i];
  return std::sqrt(sum);
}

// Faces of a channel of a cube.
void ChannelOf(const std::vector<double>& cube, size_t c, double faces[6]) {
  for (size_t face = 0; face < 6; ++face) faces[face] = cube[3 * face + c];
}
double LargestFace(const std::vector<double>& cube, size_t c) {
  double largest = 0.0;
  for (size_t face = 0; face < 6; ++face) {
    largest = std::max(largest, std::abs(cube[3 * face + c]));
  }
  return largest;
}

void ProjectReference(uint32_t n, uint32_t mode, const double* radiance, double faces[6]) {
  const int order = static_cast<int>(n);
  mode == GAUNT_AMBIENT_CUBE_SAMPLED ? ambient_cube::SampledReference(order, radiance, faces)
                                     : ambient_cube::ClosestReference(order, radiance, faces);
}

Operation ProjectOperation(uint32_t n, uint32_t mode) {
  const size_t coefficients = n * n;
  Operation operation;
  operation.name = "ambient_cube_project/n" + std::to_string(n) +
                   (mode == GAUNT_AMBIENT_CUBE_SAMPLED ? "/sampled" : "/least_squares");
  operation.inputs = {3 * coefficients};
  operation.outputs = {kPlanes};
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_ambient_cube_project(n, mode, count, in[0], out[0]);
  };
  operation.make = [=](Random& random, size_t, float* out) {
    random.Fill(out, 3 * coefficients, -1.0, 1.0);
  };
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    for (size_t c = 0; c < 3; ++c) {
      double faces[6];
      ProjectReference(n, mode, &in[0][c * coefficients], faces);
      for (size_t face = 0; face < 6; ++face) out[0][3 * face + c] = faces[face];
    }
  };
  operation.tolerance = [=](const Operation::Item& in, const Operation::Item&, size_t,
                            size_t plane) {
    return 1.5e-7 * Norm(&in[0][plane % 3 * coefficients], coefficients);
  };
  return operation;
}

Operation ToShOperation(uint32_t n) {
  const size_t coefficients = n * n;
  Operation operation;
  operation.name = "ambient_cube_to_sh/n" + std::to_string(n);
  operation.inputs = {kPlanes};
  operation.outputs = {3 * coefficients};
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_ambient_cube_to_sh(n, count, in[0], out[0]);
  };
  operation.make = [](Random& random, size_t, float* out) { random.Fill(out, kPlanes, -1.0, 1.0); };
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    for (size_t c = 0; c < 3; ++c) {
      double faces[6];
      ChannelOf(in[0], c, faces);
      ambient_cube::ToShReference(static_cast<int>(n), faces, &out[0][c * coefficients]);
    }
  };
  operation.tolerance = [=](const Operation::Item& in, const Operation::Item&, size_t,
                            size_t plane) {
    return 1.2e-6 * LargestFace(in[0], plane / coefficients);
  };
  return operation;
}

Operation EvaluateOperation() {
  Operation operation;
  operation.name = "ambient_cube_evaluate";
  operation.inputs = {kPlanes, 3};
  operation.outputs = {3};
  operation.call = [](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_ambient_cube_evaluate(count, in[0], in[1], out[0]);
  };
  operation.make = [](Random& random, size_t side, float* out) {
    side == 0 ? random.Fill(out, kPlanes, -1.0, 1.0) : random.Direction(out);
  };
  operation.reference = [](const Operation::Item& in, Operation::Item& out) {
    for (size_t c = 0; c < 3; ++c) {
      double faces[6];
      ChannelOf(in[0], c, faces);
      out[0][c] = ambient_cube::EvaluateReference(faces, in[1].data());
    }
  };
  operation.tolerance = [](const Operation::Item& in, const Operation::Item&, size_t,
                           size_t plane) { return 2.5e-7 * LargestFace(in[0], plane); };
  return operation;
}

std::vector<Operation> Operations() {
  std::vector<Operation> operations = {EvaluateOperation()};
  for (const uint32_t n : kOrders) {
    for (const uint32_t mode : kModes) operations.push_back(ProjectOperation(n, mode));
    operations.push_back(ToShOperation(n));
  }
  return operations;
}

class AmbientCube : public TargetTest {};

TEST_P(AmbientCube, MatchesTheDefinitionInEveryLayout) {
  for (const Operation& operation : Operations()) TestBatches(operation);
}

TEST_P(AmbientCube, RejectsWrongArguments) {
  for (const Operation& operation : Operations()) TestErrors(operation);
  for (const uint32_t n : {0u, GAUNT_MAX_AMBIENT_CUBE_ORDER + 1u, UINT32_MAX}) {
    EXPECT_EQ(gaunt_ambient_cube_project(n, 1, 0, nullptr, nullptr), GAUNT_ERROR_ORDER);
    EXPECT_EQ(gaunt_ambient_cube_to_sh(n, 0, nullptr, nullptr), GAUNT_ERROR_ORDER);
  }
  for (const uint32_t mode : {0u, 3u, UINT32_MAX}) {
    EXPECT_EQ(gaunt_ambient_cube_project(3, mode, 0, nullptr, nullptr), GAUNT_ERROR_RANGE);
  }
}

TEST(AmbientCubeBits, AreTheSameOnTargetsOfAClass) {
  for (const Operation& operation : Operations()) TestSameBits(operation);
}

// ---- one probe at a time -----------------------------------------------------------------------

using Floats = std::vector<float>;

gaunt_view Item(const Floats& f) {
  gaunt_view view;
  gaunt_view_interleaved(const_cast<float*>(f.data()), f.size(), &view);
  return view;
}

Floats Projected(uint32_t n, uint32_t mode, const Floats& radiance) {
  Floats cube(kPlanes, 9.0f);
  AmbientCubeProject(n, mode, 1, Item(radiance), OutView(Item(cube)));
  return cube;
}
Floats ToSh(uint32_t n, const Floats& cube) {
  Floats radiance(3 * n * n, 9.0f);
  AmbientCubeToSh(n, 1, Item(cube), OutView(Item(radiance)));
  return radiance;
}
Floats Evaluated(const Floats& cube, const Floats& normal) {
  Floats out(3, 9.0f);
  AmbientCubeEvaluate(1, Item(cube), Item(normal), OutView(Item(out)));
  return out;
}

Floats Noise(uint64_t seed, size_t n) {
  Random random(seed);
  Floats f(n);
  random.Fill(f.data(), n, -1.0, 1.0);
  return f;
}

// Of the golden file: coefficient, face, the coefficient of the face's function, and the face of
// the closest cube of y_i.
struct Pair {
  double coefficient[6][36] = {};
  double face[6][36] = {};

  Pair() {
    for (const auto& row : ReadGolden("ambient_cube_order6.csv")) {
      const size_t i = std::stoul(row[0]), f = std::stoul(row[1]);
      coefficient[f][i] = std::stod(row[2]);
      face[f][i] = std::stod(row[3]);
    }
  }
};

TEST_P(AmbientCube, MatchesGoldenProjections) {
  const Pair golden;
  for (const uint32_t n : kOrders) {
    for (size_t i = 0; i < n * n; ++i) {
      for (size_t c = 0; c < 3; ++c) {
        Floats radiance(3 * n * n, 0.0f);
        radiance[c * n * n + i] = 1.0f;
        const Floats cube = Projected(n, GAUNT_AMBIENT_CUBE_LEAST_SQUARES, radiance);
        const int l = static_cast<int>(std::sqrt(static_cast<double>(i)));
        for (size_t p = 0; p < kPlanes; ++p) {
          const double wanted = evaluate::CosineFactor(l) * golden.face[p / 3][i];
          EXPECT_NEAR(cube[p], p % 3 == c ? wanted : 0.0, 6e-8) << i << " " << p;
        }
      }
    }
  }
}

TEST_P(AmbientCube, MatchesGoldenCoefficients) {
  const Pair golden;
  for (const uint32_t n : kOrders) {
    for (size_t p = 0; p < kPlanes; ++p) {
      Floats cube(kPlanes, 0.0f);
      cube[p] = 1.0f;
      const Floats radiance = ToSh(n, cube);
      for (size_t q = 0; q < radiance.size(); ++q) {
        const size_t i = q % (n * n);
        const double factor =
            evaluate::CosineFactor(static_cast<int>(std::sqrt(static_cast<double>(i))));
        const double wanted = factor == 0.0 ? 0.0 : golden.coefficient[p / 3][i] / factor;
        EXPECT_NEAR(radiance[q], q / (n * n) == p % 3 ? wanted : 0.0, 2e-7) << p << " " << q;
      }
    }
  }
}

// What the header states as lost and kept.
TEST_P(AmbientCube, CubesComeBackFromOrder3) {
  const Floats cube = Noise(1, kPlanes);
  const Floats radiance = ToSh(3, cube);
  for (const uint32_t mode : kModes) {
    const double kept = mode == GAUNT_AMBIENT_CUBE_SAMPLED ? 0.75 : 15.0 / 16.0;
    const Floats again = Projected(3, mode, radiance);
    for (size_t axis = 0; axis < 3; ++axis) {
      for (size_t c = 0; c < 3; ++c) {
        const size_t plus = 6 * axis + c, minus = plus + 3;
        EXPECT_NEAR(again[plus] + again[minus], cube[plus] + cube[minus], 1e-6);
        EXPECT_NEAR(again[plus] - again[minus], kept * (cube[plus] - cube[minus]), 1e-6);
      }
    }
  }
}

TEST_P(AmbientCube, RadianceComesBackFromTheClosestCube) {
  const Floats radiance = Noise(2, 27);
  const Floats again = ToSh(3, Projected(3, GAUNT_AMBIENT_CUBE_LEAST_SQUARES, radiance));
  const double kept[9] = {1, 15.0 / 16, 15.0 / 16, 15.0 / 16, 0, 0, 1, 0, 1};
  for (size_t i = 0; i < 27; ++i) EXPECT_NEAR(again[i], kept[i % 9] * radiance[i], 2e-6) << i;
}

TEST_P(AmbientCube, UniformRadianceIsItself) {
  for (const uint32_t n : kOrders) {
    Floats radiance(3 * n * n, 0.0f);
    const float root = static_cast<float>(std::sqrt(4.0 * kPi));
    for (size_t c = 0; c < 3; ++c) radiance[c * n * n] = root * static_cast<float>(c + 1);
    for (const uint32_t mode : kModes) {
      const Floats cube = Projected(n, mode, radiance);
      for (size_t p = 0; p < kPlanes; ++p) {
        EXPECT_NEAR(cube[p], static_cast<double>(p % 3 + 1), 1e-6);
      }
      const Floats out = Evaluated(cube, {0.6f, -0.48f, 0.64f});
      for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(out[c], static_cast<double>(c + 1), 2e-6);
    }
  }
}

TEST_P(AmbientCube, NormalsOnAxesSeeOneFace) {
  const Floats cube = Noise(3, kPlanes);
  for (size_t face = 0; face < 6; ++face) {
    for (const float zero : {0.0f, -0.0f}) {
      Floats normal(3, zero);
      normal[face / 2] = face % 2 == 0 ? 1.0f : -1.0f;
      const Floats out = Evaluated(cube, normal);
      for (size_t c = 0; c < 3; ++c) EXPECT_EQ(out[c], cube[3 * face + c]);
    }
  }
}

TEST_P(AmbientCube, FacesBehindTheNormalHaveNoPart) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    Floats normal(3), cube = Noise(5, kPlanes);
    random.Direction(normal.data());
    const Floats wanted = Evaluated(cube, normal);
    for (size_t face = 0; face < 6; ++face) {
      if ((normal[face / 2] < 0.0f) == (face % 2 == 1)) continue;
      for (size_t c = 0; c < 3; ++c) {
        cube[3 * face + c] = std::numeric_limits<float>::quiet_NaN();
      }
    }
    EXPECT_EQ(Evaluated(cube, normal), wanted);
  }
}

TEST_P(AmbientCube, NothingNegativeComesOfCubesThatAreNot) {
  Random random(6);
  for (int i = 0; i < 1000; ++i) {
    Floats normal(3), cube(kPlanes);
    random.Direction(normal.data());
    random.Fill(cube.data(), kPlanes, 0.0, 1.0);
    for (float& face : cube) face = face < 0.5f ? 0.0f : face;
    for (const float value : Evaluated(cube, normal)) EXPECT_GE(value, 0.0f);
  }
}

// ---- texels of engines -------------------------------------------------------------------------

TEST_P(AmbientCube, PackedTexelsAreTheFaces) {
  constexpr size_t kCount = 37;
  for (const uint32_t format : {GAUNT_FORMAT_RGB9E5, GAUNT_FORMAT_R11G11B10F}) {
    // Numbers that both formats have: of six bits.
    Random random(7);
    Floats cubes(kPlanes * kCount), decoded(cubes.size(), 9.0f);
    for (float& face : cubes) face = static_cast<float>(random.Bits() % 32 + 32) / 16.0f;
    std::vector<uint32_t> texels(6 * kCount);
    gaunt_view in, out;
    gaunt_view_interleaved(cubes.data(), 3, &in);
    gaunt_view_interleaved(decoded.data(), 3, &out);
    ASSERT_EQ(gaunt_probe_encode(format, 6 * kCount, &in, texels.data(), 4, nullptr), GAUNT_OK);
    ASSERT_EQ(gaunt_probe_decode(format, 6 * kCount, texels.data(), 4, &out), GAUNT_OK);
    EXPECT_EQ(decoded, cubes);

    // Of one cube: the value at an axis is the texel of the face.
    gaunt_view_interleaved(decoded.data(), kPlanes, &in);
    for (size_t face = 0; face < 6; ++face) {
      Floats normal(3, 0.0f), values(3 * kCount);
      normal[face / 2] = face % 2 == 0 ? 1.0f : -1.0f;
      gaunt_view normals;
      gaunt_view_broadcast(normal.data(), &normals);
      gaunt_view_interleaved(values.data(), 3, &out);
      ASSERT_EQ(gaunt_ambient_cube_evaluate(kCount, &in, &normals, &out), GAUNT_OK);
      for (size_t i = 0; i < kCount; ++i) {
        for (size_t c = 0; c < 3; ++c) {
          EXPECT_EQ(values[3 * i + c], cubes[kPlanes * i + 3 * face + c]);
        }
      }
    }
  }
}

TEST_P(AmbientCube, VolumesOfBevyAreDecodedFaceByFace) {
  constexpr size_t kX = 5, kY = 3, kZ = 2;
  const auto value = [](size_t x, size_t y, size_t z, size_t face, size_t c) {
    // Of nine bits, which RGB9E5 has.
    return static_cast<float>(1 + x + kX * (y + kY * (z + kZ * face)) + 165 * c);
  };
  // By its shader: the negative faces follow in t, the axes in p.
  Floats texture(3 * kX * 2 * kY * 3 * kZ);
  for (size_t face = 0; face < 6; ++face) {
    for (size_t z = 0; z < kZ; ++z) {
      for (size_t y = 0; y < kY; ++y) {
        for (size_t x = 0; x < kX; ++x) {
          const size_t t = y + face % 2 * kY, p = z + face / 2 * kZ;
          for (size_t c = 0; c < 3; ++c) {
            texture[3 * ((p * 2 * kY + t) * kX + x) + c] = value(x, y, z, face, c);
          }
        }
      }
    }
  }
  std::vector<uint32_t> texels(texture.size() / 3);
  const gaunt_view in = [&] {
    gaunt_view view;
    gaunt_view_interleaved(texture.data(), 3, &view);
    return view;
  }();
  ASSERT_EQ(gaunt_probe_encode(GAUNT_FORMAT_RGB9E5, texels.size(), &in, texels.data(), 4, nullptr),
            GAUNT_OK);
  Floats cubes(kPlanes * kX * kY * kZ, 9.0f);
  for (size_t face = 0; face < 6; ++face) {
    for (size_t z = 0; z < kZ; ++z) {
      const size_t first = ((z + face / 2 * kZ) * 2 + face % 2) * kY * kX;
      gaunt_view out;
      gaunt_view_interleaved(&cubes[kPlanes * kX * kY * z + 3 * face], kPlanes, &out);
      EXPECT_EQ(out.item_stride, 72);
      ASSERT_EQ(gaunt_probe_decode(GAUNT_FORMAT_RGB9E5, kX * kY, &texels[first], 4, &out),
                GAUNT_OK);
    }
  }
  size_t p = 0;
  for (size_t z = 0; z < kZ; ++z) {
    for (size_t y = 0; y < kY; ++y) {
      for (size_t x = 0; x < kX; ++x) {
        for (size_t face = 0; face < 6; ++face) {
          for (size_t c = 0; c < 3; ++c, ++p) EXPECT_EQ(cubes[p], value(x, y, z, face, c));
        }
      }
    }
  }
}

// ---- the cube as a model -----------------------------------------------------------------------

// A directional light of order 3 that reflects 1 at its own direction.
std::vector<double> Directional(const double d[3]) {
  std::vector<double> radiance(9);
  for (size_t i = 0; i < 9; ++i) {
    std::vector<double> one(9, 0.0);
    one[i] = 1.0;
    radiance[i] = 16.0 * kPi / 17.0 * evaluate::ShReference(3, one.data(), d);
  }
  return radiance;
}

struct Errors {
  double largest = 0.0;
  double rms = 0.0;
  double least_face = 0.0;
};

// Of a cube against E/pi of order 3. The largest is looked for on a grid, which has the axes and
// the diagonals.
Errors ErrorsOf(const std::vector<double>& radiance, const double faces[6], int steps = 12) {
  Errors errors;
  const auto error = [&](const double n[3]) {
    return ambient_cube::EvaluateReference(faces, n) -
           evaluate::IrradianceReference(3, radiance.data(), n);
  };
  const double squared = ambient_cube::IntegralReference([&](const double n[3]) {
    const double e = error(n);
    return e * e;
  });
  errors.rms = std::sqrt(squared / (4.0 * kPi));
  for (int face = 0; face < 6; ++face) {
    errors.least_face = std::min(errors.least_face, faces[face]);
    for (int i = -steps; i <= steps; ++i) {
      for (int j = -steps; j <= steps; ++j) {
        double n[3];
        n[face / 2] = face % 2 == 0 ? 1.0 : -1.0;
        n[(face / 2 + 1) % 3] = static_cast<double>(i) / steps;
        n[(face / 2 + 2) % 3] = static_cast<double>(j) / steps;
        const double length = Norm(n, 3);
        for (double& x : n) x /= length;
        errors.largest = std::max(errors.largest, std::abs(error(n)));
      }
    }
  }
  return errors;
}

// The cube that the library makes of one channel.
void Faces(uint32_t mode, const std::vector<double>& radiance, double faces[6]) {
  Floats rgb(27, 0.0f);
  for (size_t i = 0; i < 9; ++i) rgb[9 + i] = static_cast<float>(radiance[i]);
  const Floats cube = Projected(3, mode, rgb);
  ChannelOf(std::vector<double>(cube.begin(), cube.end()), 1, faces);
}

TEST(AmbientCubeModel, HasTheStatedErrorsOfDirectionalLight) {
  const double two = std::sqrt(0.5), three = std::sqrt(1.0 / 3.0);
  const struct {
    double direction[3];
    double largest[2], rms[2];
  } rows[] = {{{0, 0, 1}, {0.118, 0.118}, {0.068, 0.086}},
              {{two, two, 0}, {0.278, 0.358}, {0.133, 0.143}},
              {{three, three, three}, {0.425, 0.493}, {0.148, 0.157}}};
  for (const auto& row : rows) {
    const std::vector<double> radiance = Directional(row.direction);
    EXPECT_NEAR(evaluate::IrradianceReference(3, radiance.data(), row.direction), 1.0, 1e-12);
    for (size_t m = 0; m < 2; ++m) {
      double faces[6];
      Faces(kModes[m], radiance, faces);
      const Errors errors = ErrorsOf(radiance, faces, 96);
      EXPECT_NEAR(errors.largest, row.largest[m], 6e-4);
      EXPECT_NEAR(errors.rms, row.rms[m], 6e-4);
    }
  }
}

TEST(AmbientCubeModel, HasTheStatedBoundsOverAllDirections) {
  Random random(8);
  const double mean = 4.0 / 17.0;  // of the radiance
  Errors most[2];
  double least_rms[2] = {1.0, 1.0};
  for (int i = 0; i < 120; ++i) {
    float d[3];
    random.Direction(d);
    // A third of them near a diagonal of the octants, where the errors are largest.
    for (float& x : d) x = i % 3 == 0 ? std::copysign(1.0f, x) + 0.1f * x : x;
    double exact[3] = {d[0], d[1], d[2]};
    const double length = Norm(exact, 3);
    for (double& x : exact) x /= length;
    const std::vector<double> radiance = Directional(exact);
    for (size_t m = 0; m < 2; ++m) {
      double faces[6];
      Faces(kModes[m], radiance, faces);
      const Errors errors = ErrorsOf(radiance, faces);
      most[m].largest = std::max(most[m].largest, errors.largest);
      most[m].rms = std::max(most[m].rms, errors.rms);
      most[m].least_face = std::min(most[m].least_face, errors.least_face);
      least_rms[m] = std::min(least_rms[m], errors.rms);
    }
  }
  const double largest[2] = {1.81, 2.10}, rms[2] = {0.63, 0.67}, face[2] = {-0.108, -0.037};
  const double least[2] = {0.0675, 0.0855};
  for (size_t m = 0; m < 2; ++m) {
    EXPECT_LE(most[m].largest / mean, largest[m]);
    EXPECT_GE(most[m].largest / mean, 0.98 * largest[m]);
    EXPECT_LE(most[m].rms / mean, rms[m]);
    EXPECT_GE(most[m].rms / mean, 0.98 * rms[m]);
    EXPECT_NEAR(most[m].least_face, face[m], 6e-4);
    EXPECT_GE(least_rms[m], least[m]);
  }
}

TEST(AmbientCubeModel, TheClosestCubeIsTheClosest) {
  const Floats rgb = Noise(9, 27);
  const std::vector<double> radiance(rgb.begin(), rgb.begin() + 9);
  const Floats cube = Projected(3, GAUNT_AMBIENT_CUBE_LEAST_SQUARES, rgb);
  double faces[6];
  ChannelOf(std::vector<double>(cube.begin(), cube.end()), 0, faces);
  const double rms = ErrorsOf(radiance, faces).rms;
  for (double& face : faces) {
    for (const double step : {-0.002, 0.002}) {
      face += step;
      EXPECT_GT(ErrorsOf(radiance, faces).rms, rms);
      face -= step;
    }
  }
}

TEST(AmbientCubeModel, Order3LosesASixteenthOfTheOddEnergy) {
  const Floats cube = Noise(10, kPlanes);
  const Floats rgb = ToSh(3, cube);
  const std::vector<double> radiance(rgb.begin(), rgb.begin() + 9);
  double faces[6], odd[6];
  ChannelOf(std::vector<double>(cube.begin(), cube.end()), 0, faces);
  for (size_t face = 0; face < 6; ++face) odd[face] = 0.5 * (faces[face] - faces[face ^ 1]);
  const double energy = ambient_cube::IntegralReference([&](const double n[3]) {
    const double value = ambient_cube::EvaluateReference(odd, n);
    return value * value;
  });
  const double rms = ErrorsOf(radiance, faces).rms;
  EXPECT_NEAR(4.0 * kPi * rms * rms, energy / 16.0, 1e-5 * energy);
}

GAUNT_INSTANTIATE_TARGETS(AmbientCube);

}  // namespace
}  // namespace gaunt::test
