// Each channel by itself: what stands still, jumps, has lost its zero, or has a mean that cannot
// be.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <railbook/filters/hybrid_filter.hpp>
#include <railbook/geometry_car/detail/health_parts.hpp>
#include <railbook/num/median.hpp>
#include <railbook/num/pile.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::geometry_car {
namespace {

using units::nan;
constexpr std::size_t least_still = 40, most_still = 200;  // equal values in a row
constexpr double narrow = 22e-3, wide = 45e-3;  // m, of gage: outside is no track in service
constexpr double brisk = 10;                    // m/s: slower, a body moves more between two rows

struct Kind {
  bool filtered;  // twice, by F: smooth enough for fourth differences
  double jump;    // SI: smaller ones are left
  double zero;    // a step of more moves the mean of what is made of it
  const char* unit;
  double si;
  std::size_t side;  // rows to either side that a parabola follows
};
Kind kind_of(const ChannelInfo& c) {
  if (c.filter == 2) return {true, 0.02, 0.03, "m/s^2", 1, 8};
  if (c.filter == 1)
    return {false, 0.4 * units::degree, 0.2 * units::degree, "deg/s", units::degree, 8};
  return {false, 3e-3, 1.5e-3, "mm", 1e-3, 3};
}

struct StillStretch {
  std::size_t first, rows;
};

// Equal values in a row, where the channel's own habit does not explain them: eight times what all
// but one in a hundred of its changes take.
std::vector<StillStretch> still(const Column& x) {
  std::vector<StillStretch> all;
  std::array<std::size_t, most_still / 8 + 1> of_length{};  // stretches; the last: and longer ones
  std::size_t count = 0;
  for (std::size_t from = 0, end = 0; from < x.size(); from = end) {
    ++end;
    if (std::isnan(x[from])) continue;
    while (end < x.size() && x[end] == x[from]) ++end;
    ++count;
    ++of_length[std::min(end - from, of_length.size() - 1)];
    if (end - from >= least_still) all.push_back({from, end - from});
  }
  if (all.empty()) return all;
  std::size_t most = 0, below = count * 99 / 100;
  while (below >= of_length[most]) below -= of_length[most++];
  const std::size_t longest =
      count < 100 ? least_still : std::clamp(8 * most, least_still, most_still);
  std::erase_if(all, [&](const StillStretch& s) { return s.rows < longest; });
  return all;
}

double coarseness(View x) {
  double least = 0;
  for (std::size_t k = 1; k < x.size(); ++k) {
    const double d = std::abs(x[k] - x[k - 1]);
    if (!std::isnan(d) && d > 0 && (least == 0 || d < least)) least = d;
  }
  return least;
}

// Second or fourth differences, centred; NaN at the ends.
Column differences(View x, bool fourth) {
  Column e(x.size(), nan);
  const std::size_t reach = fourth ? 2 : 1;
  for (std::size_t k = reach; k + reach < x.size(); ++k)
    e[k] = fourth ? x[k - 2] - 4 * x[k - 1] + 6 * x[k] - 4 * x[k + 1] + x[k + 2]
                  : x[k - 1] - 2 * x[k] + x[k + 1];
  return e;
}

bool all_within(View x, double limit) {
  return std::all_of(x.begin(), x.end(),
                     [=](double v) { return within(v, limit) || std::isnan(v); });
}

// Places where a difference is out of all proportion to those about it. The first rows of a run are
// what they are; a body's own motion between rows grows with the square of the time, until at a
// walking pace it comes to rest there.
std::vector<bool> outliers(const Column& e, View T, double T_brisk, double floor) {
  constexpr std::size_t block = 128;
  std::vector<bool> out(e.size(), false);
  Column near;
  for (std::size_t from = 0; from < e.size(); from += block) {
    // No limit is below the floor, and the median takes time.
    if (all_within(View(e).subspan(from, std::min(block, e.size() - from)), floor)) continue;
    near.clear();
    for (std::size_t k = from - std::min(from, block); k < std::min(e.size(), from + 2 * block);
         ++k)
      if (!std::isnan(e[k])) near.push_back(std::abs(e[k]));
    const double limit = std::max(floor, 12 * 1.4826 * num::upper_median(near));
    for (std::size_t k = std::max<std::size_t>(from, 4); k < std::min(e.size(), from + block);
         ++k) {
      double longest = 0;
      for (std::size_t j = k - 2; j < std::min(e.size(), k + 3); ++j)
        longest = std::max(longest, T[j]);
      const double share = std::clamp(std::pow(longest / T_brisk, 2), 1.0, 20.0);
      const double allowed = std::max(limit, share * floor);
      out[k] = !std::isnan(e[k]) && std::abs(e[k]) > allowed;
    }
  }
  return out;
}

// A change of slope from one row to the next, which differences show as one peak; a spike or a step
// has two of either sign or more.
bool is_kink(const Column& e, std::size_t first, std::size_t last) {
  double sum = 0, size = 0;
  for (std::size_t k = first - std::min<std::size_t>(first, 1); k < std::min(e.size(), last + 2);
       ++k) {
    if (std::isnan(e[k])) continue;
    sum += e[k];
    size += std::abs(e[k]);
  }
  return std::abs(sum) >= 0.6 * size;
}

// Rows near a kink of either height: joints, which the accelerometers feel too.
std::vector<bool> near_kinks(const Run& run) {
  constexpr double least = 1e-3, times = 6;  // m; median differences
  constexpr std::size_t reach = 8;           // rows: of a kink through the analog filters
  std::vector<bool> near(run.size(), false);
  for (const Channel c : {Channel::height_left, Channel::height_right}) {
    const Column e = differences(run[c], false);
    Column sizes;
    for (const double value : e)
      if (!std::isnan(value)) sizes.push_back(std::abs(value));
    const double limit = std::max(least, times * 1.4826 * median(sizes));
    for (std::size_t k = 0; k < e.size(); ++k)
      if (std::isgreater(std::abs(e[k]), limit) && is_kink(e, k, k))
        for (std::size_t j = k - std::min(k, reach / 2); j < std::min(e.size(), k + reach + 1); ++j)
          near[j] = true;
  }
  return near;
}

// By how much the level differs behind [first, last], a parabola through both sides taken off: the
// part of a unit step that no parabola explains, and as much of it as is in x.
double level_change(View x, std::size_t first, std::size_t last, std::size_t side) {
  std::vector<Column> basis(5);  // 1, t, t^2, the step, x
  for (std::size_t k = first - std::min(first, side); k < std::min(x.size(), last + side + 1);
       ++k) {
    if ((k >= first && k <= last) || std::isnan(x[k])) continue;
    const double t = static_cast<double>(k) - static_cast<double>(first);
    const std::array<double, 5> row{1, t, t * t, k > last ? 1.0 : 0.0, x[k] - x[first - 1]};
    for (std::size_t j = 0; j < row.size(); ++j) basis[j].push_back(row[j]);
  }
  const auto dot = [](const Column& a, const Column& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
  };
  if (basis[0].size() < 2 * side - 1) return 0;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = j + 1; i < 5; ++i) {
      const double share = dot(basis[i], basis[j]) / dot(basis[j], basis[j]);
      for (std::size_t k = 0; k < basis[i].size(); ++k) basis[i][k] -= share * basis[j][k];
    }
  return dot(basis[4], basis[3]) / dot(basis[3], basis[3]);
}

