#include <railbook/rolling/theory.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>

#include <railbook/rolling/contact.hpp>
#include <railbook/rolling/creep_laws.hpp>
#include <railbook/rolling/kalker_coefficients.hpp>

namespace railbook::rolling {
namespace {

constexpr std::array theories{
    Theory::fastsim, Theory::fastrip,           Theory::shen_hedrick_elkins,
    Theory::polach,  Theory::vermeulen_johnson, Theory::linear};

// Rows across for `cells` along rolling: half as many, but in a long contact so few that a cell is
// not more than 16 times as long as it is wide. Rows far narrower than their cells are long hold
// one another so fast that the states of the cells do not settle.
Eigen::Index rows_for(double axis_ratio, long cells) {
  const long half = (cells + 1) / 2;
  const double wide_enough = 16 * static_cast<double>(cells) / axis_ratio;
  if (static_cast<double>(half) <= wide_enough) return half;
  const long rows = std::max(8L, 2 * std::lround(wide_enough / 2));
  return std::min(half, rows);
}

}  // namespace

const std::vector<std::string>& theory_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all{"full"};
    for (const Theory theory : theories) all.emplace_back(name(theory));
    return all;
  }();
  return names;
}

Solver solver(const std::string& theory, double axis_ratio, double poisson, long cells,
              bool computed) {
  if (theory == "full") {
    const auto contact = std::make_shared<EllipseRolling>(
        axis_ratio, poisson, RollingOptions{.along = cells, .rows = rows_for(axis_ratio, cells)});
    return [contact](const RollingCase& c) { return contact->solve(c); };
  }
  for (const Theory one : theories) {
    if (name(one) != theory) continue;
    if (one == Theory::vermeulen_johnson)
      return [s = vermeulen_johnson_slopes(axis_ratio, poisson)](const RollingCase& c) {
        return vermeulen_johnson(c, s);
      };
    const KalkerCoefficients k = computed
                                     ? KalkerCoefficients(kalker_coefficients(axis_ratio, poisson))
                                     : kalker_table(axis_ratio, poisson);
    return [one, k](const RollingCase& c) { return creep_forces(one, c, k); };
  }
  throw std::logic_error("solver: no theory named " + theory);
}

}  // namespace railbook::rolling
