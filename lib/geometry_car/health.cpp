#include <railbook/geometry_car/health.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <railbook/geometry_car/detail/health_parts.hpp>
#include <railbook/num/median.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::geometry_car {
namespace {

constexpr double hardest = 6;     // m/s^2: no train brakes or gathers speed so
constexpr std::size_t about = 9;  // rows whose median is a speed

// Which channels a parameter is made of; `mean`: those whose zero is in it.
std::vector<Channel> sources(Parameter parameter, bool mean, const Processing& p) {
  using enum Channel;
  const bool curves =
      p.chain.high_pass.stages == 1;  // a constant acceleration shifts a space curve
  std::vector<Channel> none, lean{inclinometer, yaw_rate, roll_rate},
      attitude{inclinometer, yaw_rate, roll_rate, height_left, height_right};
  const auto with = [](std::vector<Channel> list, std::initializer_list<Channel> more) {
    list.insert(list.end(), more);
    return list;
  };
  switch (parameter) {
    case Parameter::gage:
      return {gage_left, gage_right};
    case Parameter::curvature:
    case Parameter::curvature_rate:
      if (mean) return parameter == Parameter::curvature ? std::vector{yaw_rate} : none;
      return {yaw_rate, sway_front_a, sway_front_b, sway_rear};
    case Parameter::crosslevel:
      return attitude;
    case Parameter::warp:
      return mean ? none : attitude;
    case Parameter::profile_left:
    case Parameter::profile_right:
      return mean ? lean : with(attitude, {vertical_left, vertical_right});
    case Parameter::surface_left:
    case Parameter::surface_right:
      if (mean) return curves ? with(lean, {vertical_left, vertical_right}) : lean;
      return with(attitude, {vertical_left, vertical_right});
    case Parameter::alignment_left:
    case Parameter::alignment_right:
    case Parameter::line_left:
    case Parameter::line_right: {
      const bool curve = parameter == Parameter::line_left || parameter == Parameter::line_right,
                 left = parameter == Parameter::line_left || parameter == Parameter::alignment_left;
      if (mean) return curve && curves ? with(attitude, {lateral}) : none;
      return with(attitude, {lateral, left ? gage_left : gage_right});
    }
  }
  return none;
}

// The median of nine, without branches (N. Devillard, Fast median search, 1998).
double median_of_nine(const double* x) {
  static constexpr std::pair<int, int> exchanges[]{
      {1, 2}, {4, 5}, {7, 8}, {0, 1}, {3, 4}, {6, 7}, {1, 2}, {4, 5}, {7, 8}, {0, 3},
      {5, 8}, {4, 7}, {3, 6}, {1, 4}, {2, 5}, {4, 7}, {4, 2}, {6, 4}, {4, 2}};
  std::array<double, about> v;
  std::copy_n(x, about, v.begin());
  for (const auto& [one, other] : exchanges) {
    double &a = v[static_cast<std::size_t>(one)], &b = v[static_cast<std::size_t>(other)];
    const double low = std::min(a, b), high = std::max(a, b);
    a = low;
    b = high;
  }
  return v[about / 2];
}

// A clock that stands, leaps or was stopped shows in the speed. `leapt`: it did before in this run;
// comes back for the row `at`.
void examine_speed(const Run& run, const Processing& p, Health& health, bool leapt, std::size_t at,
                   bool& then) {
  const std::size_t n = run.size();
  const bool holds = run.rows.front() <= at && at <= run.rows.back();
  if (holds) then = leapt;
  if (leapt)
    for (const std::size_t row : run.rows) health.clock_doubted[row] = true;
  if (n < 4 * about) return;
  Column v(n, 0);
  for (std::size_t k = 1; k < n; ++k) v[k] = p.layout.sample / run.T[k];
  v[0] = v[1];
  std::size_t steps = 0, first = 0, known = 0, lasting = n;
  double hard = 0;
  constexpr std::size_t block = 32;
  for (std::size_t k = about + 1; k + about <= n; ++k) {
    if (k % block == 0) {  // speeds that differ so little cannot leap
      const auto nearby = v.begin() + static_cast<std::ptrdiff_t>(k - about);
      const auto [least, most] = std::minmax_element(
          nearby, nearby + std::min<std::ptrdiff_t>(block + 2 * about, v.end() - nearby));
      if (*most <= 1.3 * *least &&
          *most * *most - *least * *least <=
              hardest * (2 * static_cast<double>(about) * p.layout.sample)) {
        k += block - 1;
        continue;
      }
    }
    const double before = median_of_nine(&v[k - about]), after = median_of_nine(&v[k]), here = v[k];
    const double rate =
        (after * after - before * before) / (2 * static_cast<double>(about) * p.layout.sample);
    const double beside = std::abs(here * here - before * before) / (2 * p.layout.sample);
    const bool leap =
        (here > 1.3 * std::max(before, after) || 1.3 * here < std::min(before, after)) &&
        beside > 2 * hardest;
    if (std::abs(rate) <= hardest && !leap) continue;
    if (steps == 0 || k > known + about) ++steps;
    if (steps == 1 && known == 0) first = run.rows[k];
    known = k;
    hard = std::max(hard, leap ? beside : std::abs(rate));
    for (std::size_t j = k - about; j < k + about; ++j) health.clock_doubted[run.rows[j]] = true;
    if (!leap) lasting = std::min(lasting, k);
    // A time that was held before the leap says nothing of its rows.
    for (std::size_t j = k; j > 1 && run.T[j - 1] == run.T[k - 1]; --j)
      health.clock_doubted[run.rows[j - 1]] = true;
  }
  // Which of two speeds is the right one is not known.
  for (std::size_t k = lasting; k < n; ++k) health.clock_doubted[run.rows[k]] = true;
  if (holds && lasting < n && run.rows[lasting] < at) then = true;
  if (steps > 0)
    health.findings.push_back(
        {Fault::clock, "elapsed", first, steps, hard,
         fmt::format("the speed leaps {}, as at {:.2g} m/s^2",
                     steps > 1 ? fmt::format("{} times", steps) : "once", hard)});
}

}  // namespace

