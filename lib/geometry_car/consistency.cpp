// Which sensor is a factor off, by the balances of all (balances.cpp). With one a factor off, the
// sum still vanishes once its term is multiplied by that factor: so the sensor is found.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <railbook/geometry_car/detail/health_parts.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::geometry_car {
namespace {

constexpr std::size_t block = 128, least_block = 64;
constexpr double evident = 0.03;        // m/s^2, rms: less of a motion proves nothing
constexpr double moved_zero = 0.1;      // m/s^2 of a block's mean: 15 mm of crosslevel
constexpr double shifted_zero = 0.033;  // of the record's mean, which is known to 0.001: 5 mm

// A stretch of a balance, freed of its straight line.
struct Piece {
  std::vector<Channel> channels;
  std::vector<Column> terms;
  Column rest;  // their sum
  double strength = 0;
};

double dot(const Column& a, const Column& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

void straighten(Column& x) {
  const double n = static_cast<double>(x.size()), middle = 0.5 * (n - 1);
  double mean = 0, slope = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean += x[i] / n;
    slope += (static_cast<double>(i) - middle) * x[i];
  }
  slope /= n * (n * n - 1) / 12;
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] -= mean + slope * (static_cast<double>(i) - middle);
}

Piece piece_of(const Balance& balance, std::size_t from, std::size_t to) {
  Piece s;
  s.rest.assign(to - from, 0);
  s.channels = balance.channels;
  for (const Column& term : balance.terms) {
    Column x(term.begin() + static_cast<std::ptrdiff_t>(from),
             term.begin() + static_cast<std::ptrdiff_t>(to));
    straighten(x);
    for (std::size_t i = 0; i < x.size(); ++i) s.rest[i] += x[i];
    s.strength += dot(x, x);
    s.terms.push_back(std::move(x));
  }
  return s;
}

// Sensors that may be off together: one, or all that are read alike.
using Group = std::vector<Channel>;
const std::vector<Group>& groups() {
  static const std::vector<Group> all = [] {
    std::vector<Group> list;
    for (const ChannelInfo& c : channel_list()) list.push_back({c.channel});
    for (const int filter : {2, 1, 0}) {
      Group alike;
      for (const ChannelInfo& c : channel_list())
        if (c.filter == filter) alike.push_back(c.channel);
      list.push_back(alike);
    }
    return list;
  }();
  return all;
}

Column share_of(const Piece& s, const Group& group) {
  Column sum(s.rest.size(), 0);
  for (std::size_t j = 0; j < s.terms.size(); ++j)
    if (std::find(group.begin(), group.end(), s.channels[j]) != group.end())
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += s.terms[j][i];
  return sum;
}

// The factor of a group's terms that balances best, and what then remains.
struct Fit {
  double factor = 1, remains = 0, before = 0;  // before: with the group left out
};
Fit fit(const Piece& s, const Group& group) {
  const Column own = share_of(s, group);
  Column others = s.rest;
  for (std::size_t i = 0; i < others.size(); ++i) others[i] -= own[i];
  const double power = dot(own, own), cross = dot(others, own), before = dot(others, others);
  if (power < 1e-30) return {1, before, before};
  return {-cross / power, std::max(0.0, before - cross * cross / power), before};
}

// What remains in all balances with a group's terms taken so many times, over what remains as they
// are.
double remainder(const std::vector<Piece>& pieces, const Group& group, double factor,
                 double floor) {
  double before = 0, after = 0;
  for (const Piece& s : pieces) {
    const double scale = 1 / std::max(s.strength, floor);
    const Column own = share_of(s, group);
    Column rest = s.rest;
    before += scale * dot(rest, rest);
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] += (factor - 1) * own[i];
    after += scale * dot(rest, rest);
  }
  return after / before;
}

bool off(double factor) {
  return factor < 0.6 || factor > 1.6;
}

struct Verdict {
  Group channels;     // empty: nothing wrong
  double factor = 0;  // of them; 0: none explains it
};

Verdict judge(const std::vector<Piece>& pieces) {
  Verdict v;
  double least = 0.35;  // share of the imbalance that remains
  Group all, suspects;
  for (const Piece& s : pieces) {
    const double floor = evident * evident * static_cast<double>(s.rest.size());
    const double wrong = dot(s.rest, s.rest);
    bool open = wrong > floor && wrong > 0.35 * s.strength;
    for (const Group& group : groups()) {
      const Fit f = fit(s, group);
      if (!(off(f.factor) && f.before > floor && f.remains < 0.1 * f.before)) continue;
      open = true;
      const double share = remainder(pieces, group, f.factor, floor);
      if (share > 0.8 * least) continue;
      least = share;
      suspects = group;
      v.factor = f.factor;
    }
    if (open) all.insert(all.end(), s.channels.begin(), s.channels.end());
  }
  if (suspects.empty()) v.factor = 0;
  v.channels = suspects.empty() ? all : suspects;
  std::sort(v.channels.begin(), v.channels.end());
  v.channels.erase(std::unique(v.channels.begin(), v.channels.end()), v.channels.end());
  return v;
}

