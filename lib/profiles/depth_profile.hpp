// A profile as a depth over the place across: what the search for contact and the gap ask for a
// million times.
//
// Both count outwards, to the field side, and down [m]: a wheel's s from its running circle, a
// rail's y from the middle of the track.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <railbook/profiles/curve.hpp>

namespace railbook::profiles {

class Profile {
 public:
  // depth = sum of c[k] y^k + sign sqrt(radius^2 - (y - centre)^2), sign -1, 0 or 1.
  struct Piece {
    double from = 0, to = 0;
    std::array<double, 9> c{};
    double sign = 0, centre = 0, radius = 0;
  };
  // Pieces in order of y, each beginning where the last one ends. Throws InputError otherwise.
  explicit Profile(std::vector<Piece> pieces);
  // A curve of arcs and lines (u inwards, z up): a wheel's with its origin at the running circle,
  // or a placed rail.
  explicit Profile(const profiles::Curve& curve);

  double from() const { return pieces_.front().from; }
  double to() const { return pieces_.back().to; }
  bool covers(double y) const { return y >= from() && y <= to(); }

  // Depth and slope d depth/dy at y on the profile; beyond its ends those of the end's piece, of an
  // arc as far as it is not upright.
  struct Value {
    double depth, slope;
  };
  Value at(double y) const;

 private:
  void index();
  std::vector<Piece> pieces_;
  std::vector<unsigned short> first_;  // piece at the beginning of each of many equal intervals
  double per_interval_ = 0;
};

// The wheel S1002, flange included, from its published polynomials and arcs. (Coefficients of
// EN 13715 as they are spread in public codes; the standard itself was not at hand. Between -35 and
// -26 mm the published coefficients leave steps of up to 1.2e-4 mm at the joints, which are closed
// here; depth is continuous to 1e-7 mm.)
Profile s1002();

// Head of a rail: crown radius 300, shoulders 80 and corners 13 mm, upright, u towards the gauge
// face, top at 0. It ends at 84 degrees, short of the flank, which a cant of 1:20 makes upright.
// `drawing` has the joints of 60E1 (EN 13674-1: 20.456, 52.053 and 72 mm apart), `benchmark` those
// of the file of the Manchester benchmark, up to 0.039 mm different. `upright`: it goes on to 86.5
// degrees, down to where the gauge of a rail that does not lean is measured.
enum class Rail60 { drawing, benchmark };
profiles::Curve rail_60e1(Rail60 kind, bool upright = false);

}  // namespace railbook::profiles
