// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "gaunt/gaunt.h"
#include "project/project_reference.h"
#include "tests/support/buffer.h"
#include "tests/support/images.h"
#include "tests/support/random.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

const double kPi = std::acos(-1.0);
const double kSphere = 4.0 * kPi;

// Light that f16 has: from 1/16 to 16, with some zeros and some of its smallest numbers.
double Light(int face, int x, int y, int c) {
  Random random(static_cast<uint64_t>(((face * 1024 + y) * 1024 + x) * 4 + c));
  const uint64_t bits = random.Bits();
  if (bits % 16 == 0) return 0.0;
  if (bits % 16 == 1) return HalfValue(static_cast<uint16_t>(bits >> 8 & 1023));
  return HalfValue(static_cast<uint16_t>((11 + (bits >> 4) % 8) << 10 | (bits >> 8 & 1023)));
}

// The manual's figures, of the mean magnitude of the texels times 4 pi or of the sum of |weight
// value|: by moments, and, in band l, by the basis of each texel or sample.
double MomentTolerance() { return 2e-6; }
double BasisTolerance(int l) { return 2e-6 + 2e-8 * std::pow(l + 1.0, 2.5); }
double CubeTolerance(uint32_t n, int l) {
  if (n > 10) return BasisTolerance(l);
  return n <= 6 ? MomentTolerance() : 2.0 * MomentTolerance();
}
// Between splits into rows.
constexpr double kSplitTolerance = 1e-12;

int BandOf(uint32_t n, size_t plane) {
  const size_t i = plane % (n * n);
  int l = 0;
  while (static_cast<size_t>((l + 1) * (l + 1)) <= i) ++l;
  return l;
}

// Coefficients of `n` from those of a higher order.
double At(const std::vector<double>& of, uint32_t order, uint32_t n, size_t plane) {
  return of[plane / (n * n) * order * order + plane % (n * n)];
}

// tolerance(l) in band l
template <class Tolerance>
void ExpectCoefficients(const Buffer& out, uint32_t n, int channels,
                        const std::vector<double>& wanted, uint32_t order,
                        const Tolerance& tolerance) {
  for (size_t p = 0; p < static_cast<size_t>(channels) * n * n; ++p) {
    ASSERT_NEAR(out.Get(0, p), At(wanted, order, n, p), tolerance(BandOf(n, p))) << "plane " << p;
  }
  ASSERT_TRUE(out.CanariesIntact());
}

// What an image of light should give, with the mean magnitude of its texels times 4 pi.
struct Wanted {
  std::vector<double> sums;
  double magnitude = 0.0;
};
Wanted EquirectWanted(uint32_t order, int channels, int width, int height) {
  Wanted wanted = {std::vector<double>(static_cast<size_t>(channels) * order * order)};
  project::EquirectReference(
      static_cast<int>(order), channels, width, height,
      [&](int x, int y, int c) {
        wanted.magnitude += Light(0, x, y, c) * kSphere / (double{1} * width * height * channels);
        return Light(0, x, y, c);
      },
      wanted.sums.data());
  return wanted;
}
Wanted CubeWanted(uint32_t order, int channels, int size) {
  Wanted wanted = {std::vector<double>(static_cast<size_t>(channels) * order * order)};
  project::CubemapReference(
      static_cast<int>(order), channels, size,
      [&](int f, int x, int y, int c) {
        wanted.magnitude += Light(f, x, y, c) * kSphere / (6.0 * size * size * channels);
        return Light(f, x, y, c);
      },
      wanted.sums.data());
  return wanted;
}

class Project : public TargetTest {};

void TestEquirect(int width, int height, const std::vector<int>& all_channels, uint32_t order,
                  const std::vector<uint32_t>& orders) {
  const Wanted wanted = EquirectWanted(order, all_channels.back(), width, height);
  for (const int channels : all_channels) {
    for (const Style& style : Styles()) {
      TestImage image(static_cast<uint32_t>(width), static_cast<uint32_t>(height), channels, style);
      image.Fill([](int x, int y, int c) { return Light(0, x, y, c); });
      for (const uint32_t n : orders) {
        SCOPED_TRACE(testing::Message() << width << "x" << height << " channels " << channels
                                        << " order " << n << " style " << &style - Styles().data());
        Buffer out(n % 2 ? Layout::kPlanar : Layout::kRecord, 1,
                   static_cast<size_t>(channels) * n * n);
        ASSERT_EQ(gaunt_project_equirect(n, static_cast<uint32_t>(channels), image.image(), nullptr,
                                         out.view()),
                  GAUNT_OK);
        ExpectCoefficients(out, n, channels, wanted.sums, order,
                           [&](int) { return wanted.magnitude * MomentTolerance(); });
      }
    }
  }
}

