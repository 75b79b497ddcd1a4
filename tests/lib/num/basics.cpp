#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <railbook/num/eigenvalues.hpp>
#include <railbook/num/even_filter.hpp>
#include <railbook/num/fft.hpp>
#include <railbook/num/fp_flags.hpp>
#include <railbook/num/gsl.hpp>
#include <railbook/num/median.hpp>
#include <railbook/num/parallel.hpp>
#include <railbook/num/pile.hpp>
#include <railbook/num/quadrature.hpp>
#include <railbook/num/roots.hpp>
#include <railbook/num/special.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;

TEST_CASE("unit: a failing GSL status is an exception with its text") {
  CHECK_THROWS_WITH(num::check_gsl(4, "my routine"), Catch::Contains("my routine"));
  CHECK_NOTHROW(num::check_gsl(0, ""));
}

TEST_CASE("unit: the upper median is the middle one in order") {
  std::vector<double> none;
  CHECK(num::upper_median(none) == 0);
  std::mt19937 random(3);
  for (const int different : {1, 2, 5, 1000}) {
    for (std::size_t n = 1; n < 200; ++n) {
      std::vector<double> values(n);
      for (double& value : values) value = static_cast<double>(random() % unsigned(different));
      std::vector<double> sorted = values;
      std::sort(sorted.begin(), sorted.end());
      REQUIRE(num::upper_median(values) == sorted[n / 2]);
    }
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

TEST_CASE("eigenvalues of a rotation, of a symmetric matrix, and of none", "[num][unit]") {
  Eigen::MatrixXd turn(2, 2);
  turn << 3, -4, 4, 3;  // 3 +- 4i
  const Eigen::VectorXcd pair = num::eigenvalues(turn);
  CHECK(pair[0].real() == Approx(3).epsilon(1e-14));
  CHECK(pair[0].imag() == Approx(4).epsilon(1e-14));
  CHECK(pair[1] == std::conj(pair[0]));

  Eigen::MatrixXd spring(3, 3);
  spring << 2, -1, 0, -1, 2, -1, 0, -1, 2;  // 2 - sqrt 2, 2, 2 + sqrt 2
  const Eigen::VectorXd ascending = num::symmetric_eigenvalues(spring);
  CHECK(ascending[0] == Approx(2 - std::sqrt(2.0)).epsilon(1e-14));
  CHECK(ascending[1] == Approx(2).epsilon(1e-14));
  CHECK(ascending[2] == Approx(2 + std::sqrt(2.0)).epsilon(1e-14));

  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (int n = 2; n <= 40; ++n) {
    const Eigen::VectorXcd all =
        num::eigenvalues(Eigen::MatrixXd::NullaryExpr(n, n, [&] { return normal(random); }));
    for (Eigen::Index k = 0; k < n; ++k) {
      if (all[k].imag() == 0) continue;
      CHECK(all[k].imag() > 0);
      REQUIRE(k + 1 < n);
      CHECK(all[k + 1] == std::conj(all[k]));
      CHECK(std::abs(all[k + 1]) == std::abs(all[k]));
      ++k;
    }
  }

  turn(0, 0) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(num::eigenvalues(turn), std::runtime_error);
}

namespace {

volatile double zero = 0;
volatile double sink = 0;

}  // namespace

TEST_CASE("extreme: a floating-point exception is reported by name and does not stop the program") {
  const num::FpFlags flags;
  CHECK(flags.raised().empty());
  sink = 1.0 / zero;
  CHECK(flags.raised() == "a division by zero");
  sink = zero / zero;
  CHECK(flags.raised() == "an invalid operation and a division by zero");
  CHECK(sink != sink);
}

TEST_CASE("extreme: a guard sees what it encloses, and tells the guards around it") {
  const num::FpFlags outer;
  sink = 1.0 / zero;
  {
    const num::FpFlags inner;
    CHECK(inner.raised().empty());
    sink = zero / zero;
    CHECK(inner.raised() == "an invalid operation");
  }
  CHECK(outer.raised() == "an invalid operation and a division by zero");
}

TEST_CASE("extreme: exceptions set aside leave no flag, and earlier flags are kept") {
  const num::FpFlags flags;
  {
    const num::FpFlagsAside aside;
    sink = zero / zero;
  }
  CHECK(flags.raised().empty());
  sink = 1.0 / zero;
  {
    const num::FpFlagsAside aside;
    sink = zero / zero;
  }
  CHECK(flags.raised() == "a division by zero");
}

TEST_CASE("extreme: a number that underflows or is rounded raises nothing") {
  const num::FpFlags flags;
  sink = std::numeric_limits<double>::min();
  sink = sink * sink;
  sink = 1.0 / 3.0;
  CHECK(flags.raised().empty());
}

TEST_CASE("num: a pile at the end of a range is ten values, and ten times as many as the next") {
  for (const double sign : {1.0, -1.0})
    for (const std::size_t at_end : {9, 10, 19, 20}) {
      std::vector<double> values{units::nan, sign * 3, sign * 5};
      values.insert(values.end(), at_end, sign * 1);
      values.insert(values.end(), at_end < 15 ? 1 : 2, sign * 2);
      CAPTURE(sign, at_end);
      const auto end = num::pile(values, sign);
      CHECK(end.has_value() == (at_end % 10 == 0));
      if (end) CHECK(*end == sign);
      CHECK_FALSE(num::pile(values, -sign).has_value());
    }
  CHECK_FALSE(num::pile({}, 1).has_value());
  CHECK_FALSE(num::pile(std::vector<double>(50, 1.0), 1).has_value());  // of one value alone
}
