// The journey of lib/geometry_car by Runge-Kutta of order 4 on the accelerations themselves, each
// through its own analog filter, and what an ideal instrument would answer, by definition in 80
// bits.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <railbook/geometry_car/reconstruct.hpp>
#include <railbook/geometry_car/simulate.hpp>
#include <railbook/units/constants.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::geometry_car;
using namespace railbook::tests;

namespace {

// The track below the car at one moment, straight in time until the next.
struct Below {
  double height = 0, roll = 0, roll_rear = 0, line = 0, line_rear = 0, grade = 0;
};

double rail(const std::vector<double>& z, double place) {
  const auto i = std::min(static_cast<std::size_t>(std::max(place, 0.0)), z.size() - 2);
  return z[i] + std::clamp(place - static_cast<double>(i), 0.0, 1.0) * (z[i + 1] - z[i]);
}

Below below(const Track& t, double s, double span) {
  const double front = s / t.spacing, rear = (s - span) / t.spacing;
  const auto mean = [](const auto& a, const auto& b, double at) {
    return (rail(a, at) + rail(b, at)) / 2;
  };
  const auto tilt = [&](double at) {
    return std::asin((rail(t.z_left, at) - rail(t.z_right, at)) / t.base);
  };
  return {mean(t.z_left, t.z_right, front),
          tilt(front),
          tilt(rear),
          mean(t.y_left, t.y_right, front),
          mean(t.y_left, t.y_right, rear),
          (mean(t.z_left, t.z_right, front) - mean(t.z_left, t.z_right, rear)) / span};
}

// Body: height, roll and sways; trucks: place and heading; then the filters' poles.
enum S {
  z,
  z1,
  phi,
  phi1,
  front,
  front1,
  rear,
  rear1,
  sway,
  sway1,
  tail,
  tail1,
  filters_from,
  states = filters_from + 10
};
using State = std::array<double, states>;

struct Body {
  const Car& car;
  double v = 0, forward = 0;  // speed, acceleration
  Below at = {}, rate = {};   // at the begin of the piece, and per second

  State operator()(const State& x, double t) const {
    const Ride& r = car.ride;
    const Layout& l = car.layout;
    const auto mode = [](const Mode& m, double rate_off, double off) {
      const double w = 2 * units::pi * m.frequency;
      return -2 * m.damping * w * rate_off - w * w * off;
    };
    const double k = 2 * units::pi / r.truck_wave;
    const double roll = at.roll + t * rate.roll, roll_rear = at.roll_rear + t * rate.roll_rear;
    // Rates of the trucks' headings, times the speed.
    const auto path = [&](double y, double p, double line, double line_rate) {
      return v * (-2 * r.truck_damping * k * (v * p - line_rate) - v * k * k * (y - line));
    };
    const double a = path(x[front], x[front1], at.line + t * rate.line, rate.line),
                 b = path(x[rear], x[rear1], at.line_rear + t * rate.line_rear, rate.line_rear);
    State d{};
    d[z] = x[z1];
    d[z1] = mode(r.bounce, x[z1] - rate.height, x[z] - at.height - t * rate.height);
    const double under = (roll + roll_rear) / 2, w = 2 * units::pi * r.roll.frequency;
    d[phi] = x[phi1];
    d[phi1] = mode(r.roll, x[phi1] - (rate.roll + rate.roll_rear) / 2, x[phi] - under) +
              r.lean * w * w * ((a + b) / 2 / g + under);
    d[front] = v * x[front1], d[front1] = v > 0 ? a / v : 0;
    d[rear] = v * x[rear1], d[rear1] = v > 0 ? b / v : 0;
    d[sway] = x[sway1], d[sway1] = mode(r.sway, x[sway1], x[sway]) - a - g * roll;
    d[tail] = x[tail1], d[tail1] = mode(r.sway, x[tail1], x[tail]) - b - g * roll_rear;
    // What the sensors feel, lateral acceleration less what the rolling of the beam does (its rate
    // leaps).
    const double body = a + d[sway1], h = l.inclinometer_height, c = std::cos(x[phi]),
                 s = std::sin(x[phi]);
    const double upward = d[z1] + g * (c - 1) - (body - h * d[phi1]) * s -
                          (r.pitches ? forward * (at.grade + t * rate.grade) : 0);
    const double yaw = (v * (x[front1] - x[rear1]) + x[sway1] - x[tail1]) / l.truck_spacing;
    const std::array<double, 6> in{upward + l.transducers / 2 * d[phi1],
                                   upward - l.transducers / 2 * d[phi1],
                                   a * std::cos(roll) + g * std::sin(roll),
                                   body * c + g * s - h * d[phi1],
                                   yaw * c,
                                   x[phi1]};
    const double f = 2 * units::pi * l.second_corner, first = 2 * units::pi * l.first_corner;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t j = filters_from + 2 * i;
      d[j] = f * (in[i] - x[j]), d[j + 1] = f * (x[j] - x[j + 1]);
    }
    d[filters_from + 8] = first * (in[4] - x[filters_from + 8]);
    d[filters_from + 9] = first * (in[5] - x[filters_from + 9]);
    return d;
  }
};