TEST_P(Project, EquirectMatchesTheDefinition) {
  for (const auto& size :
       {std::pair(1, 1), {2, 1}, {1, 5}, {7, 3}, {16, 8}, {33, 4}, {127, 5}, {129, 4}}) {
    TestEquirect(size.first, size.second, {1, 2, 3, 4}, 10, {1, 2, 3, 5, 6, 8, 10});
  }
  TestEquirect(300, 40, {3}, 6, {3, 6});
  TestEquirect(40, 6, {1, 3}, 64, {11, 12, 16, 33, 64});
}

void TestCubemap(int size, const std::vector<int>& all_channels, uint32_t order,
                 const std::vector<uint32_t>& orders) {
  const Wanted wanted = CubeWanted(order, all_channels.back(), size);
  for (const int channels : all_channels) {
    for (const Style& style : Styles()) {
      TestCube cube(static_cast<uint32_t>(size), channels, style);
      cube.Fill(Light);
      for (const uint32_t n : orders) {
        SCOPED_TRACE(testing::Message() << size << "^2 channels " << channels << " order " << n
                                        << " style " << &style - Styles().data());
        Buffer out(n % 2 ? Layout::kInterleaved : Layout::kTiled, 1,
                   static_cast<size_t>(channels) * n * n);
        ASSERT_EQ(gaunt_project_cubemap(n, static_cast<uint32_t>(channels), cube.images(), nullptr,
                                        out.view()),
                  GAUNT_OK);
        ExpectCoefficients(out, n, channels, wanted.sums, order,
                           [&](int l) { return wanted.magnitude * CubeTolerance(n, l); });
      }
    }
  }
}

TEST_P(Project, CubemapMatchesTheDefinition) {
  for (const int size : {1, 2, 3, 5, 8, 17}) {
    TestCubemap(size, {1, 2, 3, 4}, 11, {1, 2, 3, 4, 5, 6, 8, 9, 10, 11});
  }
  TestCubemap(64, {4}, 6, {3, 6});
  TestCubemap(3, {1, 3}, 64, {16, 33, 64});
}

TEST_P(Project, LongRowsOfFacesMatchTheDefinition) {
  // Runs away from the middle of the face, with a part of one at the end.
  const Wanted wanted = CubeWanted(10, 1, 135);
  TestCube cube(135, 1, Styles()[0]);
  cube.Fill(Light);
  for (const uint32_t n : {3u, 10u}) {
    Buffer out(Layout::kPlanar, 1, n * n);
    ASSERT_EQ(gaunt_project_cubemap(n, 1, cube.images(), nullptr, out.view()), GAUNT_OK);
    ExpectCoefficients(out, n, 1, wanted.sums, 10,
                       [&](int l) { return wanted.magnitude * CubeTolerance(n, l); });
  }
}

TEST_P(Project, FacesOfACubeMayDiffer) {
  std::vector<std::unique_ptr<TestImage>> faces;
  const gaunt_image* images[6];
  for (int f = 0; f < 6; ++f) {
    faces.push_back(std::make_unique<TestImage>(9, 9, 1, Styles()[static_cast<size_t>(f * 2 % 9)]));
    faces.back()->Fill([&](int x, int y, int c) { return Light(f, x, y, c); });
    images[f] = faces.back()->image();
  }
  const Wanted wanted = CubeWanted(5, 1, 9);
  Buffer out(Layout::kPlanar, 1, 25);
  ASSERT_EQ(gaunt_project_cubemap(5, 1, images, nullptr, out.view()), GAUNT_OK);
  ExpectCoefficients(out, 5, 1, wanted.sums, 5,
                     [&](int l) { return wanted.magnitude * CubeTolerance(5, l); });
}

struct TestSamples {
  std::vector<double> directions, values, weights, wanted;
  double magnitude = 0.0;

  TestSamples(uint32_t order, int channels, const Buffer& d, const Buffer& v, const Buffer& w,
              size_t count)
      : wanted(static_cast<size_t>(channels) * order * order) {
    for (size_t i = 0; i < count; ++i) {
      for (size_t k = 0; k < 3; ++k) directions.push_back(double{d.Get(i, k)});
      weights.push_back(double{w.Get(i, 0)});
      for (size_t c = 0; c < static_cast<size_t>(channels); ++c) {
        values.push_back(double{v.Get(i, c)});
        magnitude += std::abs(values.back() * weights.back());
      }
    }
    project::SamplesReference(static_cast<int>(order), channels, count, directions.data(),
                              values.data(), weights.data(), wanted.data());
  }
};

