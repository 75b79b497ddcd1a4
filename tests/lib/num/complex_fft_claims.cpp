#include <algorithm>
#include <complex>
#include <vector>

#include <railbook/num/fft.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::tests;

TEST_CASE("claim: complex transforms, forth and back") {
  Claim claim("num::ComplexFft");
  RandomStream draw(62);
  for (const std::size_t n : {1U, 2U, 7U, 96U, 2048U, 2062U, 6147U, 65536U}) {
    num::ComplexFft fft(n);
    std::vector<std::complex<double>> z(n);
    double norm = 0;
    for (auto& value : z) norm += std::norm(value = {draw(-1, 1), draw(-1, 1)});
    norm = std::sqrt(norm * static_cast<double>(n));
    std::ranges::copy(z, fft.values().begin());
    fft.forward();
    for (int i = 0; i < 60; ++i) {
      const auto k = static_cast<std::size_t>(draw(0, static_cast<double>(n)));
      std::complex<Long> sum = 0;
      for (std::size_t j = 0; j < n; ++j) {
        const Long turn = -2 * long_pi * static_cast<Long>(j * k % n) / static_cast<Long>(n);
        sum += std::complex<Long>(z[j]) * std::complex<Long>(std::cos(turn), std::sin(turn));
      }
      claim.error(static_cast<double>(std::abs(std::complex<Long>(fft.values()[k]) - sum)) / norm);
    }
    fft.inverse();
    for (std::size_t j = 0; j < n; ++j)
      claim.error(std::abs(fft.values()[j] / static_cast<double>(n) - z[j]) / norm);
  }
}
