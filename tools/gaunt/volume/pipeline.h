// SPDX-License-Identifier: MIT
// Blocks of a stream that several threads work on, read and written in order.
#ifndef GAUNT_TOOLS_GAUNT_VOLUME_PIPELINE_H_
#define GAUNT_TOOLS_GAUNT_VOLUME_PIPELINE_H_

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace gaunt::tool {

// Each thread has one Slot, which holds a block; memory does not depend on the number of blocks.
// Neither does the result depend on the number of threads, nor which of several errors is thrown:
// that of the first block.
template <class Slot>
class Pipeline {
 public:
  // read returns false at the end of the stream. read and write are called for one block after the
  // other, work for several at once; all may throw.
  Pipeline(std::function<bool(Slot&)> read, std::function<void(Slot&)> work,
           std::function<void(Slot&)> write)
      : read_(std::move(read)), work_(std::move(work)), write_(std::move(write)) {}

  void Run(uint64_t threads) {
    std::vector<std::thread> others;
    try {
      for (uint64_t t = 1; t < threads; ++t) others.emplace_back([this] { HandleBlocks(); });
    } catch (const std::system_error&) {  // the system has no more: these do it all
    }
    HandleBlocks();
    for (std::thread& thread : others) thread.join();
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void HandleBlocks() {
    Slot slot;
    while (HandleBlock(slot)) {
    }
  }

  bool HandleBlock(Slot& slot) {
    uint64_t block;
    {
      const std::lock_guard<std::mutex> lock(reading_);
      if (ended_) return false;
      block = blocks_read_;
      try {
        ended_ = !read_(slot);
      } catch (...) {
        ended_ = true;
        Fail(block);
      }
      if (ended_) return false;
      ++blocks_read_;
    }
    try {
      work_(slot);
      std::unique_lock<std::mutex> lock(writing_);
      turns_.wait(lock, [&] { return blocks_written_ == block || first_failed_ < block; });
      if (first_failed_ < block) return false;
      write_(slot);
      ++blocks_written_;
    } catch (...) {
      Fail(block);
      const std::lock_guard<std::mutex> lock(reading_);
      ended_ = true;
      return false;
    }
    turns_.notify_all();
    return true;
  }

  void Fail(uint64_t block) {
    {
      const std::lock_guard<std::mutex> lock(writing_);
      if (block < first_failed_) {
        first_failed_ = block;
        error_ = std::current_exception();
      }
    }
    turns_.notify_all();
  }

  std::function<bool(Slot&)> read_;
  std::function<void(Slot&)> work_, write_;
  std::mutex reading_;
  bool ended_ = false;
  uint64_t blocks_read_ = 0;
  std::mutex writing_;
  std::condition_variable turns_;
  uint64_t blocks_written_ = 0;
  uint64_t first_failed_ = UINT64_MAX;
  std::exception_ptr error_;
};

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_VOLUME_PIPELINE_H_
