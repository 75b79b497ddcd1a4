// The accuracy that the paper's search states: cars at random, of any amplitude, against the
// eigenvalues of the car put together body by body, in 80 bits.
#include <catch2/catch.hpp>

#include <railbook/vehicle/cycle_branch.hpp>

#include "method/eigenvector_loop.hpp"
#include "support/claim.hpp"
#include "support/random_quasi_linear.hpp"

using namespace railbook;
using namespace railbook::hunting_chapter;
using namespace railbook::tests;
using units::inch;

TEST_CASE("claim: cycles by the paper's search", "[thorough]") {
  Claim loop("hunting_chapter::paper_cycle", 300);
  RandomStream draw(2);
  for (int k = 0; k < 100; ++k) {
    const QuasiLinearCar car = random_quasi(draw, k % 4 == 3);
    const auto hopf = hopf_points(car, 6, 90);
    for (int n = 0; n < 4 && !hopf.empty(); ++n) {
      const double a = draw.decades(1e-3, 0.7) * inch;
      const vehicle::CycleSearch search = find_cycle(car, hopf[0].motion, a);
      if (!search.converged) continue;
      const LoopResult paper =
          paper_cycle(car, search.cycle.motion, a * (1 + 1e-2), ModeChoice::least_damped);
      if (paper.end == LoopEnd::converged) loop.error(off_axis(car, paper.cycle));
    }
  }
}

TEST_CASE("claim: how alike two shapes are", "[thorough]") {
  Claim alike("hunting_chapter::overlap");
  RandomStream draw(3);
  for (int k = 0; k < 1000; ++k) {
    Vector9c one, other;
    for (auto& z : one) z = {draw(-1, 1), draw(-1, 1)};
    for (auto& z : other) z = {draw(-1, 1), draw(-1, 1)};
    Long re = 0, im = 0, a = 0, b = 0;
    for (Eigen::Index n = 0; n < 9; ++n) {
      const Long p = one[n].real(), r = one[n].imag(), g = other[n].real(), h = other[n].imag();
      re += p * g + r * h, im += p * h - r * g, a += p * p + r * r, b += g * g + h * h;
    }
    alike.error(static_cast<double>(std::abs(overlap(one, other) - (re * re + im * im) / (a * b))));
  }
}