void FillSamples(size_t count, int channels, Buffer& d, Buffer& v, Buffer& w) {
  Random random(count);
  for (size_t i = 0; i < count; ++i) {
    float direction[3];
    random.Direction(direction);
    for (size_t k = 0; k < 3; ++k) d.Set(i, k, direction[k]);
    for (size_t c = 0; c < static_cast<size_t>(channels); ++c) v.Set(i, c, random.Between(-2, 4));
    w.Set(i, 0, random.Between(0.1, 2.0));
  }
}

void TestSample(Layout layout, Layout weight_layout, size_t count, int channels, uint32_t n) {
  SCOPED_TRACE(testing::Message() << Name(layout) << " " << count << " channels " << channels
                                  << " order " << n);
  Buffer d(layout, count, 3), v(layout, count, static_cast<size_t>(channels));
  Buffer w(weight_layout, count, 1);
  FillSamples(count, channels, d, v, w);
  const TestSamples samples(n, channels, d, v, w, count);
  Buffer out(Layout::kPlanar, 1, static_cast<size_t>(channels) * n * n);
  ASSERT_EQ(gaunt_project_samples(n, static_cast<uint32_t>(channels), count, d.view(), v.view(),
                                  w.view(), out.view()),
            GAUNT_OK);
  ExpectCoefficients(out, n, channels, samples.wanted, n,
                     [&](int l) { return samples.magnitude * BasisTolerance(l); });
}

TEST_P(Project, SamplesMatchTheDefinition) {
  for (const size_t count : {1, 3, 15, 16, 17, 31, 33}) {
    for (const Layout layout : Layouts()) {
      for (const int channels : {1, 2, 3, 4}) {
        for (const uint32_t n : {1u, 2u, 3u, 6u, 7u}) {
          TestSample(layout, layout, count, channels, n);
          TestSample(layout, Layout::kBroadcast, count, channels, n);
        }
      }
    }
  }
  // More than a stretch of lanes holds.
  for (const int channels : {1, 4}) {
    for (const uint32_t n : {3u, 4u, 5u, 6u, 8u, 10u}) {
      TestSample(Layout::kTiled, Layout::kTiled, 1100, channels, n);
    }
  }
  for (const uint32_t n : {16u, 33u, 64u}) {
    TestSample(Layout::kInterleaved, Layout::kInterleaved, 37, 3, n);
  }
}

TEST_P(Project, OneTexelAloneIsAccurate) {
  // Where nothing averages errors out.
  Random random(5);
  for (int times = 0; times < 40; ++times) {
    const int size = times % 2 ? 9 : 20;
    const auto below = [&](int n) {
      return static_cast<int>(random.Bits() % static_cast<uint64_t>(n));
    };
    const int face = below(6), x = times % 5 ? below(size) : 0, y = below(size);
    TestCube cube(static_cast<uint32_t>(size), 1, Styles()[0]);
    cube.Fill([](int, int, int, int) { return 0.0; });
    cube.face(face).Set(x, y, 0, 1.0f);
    TestImage image(static_cast<uint32_t>(2 * size), static_cast<uint32_t>(size), 1, Styles()[0]);
    image.Fill([&](int column, int row, int) { return column == x && row == y ? 1.0 : 0.0; });
    for (const uint32_t n : {6u, 10u, 20u, 64u}) {
      if (n == 64 && times >= 5) continue;  // the definition takes long
      const int order = static_cast<int>(n);
      double direction[3], weight = project::CubeSolidAngleReference(x, y, size), one = 1.0;
      project::CubeDirectionReference(face, x, y, size, direction);
      std::vector<double> wanted(n * n);
      project::SamplesReference(order, 1, 1, direction, &one, &weight, wanted.data());
      Buffer out(Layout::kPlanar, 1, n * n);
      ASSERT_EQ(gaunt_project_cubemap(n, 1, cube.images(), nullptr, out.view()), GAUNT_OK);
      ExpectCoefficients(out, n, 1, wanted, n, [&](int l) { return weight * CubeTolerance(n, l); });

      const double theta = kPi * (y + 0.5) / size, phi = kPi - kPi * (x + 0.5) / size;
      const double to[3] = {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                            std::cos(theta)};
      weight = kPi / size * 2.0 * std::sin(theta) * std::sin(0.5 * kPi / size);
      project::SamplesReference(order, 1, 1, to, &one, &weight, wanted.data());
      ASSERT_EQ(gaunt_project_equirect(n, 1, image.image(), nullptr, out.view()), GAUNT_OK);
      ExpectCoefficients(out, n, 1, wanted, n, [&](int) { return weight * MomentTolerance(); });
    }
  }
}

