// Loops on several threads whose results do not depend on their number.
#pragma once

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <cstddef>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>

namespace railbook::num {

// Calls work(begin, end, part) on up to `threads` threads, the calling one among them, for parts
// that together make 0 .. count, and returns when all are done. Each part number < `threads` is
// given once. The parts depend on `threads`: `work` must do each item for itself, and must not
// throw. Threads that the system refuses are done without. An invalid operation or a division by
// zero on another thread leaves its mark on the calling one, too (fp_flags.hpp).
template <class Work>
void in_parallel(int threads, std::size_t count, const Work& work) {
  const std::size_t parts = std::clamp<std::size_t>(static_cast<std::size_t>(std::max(threads, 1)),
                                                    1, std::max<std::size_t>(count, 1));
  const auto part = [&](std::size_t k) { work(count * k / parts, count * (k + 1) / parts, k); };
  std::atomic<int> raised = 0;
  {
    std::vector<std::jthread> others;  // joined where it goes out of scope
    std::size_t k = 1;
    try {
      for (; k < parts; ++k)
        others.emplace_back([&, k] {
          part(k);
          raised |= std::fetestexcept(FE_INVALID | FE_DIVBYZERO);
        });
    } catch (const std::system_error&) {
      for (; k < parts; ++k) part(k);
    }
    part(0);
  }
  std::feraiseexcept(raised);
}

// make(0) .. make(count - 1) in their order, each called on whichever of the threads is free (0: as
// many as run at once here): for items of unlike cost, whose results have a default constructor.
// They do not depend on `threads` as long as an item draws its random numbers by its own index.
// What the first item that fails throws is thrown when all are done.
template <class Make>
auto map_in_parallel(std::size_t count, const Make& make, int threads = 0) {
  std::vector<decltype(make(count))> made(count);
  std::vector<std::exception_ptr> failed(count);
  std::atomic<std::size_t> next{0};
  if (threads == 0) threads = static_cast<int>(std::thread::hardware_concurrency());
  const auto most = std::min(static_cast<std::size_t>(std::max(threads, 1)), count);
  in_parallel(threads, most, [&](std::size_t, std::size_t, std::size_t) {
    for (std::size_t i = 0; (i = next++) < count;) try {
        made[i] = make(i);
      } catch (...) {
        failed[i] = std::current_exception();
      }
  });
  for (const auto& error : failed)
    if (error) std::rethrow_exception(error);
  return made;
}

// The sum, or another reduction, of items 0 .. count: reduce(begin, end) of blocks that do not
// depend on `threads`, put together by `join` in their order.
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
