// A complex Fourier transform in steps that stay in the cache, for two real sequences at once: one
// is the real part of the samples, the other their imaginary part.
//
// Source: D. H. Bailey, FFTs in external or hierarchical memory, The Journal of Supercomputing 4
// (1990): samples in rows, a transform down each column, a turn of each value, a transform along
// each row; without the transposition that follows there.
#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>

namespace railbook::num {

// Of n samples, n >= 1, in rows of at most 2048; unnormalised, coefficients within 2e-15 of the
// norm of the samples times sqrt(n). Throws InputError for other n.
class FourStepFft {
 public:
  explicit FourStepFft(std::size_t n);
  ~FourStepFft();
  FourStepFft(FourStepFft&&) noexcept;
  FourStepFft& operator=(FourStepFft&&) noexcept;

  std::size_t rows() const;
  std::size_t columns() const;
  // Samples row * columns() and on; forward() leaves nothing of use there.
  std::span<std::complex<double>> row(std::size_t i);
  // The k of the coefficient sum of z_j exp(-2 pi i j k / n) that a row of coefficients has in this
  // column.
  std::size_t wave_number(std::size_t row, std::size_t column) const;

  // Hands out the coefficients, a row after the other.
  using Row = std::function<void(std::size_t row, std::span<std::complex<double>>)>;
  void forward(const Row& coefficients);
  // And transforms what `change` made of them back into the samples, times n. A real sequence stays
  // real where `change` multiplies by the transform of another.
  void filter(const Row& change);

 private:
  struct Parts;
  void transform_row(std::size_t row, const Row& visit);
  std::unique_ptr<Parts> parts_;
};

}  // namespace railbook::num