// The least favourable place: the monomials of all orders are largest beside the middle of a face.
TEST_P(Project, OneTexelInTheMiddleIsAccurate) {
  for (const int size : {126, 156, 353}) {
    TestCube cube(static_cast<uint32_t>(size), 1, Styles()[0]);
    cube.Fill([](int, int, int, int) { return 0.0; });
    for (const int at : {size / 2 - 3, size / 2, size / 2 + 2}) {
      cube.face(4).Set(at, at, 0, 1.0f);
      const double mean = 1.0 / (6.0 * size * size), one = 1.0;
      const double weight = project::CubeSolidAngleReference(at, at, size);
      double direction[3];
      project::CubeDirectionReference(4, at, at, size, direction);
      for (const uint32_t n : {6u, 8u, 9u, 10u}) {
        const int order = static_cast<int>(n);
        std::vector<double> wanted(n * n);
        project::SamplesReference(order, 1, 1, direction, &one, &weight, wanted.data());
        Buffer out(Layout::kPlanar, 1, n * n);
        ASSERT_EQ(gaunt_project_cubemap(n, 1, cube.images(), nullptr, out.view()), GAUNT_OK);
        ExpectCoefficients(out, n, 1, wanted, n,
                           [&](int l) { return 4.0 * kPi * mean * CubeTolerance(n, l); });
      }
      cube.face(4).Set(at, at, 0, 0.0f);
    }
  }
}

TEST_P(Project, OneSampleIsAccurate) {
  for (size_t count = 1; count < 30; ++count) {  // a seed for directions, too
    for (const uint32_t n : {6u, 10u, 33u, 64u}) {
      if (n == 64 && count >= 5) continue;
      Buffer d(Layout::kPlanar, 1, 3), v(Layout::kPlanar, 1, 1), w(Layout::kPlanar, 1, 1);
      Random random(count);
      float direction[3];
      random.Direction(direction);
      for (size_t k = 0; k < 3; ++k) d.Set(0, k, direction[k]);
      v.Set(0, 0, 1.0f);
      w.Set(0, 0, 1.0f);
      const TestSamples samples(n, 1, d, v, w, 1);
      Buffer out(Layout::kPlanar, 1, n * n);
      ASSERT_EQ(gaunt_project_samples(n, 1, 1, d.view(), v.view(), w.view(), out.view()), GAUNT_OK);
      ExpectCoefficients(out, n, 1, samples.wanted, n, [](int l) { return BasisTolerance(l); });
    }
  }
}

TEST_P(Project, NoSamplesAreNothing) {
  Buffer out(Layout::kPlanar, 1, 12);
  ASSERT_EQ(gaunt_project_samples(2, 3, 0, nullptr, nullptr, nullptr, out.view()), GAUNT_OK);
  for (size_t p = 0; p < 12; ++p) EXPECT_EQ(out.Get(0, p), 0.0f);
}

TEST_P(Project, SamplesOfTheSphereGiveTheFunctionBack) {
  // f = 1 + y_1^0 at the 6 directions of the axes, each weighing 4 pi / 6: a design of degree 3.
  const float axes[18] = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
  const float y10 = static_cast<float>(std::sqrt(3.0 / kSphere));
  const float values[6] = {1, 1, 1, 1, 1 + y10, 1 - y10}, weight = static_cast<float>(kSphere / 6);
  gaunt_view d, v, w;
  gaunt_view_interleaved(const_cast<float*>(axes), 3, &d);
  gaunt_view_interleaved(const_cast<float*>(values), 1, &v);
  gaunt_view_broadcast(const_cast<float*>(&weight), &w);
  Buffer out(Layout::kPlanar, 1, 4);
  ASSERT_EQ(gaunt_project_samples(2, 1, 6, &d, &v, &w, out.view()), GAUNT_OK);
  const double wanted[4] = {std::sqrt(kSphere), 0.0, 1.0, 0.0};
  for (size_t p = 0; p < 4; ++p) EXPECT_NEAR(out.Get(0, p), wanted[p], 2e-6 * kSphere);
}