// What a factor may stand for.
std::string guess(double factor) {
  if (factor < 0) return factor > -1.6 && factor < -0.6 ? "its sign is turned" : "";
  struct Slip {
    double factor;
    const char* text;
  };
  for (const Slip& s :
       {Slip{g, "in g under a header of m/s^2"}, Slip{1 / g, "in m/s^2 under a header of g"},
        Slip{units::degree, "in deg under a header of rad"},
        Slip{1 / units::degree, "in rad under a header of deg"},
        Slip{1e3, "in m under a header of mm"}, Slip{1e-3, "in mm under a header of m"},
        Slip{25.4, "in inches under a header of mm"},
        Slip{1 / 25.4, "in mm under a header of inches"}, Slip{0.3048, "in ft under a header of m"},
        Slip{1 / 0.3048, "in m under a header of ft"}})
    if (std::abs(std::log(factor / s.factor)) < 0.12) return s.text;
  return "";
}

struct Found {
  std::size_t first = 0, last = 0, rows = 0;
  Column sizes;
};

struct Range {
  std::size_t from, to;
};

// Rows where every balance that the run has at all can be formed, in blocks.
std::vector<Range> blocks_of(const std::vector<Balance>& balances, std::size_t n) {
  const auto whole = [&](std::size_t k) {
    return std::none_of(balances.begin(), balances.end(),
                        [k](const Balance& b) { return std::isnan(b.sum[k]); });
  };
  std::vector<Range> blocks;
  for (std::size_t k = 0; k < n;) {
    std::size_t end = k;
    while (end < n && whole(end)) ++end;
    while (end - k >= least_block) {
      const std::size_t to = end - k < block + least_block ? end : k + block;
      blocks.push_back({k, to});
      k = to;
    }
    k = end + 1;
  }
  return blocks;
}

// A stretch of a sum: its mean, and what is left of its squares without its straight line, at most:
// as each term loses its own, that is the imbalance.
struct Imbalance {
  double mean, squares;
};
Imbalance imbalance(const Column& sum, Range range) {
  const double n = static_cast<double>(range.to - range.from), middle = 0.5 * (n - 1);
  double mean = 0, slope = 0, squares = 0, at = -middle;
  for (std::size_t k = range.from; k < range.to; ++k, ++at) {
    mean += sum[k];
    slope += at * sum[k];
    squares += sum[k] * sum[k];
  }
  const double line = mean * mean / n + 12 * slope * slope / (n * (n * n - 1));
  return {mean / n, squares - line + 1e-13 * squares};
}

// Where the imbalance is so small, no group is off: with its terms times `factor`, more than
// `floor` would have to be taken to less than a tenth, and of that the group as it is leaves at
// least .9 (1 - 1/factor)^2, an eighth with a factor of 1.6.
bool balanced(const Imbalance& i, Range range) {
  return i.squares < 0.12 * evident * evident * static_cast<double>(range.to - range.from);
}

// The two gage sensors only have each other: both see the truck between the rails, and each half of
// the changes of gage. Their variances differ by chance as much as the correlation of the two,
// which falls with the length.
void compare_gages(const Record& record, const Run& run, Health& health) {
  using enum Channel;
  constexpr std::size_t apart = 10;
  double left = 0, right = 0, n = 0;
  for (std::size_t k = apart; k < run.size(); ++k) {
    const double l = run[gage_left][k] - run[gage_left][k - apart],
                 r = run[gage_right][k] - run[gage_right][k - apart];
    if (std::isnan(l) || std::isnan(r)) continue;
    left += l * l;
    right += r * r;
    ++n;
  }
  if (left + right <= 1e-8 * n || std::abs(left - right) * std::sqrt(n / 20) < 5 * (left + right))
    return;
  const double ratio = std::sqrt(left / std::max(right, 1e-30));
  for (const Channel c : {gage_left, gage_right})
    health.doubted[static_cast<std::size_t>(c)].assign(record.size(), true);
  health.findings.push_back({Fault::inconsistent, "gage_left", run.rows[0], run.rows.size(), ratio,
                             fmt::format("it moves {:.2g} times as much as gage_right", ratio)});
}

}  // namespace

