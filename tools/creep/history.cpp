/*
### `creep history`

A contact that is shifted and rolls on under loads, creepages or forces that change along the way. Its file has a row for
each place where something changes; between rows everything is linear, and a row at the distance of the one before it
changes what it has without rolling.

    distance_mm,load_kN,fx_kN
    0,80,16
    20,80,16

    creep history braking.csv --a 6mm --b 4mm --load 80kN --mu 0.3 --out mine

The first row presses the contact and shifts it (Cattaneo); then it rolls, here under a constant force, until the creepage
is that of steady rolling (Carter).
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <railbook/rolling/history.hpp>
#include <railbook/rolling/theory.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/tool/digits.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/tool/session.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "creep/contact_options.hpp"
#include "tools.hpp"

namespace railbook::creep_tool {

using namespace rolling;

namespace {

struct Options {
  std::filesystem::path file;
  ContactOptions contact;
  std::optional<double> speed;
  long cells = 24;
  tool::Destination out;
};

// The columns of the file, in SI.
class Columns {
 public:
  explicit Columns(const std::filesystem::path& file) : csv_(file) {}

  // The column, or none; throws InputError where its unit is not of `dimension`, or is missing.
  std::optional<std::size_t> find(std::string_view name, const units::Dimension& dimension) {
    const auto column = csv_.find(name);
    if (!column) return column;
    const units::Header header = table::parse_column(csv_.header()[*column]);
    const bool spin = name == "spin" && header.unit.dimension == units::wavenumber;
    if (!(header.unit.dimension == dimension) && !spin)
      throw InputError{fmt::format(
          "column \"{}\" names no unit that fits; allowed: one of the "
          "dimension of {}, as \"{}_{}\"",
          csv_.header()[*column], units::si_name(dimension), name, units::si_name(dimension))};
    used_.push_back(*column);
    scale_.resize(csv_.header().size(), 1);
    scale_[*column] = header.unit.si;
    return column;
  }
  bool next() { return csv_.next(); }
  // The value; NaN where the cell is empty and may be.
  double at(const std::optional<std::size_t>& column, double without, bool may_be_empty = false) {
    if (!column) return without;
    const double value = csv_.number(*column) * scale_[*column];
    if (std::isnan(value) && !may_be_empty)
      throw InputError{
          fmt::format("file \"{}\", line {}: column \"{}\" is empty; allowed: a number",
                      csv_.file().string(), csv_.line(), csv_.header()[*column])};
    return value;
  }
  std::string unused() const {
    std::string names;
    for (std::size_t k = 0; k < csv_.header().size(); ++k)
      if (std::ranges::find(used_, k) == used_.end())
        names += (names.empty() ? "" : ", ") + csv_.header()[k];
    return names;
  }
  const table::CsvReader& csv() const { return csv_; }

 private:
  table::CsvReader csv_;
  std::vector<std::size_t> used_;
  std::vector<double> scale_;
};

std::vector<HistoryRow> read(const Options& options, tool::Summary& answer) {
  Columns columns(options.file);
  const auto distance = columns.find("distance", units::length);
  const auto time = distance ? std::nullopt : columns.find("time", units::time);
  if (!distance && !time)
    throw InputError{
        fmt::format("file \"{}\": no column \"distance\" or \"time\" with its unit, as "
                    "distance_mm; there are: {}",
                    options.file.string(), fmt::join(columns.csv().header(), ", "))};
  if (time && !options.speed)
    throw InputError{"the file has times: give the speed of rolling, --speed"};
  const auto load = columns.find("load", units::force), fx = columns.find("fx", units::force);
  const auto longitudinal = columns.find("longitudinal", units::number);
  const auto lateral = columns.find("lateral", units::number);
  const auto spin = columns.find("spin", units::angle / units::length);
  const auto shift_x = columns.find("shift_x", units::length);
  const auto shift_y = columns.find("shift_y", units::length);
  std::vector<HistoryRow> rows;
  while (columns.next()) {
    HistoryRow r;
    r.distance = distance ? columns.at(distance, 0) : columns.at(time, 0) * *options.speed;
    r.load = columns.at(load, options.contact.load);
    const double force = columns.at(fx, units::nan, true);
    if (std::isfinite(force)) r.fx = force;
    r.creepage = {columns.at(longitudinal, 0), columns.at(lateral, 0), columns.at(spin, 0)};
    r.shift_x = columns.at(shift_x, 0), r.shift_y = columns.at(shift_y, 0);
    rows.push_back(r);
  }
  const std::string names = columns.unused();
  if (!names.empty() && !longitudinal && !lateral && !spin && !fx)
    answer.warn("unused_columns", fmt::format("no creepage and no force is given, and columns are "
                                              "not used: {}; used are longitudinal, lateral, spin "
                                              "and fx",
                                              names));
  else if (!names.empty())
    answer.add("unused_columns", "columns not used", names);
  return rows;
}

std::string csv(const std::vector<HistoryStep>& steps, const RollingCase& c) {
  std::string text =
      "distance_m,row,kind,load_N,longitudinal,lateral,spin_1_per_m,shift_x_m,shift_y_m,fx_N,fy_N,"
      "mz_N_m,stick_share,error_share,mz_error_N_m,motion_error\n";
  const auto estimate = [](double x) {
    return std::isfinite(x) ? fmt::format("{:.2g}", x) : "nan";
  };
  for (const HistoryStep& s : steps) {
    const double reach = std::sqrt(c.a * c.b) * std::cbrt(s.load / c.load);
    text += fmt::format(
        "{:.9g},{},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.6g},{},{},"
        "{}\n",
        s.distance, s.row + 1, s.rolled ? "rolled" : "shifted", s.load, s.creepage.longitudinal,
        s.creepage.lateral, s.creepage.spin, s.shift_x, s.shift_y, s.forces.fx, s.forces.fy,
        s.forces.mz, s.forces.stick_share, estimate(s.forces.error),
        estimate(s.forces.mz_error * c.friction * s.load * reach), estimate(s.motion_error));
  }
  return text;
}

// The last step at each row of the file, with the digits of its errors.
void print_rows(const std::vector<HistoryStep>& steps, const RollingCase& c) {
  std::FILE* const to = tool::session().taken ? stderr : stdout;
  fmt::print(to, "\n{:>4} {:>13} {:>10} {:>12} {:>11} {:>11} {:>11} {:>7}\n", "row", "distance, mm",
             "load, kN", "creepage", "shift, um", "fx, N", "fy, N", "stick");
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (k + 1 < steps.size() && steps[k + 1].row == steps[k].row) continue;
    const HistoryStep& s = steps[k];
    const double bound = c.friction * s.load;
    const auto force = [&](double f) { return tool::to_digits_of(f, s.forces.error * bound); };
    const auto motion = [&](double m, double unit) {
      return std::isfinite(s.motion_error) ? tool::to_digits_of(m / unit, s.motion_error / unit)
                                           : tool::to_text(m / unit);
    };
    fmt::print(to, "{:>4} {:>13} {:>10} {:>12} {:>11} {:>11} {:>11} {:>7.3f}\n", s.row + 1,
               tool::to_text(s.distance / units::millimetre),
               tool::to_text(s.load / units::kilonewton),
               s.rolled ? motion(s.creepage.longitudinal, 1) : "-",
               s.rolled ? "-" : motion(s.shift_x, 1e-6), force(s.forces.fx), force(s.forces.fy),
               std::abs(s.forces.stick_share));
  }
}

// Where it leads to, if the last row rolls on.
void add_steady(tool::Summary& answer, const HistoryStep& last, RollingCase c, double unlike) {
  if (!last.rolled || std::abs(unlike) > 0.02) return;
  const double scale = std::cbrt(last.load / c.load);
  c.a *= scale, c.b *= scale, c.load = last.load, c.creepage = last.creepage;
  const CreepForces steady = solver("full", c.a / c.b, c.poisson, 24)(c);
  if (!steady.converged) return;
  answer.add("steady_fx_N", "steady rolling with the last creepages, fx",
             tool::Estimate{steady.fx, steady.error * c.friction * c.load}, "N");
}

void run(const Options& options) {
  tool::OutFolder out(options.out, {"history.csv", "history.json", "history.png"});
  tool::Summary answer("Creep history");
  const MaterialPair pair = combine(options.contact.wheel, options.contact.rail);
  const RollingCase c = contact_of(options.contact, pair, answer);
  answer.add("load_kN", "load of these axes", c.load / units::kilonewton, "kN");
  answer.add("friction", "friction coefficient mu", c.friction, "");
  const std::vector<HistoryRow> rows = read(options, answer);
  const double unlike = std::abs(pair.dissimilarity) > 1e-9 ? pair.dissimilarity : 0;
  if (unlike != 0) {
    answer.add("dissimilarity", "Kalker's K of the unlike bodies", unlike, "");
    if (std::abs(unlike) * c.friction > 0.02)
      answer.warn("pressure", fmt::format("what the tractions do to the pressure, of the order "
                                          "mu K = {:.2f}, is left out",
                                          unlike * c.friction));
  }
  const auto steps =
      roll_history(c, rows, {.along = options.cells, .extrapolate = true, .dissimilarity = unlike});
  const HistoryStep& last = steps.back();
  if (!last.forces.converged)
    throw std::runtime_error(
        fmt::format("no answer at row {}, distance {:.6g} m: {}; another number of --cells may do",
                    last.row + 1, last.distance, last.forces.reason));
  const double rolled = last.distance - rows.front().distance;
  answer.add("steps", "steps", double(steps.size()), "");
  answer.add("rolled_mm", "rolled", rolled / units::millimetre, "mm");
  answer.add("rolled_share", "over the semi-axis along rolling", rolled / c.a, "");
  const double bound = c.friction * last.load;
  const auto with_error = [&](double f) { return tool::Estimate{f, last.forces.error * bound}; };
  answer.add("fx_N", "force along at the end", with_error(last.forces.fx), "N");
  answer.add("fy_N", "force across at the end", with_error(last.forces.fy), "N");
  answer.add("stick_share", "part of the contact that sticks", last.forces.stick_share, "");
  if (last.rolled && std::isfinite(last.motion_error))
    answer.add("longitudinal", "creepage at the end",
               tool::Estimate{last.creepage.longitudinal, last.motion_error}, "");
  add_steady(answer, last, c, unlike);
  double error = 0;
  for (const HistoryStep& s : steps) error = std::fmax(error, s.forces.error);
  if (std::isfinite(error))
    answer.add_error("error_share", "largest error estimate of the force", error, "of mu N");
  else
    answer.absent("error_share", "error estimate", "half the cells have no answer");
  answer.print();
  if (!tool::session().json) print_rows(steps, c);
  if (out) {
    out.add("history.csv", csv(steps, c));
    out.add("history.json", answer.json());
    out.figure(tools::scripts("creep") / "history.gp", {"history.csv"}, "history.png");
  }
  out.commit();
}

std::function<void()> declare(tool::OptionParser& parser) {
  const auto options = std::make_shared<Options>();
  parser.file("history", options->file, "CSV of what is done to the contact");
  parser.required();
  options->contact.declare(parser);
  parser.quantity("--speed", options->speed, units::speed,
                  "of rolling; needed where the file has times", tool::positive);
  parser.count("--cells", options->cells, "along the contact under its largest load, even", 4, 128);
  parser.out(options->out);
  parser.help(
      "Columns, with their units: distance_m (or time_s and --speed), and those that are needed of "
      "load_N, longitudinal, lateral, spin_rad_per_m, fx_N, shift_x_m, shift_y_m; what is not "
      "there "
      "is 0, the load --load. fx is a force in place of the longitudinal creepage, or of the "
      "shift. "
      "Between rows all is linear; a row at the distance of the one before it changes its values "
      "without rolling, and shifts the wheel over the rail. The first row presses a contact "
      "without "
      "tractions. The semi-axes are those at --load and grow with the cube root of the load.\n"
      "Axes: x forward, y to the right, z down. Forces are those of the wheel on the rail. Full "
      "theory, extrapolated from cells of two sizes, which gives the errors.\n"
      "history.csv: kind is rolled or shifted; fx, fy and mz, the "
      "force and the moment about z; stick_share, the part of the area that sticks; error_share, "
      "the error of the force over what friction bears, mz_error that of the moment, motion_error "
      "that of the creepage or shift that a given force asks for.");
  return [options] { run(*options); };
}

}  // namespace

tool::Tool history_tool() {
  return {"history", "shift and rolling that is not steady, along a history", declare};
}

}  // namespace railbook::creep_tool
