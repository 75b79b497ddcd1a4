#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <railbook/num/even_filter.hpp>
#include <railbook/num/fft.hpp>
#include <railbook/num/fp_flags.hpp>
#include <railbook/num/gsl.hpp>
#include <railbook/num/parallel.hpp>
#include <railbook/num/quadrature.hpp>
#include <railbook/num/roots.hpp>
#include <railbook/num/special.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;

TEST_CASE("unit: Brent finds a root to the last digits") {
  const num::Root root = num::find_root([](double x) { return std::cos(x) - x; }, 0, 1);
  CHECK(root.converged);
  CHECK(root.x == Approx(0.7390851332151606).epsilon(1e-15));
  CHECK_THROWS_AS(num::find_root([](double x) { return x * x + 1; }, -1, 1), InputError);
  CHECK_THROWS_AS(num::find_root([](double) { return std::nan(""); }, -1, 1), InputError);
  CHECK_FALSE(num::find_root([](double x) { return x * x * x - 2; }, 0, 1e6, 1e-15, 3).converged);
}

TEST_CASE("unit: integrals, finite, singular and infinite") {
  const double inf = std::numeric_limits<double>::infinity();
  const auto root = num::integrate([](double x) { return 1 / std::sqrt(x); }, 0, 1);
  CHECK(root.converged);
  CHECK(std::abs(root.value - 2) <= std::max(root.error, 1e-10));
  CHECK(num::integrate([](double x) { return std::exp(-x * x); }, -inf, inf).value ==
        Approx(std::sqrt(units::pi)).epsilon(1e-10));
  // The claimed error bounds the true one (a divergent integral says that it did not converge).
  CHECK_FALSE(num::integrate([](double x) { return 1 / x; }, 0, 1).converged);
  const num::GaussRule rule = num::gauss_legendre(5, 0, 2);
  CHECK(rule.w.sum() == Approx(2).epsilon(1e-15));
  CHECK(rule.w.dot(rule.x.array().pow(9).matrix()) == Approx(102.4).epsilon(1e-14));
}

TEST_CASE("unit: transforms match a direct sum") {
  for (std::size_t n : {1U, 2U, 7U, 12U}) {
    num::RealFft fft{n};
    for (std::size_t j = 0; j < n; ++j) fft.real()[j] = std::sin(1.0 + double(j * j));
    std::vector<double> before(fft.real().begin(), fft.real().end());
    fft.forward();
    for (std::size_t k = 0; k <= n / 2; ++k) {
      std::complex<double> sum;
      for (std::size_t j = 0; j < n; ++j)
        sum += before[j] * std::polar(1.0, -2 * units::pi * double(k * j) / double(n));
      CHECK(std::abs(sum - fft.spectrum()[k]) < 1e-13);
    }
    fft.inverse();
    for (std::size_t j = 0; j < n; ++j)
      CHECK(fft.real()[j] == Approx(double(n) * before[j]).margin(1e-13));
  }
}

TEST_CASE("unit: a two-dimensional round trip returns n times the samples") {
  num::RealFft2d fft{6, 5};
  CHECK(fft.spectrum().size() == 6 * 3);
  CHECK(fft.real().size() == 2 * 6 * 3);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 5; ++j) fft.row(i)[j] = double(10 * i + j);
  fft.forward();
  CHECK(fft.spectrum()[0].real() == Approx(810));
  fft.inverse();
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 5; ++j)
      CHECK(fft.row(i)[j] == Approx(30.0 * double(10 * i + j)).margin(1e-11));
}

TEST_CASE("unit: an even filter is the sum over its kernel, whatever the threads") {
  constexpr std::size_t rows = 5, columns = 7;
  const auto kernel = [](std::size_t v, std::size_t u) {
    return 1 / (1.0 + double(v * v + 2 * u));
  };
  for (const auto& [tall, wide] : {std::pair<std::size_t, std::size_t>{9, 14}, {10, 13}}) {
    num::EvenFilter filter(rows, columns, tall, wide, 3);
    for (std::size_t v = 0; v < rows; ++v)
      for (std::size_t u = 0; u < columns; ++u) filter.at(v, u) = kernel(v, u);
    filter.transform_kernel();
    num::Workspace space(filter.workspace());
    std::vector<double> in(rows * columns), out(in.size());
    for (std::size_t n = 0; n < in.size(); ++n) in[n] = std::sin(1.0 + double(n * n));
    filter.apply(in.data(), out.data(), space.data());
    const auto apart = [](std::size_t a, std::size_t b) { return a > b ? a - b : b - a; };
    for (std::size_t n = 0; n < in.size(); ++n) {
      double sum = 0;
      for (std::size_t m = 0; m < in.size(); ++m)
        sum += in[m] * kernel(apart(n / columns, m / columns), apart(n % columns, m % columns));
      CHECK(out[n] == Approx(sum).margin(1e-13));
    }
  }
}

