// The accuracy that the chapter's solvers state, on seeded inputs over their range; exact values in
// 80-bit arithmetic, by bisection and quadrature of their own.
#include <cmath>

#include <railbook/contact/hertz.hpp>

#include "method/countact.hpp"
#include "method/countaxi.hpp"
#include "method/punch.hpp"
#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::contact_chapter;
using namespace railbook::tests;

namespace {

// s - b arctan(s/b).
Long lift(Long s, Long b) {
  const Long x = s / b;
  if (x > 0.3L) return s - b * std::atan(x);
  Long sum = 0, power = x * x;
  for (int k = 3; k < 80; k += 2) sum += power / k, power *= -x * x;
  return s * sum;
}

// Abel's integral of the punch's pressure over E*/(pi R), by the tanh-sinh rule; nothing cancels at
// its ends.
Long abel(Long r, Long b, Long a) {
  const Long first = std::max(r, b), half = (a - first) / 2;
  Long sum = 0;
  for (int k = -60; k <= 60; ++k) {
    const Long t = k / Long{16}, s = long_pi / 2 * std::sinh(t), e = std::exp(-2 * std::abs(s));
    const Long near = 2 * half * e / (1 + e), above = t < 0 ? near : 2 * half - near;
    const Long weight = half * long_pi / 2 * std::cosh(t) * 4 * e / ((1 + e) * (1 + e)) / 16;
    if (above == 0 || weight == 0) continue;
    const Long root = std::sqrt((first - b + above) * (first + b + above));
    const Long arc = b > 0 ? b * std::atan(root / b) : 0;
    sum += weight * (2 * root - arc) / std::sqrt((first - r + above) * (first + r + above));
  }
  return sum;
}

}  // namespace

TEST_CASE("claim: how the columns are cut, and their matrix") {
  Claim uniform("contact_chapter::uniform_columns"), split("contact_chapter::split_columns"),
      graded("contact_chapter::graded_columns"), matrix("contact_chapter::countact_matrix");
  RandomStream draw(1);
  for (int k = 0; k < 1000; ++k) {
    const int n = static_cast<int>(draw.decades(3, 300)), m = static_cast<int>(draw(1, 9)),
              i = static_cast<int>(draw(0, n + 0.99));
    uniform.error(std::abs(uniform_columns(n).whole[static_cast<std::size_t>(i)] -
                           static_cast<double>(i) / n));
    const double share = draw.decades(1e-6, 0.999999);
    const Side side{n, m, share};
    const auto edges = split_columns(side, {1, 0}).left;
    REQUIRE(edges.size() == static_cast<std::size_t>(n + m + 1));
    const Long wide = (1 - Long{share}) * i / n, narrow = 1 - Long{share} * (m - i % m) / m;
    split.error(static_cast<double>(std::abs(edges[static_cast<std::size_t>(i)] - wide)));
    split.error(static_cast<double>(std::abs(edges[static_cast<std::size_t>(n + i % m)] - narrow)));
    const Long half = std::sin(long_pi * i / n / 2);
    graded.error(
        static_cast<double>(std::abs(graded_columns(1, n).right[static_cast<std::size_t>(i)] -
                                     (Long(i) / n / 2 + half * half / 2))));
  }
  const auto corner = [](Long x, Long y) {
    return (x == 0 ? 0 : x * std::asinh(y / std::abs(x))) +
           (y == 0 ? 0 : y * std::asinh(x / std::abs(y)));
  };
  for (int k = 0; k < 40; ++k) {
    const int rows = 1 + k % 4, columns = 3 + k % 3;
    const bool both_axes = k % 2 == 0;
    ColumnMesh mesh{Eigen::VectorXd(columns + 1), Eigen::VectorXd(columns)};
    for (int j = 0; j <= columns / 2; ++j) {
      const double width = draw.decades(0.01, 1);
      mesh.half_width[j] = mesh.half_width[columns - 1 - j] = width;
    }
    for (int j = 0; j <= columns; ++j) mesh.x_edges[j] = j - columns / 2.0;
    const Eigen::MatrixXd found = countact_matrix(mesh, rows, both_axes);
    const int half = (rows + 1) / 2, first = both_axes ? columns / 2 : 0;
    REQUIRE(found.rows() == half * (columns - first));
    Eigen::Matrix<Long, Eigen::Dynamic, 1> row(found.cols());
    for (Eigen::Index i = 0; i < found.rows(); ++i) {
      const Eigen::Index column = first + i / half, up = i % half;
      const Long height = 2 * Long{mesh.half_width[column]} / rows,
                 x = (mesh.x_edges[column] + Long{mesh.x_edges[column + 1]}) / 2,
                 y = (up + (rows % 2 == 1 ? 0 : Long{0.5})) * height;
      row.setZero();
      for (int j = 0; j < columns; ++j)
        for (int e = 0; e < rows; ++e) {
          const Long h = 2 * Long{mesh.half_width[j]} / rows, x1 = mesh.x_edges[j] - x,
                     x2 = mesh.x_edges[j + 1] - x, y1 = (e - rows / Long{2}) * h - y, y2 = y1 + h;
          const int from_axis = e >= rows / 2 ? e - rows / 2 : (rows - 1) / 2 - e,
                    folded = j >= first ? j - first : columns - 1 - j - first;
          row[folded * half + from_axis] +=
              corner(x2, y2) - corner(x1, y2) - corner(x2, y1) + corner(x1, y1);
        }
      for (Eigen::Index c = 0; c < found.cols(); ++c)
        matrix.error(static_cast<double>(std::abs(found(i, c) - row[c]) / row.maxCoeff()));
    }
  }
}