State plus(State x, const State& d, double h) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * d[i];
  return x;
}

Record by_runge_kutta(const Track& track, const Car& car, const Motion& motion) {
  const Layout& l = car.layout;
  Record record;
  State x{};
  Moment last;
  int facing = 0;
  bool first = true;
  double since = 0;
  Below here, before_rate;
  each_moment(motion, track.spacing, 0.1, [&](const Moment& m) {
    const double h = m.time - last.time;
    if (first) {
      here = below(track, m.position, l.truck_spacing);
      x[z] = here.height, x[phi] = (here.roll + here.roll_rear) / 2, x[front] = here.line,
      x[rear] = here.line_rear;
    } else if (h > 0) {
      const double way = m.position - last.position;
      const int direction = way > 0 ? 1 : way < 0 ? -1 : 0;
      Body body{car, std::abs(way) / h, m.acceleration, here, {}};
      if (direction != 0 && facing == 0) {
        const Below ahead =
            below(track, last.position + direction * track.spacing, l.truck_spacing);
        x[front1] = (ahead.line - here.line) / track.spacing;
        x[rear1] = (ahead.line_rear - here.line_rear) / track.spacing;
      } else if (direction == -facing) {
        x[front1] = -x[front1], x[rear1] = -x[rear1];
      }
      if (direction != 0) facing = direction;
      const Below next = below(track, m.position, l.truck_spacing);
      body.rate = {(next.height - here.height) / h,       (next.roll - here.roll) / h,
                   (next.roll_rear - here.roll_rear) / h, (next.line - here.line) / h,
                   (next.line_rear - here.line_rear) / h, (next.grade - here.grade) / h};
      // The beam's rolling leaps: an impulse for the first pole.
      x[filters_from + 4] -=
          l.beam_height * 2 * units::pi * l.second_corner * (body.rate.roll - before_rate.roll);
      before_rate = body.rate;
      const int parts = std::max(4, static_cast<int>(std::ceil(h / 1e-3)));
      const double step = h / parts;
      for (int i = 0; i < parts; ++i) {
        const double t = i * step;
        const State a = body(x, t), b = body(plus(x, a, step / 2), t + step / 2),
                    c = body(plus(x, b, step / 2), t + step / 2),
                    d = body(plus(x, c, step), t + step);
        for (std::size_t j = 0; j < x.size(); ++j)
          x[j] += step / 6 * (a[j] + 2 * b[j] + 2 * c[j] + d[j]);
      }
      here = next;
    }
    since += first ? 0 : h;
    first = false;
    last = m;
    if (m.node < 0 || m.node % track.substeps != 0) return;
    record.elapsed.push_back(since);
    since = 0;
    record.mark.push_back(m.node / track.substeps);
    const double over = x[z] - here.height,
                 tilt = l.transducers / 2 * (std::sin(x[phi]) - std::sin(here.roll));
    const double turn = 0.6 * ((x[front] + x[sway] - x[rear] - x[tail]) / l.truck_spacing -
                               x[front1] * (facing < 0 ? -1 : 1));
    const auto filtered = [&](std::size_t i) { return x[filters_from + i]; };
    const std::array<double, channels> values{
        filtered(1),
        filtered(3),
        filtered(5),
        filtered(7),
        filtered(8),
        filtered(9),
        over + tilt,
        over - tilt,
        x[sway] + turn,
        x[sway] - turn,
        x[tail],
        rail(track.y_left, m.position / track.spacing) - x[front] - l.beam / 2,
        x[front] - rail(track.y_right, m.position / track.spacing) - l.beam / 2};
    for (std::size_t c = 0; c < channels; ++c) record.values[c].push_back(values[c]);
  });
  return record;
}

}  // namespace