struct Jumps {
  std::size_t count = 0, first = 0;
  double largest = 0;
  std::size_t steps = 0, first_step = 0;
  double largest_step = 0;
};

// A zero that has moved, and the largest of its moves.
struct Zero {
  double moved = 0, largest = 0;
};

// `zero` is that of the run so far; `then` becomes that at the row `at` of the record, where the
// run holds it.
void mask_jumps(const Run& run, const ChannelInfo& c, const Processing& p,
                std::vector<bool>& joints, Record& record, Health& health, Jumps& found, Zero zero,
                std::size_t at, Zero& then) {
  const auto channel = static_cast<std::size_t>(c.channel);
  const Kind kind = kind_of(c);
  View x = run.values[channel];
  const double least = (kind.filtered ? 3 : 1) * kind.jump;
  const Column e = differences(x, kind.filtered);
  Column unmasked;
  std::vector<bool> out;
  if (!all_within(e, least)) {
    unmasked.assign(x.begin(), x.end());
    x = unmasked;
    out = outliers(e, run.T, p.layout.sample / brisk,
                   std::max(least, (kind.filtered ? 9 : 3) * coarseness(x)));
    if (kind.filtered && joints.empty()) joints = near_kinks(run);
  }
  double &moved = zero.moved, &largest = zero.largest;  // since the run began
  const bool holds = run.rows.front() <= at && at <= run.rows.back();
  if (holds) then = zero;
  const std::size_t gap = kind.filtered ? 4 : 2;
  std::size_t known = 0;  // rows whose zero is settled
  const auto doubt_to = [&](std::size_t to) {
    for (; known < to; ++known)
      if (std::abs(moved) > std::max(kind.zero, 0.15 * largest))
        health.zero_doubted[channel][run.rows[known]] = true;
  };
  for (std::size_t k = 0; k < out.size(); ++k) {
    if (!out[k]) continue;
    std::size_t last = k;
    double peak = 0;
    for (std::size_t j = k; j < std::min(x.size(), last + gap + 1); ++j)
      if (out[j]) last = j;
    const bool joint = kind.filtered ? joints[k] : c.filter == 0 && is_kink(e, k, last);
    if (joint) {
      k = last;
      continue;
    }
    for (std::size_t j = k; j <= last; ++j) {
      if (j > 0) peak = std::max(peak, std::abs(x[j] - x[j - 1]));
      if (p.mask_jumps)
        record.values[channel][run.rows[j]] = nan;
      else
        health.doubted[channel][run.rows[j]] = true;
    }
    const double change = level_change(x, k, last, kind.side);
    doubt_to(k);
    ++found.count;
    if (found.count == 1) found.first = run.rows[k];
    found.largest = std::max(found.largest, peak);
    if (std::abs(change) > std::max(kind.zero, 0.4 * peak)) {
      for (std::size_t j = k; j <= last; ++j) health.doubted[channel][run.rows[j]] = true;
      moved += change;
      largest = std::max(largest, std::abs(change));
      if (holds && run.rows[k] < at) then = zero;
      if (++found.steps == 1) found.first_step = run.rows[k];
      found.largest_step = std::max(found.largest_step, std::abs(change));
    }
    k = last;
  }
  doubt_to(x.size());
}

