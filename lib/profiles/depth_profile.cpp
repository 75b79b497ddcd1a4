#include <railbook/profiles/depth_profile.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::profiles {

using units::millimetre;

namespace {

constexpr std::size_t intervals = 4096;

Profile::Piece line_or_arc(const profiles::Piece& p) {
  Profile::Piece out{-p.end.u, -p.start.u};
  if (p.is_line()) {
    const double slope = (p.end.z - p.start.z) / (p.end.u - p.start.u);
    out.c[1] = slope;
    out.c[0] = -p.start.z + slope * p.start.u;
  } else {
    out.c[0] = -p.centre.z;
    out.sign = p.radius > 0 ? -1 : 1;
    out.centre = -p.centre.u;
    out.radius = std::abs(p.radius);
  }
  return out;
}

}  // namespace

Profile::Profile(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {
  index();
}

Profile::Profile(const profiles::Curve& curve) {
  for (const profiles::Piece& p : curve.pieces()) pieces_.push_back(line_or_arc(p));
  std::ranges::reverse(pieces_);
  index();
}

void Profile::index() {
  if (pieces_.empty() || pieces_.size() > 60000)
    throw InputError{fmt::format("profile: {} pieces; allowed: 1 to 60000", pieces_.size())};
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    if (!(pieces_[i].to > pieces_[i].from) ||
        (i > 0 && std::abs(pieces_[i].from - pieces_[i - 1].to) > 1e-9))
      throw InputError{fmt::format("profile: piece {} does not begin where the last one ends", i)};
  per_interval_ = static_cast<double>(intervals) / (to() - from());
  std::size_t piece = 0;
  for (std::size_t k = 0; k <= intervals; ++k) {
    const double y = from() + static_cast<double>(k) / per_interval_;
    while (piece + 1 < pieces_.size() && pieces_[piece].to <= y) ++piece;
    first_.push_back(static_cast<unsigned short>(piece));
  }
}

Profile::Value Profile::at(double y) const {
  const double place = std::clamp((y - from()) * per_interval_, 0.0, double(intervals));
  std::size_t k = first_[static_cast<std::size_t>(place)];
  while (k + 1 < pieces_.size() && y > pieces_[k].to) ++k;
  while (k > 0 && y < pieces_[k].from) --k;
  const Piece& p = pieces_[k];
  Value v{0, 0};
  if (p.sign != 0) {
    const double d = y - p.centre, square = p.radius * p.radius;
    const double root = std::sqrt(std::max(square - d * d, 1e-12 * square));  // upright: nearly
    return {p.c[0] + p.sign * root, -p.sign * d / root};
  }
  for (std::size_t i = p.c.size(); i-- > 0;) {
    v.slope = v.slope * y + v.depth;
    v.depth = v.depth * y + p.c[i];
  }
  return v;
}

namespace {

// Pieces given in millimetres.
Profile::Piece polynomial(double from, double to, const std::array<double, 9>& c, double sign = 1) {
  Profile::Piece p{from * millimetre, to * millimetre};
  double scale = millimetre;
  for (std::size_t k = 0; k < c.size(); ++k, scale /= millimetre) p.c[k] = sign * c[k] * scale;
  return p;
}
Profile::Piece arc(double from, double to, double sign, double centre, double depth,
                   double radius) {
  Profile::Piece p{from * millimetre, to * millimetre, {depth * millimetre}};
  p.sign = sign, p.centre = centre * millimetre, p.radius = radius * millimetre;
  return p;
}

double at(const Profile::Piece& p, double y) {
  return Profile({p}).at(y).depth;
}
double slope(const Profile::Piece& p, double y) {
  return Profile({p}).at(y).slope;
}

// Adds to a polynomial the cubic with which it begins and ends as its neighbours do, in depth and
// slope. A step, however small, would be a punch with an edge to a fine grid, whose pressure grows
// with the cells.
void join(const Profile::Piece& before, Profile::Piece& p, const Profile::Piece& after) {
  const double length = p.to - p.from;
  const double d0 = at(before, p.from) - at(p, p.from), d1 = at(after, p.to) - at(p, p.to);
  const double s0 = slope(before, p.from) - slope(p, p.from),
               s1 = slope(after, p.to) - slope(p, p.to);
  const double c2 = (3 * (d1 - d0) / length - 2 * s0 - s1) / length;
  const double c3 = (2 * (d0 - d1) / length + s0 + s1) / (length * length);
  const double y = -p.from;  // in powers of the distance from there
  p.c[0] += d0 + y * (s0 + y * (c2 + y * c3));
  p.c[1] += s0 + y * (2 * c2 + y * 3 * c3);
  p.c[2] += c2 + 3 * c3 * y;
  p.c[3] += c3;
}

}  // namespace

Profile s1002() {
  std::vector<Profile::Piece> pieces{
      arc(-70, -62.764705882, 1, -49.5, 9.519259302, 20.5),
      arc(-62.764705882, -49.662510381, 1, -55, 16, 12),
      arc(-49.662510381, -39.764473993, 1, -58.558326413, 8.834924130, 20),
      polynomial(-39.764473993, -38.426669071, {-93.576667419, -2.747477419}),
      arc(-38.426669071, -35, -1, -26.210665, 16.446, 13),
      polynomial(-35, -26,
                 {4.320221063e3, 1.038384026e3, 1.065501873e2, 6.051367875, 2.054332446e-1,
                  4.169739389e-3, 4.687195829e-5, 2.252755540e-7},
                 -1),
      polynomial(-26, 32.15796,
                 {0, -3.358537058e-2, 1.565681624e-3, -2.810427944e-5, 5.844240864e-8,
                  -1.562379023e-8, 5.309217349e-15, -5.957839843e-12, 2.646656573e-13}),
      polynomial(32.15796, 60, {1.364323640, -0.066666667}),
  };
  join(pieces[4], pieces[5], pieces[6]);
  return Profile(std::move(pieces));
}

profiles::Curve rail_60e1(Rail60 kind, bool upright) {
  const bool drawing = kind == Rail60::drawing;
  const double crown = drawing ? 10.228 : 10.5, shoulder = drawing ? 26.0265 : 25.98804;
  const double a1 = std::asin(crown / 300);
  const double a2 = std::asin((shoulder - (crown - 80 * crown / 300)) / 80),
               corner = std::atan(20.0) - (upright ? 0.0105 : 0.06);
  // One half from the top down; the other is its mirror image.
  const profiles::Curve half =
      profiles::chain({0, 0}, 0,
                      {profiles::arc(300 * millimetre, a1), profiles::arc(80 * millimetre, a2),
                       profiles::arc(13 * millimetre, corner)});
  std::vector<profiles::Piece> pieces;
  for (profiles::Piece p : half.pieces()) {
    pieces.push_back(p);
    std::swap(p.start, p.end);
    p.start.u *= -1, p.end.u *= -1, p.centre.u *= -1;
    std::swap(p.angle_start, p.angle_end);
    p.angle_start *= -1, p.angle_end *= -1;
    pieces.insert(pieces.begin(), p);
  }
  return profiles::Curve(std::move(pieces));
}

}  // namespace railbook::profiles
