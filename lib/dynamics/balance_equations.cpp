#include "dynamics/balance_equations.hpp"

#include <algorithm>

namespace railbook::dynamics {

using Complex = std::complex<double>;

Reference reference(const Oscillator& o) {
  Reference ref{{}, o.stiffness};
  for (const Channel& c : o.channels) {
    Eigen::VectorXd slope = Eigen::VectorXd::Zero(c.law.outputs());
    if (!c.of_rate) slope = 0.5 * c.law.slopes().col(c.law.piece(0));
    ref.stiffness -= c.force * slope * c.row.transpose();
    ref.slope.push_back(std::move(slope));
  }
  return ref;
}

Eigen::MatrixXcd dynamic_stiffness(const Oscillator& o, const Eigen::MatrixXd& stiffness,
                                   Complex p) {
  return o.mass.cast<Complex>() * (p * p) +
         (o.damping + o.inverse_speed * o.damping_by_speed).cast<Complex>() * p +
         stiffness.cast<Complex>();
}

Eigen::MatrixXd all_forces(const Oscillator& o) {
  Eigen::Index outputs = 0;
  for (const Channel& c : o.channels) outputs += c.force.cols();
  Eigen::MatrixXd forces(o.coordinates(), outputs);
  Eigen::Index at = 0;
  for (const Channel& c : o.channels) {
    forces.middleCols(at, c.force.cols()) = c.force;
    at += c.force.cols();
  }
  return forces;
}

Eigen::MatrixXcd all_rows(const Oscillator& o, Complex p) {
  Eigen::MatrixXcd rows(Eigen::Index(o.channels.size()), o.coordinates());
  for (std::size_t c = 0; c < o.channels.size(); ++c)
    rows.row(Eigen::Index(c)) =
        o.channels[c].row.transpose().cast<Complex>() * (o.channels[c].of_rate ? p : Complex(1));
  return rows;
}

int sample_count(const Cycle& cycle, int wanted) {
  const int highest = cycle.orders.back();
  const int least = wanted > 0 ? std::max(wanted, 4 * highest) : std::max(512, 32 * highest);
  int n = 8;
  while (n < least) n *= 2;
  return n;
}

Eigen::MatrixXd sampled_scalars(const Cycle& cycle, num::RealFft& fft) {
  const auto n = Eigen::Index(fft.size());
  Eigen::MatrixXd samples(cycle.scalars.rows(), n);
  for (Eigen::Index c = 0; c < samples.rows(); ++c) {
    std::fill(fft.spectrum().begin(), fft.spectrum().end(), Complex{});
    for (std::size_t k = 0; k < cycle.orders.size(); ++k)
      fft.spectrum()[std::size_t(cycle.orders[k])] =
          (cycle.orders[k] > 0 ? 0.5 : 1.0) * cycle.scalars(c, Eigen::Index(k));
    fft.inverse();
    for (Eigen::Index j = 0; j < n; ++j) samples(c, j) = fft.real()[std::size_t(j)];
  }
  return samples;
}

std::vector<std::vector<Complex>> slope_spectra(const Oscillator& o, const Reference& ref,
                                                const Cycle& cycle, int samples) {
  num::RealFft fft{std::size_t(samples)};
  const Eigen::MatrixXd s = sampled_scalars(cycle, fft);
  std::vector<std::vector<Complex>> result;
  std::vector<Eigen::Index> pieces(std::size_t(samples), 0);
  for (std::size_t c = 0; c < o.channels.size(); ++c) {
    const PiecewiseLinear& law = o.channels[c].law;
    for (std::size_t j = 0; j < pieces.size(); ++j)
      pieces[j] = law.piece(s(Eigen::Index(c), Eigen::Index(j)));
    for (Eigen::Index m = 0; m < law.outputs(); ++m) {
      for (std::size_t j = 0; j < pieces.size(); ++j)
        fft.real()[j] = law.slopes()(m, pieces[j]) - ref.slope[c][m];
      fft.forward();
      std::vector<Complex> p(fft.spectrum().begin(), fft.spectrum().end());
      for (Complex& x : p) x /= double(samples);
      result.push_back(std::move(p));
    }
  }
  return result;
}

}  // namespace railbook::dynamics
