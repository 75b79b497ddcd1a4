#include <railbook/profiles/profile_points.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::profiles {
namespace {

using units::millimetre;
using Index = std::ptrdiff_t;

constexpr std::size_t fewest_points = 8;
// Of the sides at the ends. The back of a wheel's flange and its rim touch no running rail, and a
// smooth curve may be steeper than the points: 84 degrees are the most that the search of contacts
// takes (wheelset_contact.hpp). A rail's side may be nearly upright.
double steepest(Body body) {
  return (body == Body::wheel ? 80 : 88) * units::degree;
}

constexpr double rim_corner = 60 * units::degree;

double distance(const Point& a, const Point& b) {
  return std::hypot(b.u - a.u, b.z - a.z);
}

double median(std::vector<double> x) {
  const auto middle = x.begin() + Index(x.size() / 2);
  std::nth_element(x.begin(), middle, x.end());
  return *middle;
}

std::string place(double from, double to) {
  if (std::abs(to - from) < 0.005 * millimetre)
    return fmt::format("{:.2f} mm across", from / millimetre);
  return fmt::format("{:.2f} to {:.2f} mm across", std::min(from, to) / millimetre,
                     std::max(from, to) / millimetre);
}

[[noreturn]] void refuse_order() {
  throw InputError(
      "the points of the profile are in no order; allowed: rows that go on across it, as measured");
}

// Keeps what can be seen from the partner's side: from the point nearest to it outwards, each point
// that goes on across.
std::vector<Point> visible(const std::vector<Point>& points, Body body, CheckedPoints& checked) {
  const auto nearest = body == Body::rail ? std::ranges::max_element(points, {}, &Point::z)
                                          : std::ranges::min_element(points, {}, &Point::z);
  std::vector<bool> kept(points.size(), false);
  const Index top = nearest - points.begin(), n = Index(points.size());
  const auto walk = [&](Index step, double sign) {
    double reached = points[std::size_t(top)].u;
    for (Index i = top + step; i >= 0 && i < n; i += step)
      if (sign * (points[std::size_t(i)].u - reached) > 0)
        kept[std::size_t(i)] = true, reached = points[std::size_t(i)].u;
  };
  kept[std::size_t(top)] = true;
  walk(1, 1), walk(-1, -1);
  const auto count = std::count(kept.begin(), kept.end(), false);
  if (2 * count > n) refuse_order();
  for (std::size_t i = 0; i < points.size();) {  // each run of those left out
    std::size_t end = i;
    while (end < points.size() && !kept[end]) ++end;
    if (end > i) {
      const auto [low, high] =
          std::minmax_element(points.begin() + Index(i), points.begin() + Index(end),
                              [](const Point& a, const Point& b) { return a.u < b.u; });
      checked.left_out.push_back({"hidden",
                                  fmt::format("{} point{} at {}, doubled or behind others", end - i,
                                              end - i == 1 ? "" : "s", place(low->u, high->u)),
                                  low->u, high->u});
    }
    i = std::max(end, i) + 1;
  }
  std::vector<Point> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (kept[i]) result.push_back(points[i]);
  return result;
}

// Of a rail, leaves out what is deeper than any wheel reaches: the web and the foot.
void cut_deep(CheckedPoints& checked) {
  constexpr double deepest = 50 * millimetre;
  std::vector<Point>& p = checked.points;
  const double highest = std::ranges::max_element(p, {}, &Point::z)->z;
  const auto deep = [&](const Point& q) { return q.z < highest - deepest; };
  const Index count = std::ranges::count_if(p, deep);
  if (count == 0) return;
  const Point first = *std::ranges::find_if(p, deep);
  std::erase_if(p, deep);
  checked.left_out.push_back(
      {"deep",
       fmt::format("{} point{} more than {:.0f} mm below the top, from {} on", count,
                   count == 1 ? "" : "s", deepest / millimetre, place(first.u, first.u)),
       first.u, first.u});
}

// Of a rail's section, keeps one body where a groove parts several (a guard rail, a wing rail, a
// keeper): the outermost of those that are as high as the highest.
std::vector<Point> one_body(const std::vector<Point>& p, CheckedPoints& checked) {
  constexpr double groove = 5 * millimetre, rise = 3 * millimetre, level = 5 * millimetre;
  std::vector<std::size_t> begins{0};
  std::vector<double> tops;
  double top = p[0].z;
  std::size_t lowest = 0;
  for (std::size_t i = 1; i < p.size(); ++i) {
    if (p[i].z > top) top = p[i].z, lowest = i;
    if (p[i].z < p[lowest].z) lowest = i;
    if (p[lowest].z > top - groove || p[i].z < p[lowest].z + rise) continue;
    tops.push_back(top);
    begins.push_back(lowest + 1);
    top = p[i].z, lowest = i;
  }
  tops.push_back(top);
  if (tops.size() == 1) return p;
  if (tops.size() > 4) refuse_order();
  begins.push_back(p.size());
  const double highest = *std::ranges::max_element(tops);
  const std::size_t kept = std::size_t(
      std::ranges::find_if(tops, [&](double z) { return z >= highest - level; }) - tops.begin());
  for (std::size_t k = 0; k < tops.size(); ++k) {
    if (k == kept) continue;
    const auto [low, high] =
        std::minmax_element(p.begin() + Index(begins[k]), p.begin() + Index(begins[k + 1]),
                            [](const Point& a, const Point& b) { return a.u < b.u; });
    const std::size_t count = begins[k + 1] - begins[k];
    const std::string text =
        fmt::format("{} points at {}, beyond a groove", count, place(low->u, high->u));
    checked.left_out.push_back({"groove", text, low->u, high->u});
    checked.warnings.push_back(
        {"groove",
         text +
             ", are left out: a guard rail, a wing rail or a keeper, whose contact is not sought",
         low->u, high->u});
  }
  return {p.begin() + Index(begins[kept]), p.begin() + Index(begins[kept + 1])};
}

// A wheel rises or runs level outwards from its tread; a rail falls to both of its sides.
void require_wheel(const std::vector<Point>& p) {
  constexpr double fall = 4 * millimetre, part = 0.3;
  const double reach = p.front().u + part * (p.back().u - p.front().u);
  const auto outer = std::ranges::find_if(p, [&](const Point& q) { return q.u > reach; });
  const auto highest =
      std::max_element(p.begin(), outer, [](const Point& a, const Point& b) { return a.z < b.z; });
  if (p.front().z < highest->z - fall)
    throw InputError(fmt::format(
        "the wheel falls {:.1f} mm to its outer end at {:.2f} mm across, as a rail does; allowed: "
        "a wheel's profile, with its flange on the inner side",
        (highest->z - p.front().z) / millimetre, p.front().u / millimetre));
}
// Leaves out sides at the ends that are all but vertical. A wheel has them within the outer
// quarters of its points, and its inner one is the back of its flange, not the face. On a rail what
// follows an upright face, 8 mm and more below the top, is left out with it.
void cut_steep_ends(CheckedPoints& checked, Body body) {
  constexpr double face = 8 * millimetre;
  std::vector<Point>& p = checked.points;
  const auto steeper = [&](std::size_t i, double angle) {
    return std::abs(p[i + 1].z - p[i].z) > std::tan(angle) * (p[i + 1].u - p[i].u);
  };
  const auto steep = [&](std::size_t i) { return steeper(i, steepest(body)); };
  const std::size_t n = p.size(), reach = n / 4;
  const std::size_t low = std::size_t(std::ranges::min_element(p, {}, &Point::z) - p.begin()),
                    top = std::size_t(std::ranges::max_element(p, {}, &Point::z) - p.begin());
  const auto is_face = [&](std::size_t i) { return p[i].z < p[top].z - face; };
  std::size_t first = 0, last = n - 1;
  if (body == Body::wheel) {
    for (std::size_t i = 0; i < reach; ++i)
      if (steep(i)) first = i + 1;
    // The corner of the rim, under which a smooth curve would fold back.
    while (first < reach && steeper(first, rim_corner)) ++first;
    for (std::size_t i = n - 1; i > n - 1 - reach && i > low + 1; --i)
      if (steep(i - 1)) last = i - 1;
  } else {
    for (std::size_t i = 0; i < top; ++i)
      if (steep(i) && (is_face(i) || i < reach)) first = i + 1;
    for (std::size_t i = n - 1; i > top; --i)
      if (steep(i - 1) && (is_face(i) || i > n - 1 - reach)) last = i - 1;
  }
  const auto tell = [&](std::size_t from, std::size_t to, std::size_t count) {
    if (count > 0)
      checked.left_out.push_back(
          {"steep",
           fmt::format("{} point{} of a side steeper than {:.0f} degrees at {}", count,
                       count == 1 ? "" : "s", steepest(body) / units::degree,
                       place(p[from].u, p[to].u)),
           p[from].u, p[to].u});
  };
  tell(0, first == 0 ? 0 : first - 1, first);
  tell(std::min(last + 1, p.size() - 1), p.size() - 1, p.size() - 1 - last);
  p = {p.begin() + Index(first), p.begin() + Index(last) + 1};
}

// How far below the top the points of the inner side go on, under the end of what is seen.
double hidden_depth(const std::vector<Point>& all, const std::vector<Point>& seen) {
  constexpr double beside = 6 * millimetre;  // a face leans back by less
  const double end = seen.back().u, top = std::ranges::max_element(seen, {}, &Point::z)->z;
  double depth = 0;
  for (const Point& p : all)
    if (std::abs(p.u - end) < beside) depth = std::max(depth, top - p.z);
  return depth;
}

void require_enough(const std::vector<Point>& points) {
  if (points.size() < fewest_points)
    throw InputError(
        fmt::format("profile: {} points; allowed: from {}", points.size(), fewest_points));
  for (const Point& p : points)
    if (!std::isfinite(p.u) || !std::isfinite(p.z))
      throw InputError("profile: a coordinate is not finite; allowed: a number in every row");
}

// A wheel has its flange, the part that reaches far below its tread, on its inner side.
void require_flange(const std::vector<Point>& p) {
  constexpr double enough =
      15 * millimetre;  // a flange is 25 mm and more high, a rim's chamfer less
  const double low = p.front().u, wide = p.back().u - low;
  std::vector<double> heights;  // at equal steps across, so that dense points count no more
  for (std::size_t k = 0, i = 0; k < 101; ++k) {
    const double u = low + wide * double(k) / 100;
    while (i + 2 < p.size() && p[i + 1].u < u) ++i;
    const double part = std::clamp((u - p[i].u) / (p[i + 1].u - p[i].u), 0.0, 1.0);
    heights.push_back(p[i].z + part * (p[i + 1].z - p[i].z));
  }
  const double tread = median(heights);
  const auto [least, most] = std::ranges::minmax_element(p, {}, &Point::z);
  const double below = tread - least->z, above = most->z - tread;
  if (above > enough && above > below)
    throw InputError(fmt::format(
        "the wheel rises {:.1f} mm above its tread at {:.1f} mm across and falls {:.1f} mm below "
        "it: it is upside down or turned; allowed: heights upwards, the flange downwards on the "
        "inner side",
        above / millimetre, most->u / millimetre, below / millimetre));
  if (below > enough && least->u < low + 0.5 * wide)
    throw InputError(fmt::format(
        "the wheel's flange, {:.1f} mm below its tread, is at {:.1f} mm across, on the outer side: "
        "it is mirrored; allowed: inward grows towards the flange",
        below / millimetre, least->u / millimetre));
}

void find_holes(CheckedPoints& checked) {
  constexpr double times = 4, smallest = 3 * millimetre;
  constexpr std::size_t around = 6;
  const std::vector<Point>& p = checked.points;
  std::vector<double> step, across;
  for (std::size_t i = 1; i < p.size(); ++i) {
    step.push_back(distance(p[i - 1], p[i]));
    across.push_back(p[i].u - p[i - 1].u);
  }
  for (std::size_t i = 0; i < step.size(); ++i) {
    if (step[i] < smallest) continue;
    std::vector<double> near, near_across;
    for (std::size_t k = i > around ? i - around : 0; k < std::min(step.size(), i + around + 1);
         ++k)
      if (k != i) near.push_back(step[k]), near_across.push_back(across[k]);
    // Points at equal steps across are far apart along a steep side, and the other way round.
    if (step[i] > times * median(near) && across[i] > times * median(near_across))
      checked.warnings.push_back(
          {"hole",
           fmt::format("no points at {}: {:.1f} mm are bridged by a smooth curve, where the others "
                       "are {:.2g} mm apart",
                       place(p[i].u, p[i + 1].u), step[i] / millimetre, median(near) / millimetre),
           p[i].u, p[i + 1].u});
  }
}

// How far p[i] is off the cubic through the nearest two points on each side that are not left out,
// across the chord of the inner two.
struct Residual {
  double distance = units::nan;
  double scaled =
      units::nan;  // divided so that it has the scatter of one point, where all five have it
};
struct Residuals {
  const std::vector<Point>& p;
  Index from = 0, to = 0;  // left out: from .. to - 1

