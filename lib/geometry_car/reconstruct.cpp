#include <railbook/geometry_car/reconstruct.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <railbook/geometry_car/detail/run.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::geometry_car {
namespace {

using units::nan;

}  // namespace

std::vector<Run> runs_of(const Record& record, const Processing& p, std::size_t& rejected) {
  std::vector<Run> runs;
  bool broken = true;
  for (std::size_t i = 0; i < record.size(); ++i) {
    // The first row has no row before it: its time means nothing.
    const double T = record.elapsed[i];
    if (i > 0 && !(filters::possible_interval(T) && T * p.fastest >= p.layout.sample)) {
      ++rejected;
      continue;
    }
    const long step = broken ? 0 : record.mark[i] - record.mark[runs.back().rows.back()];
    const bool goes_on = !broken && (step == 1 || step == -1) &&
                         (runs.back().rows.size() == 1 || step == runs.back().direction);
    if (!goes_on) runs.emplace_back();
    broken = false;
    Run& run = runs.back();
    if (run.rows.size() == 1) run.direction = static_cast<int>(step);
    run.rows.push_back(i);
  }
  return runs;
}

void load(Run& run, const Record& record) {
  const std::size_t n = run.rows.size(), first = run.rows.front();
  if (run.rows.back() - first + 1 == n) {
    run.T = View(record.elapsed).subspan(first, n);
    for (std::size_t c = 0; c < channels; ++c)
      run.values[c] = View(record.values[c]).subspan(first, n);
    return;
  }
  run.own.clear();
  run.own.reserve((channels + 1) * n);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = run.rows[k];
    double T = record.elapsed[i];
    // A rejected row took its share of the time.
    if (k > 0)
      for (std::size_t j = i - 1; j > run.rows[k - 1]; --j)
        if (record.elapsed[j] > 0) T += record.elapsed[j];
    run.own.push_back(T);
  }
  for (const Column& values : record.values)
    for (const std::size_t i : run.rows) run.own.push_back(values[i]);
  run.T = View(run.own).first(n);
  for (std::size_t c = 0; c < channels; ++c) run.values[c] = View(run.own).subspan((c + 1) * n, n);
}

void require(const Record& record, const Processing& p) {
  const Layout& l = p.layout;
  units::require_positive("distance between samples", l.sample, "m");
  units::require_between("base", l.base, 0.5, 3, "m");
  units::require_between("spacing of the transducers", l.transducers, 0.5, 4, "m");
  units::require_between("spacing of the trucks", l.truck_spacing, 2 * l.sample, 100, "m");
  units::require_between("length of the beam", l.beam, 0, 3, "m");
  units::require_between("height of the inclinometer", l.inclinometer_height, -5, 5, "m");
  units::require_between("height of the beam", l.beam_height, -5, 5, "m");
  units::require_positive("corner of B", l.first_corner, "Hz");
  units::require_positive("corner of F", l.second_corner, "Hz");
  units::require_positive("corner of the roll filter", p.roll_corner, "Hz");
  units::require_positive("fastest speed", p.fastest, "m/s");
  units::require_between("steepest grade", p.steepest, 0, 0.1);
  units::require_between("samples of the curvature's mean", p.curvature_mean, 3, 1001);
  if (p.curvature_mean % 2 == 0)
    throw InputError{"samples of the curvature's mean are " + std::to_string(p.curvature_mean) +
                     "; allowed: odd numbers"};
  if (record.elapsed.size() != record.size()) throw InputError{"record: a time for each mark"};
  for (const ChannelInfo& c : channel_list())
    if (record[c.channel].size() != record.size())
      throw InputError{"record: channel " + std::string(c.name) + " has " +
                       std::to_string(record[c.channel].size()) +
                       " values; allowed: " + std::to_string(record.size())};
}

const std::array<ParameterInfo, parameters>& parameter_list() {
  using enum Parameter;
  constexpr double mm = units::millimetre, mph = units::mph;
  static const std::array<ParameterInfo, parameters> list{{
      {gage, "gage", "mm", mm, 0, 0},
      {curvature, "curvature", "rad_per_km", 1e-3, 2 * mph, 2 * mph},
      {curvature_rate, "curvature_rate", "rad_per_km2", 1e-6, 2 * mph, 2 * mph},
      {crosslevel, "crosslevel", "mm", mm, 0, 0},
      {warp, "warp", "mm", mm, 0, 0},
      {profile_left, "profile_left", "mm", mm, 15 * mph, 5 * mph},
      {profile_right, "profile_right", "mm", mm, 15 * mph, 5 * mph},
      {alignment_left, "alignment_left", "mm", mm, 15 * mph, 5 * mph},
      {alignment_right, "alignment_right", "mm", mm, 15 * mph, 5 * mph},
      {surface_left, "surface_left", "mm", mm, 15 * mph, 5 * mph},
      {surface_right, "surface_right", "mm", mm, 15 * mph, 5 * mph},
      {line_left, "line_left", "mm", mm, 15 * mph, 5 * mph},
      {line_right, "line_right", "mm", mm, 15 * mph, 5 * mph},
  }};
  return list;
}