TEST_CASE("claim: the journey by another integrator") {
  Claim claim("geometry_car::drive");
  RandomStream draw(1);
  for (int k = 0; k < 16; ++k) {
    TrackDescription d;
    d.length = 250, d.seed = static_cast<std::uint64_t>(k);
    d.curve_begin = 0.1, d.spiral = 30, d.curve_length = 50, d.vertical_curve = 100;
    d.curvature *= draw(-1, 1), d.superelevation *= draw(0, 1);
    const Track track = build(d);
    Car car;
    for (Mode* m : {&car.ride.bounce, &car.ride.roll, &car.ride.sway})
      m->frequency *= draw(0.5, 2), m->damping = draw(0.05, 1);
    car.ride.pitches = k % 2 == 0;
    car.layout.first_corner = draw(0.3, 3), car.layout.second_corner = draw(0.3, 3);
    // At a crawl, and as fast as trains go; to a stop, and back.
    const double v = k < 2 ? 0.5 : draw(2, 40);
    Motion motion{.start = 40, .speed = v};
    motion.cruise(v > 2 ? 80 : 5).change_speed(v / 2, v * v / 60);
    if (k % 3 == 0) motion.change_speed(0, v * v / 60).stand(3).change_speed(-v, v * v / 40);
    motion.cruise(v > 2 ? 20 : 2);
    const Record found = drive(track, car, motion), other = by_runge_kutta(track, car, motion);
    REQUIRE(found.mark == other.mark);
    for (std::size_t c = 0; c < channels; ++c) {
      double largest = 0;
      for (const double value : other.values[c]) largest = std::max(largest, std::abs(value));
      for (std::size_t i = 0; i < found.size(); ++i)
        claim.error(std::abs(found.values[c][i] - other.values[c][i]) / largest);
    }
  }
}

