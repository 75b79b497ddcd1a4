// Fields on grids: gaps sampled, pressures carried over, the box that holds a contact, and places
// that a grid missed.
#include <railbook/contact/grid.hpp>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include <railbook/contact/detail/grid_fit.hpp>
#include <railbook/contact/detail/missed.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::contact;
using Catch::Matchers::Contains;
using Eigen::VectorXd;

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double infinite = std::numeric_limits<double>::infinity();

// Displacement of a place [m] by the cells of a grid: points, or rods of their length where they
// are long.
double displacement(const Grid& grid, const VectorXd& p, double modulus, double x, double y) {
  const bool along_x = grid.dx > 2 * grid.dy, along_y = grid.dy > 2 * grid.dx;
  const double least = std::min(grid.dx, grid.dy) / 4;
  double sum = 0;
  for (Eigen::Index n = 0; n < grid.cells(); ++n) {
    if (p[n] == 0) continue;
    const Eigen::Index row = n / grid.nx;
    const double dx = x - grid.x(n % grid.nx), dy = y - grid.y(row),
                 force = p[n] * grid.dx * grid.dy;
    const int parts = along_x || along_y ? 400 : 1;
    for (int k = 0; k < parts; ++k) {
      const double t = (k + 0.5) / parts - 0.5;
      const double u = along_x ? dx - t * grid.dx : along_y ? dy - t * grid.dy : dx;
      const double v = along_y ? dx : dy;
      sum += force / parts / std::hypot(u, std::max(std::abs(v), least));
    }
  }
  return sum / (pi * modulus);
}

}  // namespace

TEST_CASE("unit: a gap is sampled at the centres, and refused where it is no gap") {
  const Grid grid{1, -2, 0.5, 0.25, 3, 2};
  const VectorXd f = sample([](double x, double y) { return x > 2 ? infinite : x + 10 * y; }, grid);
  REQUIRE(f.size() == 6);
  CHECK(f[0] == Approx(1.25 - 18.75));
  CHECK(f[1] == Approx(1.75 - 18.75));
  CHECK(std::isinf(f[2]));
  CHECK(f[3] == Approx(1.25 - 16.25));
  for (const double bad : {std::nan(""), -infinite})
    CHECK_THROWS_WITH(sample([bad](double, double) { return bad; }, grid),
                      Contains("gap at x = 1.250000 m, y = -1.875000 m is"));
}

TEST_CASE("unit: squares of pressures are carried over by two lines, and end a cell outside") {
  const Grid from{0, 0, 1, 2, 2, 2};
  VectorXd p(4);
  p << 1, 3, 2, 5;
  const auto at = [&](double x, double y) {
    return transfer(from, p, Grid{x - 0.05, y - 0.05, 0.1, 0.1, 1, 1})[0];
  };
  CHECK(at(0.5, 1) == Approx(1));
  CHECK(at(1.5, 3) == Approx(5));
  CHECK(at(1, 1) == Approx(std::sqrt(5)));         // 1 and 9
  CHECK(at(0.5, 2.5) == Approx(std::sqrt(3.25)));  // 1 and 4, a quarter and three
  CHECK(at(1.25, 1.5) == Approx(std::sqrt(0.75 * 7 + 0.25 * 19.75)));
  CHECK(at(-0.25, 1) == Approx(std::sqrt(0.25)));
  CHECK(at(2.25, 3) == Approx(std::sqrt(25 * 0.25)));
  CHECK(at(0.5, 4.5) == Approx(std::sqrt(4 * 0.25)));
  CHECK(at(0.5, -0.5) == Approx(std::sqrt(0.25)));
  for (const auto& [x, y] : {std::pair{-0.6, 1.0}, {2.6, 1.0}, {1.0, -1.2}, {1.0, 5.2}})
    CHECK(at(x, y) == 0);
  const Grid two{0, 0, 1, 1, 2, 3};  // in the order of the cells
  const VectorXd all = transfer(from, p, two);
  REQUIRE(all.size() == 6);
  for (Eigen::Index n = 0; n < 6; ++n) {
    const Eigen::Index row = n / 2;
    CHECK(all[n] == Approx(at(two.x(n % 2), two.y(row))));
  }
}

