// The accuracy that lib/num states of its transforms, against sums in 80 bits.
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include <railbook/num/even_filter.hpp>
#include <railbook/num/fft.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::tests;

TEST_CASE("claim: good sizes of transforms") {
  Claim sizes("num::good_fft_size");
  for (std::size_t n = 1; n <= 2000; ++n) {
    std::size_t good = n;
    for (;; ++good) {
      std::size_t rest = good;
      for (const std::size_t f : {2U, 3U, 5U, 7U})
        while (rest % f == 0) rest /= f;
      if (rest == 1) break;
    }
    sizes.error(num::good_fft_size(n) == good ? 0 : 1);
  }
}

TEST_CASE("claim: transforms against the sum itself") {
  Claim real("num::RealFft"), filter_claim("num::EvenFilter");
  RandomStream draw(5);
  for (int k = 0; k < 1000; ++k) {
    const auto n = static_cast<std::size_t>(1 + k % 97);
    num::RealFft fft(n);
    std::vector<double> x(n);
    for (double& value : x) value = draw(-1, 1);
    std::copy(x.begin(), x.end(), fft.real().begin());
    fft.forward();
    const std::size_t bins = n / 2 + 1;
    const auto at = static_cast<std::size_t>(draw(0, static_cast<double>(bins)));
    Long re = 0, im = 0, square = 0;
    for (std::size_t j = 0; j < n; ++j) {
      const Long angle = 2 * long_pi * static_cast<Long>(j * at % n) / static_cast<Long>(n);
      re += x[j] * std::cos(angle), im -= x[j] * std::sin(angle), square += Long{x[j]} * x[j];
    }
    const auto found = fft.spectrum()[at];
    real.error(static_cast<double>(std::hypot(found.real() - re, found.imag() - im) /
                                   std::sqrt(square * static_cast<Long>(n))));

    const auto rows = static_cast<std::size_t>(1 + k % 5),
               columns = static_cast<std::size_t>(1 + k % 7);
    num::EvenFilter filter(rows, columns, 2 * rows, 2 * columns + 1);
    std::vector<double> kernel(rows * columns), in(kernel), out(kernel);
    for (double& value : kernel) value = draw(-1, 1);
    for (double& value : in) value = draw(-1, 1);
    for (std::size_t v = 0; v < rows; ++v)
      for (std::size_t u = 0; u < columns; ++u) filter.at(v, u) = kernel[v * columns + u];
    filter.transform_kernel();
    num::Workspace space(filter.workspace());
    filter.apply(in.data(), out.data(), space.data());
    const auto apart = [](std::size_t a, std::size_t b) { return a > b ? a - b : b - a; };
    double off = 0;
    for (std::size_t i = 0; i < in.size(); ++i) {
      Long sum = 0;
      for (std::size_t j = 0; j < in.size(); ++j)
        sum += Long{in[j]} *
               kernel[apart(i / columns, j / columns) * columns + apart(i % columns, j % columns)];
      off = std::max(off, static_cast<double>(std::abs(out[i] - sum)));
    }
    filter_claim.error(off / static_cast<double>(in.size()));
  }
}

TEST_CASE("claim: a transform of two dimensions against the sum itself") {
  Claim claim("num::RealFft2d");
  RandomStream draw(7);
  for (int k = 0; k < 1000; ++k) {
    const auto rows = static_cast<std::size_t>(1 + k % 13),
               columns = static_cast<std::size_t>(1 + k % 11);
    num::RealFft2d fft(rows, columns);
    const double scale = draw.decades(1e-100, 1e100);
    std::vector<double> x(rows * columns);
    for (double& value : x) value = scale * draw(-1, 1);
    const auto fill = [&] {
      for (std::size_t i = 0; i < rows; ++i)
        std::copy_n(x.data() + i * columns, columns, fft.row(i));
    };
    fill();
    fft.forward();
    const std::size_t v = static_cast<std::size_t>(k) % rows,
                      u = static_cast<std::size_t>(k) % (columns / 2 + 1);
    Long re = 0, im = 0, square = 0;
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < columns; ++j) {
        const Long turn = static_cast<Long>(i * v % rows) / static_cast<Long>(rows) +
                          static_cast<Long>(j * u % columns) / static_cast<Long>(columns);
        const Long value = x[i * columns + j];
        re += value * std::cos(2 * long_pi * turn), im -= value * std::sin(2 * long_pi * turn);
        square += value * value;
      }
    const auto found = fft.spectrum()[v * (columns / 2 + 1) + u];
    const auto count = static_cast<Long>(rows * columns);
    claim.error(static_cast<double>(std::hypot(found.real() - re, found.imag() - im) /
                                    std::sqrt(square * count)));
    fft.inverse();
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < columns; ++j)
        claim.error(static_cast<double>(std::abs(fft.row(i)[j] / count - x[i * columns + j]) /
                                        std::sqrt(square)));
  }
}

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