TEST_CASE("claim: the simply discretized methods against Hertz and the punch") {
  Claim one("contact_chapter::countact_1"), two("contact_chapter::countact_2"),
      rings("contact_chapter::countaxi");
  RandomStream draw(2);
  for (int k = 0; k < 500; ++k) {
    const double ratio = draw.decades(0.1, 10), a = draw.decades(1e-2, 1e2),
                 delta = draw.decades(1e-8, 1e-4) / a;
    const RelativeCurvature curvature{a, a * ratio, 0};
    const HertzContact exact = hertz_from_approach(curvature, 1e11, delta);
    CountactOptions options;
    options.columns = uniform_columns(7), options.rows = 5;
    for (const bool both : {false, true}) {
      const NormalContact c =
          (both ? countact_2 : countact_1)(quadratic_gap(curvature), delta, 1e11, options).contact;
      INFO("ratio " << ratio << " " << c.reason);
      CHECK(c.converged);
      Claim& claim = both ? two : one;
      claim.relative(c.force, exact.force);
      claim.relative(c.p_max, exact.p_max);
    }
    const RoundedPunch shape{k % 2 == 0 ? 0 : draw.decades(1e-3, 1), draw.decades(1e-2, 1e2)};
    const double depth = k % 2 == 0 ? shape.edge_radius * draw.decades(1e-9, 1e-3)
                                    : shape.flat_radius * shape.flat_radius / shape.edge_radius *
                                          draw.decades(0.01, 10);
    const PunchContact punch = punch_from_approach(shape, 1e11, depth);
    CountaxiOptions few;
    few.rings = 12;
    const RingContact c = countaxi(rounded_punch_gap(shape), depth, 1e11, few);
    INFO(shape.flat_radius << " " << shape.edge_radius << " " << depth << " " << c.reason);
    CHECK(c.converged);
    rings.relative(c.force, punch.force);
    rings.relative(c.radius, punch.radius);
  }
}

TEST_CASE("claim: the rounded punch and its pressure") {
  Claim closed("contact_chapter::punch_from_approach"), pressure("contact_chapter::punch_pressure");
  RandomStream draw(5);
  for (int k = 0; k < 1000; ++k) {
    const double b = draw.decades(1e-4, 1),
                 edge = k % 2 == 0 ? b * draw.decades(1e-3, 1e2) : b * draw.decades(1e-12, 1e6),
                 delta = b * draw.decades(1e-9, 1e-2);
    Long low = std::log(Long{b}) - 40, high = std::log(Long{b} + delta + edge) + 40;
    for (int n = 0; n < 80; ++n) {
      const Long s = std::exp((low + high) / 2);
      (std::hypot(s, Long{b}) * lift(s, b) < Long{delta} * edge ? low : high) = (low + high) / 2;
    }
    const Long s = std::exp((low + high) / 2), a = std::hypot(s, Long{b});
    const PunchContact c = punch_from_approach({b, edge}, 1e11, delta);
    closed.relative(c.radius, a);
    closed.relative(c.s, s);
    closed.relative(c.force, 1e11L * (a * delta + s * s * s / (3 * Long{edge})));
    if (k % 2 == 0) {
      // Also next to the edge, where the pressure falls to nothing.
      for (const double r : {draw(0, 1) * c.radius, b + draw(0, 1) * c.edge_width,
                             c.radius - c.edge_width * draw.decades(1e-6, 1)})
        if (r < c.radius)
          pressure.error(static_cast<double>(
              std::abs(punch_pressure(c, r) / (1e11L / (long_pi * edge) * abel(r, b, a)) - 1) /
              (1 + 1e-5L * a / (a - r))));
    }
  }
}

TEST_CASE("claim: the peak of the punch") {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Claim peak("contact_chapter::punch_peak");
  RandomStream draw(3);
  for (int k = 0; k < 1000; ++k) {
    const double flat = draw.decades(1e-3, 1), edge = flat * draw.decades(1e-3, 1e3);
    const PunchContact c = punch_from_approach({flat, edge}, 1e11, flat * draw.decades(1e-8, 1e-2));
    const PunchPeak top = punch_peak(c);
    // The vertex of parabolas through three pressures, extrapolated from two distances.
    const auto vertex = [&](double h) {
      const double before = punch_pressure(c, top.r - h), after = punch_pressure(c, top.r + h),
                   bend = before - 2 * top.pressure + after;
      return bend < 0 ? 0.5 * h * (before - after) / bend : infinite;
    };
    const double h = 0.02 * std::min(c.edge_width, top.r - flat);
    peak.error(std::abs(4 * vertex(h / 2) - vertex(h)) / 3 / c.edge_width);
  }
}
