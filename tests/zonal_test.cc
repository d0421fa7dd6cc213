// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gaunt/gaunt.h"
#include "tests/support/buffer.h"
#include "tests/support/golden.h"
#include "tests/support/operation.h"
#include "tests/support/targets.h"
#include "zonal/zonal_reference.h"

namespace gaunt::test {
namespace {

// As gaunt.h states them: of |z_l| in band l, of the sum where it is added to, of the result.
double RotateTolerance(uint32_t n, int l) {
  return n <= 3 ? 3e-7 : 2e-7 + 3.2e-8 * (l + 1) * (l + 1);
}
constexpr double kAddTolerance = 6e-8;
constexpr double kConvolveTolerance = 1.8e-7;

const double kPi = std::acos(-1.0);

int BandOfPlane(uint32_t n, size_t plane) {
  return static_cast<int>(std::sqrt(static_cast<double>(plane % (n * n))));
}

const float* At(const gaunt_view& view, size_t item, size_t plane) {
  const size_t tile_items = view.tile_items == 0 ? SIZE_MAX : view.tile_items;
  const ptrdiff_t bytes = static_cast<ptrdiff_t>(item / tile_items) * view.tile_stride +
                          static_cast<ptrdiff_t>(item % tile_items) * view.item_stride +
                          static_cast<ptrdiff_t>(plane) * view.plane_stride;
  return view.data + bytes / static_cast<ptrdiff_t>(sizeof(float));
}

Operation RotateOperation(uint32_t n, uint32_t channels) {
  Operation operation;
  operation.name = "zonal_rotate/n" + std::to_string(n) + "/channels" + std::to_string(channels);
  operation.inputs = {size_t{channels} * n, 3};
  operation.outputs = {size_t{channels} * n * n};
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_zonal_rotate(n, channels, count, in[0], in[1], out[0]);
  };
  operation.make = [=](Random& random, size_t side, float* planes) {
    if (side == 1) return random.Direction(planes);
    random.Fill(planes, channels * n, -1.0, 1.0);
  };
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    for (uint32_t c = 0; c < channels; ++c) {
      zonal::RotateReference(static_cast<int>(n), in[0].data() + c * n, in[1].data(),
                             out[0].data() + c * n * n);
    }
  };
  operation.tolerance = [=](const Operation::Item& in, const Operation::Item&, size_t, size_t p) {
    const int l = BandOfPlane(n, p);
    const double z = in[0][p / (n * n) * n + static_cast<size_t>(l)];
    return RotateTolerance(n, l) * std::abs(z);
  };
  return operation;
}

// What is added to is an input here, from which the output is filled before each call.
Operation AddOperation(uint32_t n, uint32_t channels) {
  const Operation rotate = RotateOperation(n, channels);
  const size_t planes = rotate.outputs[0];
  Operation operation = rotate;
  operation.name =
      "zonal_rotate_add/n" + std::to_string(n) + "/channels" + std::to_string(channels);
  operation.inputs.push_back(planes);
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    for (size_t i = 0; i < count; ++i) {
      for (size_t p = 0; p < planes; ++p) {
        *const_cast<float*>(At(*out[0], i, p)) = *At(*in[2], i, p);
      }
    }
    return gaunt_zonal_rotate_add(n, channels, count, in[0], in[1], out[0]);
  };
  operation.make = [=](Random& random, size_t side, float* out) {
    if (side != 2) return rotate.make(random, side, out);
    random.Fill(out, planes, -2.0, 2.0);
  };
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    rotate.reference(in, out);
    for (size_t p = 0; p < planes; ++p) out[0][p] += in[2][p];
  };
  operation.tolerance = [=](const Operation::Item& in, const Operation::Item& wanted, size_t side,
                            size_t p) {
    return rotate.tolerance(in, wanted, side, p) + kAddTolerance * std::abs(wanted[0][p]);
  };
  return operation;
}