TEST_CASE("unit: the box of a contact holds it, on every side by no more than a fifth") {
  // Ellipses about the origin and beside it, and one on slopes to either side.
  for (const auto& [x0, y0] : {std::pair{0.0, 0.0}, {3e-3, -2e-3}, {-0.5, 0.2}}) {
    const double a = 4e-3, b = 1e-3, approach = 2e-5;
    const Box box = interpenetration_box(
        [&, x0 = x0, y0 = y0](double x, double y) {
          return approach * (std::pow((x - x0) / a, 2) + std::pow((y - y0) / b, 2));
        },
        approach);
    INFO("about " << x0 << ", " << y0);
    CHECK(box.x_min <= x0 - a);
    CHECK(box.x_max >= x0 + a);
    CHECK(box.y_min <= y0 - b);
    CHECK(box.y_max >= y0 + b);
    // Of the way from the place where it began, which lies in the contact.
    CHECK(box.x_max - box.x_min < 1.2 * 2 * 2 * a);
    CHECK(box.y_max - box.y_min < 1.2 * 2 * 2 * b);
    if (x0 != 0) continue;
    CHECK(box.x_min > -1.2 * a);
    CHECK(box.x_max < 1.2 * a);
    CHECK(box.y_min > -1.2 * b);
    CHECK(box.y_max < 1.2 * b);
  }
  // A slender contact that leaves a box between its corners, whichever side it crosses.
  for (const double angle : {0.7, 2.1, 0.05, 1.5}) {
    const Box box = interpenetration_box(
        [&](double x, double y) {
          const double u = std::cos(angle) * x + std::sin(angle) * y,
                       v = std::cos(angle) * y - std::sin(angle) * x;
          return 1e-5 * (u * u / 1e-4 + v * v / 1e-10);
        },
        1e-5);
    const double x = std::abs(1e-2 * std::cos(angle)), y = std::abs(1e-2 * std::sin(angle));
    CHECK(std::min(-box.x_min, box.x_max) >= 0.999 * x);
    CHECK(std::min(-box.y_min, box.y_max) >= 0.999 * y);
  }
  CHECK_THROWS_WITH(interpenetration_box([](double, double) { return 1.0; }, 0.5),
                    Contains("nowhere found below the approach of 0.5 m: it is 1 m at the origin"));
  CHECK_THROWS_WITH(interpenetration_box([](double x, double) { return x * x; }, 0.5),
                    Contains("below the approach for 1 km"));
  CHECK_THROWS_WITH(interpenetration_box([](double, double) { return std::nan(""); }, 0.5),
                    Contains("NaN near the origin"));
}

TEST_CASE("unit: places that a grid missed are those still overlapping under its loads") {
  constexpr double modulus = 1e11, approach = 1e-4, share = 0.05;
  const Box box{-0.03, 0.05, -0.04, 0.02};
  const Gap gap = [](double x, double y) {
    return 3e-5 * (1 + std::sin(170 * x) * std::cos(230 * y + 0.3)) + 0.02 * x * x + 0.03 * y * y;
  };
  for (const Grid& grid :
       {Grid{-0.01, -0.008, 0.002, 0.0015, 9, 11}, Grid{-0.012, -0.004, 0.006, 0.001, 4, 9},
        Grid{-0.004, -0.012, 0.001, 0.006, 9, 4}})
    for (const double pressure : {0.0, 2e10}) {
      VectorXd p = VectorXd::Zero(grid.cells());
      for (const Eigen::Index n : {Eigen::Index{0}, Eigen::Index{13}, grid.cells() - 1})
        p[n] = pressure * (1 + 0.1 * static_cast<double>(n % 7));
      std::set<std::pair<double, double>> found;
      for (const Point& place : missed_places(gap, approach, modulus, grid, p, box, share))
        found.emplace(place.x, place.y);
      int missed = 0, loaded = 0;
      const auto look = [&](double x, double y) {
        const bool inside = x > grid.x0 && x < grid.x0 + double(grid.nx) * grid.dx && y > grid.y0 &&
                            y < grid.y0 + double(grid.ny) * grid.dy;
        const double overlap = approach - gap(x, y), sunk = displacement(grid, p, modulus, x, y);
        const double spare = overlap - sunk - share * approach;
        if (!inside && std::abs(spare) < 1e-9 + 0.02 * sunk) return;  // rods far off are points
        const bool expected = !inside && spare > 0;
        missed += expected, loaded += !inside && !expected && overlap > share * approach;
        if (found.contains({x, y}) != expected) FAIL_CHECK("at " << x << ", " << y);
      };
      INFO("cells " << grid.dx << " by " << grid.dy << ", pressure " << pressure);
      for (int j = 0; j <= 96; ++j)
        for (int i = 0; i <= 96; ++i)
          if (pressure == 0 || (i + j) % 5 == 0)
            look(box.x_min + (box.x_max - box.x_min) * i / 96,
                 box.y_min + (box.y_max - box.y_min) * j / 96);
      for (int i = 0; i <= 1024; i += 9) {
        look(box.x_min + (box.x_max - box.x_min) * i / 1024, 0);
        look(0, box.y_min + (box.y_max - box.y_min) * i / 1024);
      }
      CHECK(missed > 50);
      CHECK((loaded > 50) == (pressure > 0));
    }
  // An axis that the box does not hold is not looked along.
  const Grid grid{1, 1, 0.1, 0.1, 4, 4};
  const VectorXd none = VectorXd::Zero(16);
  const auto count = [&](const Box& where) {
    return missed_places([](double, double) { return 0.0; }, 1, 1, grid, none, where, 0.5).size();
  };
  constexpr std::size_t places = 97UL * 97;
  CHECK(count({2, 3, 2, 3}) == places);
  CHECK(count({-3, -2, -1, 0.5}) == places + 1025);
  CHECK(count({-1, 0.5, -3, -2}) == places + 1025);
}

