// Real Fourier transforms on FFTW: plans and buffers that own themselves.
//
// All plans are made with FFTW_ESTIMATE: planning does not time anything, so the same machine code
// and the same digits come out on every run. Transforms are unnormalised: inverse(forward(x)) = n
// x. n >= 1.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>

namespace railbook::num {

// The smallest n' >= n of the form 2^a 3^b 5^c 7^d: sizes FFTW transforms fast. n >= 1.
std::size_t good_fft_size(std::size_t n);
// Likewise of the multiples of 4: an odd size takes FFTW twice as long.
inline std::size_t good_frame_size(std::size_t n) {
  return 4 * good_fft_size((n + 3) / 4);
}

// A one-dimensional real transform of length n, with its own aligned buffers. Coefficients are
// within 2e-15 of the norm of the samples times sqrt(n).
class RealFft {
 public:
  explicit RealFft(std::size_t n);
  ~RealFft();
  RealFft(RealFft&&) noexcept;
  RealFft& operator=(RealFft&&) noexcept;

  std::size_t size() const;
  std::span<double> real();                    // n samples
  std::span<std::complex<double>> spectrum();  // n/2 + 1 coefficients, exp(-2 pi i k j / n)
  void forward();                              // real -> spectrum; real is preserved
  void inverse();                              // spectrum -> real; spectrum is destroyed

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

// A one-dimensional complex transform of length n, unnormalised both ways; with the same accuracy.
// Two real sequences at once are its real and its imaginary part.
class ComplexFft {
 public:
  explicit ComplexFft(std::size_t n);
  ~ComplexFft();
  ComplexFft(ComplexFft&&) noexcept;
  ComplexFft& operator=(ComplexFft&&) noexcept;

  // n samples or coefficients, exp(-2 pi i k j / n); elsewhere after a transform.
  std::span<std::complex<double>> values();
  void forward();
  void inverse();

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

// A two-dimensional real transform of rows x columns (row major), in place to halve the memory:
// the spectrum has rows x (columns/2 + 1) coefficients and overlays the samples, so a row of
// samples has stride() = 2 (columns/2 + 1) doubles, of which the first `columns` count. Accurate as
// RealFft; rows, columns >= 1.
class RealFft2d {
 public:
  RealFft2d(std::size_t rows, std::size_t columns);
  ~RealFft2d();
  RealFft2d(RealFft2d&&) noexcept;
  RealFft2d& operator=(RealFft2d&&) noexcept;

  std::size_t rows() const;
  std::size_t columns() const;
  std::size_t stride() const;
  double* row(std::size_t i);
  std::span<double> real();                    // rows * stride
  std::span<std::complex<double>> spectrum();  // rows * (columns/2 + 1)
  void forward();
  void inverse();

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

}  // namespace railbook::num
