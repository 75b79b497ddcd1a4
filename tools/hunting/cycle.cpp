/*
### `hunting cycle`

Limit cycles of the full equations against speed: a branch from a critical speed on by continuation of harmonic balance, with the speeds
at which it turns round (folds), loses its stability to a second frequency (torus) or to a lopsided motion (symmetry breaking).

    hunting cycle --pair cn --out mine
    hunting cycle car.toml --wheel wheel.csv --rail rail.csv --family 2 --speed 42m/s
    hunting cycle --pair cn --speed 150ft/s --against warp-stiffness --factor 0.5
    hunting cycle --wheel-rail-friction 0.3 --creep-law full --out mine
    hunting cycle --wheel worn-wheel.csv --rail new-rail.csv --right-wheel new-wheel.csv --noise 0.003mm

Stability is by Floquet multipliers, at every point. `--speed` lists all cycles of the branch at that speed. `--against` follows each of them
on in another datum of the car, from its value to `--factor` times it. With `--wheel-rail-friction` creep forces saturate: by the cubic of
Shen, Hedrick and Elkins, or with `--creep-law full` by a table of the full theory for a round contact; without it they are linear, and
amplitudes on the flange are academic. Where friction limits, every point has the largest derailment quotient, L/V = (tan d - f)/(1 + f tan d)
with d the contact angle and f the lateral creep force towards the outside over the static wheel load, and the largest share that the
creep force has of friction, 0 to 1; no load moves from wheel to wheel. Right wheels and rail may have profiles and a radius of their own: the
car then hunts off the centre, and cycles have harmonics of every order. Where symmetry breaks or the period doubles, the branch that leaves there is
followed too, to where it comes back; from a branch point of one symmetry, and from branches other than the first, it is not, which the
answer says at the point. Folds and other points are those of the full equations by harmonic balance and Floquet multipliers; describing functions
have no part in it. Where none of the cycles found at `--speed` is stable, motions are followed in time, from beside the unstable cycles
and from swaying of several sizes; a stable cycle to which they come is solved and followed as a branch of its own, and the answer says where
the others went. Without `--speed` the same is done in the middle of the first two ranges of speed at which branches have
unstable cycles alone and the straight run is unstable too. What neither finds may be there all the same: the answer says what was searched. Errors are
those of the solution, from solving again with a tenth of the tail of harmonics and finer multipliers; `--tail` makes them smaller. `--out` writes the points as `cycle.csv`, the special ones as `special.csv`, `cycle.json` and the figure. Stiff cars
take long: after `--points` of all branches the search ends where it is, and the answer says so.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include <railbook/cycles/cycle_error.hpp>
#include <railbook/rolling/kalker_coefficients.hpp>
#include <railbook/rolling/smooth_force.hpp>
#include <railbook/rolling/theory.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/tool/digits.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/vehicle/car_families.hpp>
#include <railbook/vehicle/creep_limit.hpp>
#include <railbook/vehicle/linear_stability.hpp>

#include "hunting/cycle_answer.hpp"
#include "hunting/cycle_branches.hpp"
#include "hunting/search.hpp"
#include "tools.hpp"

namespace railbook::hunting_tool {

using namespace cycles;
using namespace vehicle;

namespace {

constexpr double millimetre = units::millimetre;

struct Options : CarOptions {
  double lowest = 1, highest = 120;
  double first = 1 * units::millimetre;
  std::optional<double> largest, speed, wheel_rail_friction;
  std::string against, creep_law = "cubic";
  double factor = 2, tail = 3e-4;
  long family = 1, points = 1000;
  tool::Destination out;
};

// How friction limits the creep forces, if it does.
std::optional<CreepLimit> creep_of(const Options& options) {
  if (!options.wheel_rail_friction) {
    if (options.creep_law == "full")
      throw InputError("--creep-law full says how friction limits: give --wheel-rail-friction");
    return {};
  }
  CreepLimit limit{*options.wheel_rail_friction, {}};
  if (options.creep_law == "full")
    limit.curve =
        rolling::SmoothForce(rolling::shares_of(rolling::solver("full", 1, 0.3, 12), 1, 0.3),
                             rolling::kalker_coefficients(1, 0.3));
  return limit;
}

void follow_datum(tool::Summary& answer, const Options& options, const CarCase& c,
                  const LimitCycle& from, const std::optional<CreepLimit>& creep,
                  const std::string& id, const ContinuationOptions& speed_options) {
  const auto datum = std::find_if(car_data().begin(), car_data().end(),
                                  [&](const CarDatum& d) { return d.key == options.against; });
  const double value = c.car.car().data.*(datum->member), end = options.factor * value;
  units::require_positive(datum->name, value);
  const Family family = by_datum(c.car.car(), datum->member, c.table, *options.speed, creep);
  ContinuationOptions walk = speed_options;
  walk.lowest = std::min(value, end);
  walk.highest = std::max(value, end);
  const auto branch = follow_from(
      family, from.cycle, value,
      options.factor > 1 ? Direction::larger_parameter : Direction::smaller_parameter, walk);
  const auto unit = units::si_name(datum->dimension);
  if (branch.points.empty()) {
    answer.warn(id + "_against", fmt::format("{} could not be followed from there", datum->name));
    return;
  }
  answer.add(id + "_against", fmt::format("  followed in {} up to", datum->name),
             branch.points.back().parameter, unit,
             fmt::format("{}; {} mm, {}", to_string(branch.stop),
                         tool::to_text(branch.points.back().largest / millimetre),
                         stability_text(branch.points.back())));
  for (std::size_t k = 0; k < branch.special.size(); ++k)
    answer.add(fmt::format("{}_against_special_{}", id, k + 1),
               fmt::format("    {}", to_string(branch.special[k].kind)),
               branch.special[k].at.parameter, unit,
               tool::to_text(branch.special[k].at.largest / millimetre) + " mm");
}

// What the answer is about.
struct Work {
  const Options& options;
  const CarCase& car;
  const Family& family;
  const std::optional<CreepLimit>& creep;
  const ContinuationOptions& walk;
  std::vector<NamedBranch> all;
};

struct Found {
  std::string branch;
  LimitCycle cycle;
};
std::vector<Found> cycles_of(const Work& w, double speed) {
  std::vector<Found> found;
  for (const NamedBranch& named : w.all)
    for (LimitCycle& c : cycles_at(w.family, named.branch, speed, w.walk))
      found.push_back({named.name, std::move(c)});
  return found;
}
bool any_stable(const std::vector<Found>& found) {
  return std::ranges::any_of(found, [](const Found& f) { return f.cycle.stable; });
}

// Where no cycle found at a speed is stable: from motions in time. Branches through what they come
// to join the others.
Search search_at(Work& w, double speed, const std::vector<Found>& found) {
  std::vector<LimitCycle> known;
  for (const Found& f : found) known.push_back(f.cycle);
  Search search = search_in_time(w.family, w.car, speed, known, w.walk);
  for (const LimitCycle& c : search.cycles) {
    LimitCycleBranch branch = follow_both_ways(w.family, c, w.walk);
    if (branch.points.empty()) {
      branch.points = {c, c};
      branch.stop = BranchStop::asked;
    }
    const auto number = w.all.size();
    w.all.push_back({fmt::format("secondary_{}", number),
                     fmt::format("branch {}, found in time at {:.4g} m/s", number, speed),
                     std::move(branch)});
  }
  return search;
}

void add_search(tool::Summary& answer, const Search& search, double speed) {
  std::string ends;
  const auto add = [&ends](int count, const std::string& where) {
    if (count > 0) ends += fmt::format("{}{} {}", ends.empty() ? "" : "; ", count, where);
  };
  add(search.to_cycle, "to a stable cycle");
  add(search.to_rest, "to the straight run");
  add(search.left_table, "beyond the end of the profiles' table: derailed");
  add(search.unrepeating,
      fmt::format("to no motion that repeats, amplitudes from {:.3g} to {:.3g} mm",
                  search.smallest / millimetre, search.largest / millimetre));
  answer.add(fmt::format("in_time_at_{:.4g}", speed),
             fmt::format("motions followed in time at {:.4g} m/s", speed), search.starts, "", ends);
}

// Speeds at which branches have cycles, all unstable as the straight run is: low and high.
std::vector<std::pair<double, double>> unstable_speeds(const Work& w) {
  const auto covered = [&w](double speed, bool stable) {
    for (const NamedBranch& named : w.all)
      for (std::size_t k = 1; k < named.branch.points.size(); ++k) {
        const LimitCycle &a = named.branch.points[k - 1], &b = named.branch.points[k];
        if ((a.parameter - speed) * (b.parameter - speed) <= 0 &&
            (!stable || a.stable || b.stable || a.neutral || b.neutral))
          return true;
      }
    return false;
  };
  std::vector<std::pair<double, double>> ranges;
  bool open = false;
  for (double speed = w.options.lowest; speed <= w.options.highest; speed *= 1.005) {
    const bool bare =
        covered(speed, false) && !covered(speed, true) && !straight_run_stable(w.car, speed);
    if (bare && !open) ranges.emplace_back(speed, speed);
    if (bare) ranges.back().second = speed;
    open = bare;
  }
  std::erase_if(ranges, [](const auto& r) { return r.second < 1.01 * r.first; });
  return ranges;
}

void add_unstable_speeds(tool::Summary& answer, Work& w, const PointLimit& limit) {
  constexpr std::size_t most = 2;
  auto ranges = unstable_speeds(w);
  for (std::size_t k = 0; k < std::min(most, ranges.size()) && !limit.reached(); ++k) {
    const double speed = 0.5 * (ranges[k].first + ranges[k].second);
    add_search(answer, search_at(w, speed, cycles_of(w, speed)), speed);
  }
  ranges = unstable_speeds(w);
  for (std::size_t k = 0; k < ranges.size(); ++k)
    answer.warn(fmt::format("unstable_speeds_{}", k + 1),
                fmt::format("from {:.4g} to {:.4g} m/s the straight run and every cycle found are "
                            "unstable: the car does something else there; --speed looks for it in "
                            "time at one speed",
                            ranges[k].first, ranges[k].second));
}

// What the car does at --speed where no cycle found is stable.
void look_in_time(tool::Summary& answer, Work& w) {
  const double speed = *w.options.speed;
  const bool straight = straight_run_stable(w.car, speed);
  answer.add("straight_run", fmt::format("straight run at {:g} m/s", speed),
             straight ? "stable" : "unstable");
  const auto found = cycles_of(w, speed);
  if (any_stable(found)) return;
  add_search(answer, search_at(w, speed, found), speed);
  if (!straight && !found.empty() && !any_stable(cycles_of(w, speed)))
    answer.warn("unstable",
                fmt::format("at {:g} m/s the straight run and every cycle found are unstable, and "
                            "no motion followed in time came to a stable one: the car does "
                            "something else there",
                            speed));
}

void add_cycles_at(tool::Summary& answer, const Work& w) {
  const double speed = *w.options.speed;
  const auto found = cycles_of(w, speed);
  for (std::size_t k = 0; k < found.size(); ++k) {
    const std::string id = fmt::format("cycle_{}", k + 1);
    const LimitCycle& c = found[k].cycle;
    answer.add(id, fmt::format("cycle {} at {:g} m/s", k + 1, speed), "on the " + found[k].branch);
    add_cycle(answer, id, c, cycle_error(w.family, c, w.walk), w.car, w.creep);
    if (!w.options.against.empty()) follow_datum(answer, w.options, w.car, c, w.creep, id, w.walk);
  }
  answer.add("cycles", fmt::format("cycles at {:g} m/s", speed), static_cast<double>(found.size()),
             "", found.empty() ? "none on what was searched; other branches may have some" : "");
}

void write_files(tool::OutFolder& out, const CarCase& c, const std::optional<CreepLimit>& creep,
                 const std::vector<NamedBranch>& all, const tool::Summary& answer) {
  std::string text =
      "branch,V_m_per_s,A_mm,omega_rad_per_s,front_leading_mm,front_trailing_mm,rear_leading_mm,"
      "rear_trailing_mm,multiplier,unstable_multipliers,stable_mm,unstable_mm,harmonics,"
      "middle_mm,L_over_V,creep_over_friction\n";
  std::string marks = "branch,V_m_per_s,A_mm,kind\n";
  for (std::size_t b = 0; b < all.size(); ++b) {
    for (const LimitCycle& p : all[b].branch.points) {
      const std::string a = table::csv_number(p.largest / millimetre);
      text += fmt::format("{},{:.9g},{},{:.9g}", b + 1, p.parameter, a, p.cycle.omega);
      for (const double x : p.amplitude) text += fmt::format(",{:.8g}", x / millimetre);
      text +=
          fmt::format(",{:.6g},{},{},{},{},{:.8g}", p.leading, p.unstable, p.stable ? a : "nan",
                      p.unstable > 0 ? a : "nan", p.cycle.orders.back(), p.middle[0] / millimetre);
      if (!creep) {
        text += ",nan,nan\n";
        continue;
      }
      const CycleForces f = cycle_forces(c.car.car(), c.table, *creep, p.cycle);
      text +=
          fmt::format(",{:.6g},{:.6g}\n", largest_of(f.lateral_over_vertical), largest_of(f.creep));
    }
    for (const SpecialCycle& s : all[b].branch.special)
      marks += fmt::format("{},{:.9g},{:.8g},{}\n", b + 1, s.at.parameter,
                           s.at.largest / millimetre, to_string(s.kind));
  }
  out.add("cycle.csv", text);
  out.add("special.csv", marks);
  out.add("cycle.json", answer.json());
  out.figure(tools::scripts("hunting") / "cycle.gp", {"cycle.csv", "special.csv"}, "cycle.png");
}

ContinuationOptions options_of(const Options& options, PointLimit& limit) {
  ContinuationOptions walk;
  walk.first_amplitude = options.suspension == "friction" ? 0.03 * options.first : options.first;
  walk.largest_amplitude = options.largest.value_or(options.pair.end);
  walk.tail = options.tail;
  walk.multiplier_steps =
      static_cast<int>(256 * std::clamp(std::sqrt(3e-4 / options.tail), 0.5, 16.0));
  walk.lowest = options.lowest;
  walk.highest = options.highest;
  walk.go_on = [&limit](const LimitCycle& p) { return limit.add(p); };
  return walk;
}

void check(const Options& options) {
  units::require_between("highest speed", options.highest, options.lowest, 1e4, "m/s");
  const double end = options.pair.end;
  units::require_between("largest amplitude", options.largest.value_or(end), 0, end,
                         "m, the end of the table");
  units::require_between("first amplitude", options.first, 0, options.largest.value_or(end), "m");
  if (options.speed)
    units::require_between("speed on the branch", *options.speed, options.lowest, options.highest,
                           "m/s");
  if (!options.against.empty() && !options.speed)
    throw InputError("--against follows the cycles of one speed: give --speed");
}

void run(const Options& options) {
  tool::OutFolder out(options.out, {"cycle.csv", "special.csv", "cycle.json", "cycle.png"});
  check(options);
  const CarCase c = read_case(options);
  const auto hopf = hopf_points(c.car, options.lowest, options.highest);
  if (hopf.empty())
    throw InputError(
        fmt::format("speeds from {:g} to {:g} m/s: the linear car has no critical "
                    "speed there, and no branch begins; allowed: a range that holds one",
                    options.lowest, options.highest));
  units::require_between("family", static_cast<double>(options.family), 1,
                         static_cast<double>(hopf.size()));
  const HopfPoint& begin = hopf[static_cast<std::size_t>(options.family - 1)];
  const std::optional<CreepLimit> creep = creep_of(options);
  const Family family = by_speed(c.car.car(), c.table, creep);
  PointLimit limit(options.points);
  const ContinuationOptions walk = options_of(options, limit);
  Work w{options, c, family, creep, walk, follow_all(family, begin, options.family, walk, limit)};
  if (w.all.front().branch.points.empty())
    throw InputError(
        fmt::format("no limit cycle of {:g} m was found at the critical speed; try "
                    "another --first-amplitude",
                    walk.first_amplitude));
  tool::Summary answer("Limit cycles of a freight car");
  describe_case(answer, options, c);
  answer.add("creep", "creep forces",
             creep ? fmt::format("limited by a friction of {:g}, {}", creep->friction,
                                 options.creep_law == "full" ? "full theory, round contact"
                                                             : "Shen, Hedrick and Elkins")
                   : "linear");
  flag_smoothing(answer, options, c, options.lowest, options.highest);
  answer.add("hopf_m_per_s", fmt::format("critical speed {} of {}", options.family, hopf.size()),
             begin.motion.speed, "m/s", tool::to_text(begin.motion.speed / units::foot) + " ft/s");
  if (options.speed)
    look_in_time(answer, w);
  else
    add_unstable_speeds(answer, w, limit);
  for (const NamedBranch& named : w.all) {
    add_extent(answer, named);
    add_special(answer, family, named, walk);
  }
  if (options.speed) add_cycles_at(answer, w);
  limit.clear();
  if (limit.reached())
    answer.warn("points", fmt::format("the search was stopped after {} points: branches end early "
                                      "(--points gives it more)",
                                      options.points));
  for (const NamedBranch& named : w.all)
    if (named.branch.stop == BranchStop::step)
      answer.warn(named.key, fmt::format("the {} could not be followed farther than {:.4f} m/s, "
                                         "{:.4f} mm: it may go on",
                                         named.name, named.branch.points.back().parameter,
                                         named.branch.points.back().largest / millimetre));
  answer.print();
  if (out) write_files(out, c, creep, w.all, answer);
  out.commit();
}

std::function<void()> declare(tool::OptionParser& parser) {
  const auto options = std::make_shared<Options>();
  add_car_options(parser, *options);
  const tool::Range speeds{0.01, 1e4};
  parser.quantity("--lowest", options->lowest, units::speed, "the branch ends there", speeds);
  parser.quantity("--highest", options->highest, units::speed, "the branch ends there", speeds);
  parser.quantity("--first-amplitude", options->first, units::length,
                  "of the branch's first cycle; 3 % of it with friction", tool::Range{1e-6, 0.05});
  parser.quantity("--largest-amplitude", options->largest, units::length,
                  "of the branch; without it the end of the table", tool::Range{1e-6, 0.2});
  parser.count("--family", options->family, "from which critical speed, the lowest being 1", 1, 99);
  parser.quantity("--speed", options->speed, units::speed, "lists the cycles there", speeds);
  parser.quantity("--wheel-rail-friction", options->wheel_rail_friction, units::number,
                  "creep forces saturate; without it they are linear", tool::Range{0.01, 2});
  parser.choice("--creep-law", options->creep_law, {"cubic", "full"},
                "how they do: by Shen, Hedrick and Elkins, or by a table of the full theory");
  std::vector<std::string> keys;
  for (const CarDatum& d : car_data()) keys.emplace_back(d.key);
  parser.choice("--against", options->against, keys, "follows the cycles of --speed in this datum");
  parser.quantity("--factor", options->factor, units::number, "how far, as a factor",
                  tool::Range{1e-4, 1e4});
  parser.quantity("--tail", options->tail, units::number,
                  "of a cycle, the share in its highest harmonics up to which more are added: "
                  "smaller is more accurate, and slower",
                  tool::Range{1e-6, 1e-2});
  parser.count("--points", options->points,
               "of all branches, after which the search ends where it is", 1, 1000000);
  parser.out(options->out);
  parser.help(
      "Amplitudes are half of what a wheelset moves from side to side, and positive; middle_mm is "
      "where the first one moves about, positive to the left. A multiplier is a magnitude: above 1 "
      "the cycle is unstable. L_over_V is the largest of a wheel, positive as its flange presses "
      "outward; creep_over_friction the largest creep force over what friction bears, 0 to 1. "
      "stable_mm and unstable_mm are A_mm where the cycle is so, else nan. cycle.csv has V, the "
      "speed, "
      "A_mm, the largest amplitude of the wheelsets, omega, the angular velocity, front_leading, "
      "front_trailing, rear_leading and rear_trailing, the wheelsets' amplitudes, "
      "unstable_multipliers, how many are outside the circle, and harmonics, the highest one. "
      "special.csv names the kind of each special point: a fold, a torus, a branch point.");
  return [options] { run(*options); };
}

}  // namespace

tool::Tool cycle_tool() {
  return {"cycle", "limit cycles of your own car against speed", declare};
}

}  // namespace railbook::hunting_tool