// A channel whose changes are of one step, nine times in ten: it is coarse, and standing still is
// its habit.
bool is_coarse(const Column& x) {
  const double step = coarseness(x);
  std::size_t changes = 0, single = 0;
  for (std::size_t k = 1; k < x.size(); ++k) {
    const double d = std::abs(x[k] - x[k - 1]);
    if (std::isnan(d) || d == 0) continue;
    ++changes;
    single += d < 1.5 * step ? 1 : 0;
  }
  return changes > 0 && 10 * single >= 9 * changes;
}

void examine_still(const ChannelInfo& c, const Processing& p, Record& record, Health& health) {
  Column& x = record[c.channel];
  if (std::all_of(x.begin(), x.end(), [](double v) { return std::isnan(v); })) {
    health.findings.push_back(
        {Fault::dead, std::string{c.name}, 0, x.size(), 0, "no value at all"});
    return;
  }
  const auto stretches = still(x);
  if (stretches.empty()) return;
  const bool coarse = is_coarse(x);
  std::size_t rows = 0;
  for (const StillStretch& s : stretches) {
    rows += s.rows;
    const auto first = static_cast<std::ptrdiff_t>(s.first);
    if (!coarse && p.mask_still)
      std::fill_n(x.begin() + first, s.rows, nan);
    else if (!coarse)
      std::fill_n(health.doubted[static_cast<std::size_t>(c.channel)].begin() + first, s.rows,
                  true);
  }
  health.findings.push_back(
      {Fault::still, std::string{c.name}, stretches[0].first, rows, 0,
       fmt::format("{} rows without a change, {}", rows,
                   coarse         ? "which its coarse steps explain: kept"
                   : p.mask_still ? "masked"
                                  : "kept, and not trusted (--screen still masks them)")});
}

