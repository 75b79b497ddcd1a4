// Strips of cells that follow an ellipse, x = a l s with l = sqrt(1 - (y/b)^2): no staircase at the
// rim, and means over a cell of a parabolic and an elliptic pressure in closed form.
#pragma once

#include <vector>

#include <railbook/rolling/case.hpp>

namespace railbook::rolling {

// Unit circle: x in a, y in b, tractions in mu N/(a b).
class EllipseCells {
 public:
  struct Strip {
    double y = 0;                        // mean over the strip's area
    double width = 0;                    // across
    double growth = 0;                   // half length that a traction grows over: int l^2 / int l
    double weight = 0;                   // area of one cell
    double parabolic = 0, elliptic = 0;  // mean bound of a cell over the cell's own factor
  };

  // Throws InputError unless 1 <= along, strips <= 4096.
  EllipseCells(int along, int strips);

  const std::vector<Strip>& strips() const { return strips_; }
  int along() const { return static_cast<int>(parabolic_.size()); }
  // Mean over cell i, 0 at the leading edge, of 1 - s^2 and of sqrt(1 - s^2).
  double parabolic(int i) const { return parabolic_[static_cast<std::size_t>(i)]; }
  double elliptic(int i) const { return elliptic_[static_cast<std::size_t>(i)]; }

 private:
  std::vector<Strip> strips_;
  std::vector<double> parabolic_, elliptic_;
};

// Collects the cells of a solution; does nothing unless `wanted`.
class CellTractions {
 public:
  CellTractions(bool wanted, const EllipseCells& cells, const RollingCase& c);
  void add(const EllipseCells::Strip& strip, double x, double px, double py, double bound,
           bool sticks);
  Tractions take() { return std::move(tractions_); }

 private:
  bool wanted_;
  double a_, b_, unit_;
  Eigen::Index next_ = 0;
  Tractions tractions_;
};

}  // namespace railbook::rolling