Operation ConvolveOperation(uint32_t n, uint32_t channels) {
  const size_t planes = size_t{channels} * n * n;
  Operation operation;
  operation.name = "zonal_convolve/n" + std::to_string(n) + "/channels" + std::to_string(channels);
  operation.inputs = {n, planes};
  operation.outputs = {planes};
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    return gaunt_zonal_convolve(n, channels, count, in[0], in[1], out[0]);
  };
  operation.make = [=](Random& random, size_t side, float* out) {
    random.Fill(out, side == 0 ? n : planes, -1.0, 1.0);
  };
  // The theorem; ConvolutionIsTheIntegral holds it against the definition.
  operation.reference = [=](const Operation::Item& in, Operation::Item& out) {
    for (size_t p = 0; p < planes; ++p) {
      const int l = BandOfPlane(n, p);
      out[0][p] = std::sqrt(4.0 * kPi / (2.0 * l + 1.0)) * in[0][static_cast<size_t>(l)] * in[1][p];
    }
  };
  operation.tolerance = [](const Operation::Item&, const Operation::Item& wanted, size_t,
                           size_t p) { return kConvolveTolerance * std::abs(wanted[0][p]); };
  operation.in_place = {1};
  return operation;
}

// An item of a function, by interleaved views.
std::vector<float> RotateOne(uint32_t n, uint32_t channels, const float* zonal,
                             const float* direction) {
  std::vector<float> out(size_t{channels} * n * n);
  gaunt_view vz, vd, vo;
  gaunt_view_interleaved(const_cast<float*>(zonal), channels * n, &vz);
  gaunt_view_interleaved(const_cast<float*>(direction), 3, &vd);
  gaunt_view_interleaved(out.data(), out.size(), &vo);
  EXPECT_EQ(gaunt_zonal_rotate(n, channels, 1, &vz, &vd, &vo), GAUNT_OK);
  return out;
}

std::vector<float> ConvolveOne(uint32_t n, const std::vector<float>& kernel, std::vector<float> f) {
  gaunt_view vk, vf;
  gaunt_view_interleaved(const_cast<float*>(kernel.data()), n, &vk);
  gaunt_view_interleaved(f.data(), f.size(), &vf);
  EXPECT_EQ(gaunt_zonal_convolve(n, 1, 1, &vk, &vf, &vf), GAUNT_OK);
  return f;
}

std::vector<float> Delta(uint32_t n, const float* direction) {
  std::vector<float> y(n * n);
  gaunt_view vd, vy;
  gaunt_view_interleaved(const_cast<float*>(direction), 3, &vd);
  gaunt_view_interleaved(y.data(), y.size(), &vy);
  EXPECT_EQ(gaunt_basis_eval(n, 1, &vd, &vy), GAUNT_OK);
  return y;
}

// Every unrolled order, and some of those that are not.
const std::vector<uint32_t> kOrders = {1, 2, 3, 4, 5, 6, 7, 8, 11};

class Zonal : public TargetTest {};

TEST_P(Zonal, RotateMatchesTheDefinitionInEveryLayout) {
  for (const uint32_t n : kOrders) {
    for (const uint32_t channels : {1u, 3u}) TestBatches(RotateOperation(n, channels));
  }
  for (const uint32_t n : {2u, 3u, 6u, 7u}) TestBatches(RotateOperation(n, 4));
  TestBatches(RotateOperation(3, 2));
}

TEST_P(Zonal, RotateAddMatchesTheDefinitionInEveryLayout) {
  for (const uint32_t n : kOrders) {
    for (const uint32_t channels : {1u, 3u}) TestBatches(AddOperation(n, channels));
  }
  for (const uint32_t n : {2u, 3u, 6u, 7u}) TestBatches(AddOperation(n, 4));
}

TEST_P(Zonal, ConvolveMatchesTheDefinitionInEveryLayout) {
  for (const uint32_t n : kOrders) {
    for (const uint32_t channels : {1u, 3u}) TestBatches(ConvolveOperation(n, channels));
  }
  for (const uint32_t n : {2u, 3u, 6u, 7u}) TestBatches(ConvolveOperation(n, 4));
}

