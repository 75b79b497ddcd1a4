// What any stresses below a surface must be: in equilibrium with one another and with the tractions, and alike when turned.
#include <catch2/catch.hpp>
#include <cmath>

#include "support/half_space_loads.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::tests;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

struct Load {
  Grid grid = square_grid(61, 3.05);
  VectorXd p, qx, qy;
  Load() {
    const auto bump = [](double x, double y) { return std::exp(-x * x - 1.5 * y * y); };
    p = on(grid, bump);
    qx = on(grid, [&](double x, double y) { return 0.4 * (1 + 0.5 * x) * bump(x, y); });
    qy = on(grid, [&](double x, double y) { return 0.2 * bump(x + 0.3, y - 0.2); });
  }
};

// Fourth order from values at -2, -1, 1, 2 steps.
double slope(double a, double b, double c, double d, double step) {
  return (a - 8 * b + 8 * c - d) / (12 * step);
}

}  // namespace

TEST_CASE("property: stresses under any tractions are in equilibrium at every depth") {
  const Load load;
  const Index n = load.grid.nx;
  const double h = load.grid.dx, step = 0.05;
  for (const double nu : {0.0, 0.28, 0.5}) {
    const Subsurface body(load.grid, nu, load.p, load.qx, load.qy);
    for (const double z : {0.3, 1.0}) {
      INFO("nu " << nu << ", depth " << z);
      const Stresses s = body.at(z), up2 = body.at(z - 2 * step), up = body.at(z - step),
                     down = body.at(z + step), down2 = body.at(z + 2 * step);
      double worst = 0;
      for (Index j = 15; j < 46; j += 5)
        for (Index i = 15; i < 46; i += 5) {
          const Index k = j * n + i;
          const auto dx = [&](int c) {
            return slope(s(k - 2, c), s(k - 1, c), s(k + 1, c), s(k + 2, c), h);
          };
          const auto dy = [&](int c) {
            return slope(s(k - 2 * n, c), s(k - n, c), s(k + n, c), s(k + 2 * n, c), h);
          };
          const auto dz = [&](int c) {
            return slope(up2(k, c), up(k, c), down(k, c), down2(k, c), step);
          };
          worst = std::max({worst, std::abs(dx(0) + dy(3) + dz(5)), std::abs(dx(3) + dy(1) + dz(4)),
                            std::abs(dx(5) + dy(4) + dz(2))});
        }
      CHECK(worst < 2e-3);
    }
  }
}

TEST_CASE("property: the surface bears its tractions, and a layer below it the load") {
  const Load load;
  const Subsurface body(load.grid, 0.28, load.p, load.qx, load.qy);
  const Stresses top = body.at(0);
  CHECK((top.col(2) + load.p).cwiseAbs().maxCoeff() < 1e-12);
  CHECK((top.col(5) + load.qx).cwiseAbs().maxCoeff() < 1e-12);
  CHECK((top.col(4) + load.qy).cwiseAbs().maxCoeff() < 1e-12);
  const Stresses layer = body.at(0.2);
  CHECK(-layer.col(2).sum() == Approx(load.p.sum()).epsilon(0.01));
}

TEST_CASE("property: stresses turn with their tractions") {
  const Load load;
  const Index n = load.grid.nx;
  const auto turned = [&](const VectorXd& v) {  // x and y exchanged
    VectorXd out(v.size());
    for (Index k = 0; k < v.size(); ++k) out[(k % n) * n + k / n] = v[k];
    return out;
  };
  const Stresses s = Subsurface(load.grid, 0.28, load.p, load.qx, load.qy).at(0.4);
  const Stresses other =
      Subsurface(load.grid, 0.28, turned(load.p), turned(load.qy), turned(load.qx)).at(0.4);
  constexpr int exchanged[6] = {1, 0, 2, 3, 5, 4};
  for (int c = 0; c < 6; ++c)
    CHECK((turned(s.col(c)) - other.col(exchanged[c])).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("property: the largest stress settles as cells get finer") {
  const auto largest = [](Index n, double friction) {
    const Grid grid = square_grid(n, 1.1);
    const VectorXd p = hertz_circle(grid);
    return largest_stress(grid, 0.28, p, friction * p, VectorXd::Zero(grid.cells()));
  };
  const double fine = largest(80, 0.2).von_mises.value;
  CHECK(largest(32, 0.2).von_mises.value == Approx(fine).epsilon(0.005));
  CHECK(largest(56, 0.2).von_mises.value == Approx(fine).epsilon(0.0025));
}
