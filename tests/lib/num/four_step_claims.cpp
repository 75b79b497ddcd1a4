#include <complex>
#include <vector>

#include <railbook/num/four_step_fft.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::tests;

TEST_CASE("claim: complex transforms in four steps") {
  Claim claim("num::FourStepFft");
  RandomStream draw(62);
  // Up to 2,048 one row; then of an even and an odd number of rows, the last of them long columns.
  for (const std::size_t n :
       {1U, 2U, 7U, 96U, 2048U, 2062U, 4096U, 6000U, 6147U, 16384U, 65536U, 4106U}) {
    num::FourStepFft fft(n);
    const std::size_t columns = fft.columns();
    REQUIRE(fft.rows() * columns == n);
    std::vector<std::complex<double>> z(n);
    double norm = 0;
    const auto fill = [&] {
      for (std::size_t i = 0; i < n; ++i) fft.row(i / columns)[i % columns] = z[i];
    };
    for (auto& value : z) norm += std::norm(value = {draw(-1, 1), draw(-1, 1)});
    norm = std::sqrt(norm * static_cast<double>(n));
    fill();
    std::vector<std::complex<double>> found(n);
    fft.forward([&](std::size_t r, std::span<const std::complex<double>> coefficients) {
      for (std::size_t c = 0; c < columns; ++c) found[fft.wave_number(r, c)] = coefficients[c];
    });
    for (int i = 0; i < 60; ++i) {
      const auto k = static_cast<std::size_t>(draw(0, static_cast<double>(n)));
      std::complex<Long> sum = 0;
      for (std::size_t j = 0; j < n; ++j) {
        const Long turn = -2 * long_pi * static_cast<Long>(j * k % n) / static_cast<Long>(n);
        sum += std::complex<Long>(z[j]) * std::complex<Long>(std::cos(turn), std::sin(turn));
      }
      claim.error(static_cast<double>(std::abs(std::complex<Long>(found[k]) - sum)) / norm);
    }
    // Forth, each coefficient turned as by a shift of one sample, and back.
    fill();
    fft.filter([&](std::size_t r, std::span<std::complex<double>> coefficients) {
      for (std::size_t c = 0; c < columns; ++c)
        coefficients[c] *= std::polar(1.0, -2 * static_cast<double>(long_pi) *
                                               static_cast<double>(fft.wave_number(r, c)) /
                                               static_cast<double>(n));
    });
    for (int i = 0; i < 60; ++i) {
      const auto j = static_cast<std::size_t>(draw(0, static_cast<double>(n))), to = (j + 1) % n;
      const auto back = fft.row(to / columns)[to % columns] / static_cast<double>(n);
      claim.error(std::abs(back - z[j]) / norm);
    }
  }
}
