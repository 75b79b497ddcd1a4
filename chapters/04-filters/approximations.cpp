/*** ## Approximating the exponential

The paper says that an "extremely close approximation" of the digital filter is coded: for each sample of each channel a new $a_k=e^{-\omega_1T_k}$ was
needed, on a computer of 1980. An approximate $\hat a$, used in both places of $C$, keeps the gain at DC at one but leaves a tail: the
share

$$\frac{a-\hat a}{1-\hat a}$$

of what was before the last sample stays in the output, and dies out as $a^n$. Four ways to save the exponential:

{{approximations}}

{{fig-approximations}}

With the first two, $C$ does not undo $B$: at {{tail-speed}} {{tail-linear}} and {{tail-reciprocal}} of the past are left. The Padé approximation of one step each, $(2-\kappa)/(2+\kappa)$, is better, but
negative for $\kappa>2$, below {{pade-speed}} with our corner, where a stopping car makes it useless. The Padé approximation of two steps each costs two
multiplications more, and nobody would find its error in a record: "extremely close" fits it. The tails in the table are computed from the
definition and measured: the analog filter holds what an input left in it that ended before the last interval began, and what $C$ still shows of
it is the tail.

For $\kappa\to\infty$ only the exact exponential and $1/(1+\kappa)$ go to zero, as they must: what is measured after a stop must not depend on what was before
it.
*/
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "configuration.hpp"
#include "filters/hybrid_filter.hpp"
#include "items.hpp"

namespace railbook::filters_chapter {
namespace {

using filters::Decay;
constexpr std::array<std::pair<const char*, Decay>, 4> ways{{{"linear", Decay::linear},
                                                             {"reciprocal", Decay::reciprocal},
                                                             {"pade11", Decay::pade11},
                                                             {"pade22", Decay::pade22}}};

double tail(double kappa, Decay how) {
  const filters::DecayPair exact = filters::decay(kappa), approximate = filters::decay(kappa, how);
  return (approximate.rest - exact.rest) /
         approximate.rest;  // two small numbers, no cancellation of a
}

// The analog filter holds 1 from an input that has ended when the last interval begins: C should give 0.
double measured_tail(double kappa, Decay how) {
  filters::FirstOrderHybrid c{1, how};
  c.push(1, kappa);
  return c.push(std::exp(-kappa), kappa);
}

void approximations(report::Item& item) {
  const auto table = item.printed("approximations.csv");
  item.expect_checks(static_cast<int>(2 * ways.size() * table.rows.size()));
  item.columns(
      {"κ", "speed for a corner of 1 Hz, mph", "1 − κ", "1/(1 + κ)", "Padé (1,1)", "Padé (2,2)"});
  for (const auto& cells : table.rows) {
    const std::string& key = cells.at(0);
    const double kappa = report::printed_number(key);
    std::vector<std::string> shown{
        key, fmt::format("{:.3g}", gyro_corner * sample_distance / kappa / units::mph)};
    for (const auto& [name, how] : ways) {
      const double by_definition = tail(kappa, how);
      item.row(table, key).check(name, by_definition);
      item.check(std::string{"measured-"} + name + "-" + key, "the same, measured", "",
                 table.at(key, name), measured_tail(kappa, how));
      shown.push_back(fmt::format("{:.2e}", by_definition));
    }
    item.add_row(shown);
  }
  item.reconstructed(
      "which approximation was coded is not known; the reference values were worked out "
      "beforehand");
  const double nine = gyro_corner * sample_distance / (9 * units::mph);
  item.value("tail-speed", 9, "mph", "{:.0f}");
  item.value("tail-linear", tail(nine, Decay::linear), "", "{:.2f}");
  item.value("tail-reciprocal", std::abs(tail(nine, Decay::reciprocal)), "", "{:.2f}");
  item.value("pade-speed", gyro_corner * sample_distance / 2 / units::mph, "mph", "{:.1f}");
}

void fig_approximations(report::Item& item) {
  auto& data = item.data({"speed_mph", "linear", "reciprocal", "pade11", "pade22"});
  constexpr int points = 200;
  for (int i = 0; i <= points; ++i) {
    const double speed = 0.5 * std::pow(240.0, static_cast<double>(i) / points);
    const double kappa = gyro_corner * sample_distance / (speed * units::mph);
    std::array<double, 4> size{};
    for (std::size_t w = 0; w < 4; ++w) size[w] = std::abs(tail(kappa, ways[w].second));
    data.add(speed, size[0], size[1], size[2], size[3]);
  }
  item.reconstructed("the corner of 1 Hz is ours, and which approximation was coded is not known");
}

}  // namespace

void add_approximations(report::Chapter& chapter) {
  chapter.table("approximations", "What an approximate exponential leaves of the past",
                approximations);
  chapter.figure("fig-approximations", "The same against speed", fig_approximations);
}

}  // namespace railbook::filters_chapter