void require_length(std::size_t longest, const Processing& processing) {
  const std::size_t chords =
      samples_needed(processing);  // short ones; two samples more for their ends
  if (longest < chords + 2)
    throw InputError{"the longest run without a gap or a turn has " + std::to_string(longest) +
                     " samples; allowed: at least " + std::to_string(chords + 2) + ", for the " +
                     std::to_string(chords) + " short chords of one long chord with its high-pass" +
                     (longest < 3 ? "; are the samples as far apart as --sample says?" : "")};
}

Measurement reconstruct_runs(const Record& record, const Processing& processing,
                             std::vector<Run> runs) {
  Measurement result;
  result.mark = record.mark;
  result.speed.assign(record.size(), nan);
  for (auto& values : result.values) values.assign(record.size(), nan);
  result.runs = runs.size();
  for (Run& run : runs) {
    const std::size_t n = run.size();
    for (std::size_t k = n > 1 ? 1 : n; k < n; ++k)
      result.speed[run.rows[k]] = run.direction * processing.layout.sample / run.T[k];
    auto columns = process(run, processing, record.mark);
    if (n == record.size())
      result.values = std::move(columns);
    else
      for (std::size_t p = 0; p < parameters; ++p)
        for (std::size_t k = 0; k < n; ++k) result.values[p][run.rows[k]] = columns[p][k];
    run = {};
  }
  return result;
}

Measurement reconstruct(const Record& record, const Processing& processing) {
  require(record, processing);
  std::size_t rejected = 0, longest = 0;
  std::vector<Run> runs = runs_of(record, processing, rejected);
  for (const Run& run : runs) longest = std::max(longest, run.rows.size());
  require_length(longest, processing);
  for (Run& run : runs) prepare(run, record, processing);
  Measurement result = reconstruct_runs(record, processing, std::move(runs));
  result.rejected = rejected;
  return result;
}

double braking_error(double grade, double rate, double chord, double speed) {
  return grade * std::abs(rate) * chord * chord / (8 * speed * speed);
}

double levelling_error(double chord, double speed) {
  return 2.6e-3 * chord / 18.9 * chord / speed;
}

namespace {

bool is_alignment(Parameter p) {
  using enum Parameter;
  return p == alignment_left || p == alignment_right || p == line_left || p == line_right;
}

bool is_profile(Parameter p) {
  using enum Parameter;
  return p == profile_left || p == profile_right || p == surface_left || p == surface_right;
}

// What can be said of one row by itself, its value aside.
std::vector<Quality> row_quality(const Measurement& m, Parameter parameter, const Processing& p) {
  const ParameterInfo& info = parameter_list()[static_cast<std::size_t>(parameter)];
  const std::size_t n = m.size(), half = static_cast<std::size_t>(p.chain.half_chord);
  const double chord = 2 * static_cast<double>(half) * p.layout.sample;
  // The errors are so much over the speed, and times the change of its square over its square.
  const double level = is_alignment(parameter) ? levelling_error(chord, 1) : 0;
  const double braking =
      is_profile(parameter) ? braking_error(p.steepest, 1 / (2 * chord), chord, 1) : 0;
  const double degraded = std::max(info.degraded_below, level / levelling_degrades),
               unreliable = std::max(info.unreliable_below, level / levelling_spoils);
  std::vector<Quality> result(n, Quality::good);
  for (std::size_t i = 0; i < n && degraded > 0; ++i) {
    const double v = std::abs(m.speed[i]);
    if (std::isnan(v)) continue;
    double change = 0;
    if (braking > 0 && i >= half && i + half < n) {
      const double before = m.speed[i - half], after = m.speed[i + half];
      change = braking * std::abs(after * after - before * before);
      if (std::isnan(change)) change = 0;
    }
    if (v >= degraded && change <= braking_degrades * v * v) continue;
    const bool spoilt = v < unreliable || change > braking_spoils * v * v;
    result[i] = spoilt ? Quality::unreliable : Quality::degraded;
  }
  return result;
}

}  // namespace

std::vector<Quality> quality(const Measurement& m, Parameter parameter, const Processing& p) {
  const std::size_t n = m.size(), reach = reach_of(parameter, p);
  const std::vector<Quality> rows = row_quality(m, parameter, p);
  std::vector<Quality> result(n);
  for (std::size_t i = 0; i < n; ++i)
    result[i] = std::isnan(m[parameter][i]) ? Quality::missing : Quality::good;
  for (const Quality q : {Quality::degraded, Quality::unreliable})
    spread(result, reach, q, rows, q);
  return result;
}

}  // namespace railbook::geometry_car
