#include <railbook/wheel_contact/strips.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <railbook/contact/hertz.hpp>
#include <railbook/rolling/kalker_table.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::wheel_contact {

using units::pi;

double Strips::pressure(const Strip& s, double x) const {
  const double u = x / s.half_length;
  return std::abs(u) < 1 ? p_max * s.half_length / longest * std::sqrt((1 - u) * (1 + u)) : 0;
}

namespace {

constexpr int count = 60;

// The overlap at t, between the places of the patch's line: a cubic through four, of which an outer
// one beyond a profile's end is on the line through its neighbours.
double at(const std::vector<Depth>& line, double t, double Depth::*value) {
  const double h = line[1].t - line[0].t, place = (t - line.front().t) / h;
  const auto last = static_cast<double>(line.size() - 3);
  const auto i = static_cast<std::size_t>(std::clamp(std::floor(place), 1.0, last));
  const double u = place - static_cast<double>(i);
  double a = line[i - 1].*value, d = line[i + 2].*value;
  const double b = line[i].*value, c = line[i + 1].*value;
  if (!std::isfinite(a)) a = 2 * b - c;
  if (!std::isfinite(d)) d = 2 * c - b;
  return b + 0.5 * u * (c - a + u * (2 * a - 5 * b + 4 * c - d + u * (3 * (b - c) + d - a)));
}

struct Ends {
  double deepest = 0, t_deepest = 0, low = 0, high = 0;
};

// Where the overlap plus `down` exceeds `level` times its greatest value.
Ends ends_of(const std::vector<Depth>& line, double down, double level) {
  Ends e;
  std::size_t most = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    if (line[i].overlap > line[most].overlap) most = i;
  const std::size_t k = std::clamp<std::size_t>(most, 1, line.size() - 2);
  // Vertex of the parabola through the deepest place and its neighbours.
  const double h = line[1].t - line[0].t, l = line[k - 1].overlap, m = line[k].overlap,
               r = line[k + 1].overlap;
  const double bend = l - 2 * m + r, u = bend < 0 ? std::clamp(0.5 * (l - r) / bend, -1.0, 1.0) : 0;
  e.t_deepest = line[k].t + u * h;
  e.deepest = std::max(line[most].overlap, m + 0.5 * u * (r - l) + 0.5 * u * u * bend) + down;
  const double limit = level * e.deepest;
  e.low = line.front().t, e.high = line.back().t;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (line[i].overlap + down > limit) {
      if (i > 0)
        e.low = line[i].t -
                h * (line[i].overlap + down - limit) / (line[i].overlap - line[i - 1].overlap);
      break;
    }
  for (std::size_t i = line.size(); i-- > 0;)
    if (line[i].overlap + down > limit) {
      if (i + 1 < line.size())
        e.high = line[i].t +
                 h * (line[i].overlap + down - limit) / (line[i].overlap - line[i + 1].overlap);
      break;
    }
  return e;
}

// Integral over all strips of (pressure over its greatest)/r, seen from the strip `from` [m].
// Points crowd, as a cube, where a strip passes by, and follow the half ellipse at its ends.
double sinking(const Strips& s, const Strip& from) {
  constexpr int points = 8;
  double sum = 0;
  for (const Strip& strip : s.strips) {
    const double a = strip.half_length;
    const double low = strip.t - 0.5 * s.width - from.t, high = low + s.width;
    const double nearest = std::asin(std::clamp((from.x - strip.x) / a, -0.99, 0.99));
    for (const double end : {-pi / 2, pi / 2})
      for (int k = 0; k < points; ++k) {
        const double u = (k + 0.5) / points, angle = nearest + (end - nearest) * u * u * u;
        const double cosine = std::cos(angle);
        const double x = std::abs(strip.x + a * std::sin(angle) - from.x) + 1e-300;
        sum += std::abs(end - nearest) * 3 * u * u / points * a * cosine * cosine *
               (a / s.longest) * (std::asinh(high / x) - std::asinh(low / x));
      }
  }
  return sum;
}

void finish(Strips& s, double t_deepest, double effective_modulus, bool continuous) {
  for (const Strip& strip : s.strips) s.longest = std::max(s.longest, strip.half_length);
  // Outwards from the longest: how far have the strips shortened, and lengthened again?
  const auto longest = static_cast<std::size_t>(
      std::ranges::max_element(s.strips, {}, &Strip::half_length) - s.strips.begin());
  for (const int step : {-1, 1}) {
    double shortest = s.longest;
    for (auto i = static_cast<std::ptrdiff_t>(longest); i >= 0 && i < std::ssize(s.strips);
         i += step) {
      const Strip& strip = s.strips[static_cast<std::size_t>(i)];
      shortest = std::min(shortest, strip.half_length);
      if (std::abs(strip.t - s.strips[longest].t) >
          (std::abs(double(i) - double(longest)) + 1.5) * s.width)
        shortest = 0;  // strips are missing
      if (shortest < 0.7 * s.longest && strip.half_length > 1.1 * shortest + 0.1 * s.longest)
        s.two_lobes = true;
    }
  }
  double squares = 0;
  for (const Strip& strip : s.strips) {
    squares += strip.half_length * strip.half_length;
    s.area += 2 * strip.half_length * s.width;
  }
  // Midway between two strips' middles the integral is smooth: from the boundary nearest to the
  // deepest place, or on the line between the boundaries on either side of it.
  const auto below = [&](double t) {
    Strip from = *std::ranges::min_element(
        s.strips, {}, [&](const Strip& strip) { return std::abs(strip.t + 0.5 * s.width - t); });
    from.t += 0.5 * s.width;
    return std::pair{from.t, sinking(s, from)};
  };
  auto [t, sunk] = below(t_deepest);
  if (continuous && t != t_deepest) {
    const auto [other, other_sunk] = below(t + std::copysign(s.width, t_deepest - t));
    if (other != t) sunk = std::lerp(sunk, other_sunk, (t_deepest - t) / (other - t));
  }
  s.p_max = s.approach * pi * effective_modulus / sunk;
  s.load = s.p_max * pi / 2 * squares / s.longest * s.width;
}

}  // namespace

