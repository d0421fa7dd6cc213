// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>

#include "bench/product_axial_bench.h"
#include "bench/product_baseline.h"
#include "bench/product_stability.h"
#include "bench/support.h"
#include "product/methods/methods.h"
#include "product/product_reference.h"

namespace gaunt::bench {
namespace {

namespace methods = product::methods;

constexpr double kPi = 3.14159265358979323846;
// Norms of factors whose product has a norm of about 1, whatever the orders: errors are relative.
// One has the norm 1, the other the mean square 1; a function and itself are correlated.
const double kNorms[] = {1.0, std::sqrt(4.0 * kPi)};
const double kNormOfSquared = std::pow(4.0 * kPi / 3.0, 0.25);

// All bands alike, each channel of a norm.
void MakeFunction(size_t item, size_t side, size_t planes, size_t channels, double norm,
                  float* out) {
  for (size_t c = 0; c < channels; ++c, out += planes) {
    double squared = 0.0;
    for (size_t p = 0; p < planes; ++p) {
      const size_t seed = (item + 1) * (7 * p + 1) + 131 * side + 37 * c;
      out[p] = static_cast<float>(std::sin(static_cast<double>(seed)));
      squared += double{out[p]} * double{out[p]};
    }
    const double scale = norm / std::sqrt(squared);
    for (size_t p = 0; p < planes; ++p) out[p] = static_cast<float>(scale * out[p]);
  }
}

struct ProductCase {
  uint32_t a, b, out, channels;

  bool is_plain() const { return a == b && b == out; }
  std::string variant() const { return channels == 1 ? "mono" : "rgb"; }
  // Of a row of operations.
  std::string order() const {
    if (is_plain()) return std::to_string(a);
    return std::to_string(a) + "x" + std::to_string(b) + "->" + std::to_string(out);
  }
  // family/op/n<order>; mixed orders are a part of the operation, and n is the largest of them.
  std::string Name(std::string op) const {
    if (!is_plain()) {
      op += "_" + std::to_string(a) + "x" + std::to_string(b) + "to" + std::to_string(out);
    }
    return "product/" + op + "_" + variant() + "/n" + std::to_string(std::max({a, b, out}));
  }
  size_t PlanesOf(uint32_t n) const { return size_t{channels} * n * n; }

  auto MakeInputs() const {
    return [*this](size_t item, size_t side, float* to) {
      const uint32_t n = side == 0 ? a : b;
      MakeFunction(item, side, n * n, channels, kNorms[side], to);
    };
  }
  Reference MakeReference() const {
    return [*this](const std::vector<const double*>& in, double* to) {
      for (uint32_t c = 0; c < channels; ++c) {
        product::ProductReference(static_cast<int>(a), static_cast<int>(b), static_cast<int>(out),
                                  in[0] + c * a * a, in[1] + c * b * b, to + c * out * out);
      }
    };
  }
};

ProductCase Plain(int n) {
  const auto order = static_cast<uint32_t>(n);
  return {order, order, order, 1};
}

// Rows of the same orders and channels have the same inputs. Labels are of one channel only: these
// are charted.
BatchBenchmark MakeBatch(const ProductCase& product, const std::string& op,
                         const std::string& counted, const std::string& counted_variant) {
  BatchBenchmark batch;
  batch.name = product.Name(op);
  batch.operations =
      uint64_t{product.channels} * OperationsOf(counted, product.order(), counted_variant);
  batch.inputs = {product.PlanesOf(product.a), product.PlanesOf(product.b)};
  batch.outputs = {product.PlanesOf(product.out)};
  batch.make = product.MakeInputs();
  batch.reference = product.MakeReference();
  return batch;
}

void RegisterProduct(const ProductCase& product) {
  BatchBenchmark batch = MakeBatch(product, "product", "product", "fast");
  batch.call = [=](size_t count, const BatchBenchmark::Views& in,
                   const BatchBenchmark::Views& out) {
    return gaunt_product(product.a, product.b, product.out, product.channels, count, in[0], in[1],
                         out[0]);
  };
  if (product.channels == 1 && product.is_plain()) batch.label = "two functions: kernel";
  batch.large = product.channels == 1 && product.is_plain() && (product.a == 3 || product.a == 6);
  RegisterBatch(batch);
}

void RegisterSquare(int n) {
  const ProductCase product = Plain(n);
  BatchBenchmark batch = MakeBatch(product, "square", "product_square", "fast");
  batch.inputs = {product.PlanesOf(product.a)};
  batch.make = [=](size_t item, size_t side, float* to) {
    MakeFunction(item, side, product.a * product.a, 1, kNormOfSquared, to);
  };
  batch.reference = [=](const std::vector<const double*>& in, double* to) {
    product::ProductReference(n, n, n, in[0], in[0], to);
  };
  batch.call = [=](size_t count, const BatchBenchmark::Views& in,
                   const BatchBenchmark::Views& out) {
    return gaunt_product_square(product.a, product.out, 1, count, in[0], out[0]);
  };
  batch.label = "square: kernel";
  RegisterBatch(batch);
}

// What is made of a function once, and again only when it has changed.
template <class Made>
class Prepared {
 public:
  template <class Make>
  const Made& Of(const float* f, size_t planes, const Make& make) {
    if (f_.empty() || !std::equal(f_.begin(), f_.end(), f)) {
      f_.assign(f, f + planes);
      made_ = make();
    }
    return made_;
  }

