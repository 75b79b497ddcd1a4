#include <railbook/geometry_car/health.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <railbook/geometry_car/detail/health_parts.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::geometry_car {
namespace {

constexpr double hardest = 6;  // m/s^2: no train brakes or gathers speed so
constexpr std::size_t about = 9;

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
  Column middle(n, 0), window(about);  // medians of the rows from each one on
  for (std::size_t k = 1; k + about <= n; ++k) {
    std::copy_n(v.begin() + static_cast<std::ptrdiff_t>(k), about, window.begin());
    middle[k] = median_of(window);
  }
  for (std::size_t k = about + 1; k + about <= n; ++k) {
    const double before = middle[k - about], after = middle[k], here = v[k];
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
  return median_of(values);
}

double median_of(Column& values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void examine_clock(const Record& record, const Processing& p, Health& health, bool& leapt,
                   std::size_t at) {
  std::size_t rejected = 0;
  Column T;
  std::vector<bool> used(record.size(), false);
  const bool before = std::exchange(leapt, false);
  for (Run& run : runs_of(record, p, rejected)) {
    load(run, record);
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
  Health health;
  for (auto* rows : {&health.doubted, &health.zero_doubted})
    for (auto& channel : *rows) channel.assign(record.size(), false);
  health.place_doubted.assign(record.size(), false);
  health.clock_doubted.assign(record.size(), false);
  examine_channels(record, processing, health, carried, at);
  examine_clock(record, processing, health, carried.leapt, at);
  examine_consistency(record, processing, health);
  return health;
}

std::vector<Quality> quality(const Measurement& m, Parameter parameter, const Processing& p,
                             const Health& health) {
  const std::size_t n = m.size(), reach = reach_of(parameter, p);
  std::vector<Quality> result = quality(m, parameter, p);
  const std::vector<Channel> values = sources(parameter, false, p),
                             means = sources(parameter, true, p);
  std::vector<std::size_t> doubts(n + 1);  // before each row
  for (std::size_t i = 0; i < n; ++i) {
    bool doubt =
        health.place_doubted[i] || (parameter != Parameter::gage && health.clock_doubted[i]);
    for (const Channel c : values) doubt = doubt || health.doubted[static_cast<std::size_t>(c)][i];
    for (const Channel c : means)
      doubt = doubt || health.zero_doubted[static_cast<std::size_t>(c)][i];
    doubts[i + 1] = doubts[i] + (doubt ? 1 : 0);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t from = i - std::min(i, reach), to = std::min(n, i + reach + 1);
    if (doubts[to] > doubts[from] && result[i] != Quality::missing) result[i] = Quality::unreliable;
  }
  return result;
}

}  // namespace railbook::geometry_car