Strips semi_hertzian(const Patch& patch, double effective_modulus, double down, bool continuous) {
  Strips s;
  const Ends whole = ends_of(patch.line, down, 0);
  s.approach = whole.deepest;
  if (!(whole.deepest > 0)) return s;
  const double half = 0.5 * (whole.high - whole.low);
  const double along = 0.5 / patch.radius, across = whole.deepest / (half * half);
  const auto hertz =
      contact::hertz_from_approach({along, across}, effective_modulus, whole.deepest);
  const double share_x = hertz.a * hertz.a * along / whole.deepest;
  const double share_y = hertz.b * hertz.b * across / whole.deepest;
  s.ratio = hertz.a / hertz.b;
  const Ends ends = ends_of(patch.line, down, 1 - share_y);
  s.width = (ends.high - ends.low) / count;
  for (int k = 0; k < count; ++k) {
    const double t = ends.low + (k + 0.5) * s.width;
    const double f = whole.deepest - (at(patch.line, t, &Depth::overlap) + down);
    const double square = share_x / along * (whole.deepest - f / share_y);
    if (square > 0) s.strips.push_back({t, at(patch.line, t, &Depth::x), std::sqrt(square)});
  }
  if (s.strips.empty()) return s;
  finish(s, whole.t_deepest, effective_modulus, continuous);
  return s;
}