TEST_CASE("unit: a reduction in blocks does not depend on the threads, and covers all") {
  const auto sum = [](int threads, std::size_t count) {
    return num::reduce_in_blocks(
        threads, count,
        [](std::size_t begin, std::size_t end) {
          double part = 0;
          for (std::size_t k = begin; k < end; ++k) part += 1 / double(k + 1);
          return part;
        },
        [](double a, double b) { return a + b; });
  };
  CHECK(sum(1, 0) == 0);
  CHECK(sum(2, 1) == 1);
  CHECK(sum(1, 100000) == sum(3, 100000));
  CHECK(sum(1, 100000) == Approx(12.090146129863428));
}

TEST_CASE("unit: good sizes have no factor above seven") {
  CHECK(num::good_fft_size(1) == 1);
  CHECK(num::good_fft_size(11) == 12);
  CHECK(num::good_fft_size(509) == 512);
  CHECK(num::good_fft_size(4093) == 4096);
}

TEST_CASE("unit: a failing GSL status is an exception with its text") {
  CHECK_THROWS_WITH(num::check_gsl(4, "my routine"), Catch::Contains("my routine"));
  CHECK_NOTHROW(num::check_gsl(0, ""));
}

TEST_CASE("unit: parallel parts cover every item once, whatever the threads") {
  for (const int threads : {-1, 1, 2, 3, 7})
    for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
      std::vector<int> visits(count);
      num::in_parallel(threads, count, [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t k = begin; k < end; ++k) ++visits[k];
      });
      CHECK(std::count(visits.begin(), visits.end(), 1) == static_cast<long>(count));
    }
}

TEST_CASE("unit: what items make comes in their order, and the first failure is reported") {
  for (const int threads : {-1, 0, 1, 2, 3, 7}) {
    const auto square = [](std::size_t i) { return std::to_string(i * i); };
    const auto made = num::map_in_parallel(100, square, threads);
    REQUIRE(made.size() == 100);
    for (std::size_t i = 0; i < 100; ++i) CHECK(made[i] == std::to_string(i * i));
    CHECK(num::map_in_parallel(0, square, threads).empty());
    std::atomic<int> called{0};
    const auto failing = [&](std::size_t i) {
      ++called;
      if (i % 10 == 7) throw InputError{"item " + std::to_string(i)};
      return i;
    };
    CHECK_THROWS_WITH(num::map_in_parallel(100, failing, threads), Catch::Contains("item 7"));
    CHECK(called == 100);
  }
}

TEST_CASE("unit: what another thread raises is seen by the one that called") {
  for (const int threads : {1, 2, 3})
    for (const std::size_t place : {std::size_t{0}, std::size_t{99}}) {
      const num::FpFlags flags;
      std::vector<double> made(100, 1.0);
      const auto divide = [&](double by) {
        num::in_parallel(threads, made.size(), [&](std::size_t begin, std::size_t end, auto) {
          for (std::size_t k = begin; k < end; ++k) made[k] /= k == place ? by : 2.0;
        });
      };
      divide(3);
      CHECK(flags.raised().empty());
      divide(0);
      CHECK(flags.raised() == "a division by zero");
    }
}

TEST_CASE("unit: transforms may be made and used in several threads at once") {
  const auto transform = [](std::size_t i) {
    num::RealFft fft(64 + i % 7);
    for (std::size_t k = 0; k < fft.size(); ++k)
      fft.real()[k] = static_cast<double>((k * k + i) % 11);
    fft.forward();
    return std::vector(fft.spectrum().begin(), fft.spectrum().end());
  };
  const auto alone = num::map_in_parallel(500, transform, 1);
  CHECK(num::map_in_parallel(500, transform, 3) == alone);
}

TEST_CASE("unit: GSL says what is wrong instead of ending the program") {
  num::use_gsl_status_codes();
  CHECK_THROWS_AS(num::integrate([](double x) { return x; }, 0, 1, 1e-30), num::NumericalError);
}

TEST_CASE("unit: the sine integral at its ends") {
  const NoFpFault no_fault;
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(num::sine_integral(infinity) == std::numbers::pi / 2);
  CHECK(num::sine_integral(-infinity) == -std::numbers::pi / 2);
  CHECK(std::isnan(num::sine_integral(std::nan(""))));
  CHECK(num::sine_integral(0) == 0);
}
