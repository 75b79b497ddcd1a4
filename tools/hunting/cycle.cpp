/*
### `hunting cycle`

A branch of limit cycles by describing functions, from a critical speed on, with folds located and stability by a named criterion.
Branch and folds are those of the describing functions: good to some percent before the flange, while on it a branch of the equations
may turn round at quite another speed, and have cycles where this one has none.

    hunting cycle --pair cn --out mine
    hunting cycle car.toml --wheel wheel.csv --rail rail.csv --family 2 --speed 42m/s
    hunting cycle --pair cn --suspension friction --criterion hill --speed 100ft/s

`--criterion` is `rule` (the paper's: does speed rise with amplitude?), `hill` (exponents of the describing-function cycle) or
`floquet` (multipliers of the true cycle, every tenth point; the default, and the one to believe). A neutral cycle, one of many at
the same speed, is neither stable nor unstable. `--speed` solves for the cycles at that speed and gives all three. A true cycle counts
only when it is near the describing function's; where none was found, the file says so, and stable and unstable are both left open.
`--out` writes the branch as `cycle.csv`, `cycle.json` and the figure.
*/

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "dynamics/cycle_branch.hpp"
#include "dynamics/examine.hpp"
#include "dynamics/hill.hpp"
#include "hunting/car_options.hpp"
#include "table/csv.hpp"
#include "tool/out_folder.hpp"
#include "tools.hpp"
#include "units/constants.hpp"

