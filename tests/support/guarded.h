// SPDX-License-Identifier: MIT
// Memory that ends right before a page that must not be touched: reading or writing one byte beyond
// ends the test, with or without sanitizers.
#ifndef GAUNT_TESTS_SUPPORT_GUARDED_H_
#define GAUNT_TESTS_SUPPORT_GUARDED_H_

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>

namespace gaunt::test {

class GuardedBytes {
 public:
  explicit GuardedBytes(size_t bytes) {
    const size_t page = static_cast<size_t>(sysconf(_SC_PAGESIZE));
    const size_t body = (bytes + page - 1) / page * page;
    size_ = body + page;
    memory_ = static_cast<char*>(
        mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
    mprotect(memory_ + body, page, PROT_NONE);
    data_ = memory_ + body - bytes;
  }
  ~GuardedBytes() { munmap(memory_, size_); }
  GuardedBytes(const GuardedBytes&) = delete;
  GuardedBytes& operator=(const GuardedBytes&) = delete;

  char* data() const { return data_; }

 private:
  char* memory_;
  size_t size_;
  char* data_;
};

class GuardedFloats {
 public:
  explicit GuardedFloats(size_t floats) : bytes_(floats * sizeof(float)) {}
  float* data() const { return reinterpret_cast<float*>(bytes_.data()); }

 private:
  GuardedBytes bytes_;
};

}  // namespace gaunt::test

#endif  // GAUNT_TESTS_SUPPORT_GUARDED_H_