  bool outside(Index i) const { return i < from || i >= to; }
  Residual at(Index i) const {
    std::array<Index, 4> neighbour{};
    Index k = i;
    for (const std::size_t slot : {1U, 0U}) {
      do --k;
      while (k >= 0 && !outside(k));
      neighbour[slot] = k;
    }
    k = i;
    for (const std::size_t slot : {2U, 3U}) {
      do ++k;
      while (k < Index(p.size()) && !outside(k));
      neighbour[slot] = k;
    }
    if (neighbour[0] < 0 || neighbour[3] >= Index(p.size())) return {};
    const Point a = p[std::size_t(neighbour[1])], b = p[std::size_t(neighbour[2])];
    const double chord = distance(a, b), cu = (b.u - a.u) / chord, cz = (b.z - a.z) / chord;
    const auto along = [&](const Point& q) { return (q.u - a.u) * cu + (q.z - a.z) * cz; };
    const auto across = [&](const Point& q) { return (q.z - a.z) * cu - (q.u - a.u) * cz; };
    const Point here = p[std::size_t(i)];
    double value = across(here), squares = 1;
    for (const Index j : neighbour) {
      double weight = 1;
      const double xj = along(p[std::size_t(j)]);
      for (const Index m : neighbour)
        if (m != j) {
          const double xm = along(p[std::size_t(m)]);
          if (xj == xm) return {};
          weight *= (along(here) - xm) / (xj - xm);
        }
      value -= weight * across(p[std::size_t(j)]);
      squares += weight * weight;
    }
    return {value, value / std::sqrt(squares)};
  }
};

// Runs of up to three points whose removal makes their surroundings smooth.
void find_outliers(CheckedPoints& checked) {
  constexpr double times = 8, smallest = 5 * units::micrometre;
  constexpr Index around = 6;
  const std::vector<Point>& p = checked.points;
  const Index n = Index(p.size());
  for (Index i = 2; i + 2 < n;) {
    Index found = 0;
    for (Index length = 1; length <= 3 && i + length + 2 <= n && found == 0; ++length) {
      const Residuals without{p, i, i + length};
      double worst = 0;  // of the points around, once these are gone
      Index counted = 0;
      for (Index k = i - around; k < i + length + around; ++k) {
        if (k < 0 || k >= n || !without.outside(k)) continue;
        const double r = without.at(k).scaled;
        if (std::isnan(r)) continue;
        worst = std::max(worst, std::abs(r)), ++counted;
      }
      double least = units::infinity, most = 0, size = 0;
      for (Index k = i; k < i + length; ++k) {
        const Residual r = without.at(k);
        if (std::isnan(r.scaled)) least = 0;
        least = std::min(least, std::abs(r.scaled)), most = std::max(most, std::abs(r.scaled));
        size = std::max(size, std::abs(r.distance));
      }
      if (counted < 4 || least <= 0.3 * most || most < smallest || most < times * worst) continue;
      checked.warnings.push_back(
          {"outlier",
           fmt::format("{} {:.3g} mm off the others at {}: dirt, or a wrong digit?",
                       length == 1 ? "a point is" : fmt::format("{} points are", length),
                       size / millimetre,
                       place(p[std::size_t(i)].u, p[std::size_t(i + length - 1)].u)),
           p[std::size_t(i)].u, p[std::size_t(i + length - 1)].u});
      found = length;
    }
    i += std::max<Index>(found, 1);
  }
}

}  // namespace

CheckedPoints check_points(std::vector<Point> points, Body body) {
  require_enough(points);
  if (points.front().u > points.back().u) std::ranges::reverse(points);
  CheckedPoints checked;
  if (body == Body::rail) {
    points = one_body(points, checked);
    require_enough(points);
  }
  checked.points = visible(points, body, checked);
  require_enough(checked.points);
  if (body == Body::wheel) {
    require_flange(checked.points);
    cut_steep_ends(checked, body);
    require_enough(checked.points);
    require_wheel(checked.points);
  } else {
    cut_deep(checked);
    checked.depth_below_end = hidden_depth(points, checked.points);
    require_enough(checked.points);
    cut_steep_ends(checked, body);
  }
  require_enough(checked.points);
  find_holes(checked);
  find_outliers(checked);
  return checked;
}

}  // namespace railbook::profiles