TEST_CASE("unit: a long cell presses as a rod near it and as a point far from it") {
  // On flat bodies the places missed begin where 0.95 of the approach is sunk in, on either axis.
  constexpr double modulus = 1e11, approach = 1e-4, h = 4e-3;
  const double unit = 0.95 * approach * pi * modulus;  // of force over distance
  struct Case {
    double force, along, across;
  };
  for (const auto& [force, along, across] :
       {Case{unit * 2 * h / std::log(3.0), 2 * h, h / std::sinh(std::log(3.0) / 2)},
        Case{unit * 2 * h / std::log(5.0), 1.5 * h, h / std::sinh(std::log(5.0) / 2)},
        Case{unit * 5 * h, 5 * h, 5 * h}})
    for (const bool turned : {false, true}) {
      const Grid grid =
          turned ? Grid{-h / 8, -h, h / 4, 2 * h, 1, 1} : Grid{-h, -h / 8, 2 * h, h / 4, 1, 1};
      const VectorXd p = VectorXd::Constant(1, force / (grid.dx * grid.dy));
      double x = infinite, y = infinite;
      const double end = 6 * h;
      for (const Point& place : missed_places([](double, double) { return 0.0; }, approach, modulus,
                                              grid, p, {-end, end, -end, end}, 0.05)) {
        if (std::abs(place.y) < 1e-12) x = std::min(x, std::abs(place.x));
        if (std::abs(place.x) < 1e-12) y = std::min(y, std::abs(place.y));
      }
      INFO("force " << force << ", turned " << turned);
      const double step = 2 * end / 1024, near = turned ? y : x, beside = turned ? x : y;
      CHECK(near > along - 1e-9);
      CHECK(near < along + step);
      CHECK(beside > across - 1e-9);
      CHECK(beside < across + step);
    }
}

TEST_CASE(
    "unit: an axis lies two empty cells beyond both ends, and with an edge on one of its own") {
  for (const double phase : {0.2, 0.5, 0.9})
    for (const Eigen::Index cells : {24, 41, 90})
      for (const double edge : {-2.0, -0.7, 0.1, 1.9, 5.0}) {
        INFO("phase " << phase << ", cells " << cells << ", edge " << edge);
        const double low = -1, high = 2.5, least = 3.5 / (double(cells) - 6 + 2 * phase);
        const Axis axis = fit_axis(low, high, cells, phase, edge);
        CHECK(axis.cells == cells);
        CHECK(axis.start + 2 * axis.step <= low);
        CHECK(axis.start + (double(cells) - 2) * axis.step >= high);
        const double before = (low - axis.start) / axis.step,
                     behind = (high - axis.start) / axis.step;
        if (edge < low || edge > high) {  // the outermost cells hold `phase` of the region
          CHECK(axis.step == Approx(least));
          CHECK(3 - before == Approx(phase));
          CHECK(behind - std::floor(behind) == Approx(phase));
          continue;
        }
        CHECK(axis.step >= least * (1 - 1e-12));
        CHECK(axis.step < 1.04 * least);
        const double at = (edge - axis.start) / axis.step;
        CHECK(at == Approx(std::round(at)).margin(1e-9));
        // No other step up to 4 % larger that leaves two empty cells misses the phase by less.
        const auto missed = [&](double step) {
          double sum = 0, needed = 4;
          for (const double side : {edge - low, high - edge}) {
            const double t = side / step - phase;
            sum += (t - std::round(t)) * (t - std::round(t));
            needed += std::ceil(side / step);
          }
          return needed <= double(cells) ? sum : 1e9;
        };
        double best = infinite;
        for (int k = 0; k < 2000; ++k) best = std::min(best, missed(least * (1 + 0.04 * k / 2000)));
        CHECK(missed(axis.step) < best + 0.01);
      }
  const Axis cover = cover_axis(-1, 3, 20, 0.1);  // 5.5 of 20 cells, rounded to 6
  CHECK(cover.start == Approx(0.1 - 6 * cover.step));
  CHECK(cover.step == Approx(2.9 / 14));
  CHECK(cover.cells == 20);
  for (const double beyond : {-1.0, 3.0, 7.0}) {
    CHECK(cover_axis(-1, 3, 20, beyond).start == -1);
    CHECK(cover_axis(-1, 3, 20, beyond).step == Approx(0.2));
  }
  CHECK(cover_axis(-1, 3, 20, 0.05).step == Approx(1.05 / 5));
  CHECK(cover_axis(0, 1, 10, 0.99).step == Approx(0.99 / 9));
  CHECK(cover_axis(0, 1, 1, 0.5).step == 1);
  // Of seven cells two to either side of an edge and two beyond are too many: they cover a tenth
  // more than the region.
  const Axis few = fit_axis(-1, 2.5, 7, 0.9, 0.3), instead = cover_axis(-1.35, 2.85, 7, 0.3);
  CHECK(few.start == Approx(instead.start));
  CHECK(few.step == Approx(instead.step));
  CHECK(cover_axis(0, 1, 10, 0.01).start == Approx(0.01 - 0.99 / 9));  // one cell at least
}