TEST_P(Project, EquirectAxesAreWhereTheManualSays) {
  const auto lit = [](const std::function<bool(int, int)>& where) {
    TestImage image(64, 32, 1, Styles()[0]);
    image.Fill([&](int x, int y, int) { return where(x, y) ? 1.0 : 0.0; });
    std::vector<float> f(4);
    gaunt_view out;
    gaunt_view_interleaved(f.data(), 4, &out);
    EXPECT_EQ(gaunt_project_equirect(2, 1, image.image(), nullptr, &out), GAUNT_OK);
    return f;
  };
  std::vector<float> f =
      lit([](int x, int y) { return (x == 31 || x == 32) && (y == 15 || y == 16); });
  EXPECT_GT(-f[3], 0.0f) << "the centre looks at +x";
  EXPECT_NEAR(f[1], 0.0f, 1e-6);
  EXPECT_NEAR(f[2], 0.0f, 1e-6);
  f = lit([](int x, int y) { return x == 48 && (y == 15 || y == 16); });
  EXPECT_LT(-f[1], 0.0f) << "right of the centre is -y";
  f = lit([](int x, int y) { return x == 5 && y == 0; });
  EXPECT_GT(f[2], 0.0f) << "the top row is +z";
}

TEST_P(Project, FacesLieWhereTheManualSays) {
  // Per face: where it looks, where its columns go, where its rows go.
  const int axes[6][3][3] = {
      {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
      {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},   {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
      {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}};
  constexpr int kSize = 8;
  for (const uint32_t cube_convention : {GAUNT_CUBE_D3D, GAUNT_CUBE_GL, GAUNT_CUBE_UNITY}) {
    const gaunt_project_options options = {sizeof(options), 0, cube_convention};
    for (int face = 0; face < 6; ++face) {
      for (const int part : {0, 1, 2}) {  // the whole face; its right half; its lower half
        TestCube cube(kSize, 1, Styles()[0]);
        cube.Fill([&](int f, int x, int y, int) {
          return f == face && (part != 1 || x >= kSize / 2) && (part != 2 || y >= kSize / 2) ? 1.0
                                                                                             : 0.0;
        });
        float f[4];
        gaunt_view out;
        gaunt_view_interleaved(f, 4, &out);
        ASSERT_EQ(gaunt_project_cubemap(2, 1, cube.images(), &options, &out), GAUNT_OK);
        const float to[3] = {-f[3], -f[1], f[2]};
        for (int k = 0; k < 3; ++k) {
          const int wanted = axes[face][0][k] + (part > 0 ? axes[face][part][k] : 0);
          if (wanted == 0) {
            EXPECT_NEAR(to[k], 0.0f, 1e-6) << face << " " << part << " " << k;
          } else {
            EXPECT_GT(to[k] * static_cast<float>(wanted), 0.05f) << face << " " << part << " " << k;
          }
        }
      }
    }
  }
}

TEST_P(Project, ConstantLightIsAllMean) {
  // Rows of a panorama sum to 4 pi exactly; midpoints leave a little of band 2.
  TestImage image(256, 128, 3, Styles()[0]);
  image.Fill([](int, int, int) { return 2.0; });
  Buffer out(Layout::kPlanar, 1, 27);
  ASSERT_EQ(gaunt_project_equirect(3, 3, image.image(), nullptr, out.view()), GAUNT_OK);
  for (size_t p = 0; p < 27; ++p) {
    const double wanted = p % 9 == 0 ? 2.0 * std::sqrt(kSphere) : 0.0;
    EXPECT_NEAR(out.Get(0, p), wanted, p % 9 == 6 ? 1e-3 : 2e-6 * 2.0 * kSphere);
  }
}

void TestConstantCube(uint32_t size, double value) {
  // One face serves six times: memory.
  TestImage face(size, size, 1, Styles()[0]);
  face.Fill([&](int, int, int) { return value; });
  const gaunt_image* const faces[6] = {face.image(), face.image(), face.image(),
                                       face.image(), face.image(), face.image()};
  // By the symmetry of a cube, bands 1 to 3 of any constant light are zero.
  Buffer out(Layout::kPlanar, 1, 16);
  ASSERT_EQ(gaunt_project_cubemap(4, 1, faces, nullptr, out.view()), GAUNT_OK);
  const double mean = static_cast<double>(static_cast<float>(value)) * std::sqrt(kSphere);
  EXPECT_NEAR(out.Get(0, 0) / mean, 1.0, 1e-6) << size;
  for (size_t p = 1; p < 16; ++p) EXPECT_NEAR(out.Get(0, p) / mean, 0.0, 1e-6) << size;
}

TEST_P(Project, SolidAnglesOfACubeAreExact) {
  for (uint32_t size = 1; size <= 40; ++size) TestConstantCube(size, 0.7);
  for (const uint32_t size : {63, 64, 65, 100, 128, 129, 200, 256, 511}) {
    TestConstantCube(size, 0.7);
  }
  // One texel at a time: middle, edge and corner.
  for (const int size : {1, 2, 3, 4, 7, 15, 16, 17, 32, 64, 128, 500, 1024}) {
    for (const int x : {0, size / 3, size / 2, size - 1}) {
      for (const int y : {0, size / 4, size / 2, size - 1}) {
        TestImage row(static_cast<uint32_t>(size), 1, 1, Styles()[0]);
        row.Fill([&](int column, int, int) { return column == x ? 1.0 : 0.0; });
        double sums[1] = {};
        ASSERT_EQ(gaunt_project_cubemap_rows(1, 1, 0, row.image(), static_cast<uint32_t>(y),
                                             nullptr, sums),
                  GAUNT_OK);
        const double wanted = project::CubeSolidAngleReference(x, y, size) / std::sqrt(kSphere);
        EXPECT_NEAR(sums[0] / wanted, 1.0, 4e-7) << size << ": " << x << ", " << y;
      }
    }
  }
}

TEST_P(Project, LargeFacesDoNotDrift) { TestConstantCube(1024, 0.1); }

TEST_P(Project, RowsAddUpToTheWhole) {
  constexpr uint32_t kWidth = 150, kHeight = 37, kSize = 33;
  Random random(7);
  const double image_magnitude = EquirectWanted(1, 3, kWidth, kHeight).magnitude;
  for (const size_t which : {0u, 1u, 6u}) {
    const Style& style = Styles()[which];
    TestImage image(kWidth, kHeight, 3, style);
    image.Fill([](int x, int y, int c) { return Light(0, x, y, c); });
    TestCube cube(kSize, 3, style);
    cube.Fill(Light);
    for (const uint32_t n : {1u, 3u, 6u, 10u, 13u}) {
      const size_t planes = 3 * n * n;
      std::vector<double> whole(planes), faces(planes);
      ASSERT_EQ(gaunt_project_equirect_rows(n, 3, image.image(), 0, kHeight, nullptr, whole.data()),
                GAUNT_OK);
      for (uint32_t f = 0; f < 6; ++f) {
        ASSERT_EQ(gaunt_project_cubemap_rows(n, 3, f, cube.images()[f], 0, nullptr, faces.data()),
                  GAUNT_OK);
      }
      const auto random_split = [&](uint32_t rows, const auto& project) {
        for (uint32_t first = 0, part; first < rows; first += part) {
          part = std::min(rows - first, static_cast<uint32_t>(1 + random.Bits() % 9));
          project(first, part);
        }
      };
      std::vector<double> split(planes), split_faces(planes);
      random_split(kHeight, [&](uint32_t first, uint32_t part) {
        const gaunt_image rows = image.Rows(first, part);
        ASSERT_EQ(gaunt_project_equirect_rows(n, 3, &rows, first, kHeight, nullptr, split.data()),
                  GAUNT_OK);
      });
      for (uint32_t f = 6; f-- > 0;) {
        random_split(kSize, [&](uint32_t first, uint32_t part) {
          const gaunt_image rows = cube.face(static_cast<int>(f)).Rows(first, part);
          ASSERT_EQ(gaunt_project_cubemap_rows(n, 3, f, &rows, first, nullptr, split_faces.data()),
                    GAUNT_OK);
        });
      }
      Buffer out(Layout::kPlanar, 1, planes), rounded(Layout::kInterleaved, 1, planes);
      ASSERT_EQ(gaunt_project_equirect(n, 3, image.image(), nullptr, out.view()), GAUNT_OK);
      ASSERT_EQ(gaunt_project_sums(n, 3, whole.data(), rounded.view()), GAUNT_OK);
      Buffer cube_out(Layout::kPlanar, 1, planes);
      ASSERT_EQ(gaunt_project_cubemap(n, 3, cube.images(), nullptr, cube_out.view()), GAUNT_OK);
      // Above the orders of moments, a face's rows share sums in float.
      const double exact = kSplitTolerance * image_magnitude;
      const double faces_exact = n > 10 ? MomentTolerance() * image_magnitude : exact;
      for (size_t p = 0; p < planes; ++p) {
        ASSERT_NEAR(split[p], whole[p], exact) << "order " << n << " plane " << p;
        ASSERT_NEAR(split_faces[p], faces[p], faces_exact) << "order " << n << " plane " << p;
        ASSERT_EQ(rounded.Get(0, p), static_cast<float>(whole[p]));
        ASSERT_NEAR(out.Get(0, p), whole[p], 1e-12 + 6e-8 * std::abs(whole[p]));
        ASSERT_NEAR(cube_out.Get(0, p), faces[p], faces_exact + 6e-8 * std::abs(faces[p]));
      }
    }
  }
}

TEST_P(Project, TwoThreadsAgreeWithOne) {
  TestImage image(200, 64, 3, Styles()[0]);
  image.Fill([](int x, int y, int c) { return Light(0, x, y, c); });
  std::vector<double> whole(27), halves[2];
  ASSERT_EQ(gaunt_project_equirect_rows(3, 3, image.image(), 0, 64, nullptr, whole.data()),
            GAUNT_OK);
  std::vector<std::thread> threads;
  for (uint32_t t = 0; t < 2; ++t) {
    halves[t].assign(27, 0.0);
    threads.emplace_back([&image, &halves, t] {
      const gaunt_image rows = image.Rows(32 * t, 32);
      gaunt_project_equirect_rows(3, 3, &rows, 32 * t, 64, nullptr, halves[t].data());
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (size_t p = 0; p < 27; ++p) {
    EXPECT_NEAR(halves[0][p] + halves[1][p], whole[p],
                kSplitTolerance * EquirectWanted(1, 3, 200, 64).magnitude);
  }
}

TEST_P(Project, SamplesAddUp) {
  Buffer d(Layout::kTiled, 100, 3), v(Layout::kTiled, 100, 3), w(Layout::kTiled, 100, 1);
  FillSamples(100, 3, d, v, w);
  // In one pass, in several, and in several of each channel.
  for (const uint32_t n : {3u, 12u, 40u}) {
    std::vector<double> sums(3 * n * n, 0.25);
    for (int times = 0; times < 2; ++times) {
      ASSERT_EQ(gaunt_project_samples_add(n, 3, 100, d.view(), v.view(), w.view(), sums.data()),
                GAUNT_OK);
    }
    Buffer out(Layout::kPlanar, 1, sums.size());
    ASSERT_EQ(gaunt_project_samples(n, 3, 100, d.view(), v.view(), w.view(), out.view()), GAUNT_OK);
    for (size_t p = 0; p < sums.size(); ++p) {
      EXPECT_EQ(out.Get(0, p), static_cast<float>((sums[p] - 0.25) / 2.0)) << p;
    }
  }
}

TEST_P(Project, ClampsTexelsWhereAsked) {
  const float bad[] = {-1.0f, std::nanf(""), HUGE_VALF, -HUGE_VALF};
  const auto spoilt = [](int x, int y, int c) { return (7 * y + x) % 5 == c; };
  const gaunt_project_options options = {sizeof(options), GAUNT_PROJECT_CLAMP, GAUNT_CUBE_D3D};
  for (const Style& style : Styles()) {
    SCOPED_TRACE(&style - Styles().data());
    TestCube wrong(20, 3, style), right(20, 3, style);
    wrong.Fill([&](int f, int x, int y, int c) {
      return spoilt(x, y, c) ? double{bad[(x + f) % 4]} : Light(f, x, y, c);
    });
    right.Fill(
        [&](int f, int x, int y, int c) { return spoilt(x, y, c) ? 0.0 : Light(f, x, y, c); });
    for (const uint32_t n : {3u, 11u}) {
      const size_t planes = 3 * n * n;
      Buffer clamped(Layout::kPlanar, 1, planes), wanted(Layout::kPlanar, 1, planes);
      Buffer spread(Layout::kPlanar, 1, planes);
      const auto same = [&] {
        for (size_t p = 0; p < planes; ++p) {
          ASSERT_NEAR(clamped.Get(0, p), wanted.Get(0, p),
                      1e-6 * std::abs(wanted.Get(0, p)) + 1e-6);
          ASSERT_TRUE(std::isnan(spread.Get(0, p)));
        }
      };
      ASSERT_EQ(gaunt_project_cubemap(n, 3, wrong.images(), &options, clamped.view()), GAUNT_OK);
      ASSERT_EQ(gaunt_project_cubemap(n, 3, right.images(), nullptr, wanted.view()), GAUNT_OK);
      ASSERT_EQ(gaunt_project_cubemap(n, 3, wrong.images(), nullptr, spread.view()), GAUNT_OK);
      same();
      ASSERT_EQ(gaunt_project_equirect(n, 3, wrong.images()[0], &options, clamped.view()),
                GAUNT_OK);
      ASSERT_EQ(gaunt_project_equirect(n, 3, right.images()[0], nullptr, wanted.view()), GAUNT_OK);
      ASSERT_EQ(gaunt_project_equirect(n, 3, wrong.images()[0], nullptr, spread.view()), GAUNT_OK);
      same();
    }
  }
}

TEST_P(Project, ANanStaysInItsChannel) {
  for (const int channels : {2, 3, 4}) {
    for (const size_t which : {0u, 3u, 6u}) {
      TestCube good(18, channels, Styles()[which]), bad(18, channels, Styles()[which]);
      good.Fill(Light);
      bad.Fill(Light);
      bad.face(2).Set(3, 4, 1, std::nanf(""));
      for (const uint32_t n : {3u, 11u}) {
        const size_t planes = static_cast<size_t>(channels) * n * n;
        Buffer wanted(Layout::kPlanar, 1, planes), out(Layout::kPlanar, 1, planes);
        ASSERT_EQ(gaunt_project_cubemap(n, static_cast<uint32_t>(channels), good.images(), nullptr,
                                        wanted.view()),
                  GAUNT_OK);
        ASSERT_EQ(gaunt_project_cubemap(n, static_cast<uint32_t>(channels), bad.images(), nullptr,
                                        out.view()),
                  GAUNT_OK);
        for (size_t p = 0; p < planes; ++p) {
          if (p / (n * n) == 1) {
            EXPECT_TRUE(std::isnan(out.Get(0, p)));
          } else {
            EXPECT_EQ(out.Get(0, p), wanted.Get(0, p));
          }
        }
      }
    }
  }
}

TEST_P(Project, EveryHalfIsItsNumber) {
  // A panorama of one texel has it as its mean; four at a time, as channels.
  std::vector<uint16_t> all(65536);
  for (size_t i = 0; i < all.size(); ++i) all[i] = static_cast<uint16_t>(i);
  for (uint32_t i = 0; i < 65536; i += 4) {
    const gaunt_image texel = {&all[i], 1, 1, 8, 8, GAUNT_TEXEL_F16};
    double sums[4] = {};
    ASSERT_EQ(gaunt_project_equirect_rows(1, 4, &texel, 0, 1, nullptr, sums), GAUNT_OK);
    for (uint32_t c = 0; c < 4; ++c) {
      const double wanted = HalfValue(all[i + c]) * std::sqrt(kSphere);
      if (std::isnan(wanted)) {
        ASSERT_TRUE(std::isnan(sums[c])) << i + c;
      } else if (std::isinf(wanted)) {
        ASSERT_EQ(sums[c], wanted) << i + c;
      } else {
        ASSERT_NEAR(sums[c], wanted, 1e-12 * std::abs(wanted)) << i + c;
      }
    }
  }
}

TEST_P(Project, CubemapsAndPanoramasAgree) {
  // One analytic light, which both sample: band 0 to 3, and what is above.
  const auto light = [](const double* d, int c) {
    return 1.5 + d[0] * (c + 1) + d[1] * d[2] - 0.5 * d[2] * d[2] * d[0] + std::exp(d[c] - 1.0);
  };
  constexpr int kWidth = 512, kHeight = 256, kSize = 96;
  TestImage image(kWidth, kHeight, 3, Styles()[0]);
  image.Fill([&](int x, int y, int c) {
    const double theta = kPi * (y + 0.5) / kHeight, phi = kPi - 2.0 * kPi * (x + 0.5) / kWidth;
    const double d[3] = {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                         std::cos(theta)};
    return light(d, c);
  });
  TestCube cube(kSize, 3, Styles()[0]);
  cube.Fill([&](int f, int x, int y, int c) {
    double d[3];
    project::CubeDirectionReference(f, x, y, kSize, d);
    return light(d, c);
  });
  Buffer a(Layout::kPlanar, 1, 108), b(Layout::kPlanar, 1, 108);
  ASSERT_EQ(gaunt_project_equirect(6, 3, image.image(), nullptr, a.view()), GAUNT_OK);
  ASSERT_EQ(gaunt_project_cubemap(6, 3, cube.images(), nullptr, b.view()), GAUNT_OK);
  for (size_t p = 0; p < 108; ++p) EXPECT_NEAR(a.Get(0, p), b.Get(0, p), 2e-3) << p;
}

GAUNT_INSTANTIATE_TARGETS(Project);

}  // namespace
}  // namespace gaunt::test
