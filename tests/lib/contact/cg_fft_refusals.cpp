#include <catch2/catch.hpp>
#include <limits>

#include <railbook/contact/cg_fft.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::contact;

TEST_CASE("input: bad arguments of the grid solver are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const Gap bowl = [](double x, double y) { return x * x + y * y; };
  const Gap hole = [&](double x, double y) { return x > 0.1 && y > 0.1 ? nan : x * x + y * y; };
  const Gap all_nan = [&](double, double) { return nan; };
  const Gap plane = [](double, double) { return 0.0; };
  const Gap trough = [](double x, double) { return x * x; };
  CHECK_THROWS_AS(solve_cg_fft(bowl, nan, 1), InputError);
  CHECK_THROWS_AS(solve_cg_fft(bowl, inf, 1), InputError);
  CHECK_THROWS_AS(solve_cg_fft(bowl, 1, 0), InputError);
  CHECK_THROWS_AS(solve_cg_fft(bowl, 1, -1), InputError);
  CHECK_THROWS_AS(solve_cg_fft(hole, 1, 1), InputError);
  CHECK_THROWS_AS(solve_cg_fft(all_nan, 1, 1), InputError);
  CHECK_THROWS_WITH(solve_cg_fft(plane, 1, 1), Catch::Contains("do not separate"));
  CHECK_THROWS_WITH(solve_cg_fft(trough, 1, 1), Catch::Contains("do not separate"));
  CHECK_THROWS_AS(solve_cg_fft_load(bowl, 0, 1), InputError);
  CHECK_THROWS_AS(solve_cg_fft_load(bowl, -3, 1), InputError);
  CgFftOptions options;
  options.nx = 0;
  CHECK_THROWS_AS(solve_cg_fft(bowl, 1, 1, options), InputError);
  options.nx = options.ny = 60000;
  CHECK_THROWS_WITH(solve_cg_fft(bowl, 1, 1, options), Catch::Contains("GB"));
}

TEST_CASE("input: samples of a gap have no NaN and no minus infinity") {
  const Grid grid{0, 0, 1, 1, 4, 4};
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()})
    CHECK_THROWS_AS(sample([=](double x, double) { return x > 3 ? bad : 1; }, grid), InputError);
}

TEST_CASE("input: too few iterations are reported") {
  const Gap bowl = [](double x, double y) { return x * x + y * y; };
  CgFftOptions options;
  options.cg.most_iterations = 2;
  const NormalContact contact = solve_cg_fft(bowl, 1, 1, options).contact;
  CHECK_FALSE(contact.converged);
  CHECK(contact.reason.find("conjugate gradients") != std::string::npos);
}
