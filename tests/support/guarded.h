// SPDX-License-Identifier: MIT
// Memory that ends right before a page that must not be touched: reading or writing one byte beyond
// ends the test, with or without sanitizers.
#ifndef GAUNT_TESTS_SUPPORT_GUARDED_H_
#define GAUNT_TESTS_SUPPORT_GUARDED_H_

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>

namespace gaunt::test {

class GuardedFloats {
 public:
  explicit GuardedFloats(size_t floats) {
    const size_t page = static_cast<size_t>(sysconf(_SC_PAGESIZE));
    const size_t bytes = floats * sizeof(float);
    const size_t body = (bytes + page - 1) / page * page;
    size_ = body + page;
    memory_ = static_cast<char*>(
        mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
    mprotect(memory_ + body, page, PROT_NONE);
    data_ = reinterpret_cast<float*>(memory_ + body - bytes);
  }
  ~GuardedFloats() { munmap(memory_, size_); }
  GuardedFloats(const GuardedFloats&) = delete;
  GuardedFloats& operator=(const GuardedFloats&) = delete;

  float* data() const { return data_; }

 private:
  char* memory_;
  size_t size_;
  float* data_;
};

}  // namespace gaunt::test

#endif  // GAUNT_TESTS_SUPPORT_GUARDED_H_