const char* name_of(Fault fault) {
  static constexpr std::array<const char*, faults> names{
      "dead", "still", "jump", "step", "level", "scale", "inconsistent", "clock", "place"};
  return names[static_cast<std::size_t>(fault)];
}

double median(Column values) {
  return num::upper_median(values);
}

void examine_clock(const Record& record, const std::vector<Run>& runs, std::size_t rejected,
                   const Processing& p, Health& health, bool& leapt, std::size_t at) {
  Column T;
  std::vector<bool> used(record.size(), false);
  const bool before = std::exchange(leapt, false);
  for (const Run& run : runs) {
    for (const std::size_t i : run.rows) used[i] = true;
    examine_speed(run, p, health, before && run.rows.front() == 0, at, leapt);
    T.insert(T.end(), run.T.begin() + 1, run.T.end());
  }
  if (rejected > 3 && 1000 * rejected > record.size())
    health.findings.push_back(
        {Fault::clock, "elapsed", 0, rejected, 0,
         fmt::format("{} of {} rows have no time that can be", rejected, record.size())});
  if (const double typical = p.layout.sample / std::max(median(T), 1e-9);
      !T.empty() && (typical < 0.5 || typical > 120)) {
    health.findings.push_back(
        {Fault::clock, "elapsed", 0, record.size(), typical,
         fmt::format(
             "a speed of {:.2g} m/s; are the times in the unit of their header? What depends on "
             "them counts as unreliable",
             typical)});
    health.clock_doubted.assign(record.size(), true);
  }
  // Rows that repeat a mark, but for the one where the car turns.
  std::size_t held = 0, first = 0;
  for (std::size_t k = 1; k + 1 < record.size(); ++k) {
    if (record.mark[k] != record.mark[k - 1] || !used[k]) continue;
    if (record.mark[k + 1] != record.mark[k] && (k < 2 || record.mark[k - 2] != record.mark[k])) {
      const long after = record.mark[k + 1] - record.mark[k];
      const long previous = k < 2 ? -after : record.mark[k - 1] - record.mark[k - 2];
      if (after == -previous) continue;
    }
    if (held++ == 0) first = k;
    health.place_doubted[k] = health.place_doubted[k - 1] = true;
  }
  if (held > 0)
    health.findings.push_back({Fault::place, "distance", first, held, 0,
                               fmt::format("it stands still over {} rows", held)});
}

Health examine(Record& record, const Processing& processing) {
  ChannelOffsets nothing;
  return examine(record, processing, nothing, record.size());
}

Health examine(Record& record, const Processing& processing, ChannelOffsets& carried,
               std::size_t at) {
  require(record, processing);
  std::vector<Run> runs;
  return examine(record, processing, carried, at, runs);
}

Health examine(Record& record, const Processing& processing, ChannelOffsets& carried,
               std::size_t at, std::vector<Run>& runs) {
  Health health;
  for (auto* rows : {&health.doubted, &health.zero_doubted})
    for (auto& channel : *rows) channel.assign(record.size(), false);
  health.place_doubted.assign(record.size(), false);
  health.clock_doubted.assign(record.size(), false);
  std::size_t rejected = 0;
  runs = runs_of(record, processing, rejected);
  examine_channels(record, runs, processing, health, carried, at);
  for (Run& run : runs) prepare(run, record, processing);
  examine_clock(record, runs, rejected, processing, health, carried.leapt, at);
  examine_consistency(record, runs, processing, health);
  return health;
}

std::vector<Quality> quality(const Measurement& m, Parameter parameter, const Processing& p,
                             const Health& health) {
  std::vector<Quality> result = quality(m, parameter, p);
  const auto doubt = [&](const std::vector<char>& rows) {
    spread(result, reach_of(parameter, p), Quality::unreliable, rows, char{true});
  };
  doubt(health.place_doubted);
  if (parameter != Parameter::gage) doubt(health.clock_doubted);
  for (const Channel c : sources(parameter, false, p))
    doubt(health.doubted[static_cast<std::size_t>(c)]);
  for (const Channel c : sources(parameter, true, p))
    doubt(health.zero_doubted[static_cast<std::size_t>(c)]);
  return result;
}

}  // namespace railbook::geometry_car
