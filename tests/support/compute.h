// SPDX-License-Identifier: MIT
// Compute shaders without a window or a GPU: OpenGL ES 3.1 on Mesa's software renderer.
#ifndef GAUNT_TESTS_SUPPORT_COMPUTE_H_
#define GAUNT_TESTS_SUPPORT_COMPUTE_H_

#include <cstddef>
#include <memory>
#include <string>

namespace gaunt::test {

class Compute {
 public:
  // Null, and a reason, where there is no such context.
  static std::unique_ptr<Compute> Open(std::string* reason);
  ~Compute();
  Compute(const Compute&) = delete;
  Compute& operator=(const Compute&) = delete;

  // Who draws, such as "llvmpipe (LLVM 15.0.6, 256 bits)".
  const std::string& renderer() const { return renderer_; }

  // Runs a compute shader (GLSL ES 3.10) over work groups in one dimension. The storage buffer of
  // binding 0 holds `in`, that of binding 1 `out`. Returns what went wrong, or nothing.
  std::string Run(const std::string& source, size_t groups, const void* in, size_t in_bytes,
                  void* out, size_t out_bytes) const;

 private:
  Compute() = default;

  // EGLDisplay and EGLContext, whose header drags in those of the window system.
  void* display_ = nullptr;
  void* context_ = nullptr;
  std::string renderer_;
};

}  // namespace gaunt::test

#endif  // GAUNT_TESTS_SUPPORT_COMPUTE_H_
