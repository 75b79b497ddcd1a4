/*** ## Independent of speed and direction?

**Constant speed.** What is left of the speed in an ideal profile is a matter of phase. The kernel of $F\cdot G$ has its centroid not a sample late but
$2T(1/\kappa-a/(1-a))\approx T(1-\kappa/6)$: the path of the body is read $\kappa d/6$ ahead, while the height sensors read it where they are. So the error
must be this shift times the slope of the body's path, of one sign forwards and of the other backwards:

{{table-directions}}

It is. The claim "independent of speed and direction" holds to the first order in $\kappa$, and the table shows what the first order costs.
Car turned about or car backing makes no difference: the table's *turned* column is the same car met from the other end of the track.

{{fig-directions}}

**Changing speed.** The filter $G$ knows each $T_k$, and annihilates both analog modes for any history. What it cannot know is $z_k-z_{k-1}$: on a grade, a car
that changes speed feels a vertical acceleration, grade times $\dot V$, if its accelerometers stay upright. If they pitch with the
grade they do not. The table compares a filter that takes the last interval for both (*local*), the exact one, the exact one told the slope
of the rail, and the exact one in a car that pitches:

{{table-speeds}}

The slope is what matters, on level track as well: joints and roughness are slopes, too. The varying $T$ itself is worth little at rates a train can
change its speed. A car that pitches with the grade is the better instrument; what it has left is that its pitch is the slope between its trucks, not at
the axle. The 700 ft before and behind each change, in which the speed is constant, are in the errors.

**Every parameter.** The whole main line, typical sensors, from walking pace to 120 mph:

{{fig-parameters}}

{{table-claims}}

Gage has no time in it, and its error is that of two steps of 0.1 mm at any speed. Crosslevel is *better* at low speed: no sway, no centrifugal acceleration,
and the inclinometer alone has the answer at rest. Curvature's error is the gyro's bias over the speed: {{curvature-2}} at 2 mph, where the paper draws its line, with a bias of 0.005 deg/s,
which is why the gyro is debiased at standstill; the earth's own rotation is nearly as much. Alignment is the hard one. Its accelerometer feels gravity as
soon as the beam rolls, and a tenth of a milliradian within a chord is 9 mm at 5 mph: {{alignment-15}} at 15 mph and {{alignment-5}} at 5 mph, of a signal of {{alignment-true}}.
*/
#include "experiment.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "filters/hybrid_filter.hpp"
#include "items.hpp"