// A converter at both of its ends. An acceleration that has been filtered twice has no such crests.
void examine_clipping(const ChannelInfo& c, Record& record, Health& health) {
  if (c.filter != 2) return;
  Column& x = record[c.channel];
  const auto lowest = num::pile(x, 1), highest = num::pile(x, -1);
  if (!lowest || !highest) return;
  const double low = *lowest, high = *highest;
  std::size_t first = x.size(), rows = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] != low && x[i] != high) continue;
    first = std::min(first, i);
    ++rows;
    x[i] = nan;
  }
  health.findings.push_back({Fault::still, std::string{c.name}, first, rows, high - low,
                             fmt::format("{} rows at the ends of its range, masked", rows)});
}

// Of all rows: the mean of an accelerometer is gravity on a lean at most, and gage sensors read
// about zero.
void examine_level(const Record& record, const Processing& p, Health& health) {
  using enum Channel;
  for (const ChannelInfo& c : channel_list()) {
    if (c.filter != 2) continue;
    Column values;
    for (const double v : record[c.channel])
      if (!std::isnan(v)) values.push_back(v);
    const double middle = median(values);
    if (std::abs(middle) < 3) continue;
    health.findings.push_back(
        {Fault::level, std::string{c.name}, 0, record.size(), middle,
         fmt::format("its median is {:.3g} m/s^2; gravity left in?", middle)});
    const auto i = static_cast<std::size_t>(c.channel);
    health.doubted[i].assign(record.size(), true);
  }
  // Running lines lie a rail head, and twice a quarter of one, further apart than gage faces: 76 mm
  // on the default car.
  const double expected = p.layout.base - 76.2e-3;
  std::size_t off = 0, known = 0, first = 0;
  Column values;
  for (std::size_t k = 0; k < record.size(); ++k) {
    const double gage = record[gage_left][k] + record[gage_right][k] + p.layout.beam;
    const bool rejected = k > 0 && !filters::possible_interval(record.elapsed[k]);
    if (std::isnan(gage) || rejected) continue;
    ++known;
    if (gage > expected - narrow && gage < expected + wide) continue;
    if (off++ == 0) first = k;
    values.push_back(gage);
    for (const Channel c : {gage_left, gage_right})
      health.doubted[static_cast<std::size_t>(c)][k] = true;
  }
  if (off > 0)
    health.findings.push_back(
        {Fault::level, "gage", first, off, median(values),
         fmt::format("{:.1f} mm in {} of {} rows, where base says {:.0f} to {:.0f}",
                     median(values) * 1e3, off, known, (expected - narrow) * 1e3,
                     (expected + wide) * 1e3)});
}

