// Convolution of a real array with a kernel that is even in both directions, by Fourier transforms.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include <railbook/num/frame_fft.hpp>

namespace railbook::num {

// out = filter * in for arrays of `rows` x `columns` (row major) in a periodic frame of at least
// that size, zero around the array: see FrameFft. The filter's transform is real and even, so a
// quarter of it is held.
//
// Errors are of the order of rounding, 2e-15 of the largest value and kernel times the number of
// values.
class EvenFilter {
 public:
  EvenFilter(std::size_t rows, std::size_t columns, std::size_t frame_rows,
             std::size_t frame_columns, int threads = 1);
  ~EvenFilter();
  EvenFilter(EvenFilter&&) noexcept;
  EvenFilter& operator=(EvenFilter&&) noexcept;

  std::size_t frame_rows() const;
  std::size_t frame_columns() const;
  // The values at wave numbers v = 0 .. frame_rows/2 down the columns and u = 0 .. frame_columns/2
  // along the rows; before transform_kernel(), the kernel at these distances. Zero at first.
  double& at(std::size_t v, std::size_t u);
  void transform_kernel();

  // Complex numbers that apply() works on, rows x (frame_columns/2 + 1); filters may share them.
  std::size_t workspace() const;
  // Aligned as `Workspace` is. `in` and `out` may be the same.
  void apply(const double* in, double* out, double* workspace) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace railbook::num