namespace railbook::filters_chapter {

using namespace geometry_car;

namespace {

// The error that the shift of FG's centroid makes, by row: shift times the slope of the body's long chord.
std::vector<double> shift_error(const Record& record, const Track& track, double shift) {
  const std::size_t n = record.size();
  std::vector<double> body(n), short_offset(n, std::nan("")), error(n, std::nan(""));
  for (std::size_t i = 0; i < n; ++i)
    body[i] = track.z_left[static_cast<std::size_t>(record.mark[i] * track.substeps)] +
              record[Channel::height_left][i];
  for (std::size_t i = 1; i + 1 < n; ++i)
    short_offset[i] = body[i] - 0.5 * (body[i - 1] + body[i + 1]);
  const auto chord = filters::geometry(short_offset).chord;
  for (std::size_t i = 1; i + 1 < n; ++i)
    error[i] = shift * (chord[i + 1] - chord[i - 1]) / (2 * foot);
  return error;
}

double rms(const std::vector<double>& values) {
  double sum = 0;
  int n = 0;
  for (const double v : values)
    if (!std::isnan(v)) sum += v * v, ++n;
  return n > 0 ? std::sqrt(sum / n) : 0.0;
}

void table_directions(report::Item& item) {
  const Track track = build(bounce_line()), back = turned(track);
  const Car car = bounce_car();
  const Processing p{.layout = car.layout};
  const auto there = truth(track, p), again = truth(back, p);
  const std::vector<double> speeds{5, 9, 15, 30, 80};
  item.expect_checks(static_cast<int>(3 * speeds.size()));
  item.columns(
      {"mph", "κ", "shift, mm", "error by the shift, mm", "forwards", "backing", "turned"});
  for (const double speed : speeds) {
    const Record ahead = cruise(track, car, speed * mph);
    const double kappa = 2 * units::pi * car.layout.second_corner * foot / (speed * mph);
    const double shift = (1 - 2 * filters::centroid_delay(kappa)) * foot;
    const double by_shift = rms(shift_error(ahead, track, shift)) / mm;
    const auto error = [&](const Record& r, const Measurement& t) {
      return misfit(reconstruct(r, p), t, Parameter::profile_left).rms / mm;
    };
    const double forwards = error(ahead, there),
                 backing = error(cruise(track, car, -speed * mph), there),
                 about = error(cruise(back, car, speed * mph), again);
    const std::string name = fmt::format("{}", speed), of = fmt::format("at {} mph, RMS", speed);
    const char* why =
        "shift of the kernel's centroid, first order in kappa; each way has its own ride";
    item.agree("forwards-" + name, "ideal error forwards " + of, "mm", forwards, by_shift, 0.1,
               why);
    item.agree("backing-" + name, "ideal error backing " + of, "mm", backing, by_shift, 0.1, why);
    item.agree("turned-" + name, "ideal error turned " + of, "mm", about, by_shift, 0.1, why);
    item.add_row({name, fmt::format("{:.4f}", kappa), fmt::format("{:.2f}", shift / mm),
                  fmt::format("{:.4f}", by_shift), fmt::format("{:.4f}", forwards),
                  fmt::format("{:.4f}", backing), fmt::format("{:.4f}", about)});
  }
}

void fig_directions(report::Item& item) {
  item.reconstructed("track, ride and corners are ours");
  auto& data = item.data({"x_ft", "run", "profile_mm", "truth_mm", "error_mm"});
  const Track track = build(main_line());
  const Car car;
  const Processing p{.layout = car.layout};
  const auto t = truth(track, p);
  for (const double speed : {9.0, -9.0, 80.0, -80.0}) {
    const auto m = reconstruct(cruise(track, car, speed * mph), p);
    for (std::size_t i = 0; i < m.size(); ++i) {
      if (m.mark[i] < 2000 || m.mark[i] > 2400) continue;
      const double v = m[Parameter::profile_left][i] / mm,
                   v0 = t[Parameter::profile_left][static_cast<std::size_t>(m.mark[i])] / mm;
      data.add(static_cast<double>(m.mark[i]), speed, v, v0, v - v0);
    }
    data.gap();
  }
}

struct History {
  std::string id, what;
  double grade, from, to, rate, start;  // speeds in mph; start in ft
};

void table_speeds(report::Item& item) {
  item.reconstructed("track, ride, corner and histories are ours");
  const std::vector<History> histories{
      {"up", "5 to 80 mph at 0.5 m/s², level", 0.0, 5, 80, 0.5, 2000},
      {"down", "60 to 9 mph at 0.3 m/s², 1 % grade", 0.01, 60, 9, 0.3, 2600}};
  item.expect_checks(6);
  item.columns({"history", "", "local", "exact", "exact, slope known", "exact, pitching car"});
  for (const History& h : histories) {
    TrackDescription line = bounce_line();
    line.grade = h.grade;
    const Track track = build(line);
    Car car = bounce_car();
    Processing p{.layout = car.layout};
    const auto t = truth(track, p);
    Motion motion{.start = h.start * foot, .speed = h.from * mph};
    motion.cruise(700 * foot).change_speed(h.to * mph, h.rate).cruise(700 * foot);
    const Record upright = drive(track, car, motion);
    car.ride.pitches = true;
    const Record pitching = drive(track, car, motion);
    const auto error = [&](const Record& r, const Processing& how) {
      return misfit(reconstruct(r, how), t, Parameter::profile_left, 330 + 300);
    };
    Processing local = p, told = p;
    local.local = true;
    for (std::size_t i = 0; i + 16 < track.size(); i += 16)
      told.grade.push_back((track.z_left[i + 16] - track.z_left[i]) / foot);
    const Misfit a = error(upright, local), b = error(upright, p), c = error(upright, told),
                 d = error(pitching, p);
    const auto text = [](double v) { return fmt::format("{:.3f}", v / mm); };
    item.add_row({h.what, "RMS, mm", text(a.rms), text(b.rms), text(c.rms), text(d.rms)});
    item.add_row(
        {"", "largest, mm", text(a.largest), text(b.largest), text(c.largest), text(d.largest)});
    // The slowest part is the worst: no history may be worse than cruising at its slowest speed.
    const double slowest = misfit(reconstruct(cruise(track, car, std::min(h.from, h.to) * mph), p),
                                  t, Parameter::profile_left)
                               .rms;
    const auto bound = fmt::format("{:.4f}", slowest / mm);
    item.check(h.id + "-known", "slope known, against cruising at the slowest speed", "mm", bound,
               c.rms / mm, report::at_most("the error of the slowest speed, all along"));
    item.check(h.id + "-pitching", "pitching car, against the upright one", "mm",
               fmt::format("{:.6f}", b.rms / mm), d.rms / mm,
               report::at_most("it does not feel the grade"));
    item.check(h.id + "-local", "slope known, against the local filter", "mm",
               fmt::format("{:.6f}", a.rms / mm), c.rms / mm,
               report::at_most("nothing is left out"));
  }
}

struct Sweep {
  std::vector<double> speeds{0.5, 1, 2, 5, 9, 15, 30, 60, 120};
  std::vector<Measurement> ideal, typical;
  Measurement truth;
  double error(std::size_t i, Parameter p, bool with_sensors) const {
    return misfit(with_sensors ? typical[i] : ideal[i], truth, p, 700).rms;
  }
  double at(double speed, Parameter p) const {
    std::size_t i = 0;
    while (speeds[i] != speed) ++i;
    return error(i, p, true);
  }
};

const Sweep& sweep() {
  static const Sweep result = [] {
    Sweep s;
    const Track track = build(main_line());
    const Car car;
    const Processing p{.layout = car.layout};
    s.truth = truth(track, p);
    for (const double v : s.speeds) {
      const Record r = cruise(track, car, v * mph);
      s.ideal.push_back(reconstruct(r, p));
      s.typical.push_back(reconstruct(measured(r, car.layout, typical_sensors(), 3), p));
    }
    return s;
  }();
  return result;
}

void fig_parameters(report::Item& item) {
  item.reconstructed("track, ride, corners and sensors are ours");
  using enum Parameter;
  auto& data = item.data({"speed_mph", "sensors", "gage_mm", "crosslevel_mm", "profile_mm",
                          "alignment_mm", "curvature_deg_per_100ft"});
  const Sweep& s = sweep();
  for (const bool typical : {false, true}) {
    for (std::size_t i = 0; i < s.speeds.size(); ++i)
      data.add(s.speeds[i], typical ? "typical" : "ideal", s.error(i, gage, typical) / mm,
               s.error(i, crosslevel, typical) / mm, s.error(i, profile_left, typical) / mm,
               s.error(i, alignment_left, typical) / mm,
               s.error(i, curvature, typical) / per_100ft);
    data.gap();
  }
}

void table_claims(report::Item& item) {
  const auto printed = item.printed("claims.csv");
  const Sweep& s = sweep();
  using enum Parameter;
  item.expect_checks(9);
  item.columns({"the paper says", "we find"});
  const double steps = std::sqrt(2.0 / 12) * 0.1;  // of two gage sensors, mm
  for (const double v : {0.5, 120.0})
    item.agree(fmt::format("gage-{}", v), fmt::format("gage error at {} mph", v), "mm",
               s.at(v, gage) / mm, steps, 0.03, "two steps of 0.1 mm, whatever the speed");
  for (const double v : {0.5, 1.0, 2.0})
    item.check(fmt::format("crosslevel-{}", v),
               fmt::format("crosslevel error at {} mph, at most that at 30 mph", v), "mm",
               fmt::format("{:.4f}", s.at(30, crosslevel) / mm), s.at(v, crosslevel) / mm,
               report::at_most("accurate to 0 mph"));
  const double floor = report::printed_number(printed.at("yaw-floor", "value"));
  item.agree("curvature", "curvature error at the paper's lowest speed", "deg/100 ft",
             s.at(floor, curvature) / per_100ft, 0.005 * units::degree / (floor * mph) / per_100ft,
             0.05, "bias of 0.005 deg/s over the speed, the rest is small");
  item.row(printed, "half-sample").check("value", 0.5 * Layout{}.sample / units::inch);
  const double paper = report::printed_number(printed.at("strip-mile", "value")) * units::inch;
  item.agree("strip", "samples an inch of strip chart", "",
             units::mile / foot / (paper / units::inch), 5280.0 / 18, 1e-12, "a mile on 18 in");
  const double degraded = report::printed_number(printed.at("degraded", "value")),
               unreliable = report::printed_number(printed.at("unreliable", "value"));
  item.check("profile", "growth of the profile's error from degraded to unreliable, at least", "",
             "3", s.at(unreliable, profile_left) / s.at(degraded, profile_left),
             report::at_least("the ratio of the speeds"));
  const auto row = [&](const std::string& says, const std::string& find) {
    item.add_row({says, find});
  };
  row("gage remains accurate to 0 mph", fmt::format("RMS error {:.3f} mm at 0.5 mph, {:.3f} at 120",
                                                    s.at(0.5, gage) / mm, s.at(120, gage) / mm));
  row("so does crosslevel",
      fmt::format("{:.2f} mm at 0.5 mph, {:.2f} at 30, {:.2f} at 120", s.at(0.5, crosslevel) / mm,
                  s.at(30, crosslevel) / mm, s.at(120, crosslevel) / mm));
  row("curvature to about 2 mph",
      fmt::format("{:.3f} deg per 100 ft at 2 mph, {:.3f} at 15", s.at(2, curvature) / per_100ft,
                  s.at(15, curvature) / per_100ft));
  row("profile is degraded below 15 mph, not to be relied upon below 5",
      fmt::format("{:.2f} mm at 15 mph, {:.2f} at 5, {:.1f} at 2", s.at(15, profile_left) / mm,
                  s.at(5, profile_left) / mm, s.at(2, profile_left) / mm));
  row("so is alignment",
      fmt::format("{:.2f} mm at 15 mph, {:.2f} at 5, {:.1f} at 2", s.at(15, alignment_left) / mm,
                  s.at(5, alignment_left) / mm, s.at(2, alignment_left) / mm));
  const double year =
      report::printed_number(printed.at("track-miles", "value")) * units::mile / foot;
  row("70 000 track miles a year", fmt::format("{:.3g} samples of each channel", year));
  row("a mile on about 18 in of paper",
      fmt::format("scale 1:{:.0f}, {:.0f} samples an inch", units::mile / paper,
                  units::mile / foot / (paper / units::inch)));
  item.value("curvature-2", s.at(2, curvature) / per_100ft, "deg per 100 ft", "{:.2f}");
  item.value("alignment-15", s.at(15, alignment_left) / mm, "mm", "{:.1f}");
  item.value("alignment-5", s.at(5, alignment_left) / mm, "mm", "{:.1f}");
  item.value("alignment-true", rms(s.truth[alignment_left]) / mm, "mm", "{:.1f}");
}

}  // namespace

void add_speeds(report::Chapter& chapter) {
  chapter.table("table-directions", "The ideal error is a shift, forwards and backwards",
                table_directions);
  chapter.figure("fig-directions", "Forwards and backwards over the same rail", fig_directions);
  chapter.table("table-speeds", "Profile while the speed changes", table_speeds);
  chapter.figure("fig-parameters", "RMS error of every parameter against speed", fig_parameters);
  chapter.table("table-claims", "What the paper claims of its speeds", table_claims);
}

}  // namespace railbook::filters_chapter
