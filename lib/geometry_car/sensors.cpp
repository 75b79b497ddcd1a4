#include <railbook/geometry_car/sensors.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <railbook/num/random_source.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::geometry_car {
namespace {

// 1 - exp(-x) times the first n terms of the series of exp(x), x >= 0: without a difference of near
// equals where x is small.
double rest(int n, double x) {
  double term = std::exp(-x), sum = 0;
  if (x > 1) {
    for (int j = 0; j < n; ++j, term *= x / j) sum += term;
    return 1 - sum;
  }
  for (int j = 1; j < n + 20; ++j) {
    term *= x / j;
    if (j >= n) sum += term;
  }
  return sum;
}

// White noise of two-sided intensity S through one or two equal poles at w: the stationary
// covariance is (wS/2) [1 1/2; 1/2 1/2], and over an interval T the states decay by a [1 0; wT 1],
// a = exp(-wT), while what the noise adds has the covariance that keeps the stationary one.
class FilteredNoise {
 public:
  FilteredNoise(int order, double w, double density, const num::RandomSource& source)
      : order_(order), w_(w), variance_(0.25 * w * density * density), source_(source) {
    const double sigma = std::sqrt(variance_);
    first_ = sigma * draw();
    second_ = 0.5 * first_ + 0.5 * sigma * draw();
  }

  double next(double T) {
    const double k = w_ * std::max(T, 0.0), a = std::exp(-k);
    const double q11 = rest(1, 2 * k), q12 = 0.5 * rest(2, 2 * k), q22 = 0.5 * rest(3, 2 * k);
    const double l11 = std::sqrt(std::max(q11, 0.0)), l21 = l11 > 0 ? q12 / l11 : 0.0;
    const double l22 = std::sqrt(std::max(q22 - l21 * l21, 0.0));
    const double sigma = std::sqrt(variance_), e1 = draw(), e2 = draw();
    second_ = a * (second_ + k * first_) + sigma * (l21 * e1 + l22 * e2);
    first_ = a * first_ + sigma * l11 * e1;
    return order_ == 1 ? first_ : second_;
  }

 private:
  double draw() { return source_.normal(drawn_++); }

  int order_;
  double w_, variance_, first_ = 0, second_ = 0;
  num::RandomSource source_;
  std::uint64_t drawn_ = 0;
};

void require(const ChannelInfo& info, const SensorError& e) {
  const auto named = [&](const char* what) {
    return std::string(what) + " of " + std::string(info.name);
  };
  units::require_finite(named("bias"), e.bias);
  units::require_between(named("error of the gain"), e.scale, -0.5, 0.5);
  units::require_non_negative(named("noise density"), e.density);
  units::require_non_negative(named("scatter"), e.scatter);
  units::require_non_negative(named("range"), e.range);
  units::require_non_negative(named("step"), e.step);
}

}  // namespace

Sensors typical_sensors() {
  using enum Channel;
  constexpr double rate = 0.005 * units::degree;
  Sensors s;
  for (const Channel c : {vertical_left, vertical_right, lateral, inclinometer})
    s[c] = {.bias = 1e-3 * g, .density = 20e-6 * g, .range = g, .step = 2 * g / 4096};
  for (const Channel c : {yaw_rate, roll_rate}) s[c] = {.bias = rate, .density = rate};
  for (const Channel c :
       {height_left, height_right, sway_front_a, sway_front_b, sway_rear, gage_left, gage_right})
    s[c] = {.step = 0.1 * units::millimetre};
  return s;
}

Record measured(const Record& clean, const Layout& layout, const Sensors& sensors,
                std::uint64_t seed) {
  Record record = clean;
  for (const ChannelInfo& info : channel_list()) {
    const SensorError& e = sensors[info.channel];
    require(info, e);
    const num::RandomSource noise{seed, 100 + static_cast<std::uint64_t>(info.channel)};
    const num::RandomSource white{seed, 200 + static_cast<std::uint64_t>(info.channel)};
    const double corner = info.filter == 2 ? layout.second_corner : layout.first_corner;
    FilteredNoise filtered{info.filter, 2 * units::pi * corner, e.density, noise};
    auto& values = record[info.channel];
    for (std::size_t k = 0; k < values.size(); ++k) {
      double v = values[k] * (1 + e.scale) + e.bias;
      if (e.density > 0 && info.filter > 0) v += filtered.next(record.elapsed[k]);
      if (e.scatter > 0) v += e.scatter * white.normal(k);
      if (e.range > 0) v = std::clamp(v, -e.range, e.range);
      if (e.step > 0) v = e.step * std::round(v / e.step);
      values[k] = v;
    }
  }
  return record;
}

}  // namespace railbook::geometry_car