void examine_consistency(const Record& record, const std::vector<Run>& runs, const Processing& p,
                         Health& health) {
  std::map<Channel, Found> scales, contradictions, zeros;
  double difference = 0, compared = 0;  // of the inclinometer's zero; rows
  using enum Channel;
  for (const Run& run : runs) {
    if (run.rows.size() < least_block) continue;
    compare_gages(record, run, health);
    std::vector<Balance> all = balances(run, p, false);
    if (all.empty()) continue;
    const std::vector<Range> blocks = blocks_of(all, run.size());
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      std::vector<Imbalance> imbalances;
      imbalances.reserve(all.size());
      for (const Balance& b : all) imbalances.push_back(imbalance(b.sum, blocks[i]));
      // Rows between two blocks share the verdict of the one behind them.
      const std::size_t from = i == 0 ? 0 : blocks[i - 1].to,
                        to = i + 1 == blocks.size() ? run.size() : blocks[i].to;
      const auto doubt = [&](std::map<Channel, Found>& where, Channel c, double size, auto& rows) {
        Found& f = where[c];
        if (f.rows == 0) f.first = run.rows[from];
        f.last = run.rows[to - 1];
        f.rows += to - from;
        f.sizes.push_back(size);
        auto& doubted = rows[static_cast<std::size_t>(c)];
        // a fault may begin within the block before
        for (std::size_t k = from - std::min(from, block); k < std::min(run.size(), to + block);
             ++k)
          doubted[run.rows[k]] = true;
      };
      Verdict v;
      if (!std::all_of(imbalances.begin(), imbalances.end(),
                       [&](const Imbalance& s) { return balanced(s, blocks[i]); })) {
        if (all[0].terms.empty()) all = balances(run, p, true);
        std::vector<Piece> pieces;
        pieces.reserve(all.size());
        for (const Balance& b : all) pieces.push_back(piece_of(b, blocks[i].from, blocks[i].to));
        v = judge(pieces);
      }
      for (const Channel c : v.channels)
        doubt(v.factor != 0 ? scales : contradictions, c, v.factor, health.doubted);
      for (std::size_t b = 0; b < all.size() && v.channels.empty(); ++b) {
        if (all[b].channels[1] != lateral) continue;
        const double mean = imbalances[b].mean;
        difference += mean * static_cast<double>(to - from);
        compared += static_cast<double>(to - from);
        if (std::abs(mean) > moved_zero)
          for (const Channel c : {inclinometer, height_left, height_right})
            doubt(zeros, c, mean, health.doubted);
      }
    }
  }
  // A sensor that is a factor off somewhere is not trusted anywhere; a contradiction that is met
  // again and again holds in between.
  for (const auto& [c, f] : scales)
    health.doubted[static_cast<std::size_t>(c)].assign(record.size(), true);
  for (const auto& [c, f] : contradictions) {
    const bool everywhere = 5 * f.rows > record.size();
    const auto first = static_cast<std::ptrdiff_t>(everywhere ? 0 : f.first);
    const auto end = static_cast<std::ptrdiff_t>(everywhere ? record.size() : f.last + 1);
    for (auto* rows : {&health.doubted[static_cast<std::size_t>(c)], &health.clock_doubted})
      std::fill(rows->begin() + first, rows->begin() + end, true);
  }
  const auto name = [](Channel c) {
    return std::string{channel_list()[static_cast<std::size_t>(c)].name};
  };
  for (const auto& [c, f] : scales) {
    const double factor = median(f.sizes);
    const std::string why = guess(factor);
    health.findings.push_back({Fault::scale, name(c), f.first, f.rows, factor,
                               fmt::format("the other sensors say {:.3g} times as much{}", factor,
                                           why.empty() ? "" : ": " + why + "?")});
  }
  for (const auto& [c, f] : contradictions)
    health.findings.push_back(
        {Fault::inconsistent, name(c), f.first, f.rows, 0, "other sensors contradict it"});
  if (difference /= std::max(compared, 1.0);
      2 * compared > static_cast<double>(record.size()) && std::abs(difference) > shifted_zero) {
    health.zero_doubted[static_cast<std::size_t>(inclinometer)].assign(record.size(), true);
    health.findings.push_back(
        {Fault::level, "inclinometer", 0, record.size(), difference,
         fmt::format(
             "its mean over the record differs from the beam's accelerometer and the roll "
             "of the heights by {:.2g} m/s^2: a bias of one of them? Crosslevel rests on it",
             difference)});
  } else if (const auto& f = zeros[inclinometer]; f.rows > 0)
    health.findings.push_back(
        {Fault::level, "inclinometer", f.first, f.rows, median(f.sizes),
         fmt::format(
             "its mean differs from the beam's accelerometer and the roll of the heights by "
             "{:.2g} m/s^2",
             median(f.sizes))});
}

}  // namespace railbook::geometry_car
