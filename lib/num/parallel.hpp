// Loops on several threads whose results do not depend on their number.
#pragma once

#include <algorithm>
#include <cstddef>
#include <system_error>
#include <thread>
#include <vector>

namespace railbook::num {

// Calls work(begin, end, part) on up to `threads` threads, the calling one among them, for parts that together make
// 0 .. count, and returns when all are done. Each part number < `threads` is given once. The parts depend on `threads`:
// `work` must do each item for itself, and must not throw. Threads that the system refuses are done without.
template <class Work>
void in_parallel(int threads, std::size_t count, const Work& work) {
  const std::size_t parts = std::clamp<std::size_t>(static_cast<std::size_t>(std::max(threads, 1)),
                                                    1, std::max<std::size_t>(count, 1));
  const auto part = [&](std::size_t k) { work(count * k / parts, count * (k + 1) / parts, k); };
  std::vector<std::jthread> others;  // joined where it goes out of scope
  std::size_t k = 1;
  try {
    for (; k < parts; ++k) others.emplace_back(part, k);
  } catch (const std::system_error&) {
    for (; k < parts; ++k) part(k);
  }
  part(0);
}

// The sum, or another reduction, of items 0 .. count: reduce(begin, end) of blocks that do not depend on `threads`,
// put together by `join` in their order.
template <class Reduce, class Join>
double reduce_in_blocks(int threads, std::size_t count, const Reduce& reduce, const Join& join) {
  constexpr std::size_t block = 1 << 14;
  const std::size_t blocks = (count + block - 1) / block;
  std::vector<double> found(blocks);
  in_parallel(threads, blocks, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t k = begin; k < end; ++k)
      found[k] = reduce(k * block, std::min(count, (k + 1) * block));
  });
  double result = 0;
  for (const double value : found) result = join(result, value);
  return result;
}

}  // namespace railbook::num
