#include <algorithm>
#include <cmath>

#include <railbook/vehicle/linear_stability.hpp>

#include "hunting/search.hpp"

namespace railbook::hunting_tool {

using namespace cycles;
using namespace vehicle;

namespace {

constexpr std::size_t most_left = 4;  // unstable cycles that motions leave from

constexpr std::size_t most_modes = 2;

std::vector<Motion> least_damped(const CarCase& c, double speed) {
  std::vector<Motion> all = modes(c.car, c.car.small(), speed);
  std::erase_if(all, [](const Motion& m) { return !(m.lambda.imag() > 0); });
  all.resize(std::min(all.size(), most_modes));
  return all;
}

Eigen::VectorXd moved(const Eigen::VectorXd& state, const Vector9& rest, double factor) {
  Eigen::VectorXd y = state;
  y.head(9) = rest + factor * (state.head(9) - rest);
  y.tail(9) *= factor;
  return y;
}

}  // namespace

bool straight_run_stable(const CarCase& c, double speed) {
  return modes(c.car, c.car.small(), speed).front().lambda.real() < 0;
}

Search search_in_time(const Family& family, const CarCase& c, double speed,
                      const std::vector<LimitCycle>& known, const ContinuationOptions& options) {
  const Vector9& rest = c.car.rest();
  struct Start {
    Eigen::VectorXd state;
    double omega;
  };
  std::vector<Start> starts;
  for (const LimitCycle& p : known) {
    if (p.stable || p.neutral || starts.size() >= 2 * most_left) continue;
    for (const double factor : {0.98, 1.02})
      starts.push_back({moved(state_at(p.cycle, 0), rest, factor), p.cycle.omega});
  }
  for (const Motion& mode : least_damped(c, speed))
    for (const double part : {0.1, 0.4, 0.7}) {
      const Vector9c shape = scaled_to(c.car.car(), mode.shape, part * options.largest_amplitude);
      Eigen::VectorXd y(18);
      y << rest + shape.real(), (mode.lambda * shape).real();
      starts.push_back({y, mode.lambda.imag()});
    }
  Search result;
  result.smallest = units::infinity;
  for (const Start& start : starts) {
    SettleOptions settling;
    settling.omega = start.omega;
    ++result.starts;
    const SettledMotion m = settle(family, speed, start.state, settling, options);
    switch (m.kind) {
      case SettledMotion::Kind::rest:
        ++result.to_rest;
        break;
      case SettledMotion::Kind::left_table:
        ++result.left_table;
        break;
      case SettledMotion::Kind::cycle: {
        ++result.to_cycle;
        const auto same = [&m](const LimitCycle& other) {
          return std::abs(other.largest / m.cycle.largest - 1) < 1e-3 &&
                 std::abs(other.cycle.omega / m.cycle.cycle.omega - 1) < 5e-4;
        };
        if (std::none_of(result.cycles.begin(), result.cycles.end(), same) &&
            std::none_of(known.begin(), known.end(), same))
          result.cycles.push_back(m.cycle);
        break;
      }
      default:
        ++result.unrepeating;
        result.smallest = std::min(result.smallest, m.smallest);
        result.largest = std::max(result.largest, m.largest);
    }
  }
  return result;
}

}  // namespace railbook::hunting_tool