TEST_P(Zonal, RejectsWrongArguments) {
  for (const uint32_t n : {1u, 3u, 6u, 7u}) {
    TestErrors(RotateOperation(n, 3));
    TestErrors(ConvolveOperation(n, 3));
    Operation add = RotateOperation(n, 3);
    add.name = "zonal_rotate_add";
    add.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
      return gaunt_zonal_rotate_add(n, 3, count, in[0], in[1], out[0]);
    };
    TestErrors(add);
  }
  for (const auto function : {gaunt_zonal_rotate, gaunt_zonal_rotate_add, gaunt_zonal_convolve}) {
    EXPECT_EQ(function(0, 1, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_ORDER);
    EXPECT_EQ(function(65, 1, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_ORDER);
    EXPECT_EQ(function(3, 0, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_RANGE);
    EXPECT_EQ(function(3, 5, 0, nullptr, nullptr, nullptr), GAUNT_ERROR_RANGE);
  }
  // A view that has as many planes as the output is still no place for it.
  float z[1] = {0.5f}, d[3] = {0, 0, 1}, f[1] = {2.0f};
  gaunt_view vz, vd, vf;
  gaunt_view_interleaved(z, 1, &vz);
  gaunt_view_interleaved(d, 3, &vd);
  gaunt_view_interleaved(f, 1, &vf);
  EXPECT_EQ(gaunt_zonal_rotate(1, 1, 1, &vz, &vd, &vz), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(gaunt_zonal_rotate_add(1, 1, 1, &vz, &vd, &vz), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(gaunt_zonal_convolve(1, 1, 1, &vz, &vf, &vz), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(z[0], 0.5f);
}

// The highest order, few items: the reference is slow there.
TEST_P(Zonal, ReachesOrder64) {
  constexpr uint32_t n = 64;
  constexpr size_t kCount = 18;
  const Operation operation = AddOperation(n, 1);
  std::vector<Buffer> in;
  in.emplace_back(Layout::kInterleaved, kCount, operation.inputs[0]);
  in.emplace_back(Layout::kTiled, kCount, operation.inputs[1]);
  in.emplace_back(Layout::kPlanar, kCount, operation.inputs[2]);
  Buffer added(Layout::kPlanar, kCount, n * n), set(Layout::kTiled, kCount, n * n);
  Random random(17);
  std::vector<Operation::Item> items(kCount, Operation::Item(in.size()));
  for (size_t i = 0; i < kCount; ++i) {
    for (size_t side = 0; side < in.size(); ++side) {
      std::vector<float> planes(operation.inputs[side]);
      operation.make(random, side, planes.data());
      items[i][side].assign(planes.begin(), planes.end());
      for (size_t p = 0; p < planes.size(); ++p) in[side].Set(i, p, planes[p]);
    }
  }
  ASSERT_EQ(operation.call(kCount, {in[0].view(), in[1].view(), in[2].view()}, {added.view()}),
            GAUNT_OK);
  ASSERT_EQ(gaunt_zonal_rotate(n, 1, kCount, in[0].view(), in[1].view(), set.view()), GAUNT_OK);
  for (const size_t i : {size_t{0}, kCount - 1}) {
    Operation::Item wanted = {std::vector<double>(n * n)};
    operation.reference(items[i], wanted);
    for (size_t p = 0; p < n * n; ++p) {
      const double tolerance = operation.tolerance(items[i], wanted, 0, p);
      ASSERT_NEAR(added.Get(i, p), wanted[0][p], tolerance) << i << " " << p;
      ASSERT_NEAR(set.Get(i, p), wanted[0][p] - items[i][2][p], tolerance) << i << " " << p;
    }
  }
}

// Outputs that are streamed past the caches are the same, to the bit and to the edge.
TEST_P(Zonal, LargeOutputsAreTheSame) {
  constexpr uint32_t kChannels = 3;
  for (const uint32_t n : {3u, 7u}) {
    const size_t planes = kChannels * n * n;
    const size_t count = (size_t{33} << 20) / (planes * sizeof(float)) + 21;
    for (const Layout layout : {Layout::kTiled, Layout::kInterleaved}) {
      SCOPED_TRACE(Name(layout) + " " + std::to_string(n));
      Buffer zonal(layout, count, kChannels * n), direction(layout, count, 3);
      Buffer out(layout, count, planes, Start::kLine);
      Random random(5);
      float d[3], z[kChannels * 7];
      for (size_t i = 0; i < count; ++i) {
        random.Direction(d);
        for (size_t k = 0; k < 3; ++k) direction.Set(i, k, d[k]);
        for (size_t p = 0; p < kChannels * n; ++p) zonal.Set(i, p, random.Between(-1.0, 1.0));
      }
      ASSERT_EQ(gaunt_zonal_rotate(n, kChannels, count, zonal.view(), direction.view(), out.view()),
                GAUNT_OK);
      ASSERT_TRUE(out.CanariesIntact());
      const auto wanted = [&](size_t i) {
        for (size_t k = 0; k < 3; ++k) d[k] = direction.Get(i, k);
        for (size_t p = 0; p < kChannels * n; ++p) z[p] = zonal.Get(i, p);
        return RotateOne(n, kChannels, z, d);
      };
      const auto step = [&](size_t i) { return i + 50 < count ? size_t{997} : size_t{1}; };
      for (size_t i = 0; i < count; i += step(i)) {
        const std::vector<float> one = wanted(i);
        for (size_t p = 0; p < planes; ++p) ASSERT_EQ(out.Get(i, p), one[p]) << i << " " << p;
      }
      ASSERT_EQ(
          gaunt_zonal_rotate_add(n, kChannels, count, zonal.view(), direction.view(), out.view()),
          GAUNT_OK);
      for (size_t i = 0; i < count; i += step(i)) {
        const std::vector<float> one = wanted(i);
        for (size_t p = 0; p < planes; ++p) {
          ASSERT_NEAR(out.Get(i, p), 2.0f * one[p], 2e-7) << i << " " << p;
        }
      }
      ASSERT_TRUE(out.CanariesIntact());
      std::vector<float> unit(n);
      for (uint32_t l = 0; l < n; ++l) {
        unit[l] = static_cast<float>(std::sqrt((2.0 * l + 1.0) / (4.0 * kPi)));
      }
      gaunt_view kernel;
      gaunt_view_broadcast(unit.data(), &kernel);
      ASSERT_EQ(gaunt_zonal_convolve(n, kChannels, count, &kernel, out.view(), out.view()),
                GAUNT_OK);
      for (size_t i = 0; i < count; i += step(i)) {
        const std::vector<float> one = wanted(i);
        for (size_t p = 0; p < planes; ++p) {
          ASSERT_NEAR(out.Get(i, p), 2.0f * one[p], 1e-6) << i << " " << p;
        }
      }
      ASSERT_TRUE(out.CanariesIntact());
    }
  }
}

// At +z the coefficients of the function itself, and nothing else.
TEST_P(Zonal, StaysWhereItIsAtZ) {
  Random random(4);
  const float z_axis[3] = {0.0f, 0.0f, 1.0f};
  for (const uint32_t n : {1u, 2u, 3u, 4u, 5u, 6u, 10u, 64u}) {
    std::vector<float> z(n);
    random.Fill(z.data(), n, -1.0, 1.0);
    const std::vector<float> out = RotateOne(n, 1, z.data(), z_axis);
    for (size_t i = 0; i < out.size(); ++i) {
      const int l = BandOfPlane(n, i);
      const bool zonal = i == static_cast<size_t>(l * (l + 1));
      const float wanted = zonal ? z[static_cast<size_t>(l)] : 0.0f;
      ASSERT_NEAR(out[i], wanted, zonal ? RotateTolerance(n, l) * std::abs(wanted) : 0.0) << i;
    }
  }
}

TEST_P(Zonal, UnitKernelIsTheIdentity) {
  Random random(8);
  for (const uint32_t n : {1u, 3u, 6u, 9u, 64u}) {
    std::vector<float> kernel(n), f(n * n);
    random.Fill(f.data(), f.size(), -1.0, 1.0);
    for (uint32_t l = 0; l < n; ++l) {
      kernel[l] = static_cast<float>(std::sqrt((2.0 * l + 1.0) / (4.0 * kPi)));
    }
    const std::vector<float> out = ConvolveOne(n, kernel, f);
    for (size_t i = 0; i < f.size(); ++i) ASSERT_NEAR(out[i], f[i], 2.4e-7 * std::abs(f[i]));
  }
}

// A delta at d, convolved with h, is h turned to d.
TEST_P(Zonal, RotationConvolvesADelta) {
  Random random(9);
  for (const uint32_t n : {1u, 3u, 6u, 9u, 64u}) {
    for (int trial = 0; trial < 20; ++trial) {
      float d[3];
      random.Direction(d);
      std::vector<float> h(n);
      random.Fill(h.data(), n, -1.0, 1.0);
      const std::vector<float> turned = RotateOne(n, 1, h.data(), d);
      const std::vector<float> convolved = ConvolveOne(n, h, Delta(n, d));
      for (size_t i = 0; i < turned.size(); ++i) {
        const int l = BandOfPlane(n, i);
        ASSERT_NEAR(turned[i], convolved[i],
                    RotateTolerance(n, l) * std::abs(h[static_cast<size_t>(l)]))
            << n << " " << i;
      }
    }
  }
}

// A cosine lobe at d is A_l y_lm(d), both of them golden.
TEST_P(Zonal, CosineLobeMatchesGoldenValues) {
  std::vector<float> lobe;
  std::vector<double> a;
  for (const auto& row : ReadGolden("zh_clamped_cosine.csv")) {
    a.push_back(std::stod(row[1]));
    lobe.push_back(static_cast<float>(std::stod(row[3])));
  }
  ASSERT_GE(lobe.size(), 16u);
  const struct {
    const char* file;
    uint32_t n;
  } files[] = {{"basis_order6.csv", 3}, {"basis_order6.csv", 6}, {"basis_order16.csv", 16}};
  for (const auto& [file, n] : files) {
    for (const auto& row : ReadGolden(file)) {
      float d[3];
      for (size_t k = 0; k < 3; ++k) d[k] = static_cast<float>(std::stod(row[k]));
      const std::vector<float> turned = RotateOne(n, 1, lobe.data(), d);
      const std::vector<float> convolved = ConvolveOne(n, lobe, Delta(n, d));
      for (size_t i = 0; i < turned.size(); ++i) {
        const size_t l = static_cast<size_t>(BandOfPlane(n, i));
        const double wanted = a[l] * std::stod(row[3 + i]);
        // Rounding the direction to float moves y_lm as well.
        const double tolerance =
            2.0 * RotateTolerance(n, static_cast<int>(l)) * std::abs(double{lobe[l]});
        ASSERT_NEAR(turned[i], wanted, tolerance) << file << " coefficient " << i;
        ASSERT_NEAR(convolved[i], wanted, tolerance) << file << " coefficient " << i;
      }
    }
  }
}

TEST_P(Zonal, ConvolutionIsTheIntegral) {
  Random random(10);
  for (const uint32_t n : {1u, 2u, 4u, 6u, 7u}) {
    std::vector<float> h(n), f(n * n);
    random.Fill(h.data(), n, -1.0, 1.0);
    random.Fill(f.data(), f.size(), -1.0, 1.0);
    std::vector<double> wanted(n * n);
    const std::vector<double> kernel(h.begin(), h.end()), in(f.begin(), f.end());
    zonal::ConvolveReference(static_cast<int>(n), kernel.data(), in.data(), wanted.data());
    const std::vector<float> out = ConvolveOne(n, h, f);
    for (size_t i = 0; i < f.size(); ++i) {
      ASSERT_NEAR(out[i], wanted[i], kConvolveTolerance * std::abs(wanted[i]) + 1e-13) << n;
    }
  }
}

TEST(ZonalBits, AreTheSameOnTargetsOfAClass) {
  for (const uint32_t n : kOrders) {
    for (const uint32_t channels : {1u, 3u}) TestSameBits(RotateOperation(n, channels));
    TestSameBits(AddOperation(n, 3));
    TestSameBits(ConvolveOperation(n, 3));
  }
}

GAUNT_INSTANTIATE_TARGETS(Zonal);

}  // namespace
}  // namespace gaunt::test
