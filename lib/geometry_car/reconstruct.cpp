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
  for (const std::size_t i : run.rows) {
    double T = record.elapsed[i];
    // A rejected row took its share of the time.
    if (!run.T.empty())
      for (std::size_t j = i - 1; j > run.rows[run.T.size() - 1]; --j)
        if (record.elapsed[j] > 0) T += record.elapsed[j];
    run.T.push_back(T);
    for (std::size_t c = 0; c < channels; ++c) run.values[c].push_back(record.values[c][i]);
  }
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
                     std::to_string(chords) + " short chords of one long chord with its high-pass"};
}

Measurement reconstruct_runs(const Record& record, const Processing& processing,
                             std::vector<Run> runs) {
  Measurement result;
  result.mark = record.mark;
  result.speed.assign(record.size(), nan);
  for (auto& values : result.values) values.assign(record.size(), nan);
  result.runs = runs.size();
  for (Run& run : runs) {
    load(run, record);
    const std::size_t n = run.rows.size();
    for (std::size_t k = n > 1 ? 1 : n; k < n; ++k)
      result.speed[run.rows[k]] = run.direction * processing.layout.sample / run.T[k];
    const auto columns = process(run, processing, record.mark);
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
  const auto half = static_cast<std::size_t>(p.chain.half_chord);
  const double chord = 2 * static_cast<double>(half) * p.layout.sample;
  std::vector<Quality> result(m.size(), Quality::good);
  for (std::size_t i = 0; i < m.size(); ++i) {
    const double v = std::abs(m.speed[i]);
    if (std::isnan(v)) continue;
    double braking = 0;
    if (is_profile(parameter) && v >= info.unreliable_below && i >= half && i + half < m.size()) {
      const double before = m.speed[i - half], after = m.speed[i + half];
      if (!std::isnan(before) && !std::isnan(after))
        braking =
            braking_error(p.steepest, (after * after - before * before) / (2 * chord), chord, v);
    }
    const double level = is_alignment(parameter) ? levelling_error(chord, v) : 0;
    if (v < info.unreliable_below || braking > braking_spoils || level > levelling_spoils)
      result[i] = Quality::unreliable;
    else if (v < info.degraded_below || braking > braking_degrades || level > levelling_degrades)
      result[i] = Quality::degraded;
  }
  return result;
}

}  // namespace

std::vector<Quality> quality(const Measurement& m, Parameter parameter, const Processing& p) {
  const std::size_t n = m.size(), reach = reach_of(parameter, p);
  std::vector<Quality> result = row_quality(m, parameter, p);
  std::vector<std::size_t> degraded(n + 1), unreliable(n + 1);  // how many before each row
  for (std::size_t i = 0; i < n; ++i) {
    degraded[i + 1] = degraded[i] + (result[i] == Quality::degraded ? 1 : 0);
    unreliable[i + 1] = unreliable[i] + (result[i] == Quality::unreliable ? 1 : 0);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t from = i - std::min(i, reach), to = std::min(n, i + reach + 1);
    result[i] = std::isnan(m[parameter][i])         ? Quality::missing
                : unreliable[to] > unreliable[from] ? Quality::unreliable
                : degraded[to] > degraded[from]     ? Quality::degraded
                                                    : Quality::good;
  }
  return result;
}

}  // namespace railbook::geometry_car
