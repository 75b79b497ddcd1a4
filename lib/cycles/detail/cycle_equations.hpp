// The equations of harmonic balance and their derivative; for continuation.cpp and multipliers.cpp.
//
// Only the coordinates that a nonlinear force sees are unknowns ("active"): the linear rest is
// solved once a harmonic. The forces are sampled in time and transformed back (alternating
// frequency/time, Cameron and Griffin 1989). The derivative is exact for the sampled forces: that
// of a law along the cycle is a Toeplitz plus a Hankel matrix in the harmonics.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include <railbook/cycles/harmonic_cycle.hpp>
#include <railbook/num/fft.hpp>

namespace railbook::cycles {

// All scalars of an oscillator, channels first: s = of_motion q + of_rate q', inputs x n, at its
// speed; the forces that act on them side by side, n x outputs; and which outputs belong to which
// inputs.
struct Scalars {
  Eigen::MatrixXd of_motion, of_rate, forces;
  struct Law {
    Eigen::Index input = 0, inputs = 1, output = 0, outputs = 1;
  };
  std::vector<Law> laws;  // in the order of channels, then couplings

  explicit Scalars(const Oscillator& oscillator);
};

// Laws along a cycle, samples x outputs, and their slopes, samples x (law by law, output by output,
// input by input). A piecewise linear law is averaged over the way from each sample to the next, so
// that it has a continuous derivative also where kinks are passed: `slopes` by the sample and
// `next` by the following one. A coupling is taken at the sample, `next` being zero.
struct SampledLaws {
  Eigen::MatrixXd values, slopes, next;
};
// Harmonics of scalars (inputs x orders) whose rows (inputs x n) times the motion and its rate they
// are, from those of the motion (n x orders), whose frequencies are orders times omega.
Eigen::MatrixXcd scalar_harmonics(const Eigen::MatrixXd& of_motion, const Eigen::MatrixXd& of_rate,
                                  const Eigen::MatrixXcd& motion, const std::vector<int>& orders,
                                  double omega);
// Samples of scalars (samples x inputs) of which one period is given by harmonics (inputs x
// orders).
Eigen::MatrixXd in_time(const Eigen::MatrixXcd& harmonics, const std::vector<int>& orders,
                        num::RealFft& fft);
SampledLaws sample_laws(const Oscillator& oscillator, const Scalars& scalars,
                        const Eigen::MatrixXd& samples, bool slopes);
// A power of two of at least 512, 16 times the highest order and what is wanted.
int samples_for(int highest, int wanted = 0);

class CycleEquations {
 public:
  // Throws InputError for an oscillator without nonlinear forces.
  CycleEquations(const Oscillator& oscillator, std::vector<int> orders, int samples = 0);
  // The same with other data: as many channels and couplings that see the same coordinates.
  void change(const Oscillator& oscillator);

  // Unknowns: for each active coordinate the real and imaginary parts of each order, SI.
  Eigen::Index size() const { return Eigen::Index(active_.size()) * reals_; }
  const std::vector<int>& orders() const { return orders_; }
  Eigen::VectorXd unknowns(const Eigen::MatrixXcd& motion) const;
  // Forces left over on the active coordinates, divided by their dynamic stiffness: SI as z.
  Eigen::VectorXd residual(const Eigen::VectorXd& z, double omega);
  // With its derivative by z and, last, by omega: size() x (size() + 1).
  Eigen::VectorXd residual(const Eigen::VectorXd& z, double omega, Eigen::MatrixXd& jacobian);
  // All coordinates, the others following those of the last residual: n x orders.
  const Eigen::MatrixXcd& motion() const { return motion_; }
  // Unknowns of the rate of change along the cycle: d/d(phase).
  Eigen::VectorXd turned(const Eigen::VectorXd& z) const;
  // Places of the unknowns of one order.
  std::vector<Eigen::Index> places(int order) const;

 private:
  Eigen::Index at(Eigen::Index coordinate, std::size_t k) const {
    return coordinate * reals_ + offset_[k];
  }
  Eigen::MatrixXcd harmonics(const Eigen::VectorXd& z) const;  // active x orders
  Eigen::VectorXd evaluate(const Eigen::VectorXd& z, double omega, Eigen::MatrixXd* jacobian);
  std::complex<double> centred(int order) const;
  void sample(const Eigen::MatrixXcd& s, bool slopes);
  struct Condensed;
  Condensed condense(double omega, const Eigen::VectorXcd& z, std::size_t k) const;
  void add_derivatives(const Eigen::MatrixXcd& z, double omega, const Eigen::MatrixXcd& transfer,
                       std::size_t k, Eigen::MatrixXd& jacobian) const;

  const Oscillator* oscillator_;
  Scalars scalars_;
  std::vector<int> orders_;
  std::vector<Eigen::Index> offset_, active_, passive_;
  Eigen::Index reals_ = 0, means_ = 0;  // outputs that are means over steps: the channels'
  num::RealFft fft_;
  Eigen::MatrixXd of_motion_, of_rate_;  // of the active coordinates
  Eigen::MatrixXcd laws_;                // outputs x orders
  Eigen::MatrixXcd slopes_, next_;       // as SampledLaws::slopes x orders 0 ... 2H
  Eigen::MatrixXcd motion_;
};

}  // namespace railbook::cycles