 private:
  std::vector<float> f_;
  Made made_;
};

// One function for all items.
void RegisterPrepared(int n) {
  const ProductCase product = Plain(n);
  BatchBenchmark batch = MakeBatch(product, "prepared", "product_prepared", "fast");
  batch.broadcast = {0};
  batch.call = [=, made = std::make_shared<Prepared<std::vector<unsigned char>>>()](
                   size_t count, const BatchBenchmark::Views& in,
                   const BatchBenchmark::Views& out) {
    const auto& op = made->Of(in[0]->data, batch.inputs[0], [&] {
      size_t size = 0;
      gaunt_product_prepare(product.a, product.b, product.out, in[0], nullptr, &size);
      std::vector<unsigned char> bytes(size);
      gaunt_product_prepare(product.a, product.b, product.out, in[0], bytes.data(), &size);
      return bytes;
    });
    return gaunt_product_apply(op.data(), op.size(), 1, count, in[1], out[0]);
  };
  batch.label = "one function for all: kernel";
  RegisterBatch(batch);
}

simd::InView InputOf(const gaunt_view& view) {
  return {reinterpret_cast<const unsigned char*>(view.data), view.item_stride, view.plane_stride,
          view.tile_stride, view.tile_items};
}
simd::OutView OutputOf(const gaunt_view& view) {
  return {reinterpret_cast<unsigned char*>(view.data), view.item_stride, view.plane_stride,
          view.tile_stride, view.tile_items};
}

using MethodOf = std::function<methods::MethodFn()>;  // of the chosen target

void RegisterMethod(int n, const std::string& op, const MethodOf& method,
                    const std::string& label) {
  BatchBenchmark batch = MakeBatch(Plain(n), op, "product", op);
  batch.call = [=](size_t count, const BatchBenchmark::Views& in,
                   const BatchBenchmark::Views& out) {
    method()(count, InputOf(*in[0]), InputOf(*in[1]), OutputOf(*out[0]));
    return gaunt_status{GAUNT_OK};
  };
  batch.label = label;
  RegisterBatch(batch);
}

void RegisterMethods(int n) {
  if (n <= methods::sparse::kMaxOrder) {
    RegisterMethod(
        n, "by_output", [n] { return methods::sparse::Kernels().by_output[n]; },
        "two functions: sparse by output");
    RegisterMethod(
        n, "by_pairs", [n] { return methods::sparse::Kernels().by_pairs[n]; },
        "two functions: sparse by pairs");
  }
  for (int level = 0; level < methods::levels::kLevels && n <= methods::levels::kMaxOrder;
       ++level) {
    const std::string name = std::to_string(level);
    RegisterMethod(
        n, "grid" + name, [=] { return methods::levels::Kernels().product[level][n]; },
        "two functions: grid, level " + name);
  }
  BatchBenchmark batch = MakeBatch(Plain(n), "prepared_matrix", "product_prepared", "matrix");
  batch.broadcast = {0};
  batch.call = [=, made = std::make_shared<Prepared<std::vector<float>>>()](
                   size_t count, const BatchBenchmark::Views& in,
                   const BatchBenchmark::Views& out) {
    const auto& matrix = made->Of(in[0]->data, batch.inputs[0],
                                  [&] { return methods::dense::MatrixOf(n, in[0]->data); });
    methods::dense::Kernels().apply[n](matrix.data(), count, InputOf(*in[1]), OutputOf(*out[0]));
    return gaunt_status{GAUNT_OK};
  };
  batch.label = "one function for all: matrix";
  RegisterBatch(batch);
}

void RegisterBaseline(int n, const std::string& op, const std::string& baseline,
                      const decltype(ScalarBenchmark::call)& call, const std::string& label) {
  const ProductCase product = Plain(n);
  ScalarBenchmark scalar;
  scalar.name = product.Name(op);
  scalar.baseline = baseline;
  scalar.inputs = {product.PlanesOf(product.a), product.PlanesOf(product.b)};
  scalar.output = product.PlanesOf(product.out);
  if (op == "prepared") scalar.broadcast = {0};
  scalar.call = call;
  scalar.make = product.MakeInputs();
  scalar.reference = product.MakeReference();
  scalar.label = label;
  RegisterScalar(scalar);
}

void RegisterBaselines(int n) {
  using Pointers = std::vector<const float*>;
  RegisterBaseline(
      n, "product", "table",
      [=](size_t count, const Pointers& in, float* out) {
        ProductByTable(n, count, in[0], in[1], out);
      },
      "two functions: scalar loop over a table");
  if (n <= kMaxPairsOrder) {
    RegisterBaseline(
        n, "product", "pairs",
        [=](size_t count, const Pointers& in, float* out) {
          ProductByPairs(n)(count, in[0], in[1], out);
        },
        "two functions: scalar pairs, as D3DX");
  }
  RegisterBaseline(
      n, "prepared", "matrix",
      [=, made = std::make_shared<Prepared<std::vector<float>>>()](
          size_t count, const Pointers& in, float* out) {
        const auto& matrix = made->Of(in[0], static_cast<size_t>(n * n),
                                      [&] { return methods::dense::MatrixOf(n, in[0]); });
        ProductByMatrix(n, matrix.data(), count, in[1], out);
      },
      "one function for all: scalar matrix");
}

}  // namespace

GAUNT_BENCHMARKS(product) {
  for (int n = methods::kMinOrder; n <= product::kMaxOrder; ++n) {
    RegisterProduct(Plain(n));
    RegisterSquare(n);
    RegisterPrepared(n);
    RegisterMethods(n);
    RegisterBaselines(n);
  }
  for (const uint32_t n : {3u, 6u}) RegisterProduct({n, n, n, 3});
  for (const auto& [a, b, out] :
       {std::tuple(2u, 6u, 6u), {3u, 6u, 6u}, {6u, 6u, 3u}, {6u, 6u, 4u}, {6u, 6u, 11u}}) {
    RegisterProduct({a, b, out, 1});
  }
  RegisterAxialProducts();
  RegisterProductStability();
}

}  // namespace gaunt::bench