TEST_CASE("claim: the truth by definition") {
  Claim claim("geometry_car::truth");
  RandomStream draw(2);
  for (int k = 0; k < 6; ++k) {
    Processing p;
    p.chain.high_pass = {3 + 2 * (k + 2), 1 + k % 4, 1};
    p.chain.half_chord = 2 + 3 * k;
    p.curvature_mean = 3 + 2 * k;
    p.layout.truck_spacing = (4 + 2 * k) * p.layout.sample;
    const std::size_t marks = 150, step = static_cast<std::size_t>(2 + k);
    Track track{
        p.layout.sample / static_cast<double>(step), static_cast<int>(step), 1.5, {}, {}, {}, {}};
    for (auto* values : {&track.z_left, &track.z_right, &track.y_left, &track.y_right})
      for (std::size_t i = 0; i < marks * step; ++i) values->push_back(draw(-0.01, 0.01));
    const Measurement m = truth(track, p);
    using Values = std::vector<std::optional<Long>>;
    const auto at_marks = [&](const std::vector<double>& fine) {
      Values all;
      for (std::size_t i = 0; i < marks; ++i) all.emplace_back(fine[i * step]);
      return all;
    };
    // Nothing where a place is not there.
    const auto made = [&](auto value) {
      Values all(marks);
      for (std::size_t i = 0; i < marks; ++i) all[i] = value(static_cast<long>(i));
      return all;
    };
    const auto sum = [&](const Values& x, std::initializer_list<std::pair<long, Long>> terms) {
      std::optional<Long> total = 0;
      for (const auto& [i, weight] : terms) {
        const bool there = i >= 0 && i < static_cast<long>(marks) && x[static_cast<std::size_t>(i)];
        if (!there) return std::optional<Long>{};
        *total += weight * *x[static_cast<std::size_t>(i)];
      }
      return total;
    };
    const Long foot = p.layout.sample;
    const Values z_l = at_marks(track.z_left), z_r = at_marks(track.z_right),
                 y_l = at_marks(track.y_left), y_r = at_marks(track.y_right);
    const Values level = made([&](long i) {
      return *sum(z_l, {{i, 1}}) - *sum(z_r, {{i, 1}});
    }),
                 gage = made([&](long i) {
                   return *sum(y_l, {{i, 1}}) - *sum(y_r, {{i, 1}});
                 }),
                 middle = made([&](long i) {
                   return (*sum(y_l, {{i, 1}}) + *sum(y_r, {{i, 1}})) / 2;
                 });
    const long half = p.chain.half_chord, span = 4 + 2 * k, mean = p.curvature_mean / 2;
    const Values heading = made([&](long i) {
      return sum(middle, {{i, 1 / (span * foot)}, {i - span, -1 / (span * foot)}});
    });
    const Long per = 2 * p.curvature_mean * foot;
    const Values curve = made([&](long i) {
      const long j = i + span / 2;
      return sum(heading, {{j + mean + 1, 1 / per},
                           {j + mean, 1 / per},
                           {j - mean, -1 / per},
                           {j - mean - 1, -1 / per}});
    });
    const Values change = made([&](long i) {
      return sum(curve, {{i + mean, 1 / (2 * mean * foot)}, {i - mean, -1 / (2 * mean * foot)}});
    });
    const auto compare = [&](Parameter parameter, const Values& exact, Long scale) {
      int there = 0;
      for (std::size_t i = 0; i < marks; ++i) {
        if (std::isnan(m[parameter][i])) continue;
        ++there;
        claim.error(
            exact[i] ? static_cast<double>(std::abs(m[parameter][i] - *exact[i]) / (0.01L * scale))
                     : 1);
      }
      CHECK(there > 20);
    };
    compare(Parameter::gage, gage, 1);
    compare(Parameter::crosslevel, level, 1);
    compare(Parameter::warp, made([&](long i) {
              return sum(level, {{i + half, 1}, {i - half, -1}});
            }),
            1);
    compare(Parameter::curvature, curve, 1 / (span * foot * per));
    compare(Parameter::curvature_rate, change, 1 / (span * foot * per * mean * foot));
    const auto chord = [&](const Values& rails, Parameter offset, Parameter curved) {
      Values smooth = rails;
      const long side = p.chain.high_pass.length / 2;
      for (int pass = 0; pass < p.chain.high_pass.passes; ++pass) {
        const Values x = smooth;
        smooth = made([&](long i) {
          std::optional<Long> total = 0;
          for (long j = i - side; j <= i + side; ++j) {
            const auto one = sum(x, {{j, 1 / static_cast<Long>(2 * side + 1)}});
            if (!one) return std::optional<Long>{};
            *total += *one;
          }
          return total;
        });
      }
      const Values high = made([&](long i) {
        const auto slow = sum(smooth, {{i, 1}});
        return slow ? std::optional<Long>{*sum(rails, {{i, 1}}) - *slow} : slow;
      });
      compare(curved, high, 1);
      compare(offset, made([&](long i) {
                return sum(high, {{i, 1}, {i - half, -0.5L}, {i + half, -0.5L}});
              }),
              1);
    };
    chord(z_l, Parameter::profile_left, Parameter::surface_left);
    chord(z_r, Parameter::profile_right, Parameter::surface_right);
    chord(y_l, Parameter::alignment_left, Parameter::line_left);
    chord(y_r, Parameter::alignment_right, Parameter::line_right);
  }
}
