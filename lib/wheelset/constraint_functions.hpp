// What the dynamics needs of wheel and rail: odd functions of the wheelset's lateral displacement,
// as tables.
//
//   const auto& pair = wheelset::new_wheel_table();           // wheelset/paper_pairs.hpp
//   const auto c = pair.at(x);                                 // R, D, Phi and their slopes at x
//   [m] for (double knot : pair.R.values()) ...                    // at 0, step, 2 step, ...
//
// x > 0 is to the left (see wheelset_contact.hpp). A function of x_w/a, as the paper writes it, has
// a times these slopes.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace railbook::wheelset {

// An odd, piecewise linear function with knots at 0, step, 2 step, ...; beyond the last knot it
// goes on with its last slope. At a knot the slope is that of the outer side. Values to 1e-14 of
// the largest.
class OddTable {
 public:
  OddTable() = default;
  // `values` at the knots: at least two, the first 0, all finite; step > 0. Throws InputError
  // otherwise.
  OddTable(double step, std::vector<double> values);

  double operator()(double x) const {
    const std::size_t i = interval(std::abs(x));
    const double y = values_[i] + (std::abs(x) - step_ * double(i)) * slopes_[i];
    return x < 0 ? -y : y;
  }
  double slope(double x) const { return slopes_[interval(std::abs(x))]; }

  double step() const { return step_; }
  double end() const { return step_ * double(slopes_.size()); }  // the last knot
  const std::vector<double>& values() const { return values_; }
  const std::vector<double>& slopes() const { return slopes_; }  // of each interval

  // The interval of |x|; beyond the last knot the last one.
  std::size_t interval(double size) const {
    const double i = size * inverse_;
    return i < last_ ? std::size_t(i) : std::size_t(last_);
  }

 private:
  double step_ = 0, inverse_ = 0, last_ = 0;
  std::vector<double> values_, slopes_;
};

struct ConstraintValues {
  double R, D, Phi;     // (r_L - r_R)/2a, (delta_L - delta_R)/2 [rad], phi_w [rad]
  double dR, dD, dPhi;  // their slopes [1/m]
};

// The constraint functions of a wheelset on its track. Displacements x and half spacing in metres.
struct ConstraintFunctions {
  double half_spacing = 0;  // a: half the distance between the rails' head centres
  double radius = 0;        // r_0: rolling radius at x = 0, the mean of both wheels
  OddTable R, D, Phi;       // all with the same step and length
  // What is added where left and right differ: even functions, at 0, step, ...; empty for a
  // symmetric wheelset and track.
  struct Even {
    std::vector<double> R, D, Phi;
  } even{};
  // Rolling radii [m] and contact angles to the axle [rad] of both wheels at -end, ..., -step, 0,
  // step, ..., end. Of a symmetric wheelset the right one's are the left one's at -x.
  std::vector<double> r_left{}, delta_left{}, r_right{}, delta_right{};

  double end() const { return R.end(); }
  bool symmetric() const { return even.R.empty(); }

  ConstraintValues at(double x) const {
    const double size = std::abs(x), sign = x < 0 ? -1.0 : 1.0;
    const std::size_t i = R.interval(size);
    const double past = size - R.step() * double(i);
    const double dR = R.slopes()[i], dD = D.slopes()[i], dPhi = Phi.slopes()[i];
    ConstraintValues c{sign * (R.values()[i] + past * dR),
                       sign * (D.values()[i] + past * dD),
                       sign * (Phi.values()[i] + past * dPhi),
                       dR,
                       dD,
                       dPhi};
    if (symmetric()) return c;
    const auto add = [&](const std::vector<double>& e, double& value, double& slope) {
      const double d = (e[i + 1] - e[i]) / R.step();
      value += e[i] + past * d;
      slope += sign * d;
    };
    add(even.R, c.R, c.dR);
    add(even.D, c.D, c.dD);
    add(even.Phi, c.Phi, c.dPhi);
    return c;
  }
};

}  // namespace railbook::wheelset
