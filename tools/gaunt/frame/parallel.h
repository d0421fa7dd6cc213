// SPDX-License-Identifier: MIT
// Loops over all cores whose results do not depend on how many there are.
#ifndef GAUNT_TOOLS_GAUNT_FRAME_PARALLEL_H_
#define GAUNT_TOOLS_GAUNT_FRAME_PARALLEL_H_

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace gaunt::tool {

// Calls work(i) for i below count, in any order; progress, if any, from the calling thread.
inline void ParallelFor(int count, const std::function<void(int)>& work,
                        const std::function<void(double)>& progress = nullptr) {
  std::atomic<int> next{0};
  const auto run = [&](bool reports) {
    for (int i = next++; i < count; i = next++) {
      work(i);
      if (reports && progress) progress(static_cast<double>(i + 1) / count);
    }
  };
  std::vector<std::thread> threads;
  for (unsigned t = 1; t < std::thread::hardware_concurrency(); ++t) {
    threads.emplace_back(run, false);
  }
  run(true);
  for (std::thread& thread : threads) thread.join();
}

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_FRAME_PARALLEL_H_