namespace railbook::hunting_tool {

using namespace dynamics;

namespace {

constexpr double millimetre = units::millimetre;

struct Wish : CarWish {
  double lowest = 1, highest = 120;
  double first = 1 * units::millimetre;
  std::optional<double> largest, speed;
  long family = 1;
  std::string criterion = "floquet";
  tool::Destination out;
};

struct Label {
  std::string verdict;  // "stable", "unstable", "neutral", "not found"; empty: not asked for
  double figure = std::numeric_limits<double>::quiet_NaN();  // what the criterion is about
};

// Where every amplitude is a cycle, as on a cone's tread, no criterion can call one stable.
Label label(const CyclePoint& p, bool stable, double figure) {
  return {!stable ? "unstable" : p.neutral ? "neutral" : "stable", figure};
}
Label by_rule(const CyclePoint& p) {
  return label(p, p.stable || p.neutral, p.speed_by_amplitude);
}
Label by_hill(const CarCase& c, const CyclePoint& p) {
  const double growth = leading_exponent(c.car, p.motion).real();
  return label(p, growth < 1e-6, growth);
}
Label by(const std::string& criterion, const CarCase& c, const CyclePoint& p) {
  if (criterion == "rule") return by_rule(p);
  if (criterion == "hill") return by_hill(c, p);
  const Examined e = examine(c.car.car(), c.table, p.motion);
  if (!e.converged) return {"not found"};
  const double largest = e.stability.largest;
  return label(p, e.stability.stable || (p.neutral && largest < 1 + 1e-6), largest);
}

const char* full_name(const std::string& criterion) {
  if (criterion == "hill") return "Hill's exponents, one harmonic";
  if (criterion == "floquet") return FloquetStability::criterion;
  return "the paper's rule (dV/dA > 0)";
}

std::string wheelsets_text(const CyclePoint& p) {
  return fmt::format("{:.4f}, {:.4f}, {:.4f}, {:.4f} mm", p.amplitude[0] / millimetre,
                     p.amplitude[1] / millimetre, p.amplitude[2] / millimetre,
                     p.amplitude[3] / millimetre);
}

void add_point(tool::Summary& answer, const std::string& id, const std::string& what,
               const CyclePoint& p) {
  answer.add(id + "_m_per_s", what + ", speed", p.motion.speed, "m/s",
             fmt::format("{:.4f} ft/s", p.motion.speed / units::foot));
  answer.add(id + "_mm", "  largest amplitude", p.largest / millimetre, "mm", wheelsets_text(p));
  answer.add(id + "_rad_per_s", "  frequency", p.motion.lambda.imag(), "rad/s");
}

// A line for somebody who waits; n = 0 clears it.
void progress(const char* what, std::size_t k, std::size_t n) {
  if (isatty(STDERR_FILENO) == 0) return;
  fmt::print(stderr, "\r{:60}\r", "");
  if (n > 0) fmt::print(stderr, "stability of {} {} of {} ", what, k + 1, n);
}

// The true cycle of each; one orbit belongs to the describing-function cycle that is nearest to it.
std::vector<Examined> examine_all(const CarCase& c, const std::vector<CyclePoint>& cycles) {
  std::vector<Examined> all;
  for (const auto& p : cycles) {
    progress("cycle", all.size(), cycles.size());
    all.push_back(examine(c.car.car(), c.table, p.motion));
  }
  progress("", 0, 0);
  for (auto& e : all)
    for (const auto& other : all)
      if (e.converged && other.converged && other.distance < e.distance &&
          std::abs(other.omega / e.omega - 1) < 1e-6 &&
          std::abs(other.amplitude / e.amplitude - 1) < 1e-6) {
        e.converged = false;
        e.reason =
            fmt::format("what was found, {:.4f} mm at {:.5f} rad/s, is nearer to another one",
                        e.amplitude / millimetre, e.omega);
      }
  return all;
}

void add_cycles_at(tool::Summary& answer, const CarCase& c, const CycleBranch& branch,
                   double speed) {
  const auto cycles = cycles_at_speed(c.car, branch, speed);
  answer.add("describing_function_cycles",
             fmt::format("describing-function cycles at {:g} m/s", speed),
             static_cast<double>(cycles.size()), "",
             cycles.empty() ? "no proof: the equations may have cycles there" : "");
  const auto all = examine_all(c, cycles);
  for (std::size_t k = 0; k < cycles.size(); ++k) {
    const auto& p = cycles[k];
    const std::string id = fmt::format("cycle_{}", k + 1);
    add_point(answer, id, fmt::format("cycle {}", k + 1), p);
    answer.add(id + "_rule", "  the paper's rule", by_rule(p).verdict);
    const Label hill = by_hill(c, p);
    if (std::isnan(hill.figure))
      answer.absent(id + "_hill", "  Hill's leading exponent", "not found");
    else
      answer.add(id + "_hill", "  Hill's leading exponent", hill.figure, "1/s", hill.verdict);
    const Examined& e = all[k];
    if (e.converged) {
      answer.add(id + "_floquet", "  Floquet's largest multiplier", e.stability.largest, "",
                 e.stability.stable ? "stable" : "unstable, " + e.stability.loss);
      answer.add(id + "_true_mm", "  true amplitude", e.amplitude / millimetre, "mm",
                 fmt::format("at {:.5f} rad/s; {:.1f} % from the describing function's", e.omega,
                             100 * e.distance));
      continue;
    }
    answer.add(id + "_floquet", "  Floquet's multipliers",
               "no true cycle found near it: " + e.reason);
    answer.flag(id, fmt::format("no true cycle was found near cycle {}; it may not exist", k + 1));
  }
}

// By the criterion, at the points that it is asked of.
std::vector<Label> labels(const Wish& wish, const CarCase& c, const CycleBranch& branch) {
  const std::size_t every = wish.criterion == "floquet" ? 10 : 1, n = branch.points.size();
  std::vector<Label> all(n);
  for (std::size_t k = 0; k < n; k += every) {
    progress("point", k, n);
    all[k] = by(wish.criterion, c, branch.points[k]);
  }
  progress("", 0, 0);
  return all;
}

void flag_missing(tool::Summary& answer, const std::vector<Label>& all) {
  const auto asked = std::ranges::count_if(all, [](const Label& l) { return !l.verdict.empty(); });
  const auto missing = std::ranges::count(all, "not found", &Label::verdict);
  answer.add("probes", "points whose stability was asked for", static_cast<double>(asked), "");
  answer.add("probes_not_found", "  of them without a true cycle found",
             static_cast<double>(missing), "");
  if (missing > 0)
    answer.flag("probes_not_found",
                fmt::format("at {} of {} points no true cycle was found near the describing "
                            "function's: their stability is open, and the cycle may not exist",
                            missing, asked));
}

void write_files(tool::OutFolder& out, const Wish& wish, const CycleBranch& branch,
                 const std::vector<Label>& all, const tool::Summary& answer) {
  std::string text =
      "V_m_per_s,A_mm,omega_rad_per_s,front_leading_mm,front_trailing_mm,rear_leading_mm,"
      "rear_trailing_mm,criterion_value,stable_mm,unstable_mm,not_found_mm\n";
  for (std::size_t k = 0; k < branch.points.size(); ++k) {
    const auto& p = branch.points[k];
    const Label& label = all[k];
    const std::string a = table::csv_number(p.largest / millimetre);
    const auto where = [&](const char* verdict) { return label.verdict == verdict ? a : "nan"; };
    text += fmt::format("{:.9g},{},{:.9g}", p.motion.speed, a, p.motion.lambda.imag());
    for (const double x : p.amplitude) text += fmt::format(",{:.8g}", x / millimetre);
    text += fmt::format(",{},{},{},{}\n", table::csv_number(label.figure), where("stable"),
                        where("unstable"), where("not found"));
  }
  out.add("cycle.csv", text);
  out.add("criterion.txt", std::string(full_name(wish.criterion)) + "\n");
  out.add("cycle.json", answer.json());
  out.figure(tools::scripts("hunting") / fmt::format("cycle_{}.gp", wish.criterion), {"cycle.csv"},
             "cycle.png");
}

void run(const Wish& wish) {
  tool::OutFolder out(wish.out, {"cycle.csv", "criterion.txt", "cycle.json", "cycle.png"});
  units::require_between("highest speed", wish.highest, wish.lowest, 1e4, "m/s");
  const double end = wish.pair.end;
  const double largest = wish.largest.value_or(end);
  units::require_between("largest amplitude", largest, 0, end, "m, the end of the table");
  units::require_between("first amplitude", wish.first, 0, largest, "m");
  if (wish.speed)
    units::require_between("speed on the branch", *wish.speed, wish.lowest, wish.highest, "m/s");
  const CarCase c = read_case(wish);
  const auto hopf = hopf_points(c.car, wish.lowest, wish.highest);
  if (hopf.empty())
    throw InputError(
        fmt::format("speeds from {:g} to {:g} m/s: the linear car has no critical "
                    "speed there, and no branch begins",
                    wish.lowest, wish.highest));
  units::require_between("family", static_cast<double>(wish.family), 1,
                         static_cast<double>(hopf.size()));
  BranchOptions options;
  options.first_amplitude = wish.suspension == "friction" ? 0.03 * wish.first : wish.first;
  options.largest_amplitude = largest;
  options.lowest_speed = wish.lowest;
  options.highest_speed = wish.highest;
  const auto branch = trace_from(c.car, hopf[static_cast<std::size_t>(wish.family - 1)], options);
  if (branch.points.empty())
    throw InputError(
        fmt::format("no limit cycle of {:g} m was found at the critical speed; try "
                    "another --first-amplitude",
                    options.first_amplitude));
  tool::Summary answer("Limit cycles of a freight car, by describing functions");
  describe_case(answer, wish, c);
  flag_smoothing(answer, wish, c, wish.lowest, wish.highest);
  const double critical = hopf[static_cast<std::size_t>(wish.family - 1)].motion.speed;
  answer.add("hopf_m_per_s", fmt::format("critical speed {} of {}", wish.family, hopf.size()),
             critical, "m/s", fmt::format("{:.4f} ft/s", critical / units::foot));
  answer.add("points", "points of the branch", static_cast<double>(branch.points.size()), "",
             to_string(branch.end));
  for (std::size_t k = 0; k < branch.folds.size(); ++k)
    add_point(answer, fmt::format("describing_function_fold_{}", k + 1),
              fmt::format("describing-function fold {}", k + 1), branch.folds[k]);
  if (wish.speed) add_cycles_at(answer, c, branch, *wish.speed);
  answer.add("criterion", "stability in the files by", full_name(wish.criterion));
  if (out) {
    const auto all = labels(wish, c, branch);
    flag_missing(answer, all);
    write_files(out, wish, branch, all, answer);
  }
  answer.print();
  out.commit();
}

std::function<void()> declare(tool::Options& options) {
  const auto wish = std::make_shared<Wish>();
  add_car_options(options, *wish);
  const tool::Range speeds{0.01, 1e4};
  options.quantity("--lowest", wish->lowest, units::speed, "the branch ends there", speeds);
  options.quantity("--highest", wish->highest, units::speed, "the branch ends there", speeds);
  options.quantity("--first-amplitude", wish->first, units::length,
                   "of the branch's first cycle; 3 % of it with friction", tool::Range{1e-6, 0.05});
  options.quantity("--largest-amplitude", wish->largest, units::length,
                   "of the branch; without it the end of the table", tool::Range{1e-6, 0.2});
  options.count("--family", wish->family, "from which critical speed, the lowest being 1", 1, 99);
  options.quantity("--speed", wish->speed, units::speed, "solves for the cycles there", speeds);
  options.choice("--criterion", wish->criterion, {"rule", "hill", "floquet"},
                 "of stability, for the files");
  options.out(wish->out);
  return [wish] { run(*wish); };
}

}  // namespace

tool::Tool cycle_tool() {
  return {"cycle", "limit cycles of your own car against speed", declare};
}

}  // namespace railbook::hunting_tool