Strips hertzian(const Patch& patch, double effective_modulus, double down) {
  Strips s;
  const Ends whole = ends_of(patch.line, down, 0);
  s.approach = whole.deepest;
  if (!(whole.deepest > 0)) return s;
  const double h = (whole.high - whole.low) / 8;
  const double t = std::clamp(whole.t_deepest, patch.line.front().t + h, patch.line.back().t - h);
  const auto depth = [&](double place) { return at(patch.line, place, &Depth::overlap); };
  const double bend = -(depth(t - h) - 2 * depth(t) + depth(t + h)) / (h * h);
  if (!(bend > 0))
    throw InputError{
        "Hertz's theory: wheel and rail are not convex to one another across; "
        "allowed: the methods strips and full"};
  const auto hertz = contact::hertz_from_approach({0.5 / patch.radius, 0.5 * bend},
                                                  effective_modulus, whole.deepest);
  s.ratio = hertz.a / hertz.b;
  s.width = 2 * hertz.b / count;
  for (int k = 0; k < count; ++k) {
    const double u = 2 * (k + 0.5) / count - 1;
    s.strips.push_back({whole.t_deepest + u * hertz.b, at(patch.line, t, &Depth::x),
                        hertz.a * std::sqrt(1 - u * u)});
  }
  s.longest = hertz.a;
  s.p_max = hertz.p_max, s.load = hertz.force, s.area = pi * hertz.a * hertz.b;
  return s;
}

rolling::CreepForces fastsim(const Strips& contact, const rolling::RollingCase& c,
                             bool keep_tractions) {
  constexpr int cells = 40;
  rolling::CreepForces out;
  out.converged = true;
  if (c.friction == 0 || !(contact.load > 0)) return out;
  const double ratio = std::clamp(contact.ratio, 0.1, 10.0);
  if (ratio != contact.ratio)
    out.warning =
        "the patch is more slender than Kalker's table (a/b 0.1 to 10), whose end is used";
  const auto k = rolling::kalker_table(ratio, c.poisson);
  const double mean = std::sqrt(contact.area / pi);  // sqrt(a b)
  const double a = mean * std::sqrt(ratio);
  const double l1 = 8 * a / (3 * c.shear_modulus * k.c11),
               l2 = 8 * a / (3 * c.shear_modulus * k.c22);
  const double l3 = pi * a * a / (4 * c.shear_modulus * mean * k.c23);
  double cubes = 0;
  for (const Strip& s : contact.strips) cubes += std::pow(s.half_length, 3);
  const double bend = c.friction * contact.load / (4.0 / 3 * cubes * contact.width);
  double stuck = 0;
  std::vector<std::array<double, 8>> kept;
  const auto& creep = c.creepage;
  for (const Strip& s : contact.strips) {
    const double h = 2 * s.half_length / cells, cell = h * contact.width;
    double px = 0, py = 0;
    for (int i = 0; i < cells; ++i) {
      const double u = s.half_length - (i + 0.5) * h, x = s.x + u;
      // Mean of the parabola over the cell; the slip half a cell ahead, a quarter in the first.
      const double bound = bend * ((s.half_length - u) * (s.half_length + u) - h * h / 12);
      const double step = i == 0 ? h / 2 : h, ahead = x + step / 2;
      px += step * (creep.longitudinal / l1 - creep.spin * s.t / l3);
      py += step * (creep.lateral / l2 + creep.spin * ahead / l3);
      const double size = std::sqrt(px * px + py * py);
      const bool slides = size > bound;
      if (slides) px *= bound / size, py *= bound / size;
      out.fx += cell * px, out.fy += cell * py, out.mz += cell * (x * py - s.t * px);
      if (!slides) stuck += cell;
      if (keep_tractions)
        kept.push_back({x, s.t, h, contact.width, px, py, bound, slides ? 0.0 : 1.0});
    }
  }
  out.stick_share = stuck / contact.area;
  auto& t = out.tractions;
  const std::array all{&t.x, &t.y, &t.dx, &t.dy, &t.px, &t.py, &t.bound, &t.stick};
  for (std::size_t m = 0; m < all.size(); ++m) {
    all[m]->resize(static_cast<Eigen::Index>(kept.size()));
    for (std::size_t i = 0; i < kept.size(); ++i)
      (*all[m])[static_cast<Eigen::Index>(i)] = kept[i][m];
  }
  return out;
}

}  // namespace railbook::wheel_contact