// Zeros that the whole record tells: no track leans further and further, nor is it nowhere
// straight, nor does it fall without end.
void examine_zeros(const Record& record, const Processing& p, Health& health) {
  using enum Channel;
  constexpr double most_lean = 0.15;                  // rad, from one end to the other
  constexpr double least_yaw = 0.14 * units::degree;  // rad/s: 10 mm of crosslevel at 60 mph
  constexpr double least_vertical = 0.047;            // m/s^2: 20 mm of a space curve
  const auto report = [&](Channel c, double size, std::string text) {
    const auto i = static_cast<std::size_t>(c);
    health.zero_doubted[i].assign(record.size(), true);
    health.findings.push_back({Fault::level, std::string{channel_list()[i].name}, 0, record.size(),
                               size, std::move(text)});
  };
  double turned = 0, time = 0;
  constexpr std::size_t smooth = 100;  // rows: sway and line are shorter
  Column yaw;
  double sum = 0;
  std::size_t rows = 0;
  for (std::size_t k = 1; k < record.size(); ++k) {
    const double T = record.elapsed[k];
    if (!filters::possible_interval(T) || T * 1.0 > p.layout.sample) continue;  // at a crawl
    if (!std::isnan(record[roll_rate][k])) turned += T * record[roll_rate][k], time += T;
    if (std::isnan(record[yaw_rate][k])) continue;
    sum += record[yaw_rate][k];
    if (++rows % smooth > 0) continue;
    yaw.push_back(sum / smooth);
    sum = 0;
  }
  if (std::abs(turned) > most_lean)
    report(
        roll_rate, turned / time,
        fmt::format("its mean over {:.3g} s is {:.2g} deg/s, which turns the car by {:.2g} rad: a "
                    "bias? Crosslevel rests on it; see --roll-bias",
                    time, turned / time / units::degree, turned));
  // The shortest interval with three tenths of all rows, where next to none is straight.
  std::sort(yaw.begin(), yaw.end());
  if (const std::size_t part = 3 * yaw.size() / 10; part > 5) {
    std::size_t best = 0;
    for (std::size_t i = 0; i + part < yaw.size(); ++i)
      if (yaw[i + part] - yaw[i] < yaw[best + part] - yaw[best]) best = i;
    const double usual = yaw[best + part / 2];
    const auto straight = std::count_if(yaw.begin(), yaw.end(), [&](double rate) {
      return std::abs(rate) < 0.5 * std::abs(usual);
    });
    if (std::abs(usual) > least_yaw && 20 * static_cast<std::size_t>(straight) < yaw.size())
      report(
          yaw_rate, usual,
          fmt::format("it is {:.2g} deg/s most of the time and hardly ever near zero: a bias, or "
                      "a record without straight track? Curvature and crosslevel rest on it; see "
                      "--yaw-bias",
                      usual / units::degree));
  }
  if (p.chain.high_pass.stages > 1) return;
  // Both feel the same hills; what roll adds to one and takes from the other has no mean.
  double apart = 0, known = 0;
  for (std::size_t k = 0; k < record.size(); ++k) {
    const double difference = record[vertical_left][k] - record[vertical_right][k];
    if (!std::isnan(difference)) apart += difference, known += 1;
  }
  apart /= std::max(known, 1.0);
  if (!(std::abs(apart) > least_vertical && std::abs(apart) < 1)) return;
  health.zero_doubted[static_cast<std::size_t>(vertical_right)].assign(record.size(), true);
  report(
      vertical_left, apart,
      fmt::format("its mean is {:.2g} m/s^2 above that of vertical_right: a bias of one of them? "
                  "The surfaces rest on it; --stages 2 frees them",
                  apart));
}

}  // namespace

void examine_channels(Record& record, std::vector<Run>& runs, const Processing& p, Health& health,
                      ChannelOffsets& carried, std::size_t at) {
  for (const ChannelInfo& c : channel_list()) {
    examine_still(c, p, record, health);
    examine_clipping(c, record, health);
  }
  std::array<Jumps, channels> found;
  const ChannelOffsets before = std::exchange(carried, {.leapt = carried.leapt});
  for (Run& run : runs) {
    load(run, record);
    std::vector<bool> joints;  // made where they are asked for
    for (std::size_t i = 0; i < channels; ++i) {
      Zero then{carried.moved[i], carried.largest[i]};
      mask_jumps(run, channel_list()[i], p, joints, record, health, found[i],
                 run.rows.front() == 0 ? Zero{before.moved[i], before.largest[i]} : Zero{}, at,
                 then);
      carried.moved[i] = then.moved;
      carried.largest[i] = then.largest;
    }
  }
  for (const ChannelInfo& c : channel_list()) {
    const Jumps& j = found[static_cast<std::size_t>(c.channel)];
    const Kind kind = kind_of(c);
    if (j.count > 0)
      health.findings.push_back(
          {Fault::jump, std::string{c.name}, j.first, j.count, j.largest,
           fmt::format(
               "{} jump{} of up to {:.2g} {}, {}", j.count, j.count > 1 ? "s" : "",
               j.largest / kind.si, kind.unit,
               p.mask_jumps ? "masked" : "kept, and not trusted (--screen jumps masks them)")});
    if (j.steps > 0)
      health.findings.push_back(
          {Fault::step, std::string{c.name}, j.first_step, j.steps, j.largest_step,
           fmt::format("its zero moved, by up to {:.2g} {}", j.largest_step / kind.si, kind.unit)});
  }
  examine_level(record, p, health);
  examine_zeros(record, p, health);
}

}  // namespace railbook::geometry_car
