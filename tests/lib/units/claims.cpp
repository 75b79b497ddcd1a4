// What lib/units states, on seeded texts: units from their definitions (NIST SP 811, appendix B) in
// 80-bit arithmetic, numbers as strtold reads them, words and characters by construction.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <railbook/units/input_error.hpp>
#include <railbook/units/nearest.hpp>
#include <railbook/units/printable.hpp>
#include <railbook/units/quantity.hpp>

#include "support/claim.hpp"
#include "support/number_text.hpp"

using namespace railbook;
using namespace railbook::units;
using namespace railbook::tests;

namespace {

constexpr Long lbf = 0.45359237L * 9.80665L;

struct Known {
  const char* name;
  Long si;
  Dimension dimension;
};
const std::vector<Known>& known() {
  static const std::vector<Known> all{{"m", 1, length},
                                      {"mm", 1e-3L, length},
                                      {"um", 1e-6L, length},
                                      {"cm", 1e-2L, length},
                                      {"km", 1e3L, length},
                                      {"in", 0.0254L, length},
                                      {"ft", 0.3048L, length},
                                      {"yd", 0.9144L, length},
                                      {"mi", 1609.344L, length},
                                      {"kg", 1, mass},
                                      {"g", 1e-3L, mass},
                                      {"t", 1e3L, mass},
                                      {"lb", 0.45359237L, mass},
                                      {"slug", lbf / 0.3048L, mass},
                                      {"s", 1, units::time},
                                      {"ms", 1e-3L, units::time},
                                      {"min", 60, units::time},
                                      {"h", 3600, units::time},
                                      {"N", 1, force},
                                      {"kN", 1e3L, force},
                                      {"MN", 1e6L, force},
                                      {"lbf", lbf, force},
                                      {"kip", 1e3L * lbf, force},
                                      {"Pa", 1, pressure},
                                      {"kPa", 1e3L, pressure},
                                      {"MPa", 1e6L, pressure},
                                      {"GPa", 1e9L, pressure},
                                      {"psi", lbf / (0.0254L * 0.0254L), pressure},
                                      {"ksi", 1e3L * lbf / (0.0254L * 0.0254L), pressure},
                                      {"Hz", 1, frequency},
                                      {"kHz", 1e3L, frequency},
                                      {"mph", 0.44704L, speed},
                                      {"kph", 1 / 3.6L, speed},
                                      {"kmh", 1 / 3.6L, speed},
                                      {"fps", 0.3048L, speed},
                                      {"rad", 1, angle},
                                      {"mrad", 1e-3L, angle},
                                      {"deg", std::acos(-1.0L) / 180, angle},
                                      {"cycle", 1, number},
                                      {"cycles", 1, number},
                                      {"percent", 1e-2L, number},
                                      {"%", 1e-2L, number},
                                      {"1", 1, number}};
  return all;
}

// A unit of up to four names with powers, what it is, and how many factors it is made of.
struct Written {
  std::string text;
  Long si = 1;
  Dimension dimension;
  int factors = 0;
  bool allowed = true, clear = true;  // clear: not within rounding of a limit
};

// `header`: as the suffix of a column's header.
Written written(RandomStream& draw, bool header) {
  Written w;
  const std::size_t names = 1 + below(draw, header ? 7 : 4);
  for (std::size_t i = 0; i < names; ++i) {
    const Known& one = known()[below(draw, known().size() - (header ? 2 : 0))];
    const bool under = draw(0, 1) < 0.4 && (i > 0 || header);
    const int power = draw(0, 1) < 0.5 ? 1 : 1 + static_cast<int>(below(draw, 9));
    if (header) {
      w.text += i == 0 ? (under ? "per_" : "") : under ? "_per_" : "_";
    } else {
      const std::string blank(below(draw, 2), ' ');
      if (i > 0) w.text += blank + (under ? "/" : "*") + blank;
    }
    w.text += one.name;
    if (power > 1 || draw(0, 1) < 0.1)
      w.text += (header || draw(0, 1) < 0.5 ? "" : "^") + std::to_string(power);
    for (int n = 0; n < power; ++n) {
      w.si = under ? w.si / one.si : w.si * one.si;
      w.dimension = under ? w.dimension / one.dimension : w.dimension * one.dimension;
    }
    w.factors += power;
    const Long size = std::abs(std::log10(w.si));
    w.clear = w.clear && std::abs(size - 60) > 1e-12L;
    const Dimension& d = w.dimension;
    for (const int p : {d.length, d.mass, d.time, d.angle})
      w.allowed = w.allowed && std::abs(p) <= 20;
    w.allowed = w.allowed && size < 60;
  }
  return w;
}

}  // namespace

TEST_CASE("claim: units and quantities as text") {
  Claim unit("units::parse_unit"), quantity("units::parse_quantity"), header("units::parse_header");
  const auto off = [](double found, Long exact, int factors) {
    return static_cast<double>(std::abs((found - exact) / exact)) / factors;
  };
  for (const Known& one : known()) {
    const Unit found = parse_unit(one.name);
    unit.error(found.dimension == one.dimension ? off(found.si, one.si, 1) : 1);
  }
  const Long largest = std::numeric_limits<double>::max(),
             least = std::numeric_limits<double>::min();
  RandomStream draw(1);
  int allowed = 0, held = 0;
  for (int k = 0; k < 6000; ++k) {
    const Written w = written(draw, false);
    const bool sane = !refuses([&] {
      const Unit found = parse_unit(w.text);
      unit.error(found.dimension == w.dimension ? off(found.si, w.si, w.factors) : 1);
    });
    unit.error(sane == w.allowed || !w.clear ? 0 : 1);
    allowed += sane ? 1 : 0;
    if (!sane) continue;

    const std::string digits = figures(draw), text = digits + " " + w.text;
    const Long value = std::strtold(digits.c_str(), nullptr), si = value * w.si;
    const auto inside = [&](Long x) {
      return x == 0 || (std::abs(x) <= largest && std::abs(x) >= least);
    };
    const auto beside = [&](Long x) {  // a limit, within rounding
      return std::abs(std::abs(x) / largest - 1) < 1e-13L ||
             std::abs(std::abs(x) / least - 1) < 1e-13L;
    };
    const bool read = !refuses([&] {
      const double found = parse_quantity("x", text, w.dimension);
      quantity.error(value == 0 ? std::abs(found) : off(found, si, w.factors + 1));
    });
    quantity.error(read == (inside(value) && inside(si)) || beside(value) || beside(si) ? 0 : 1);
    held += read ? 1 : 0;
  }
  CHECK(allowed > 3000);
  CHECK(held > 1500);

  for (int k = 0; k < 3000; ++k) {
    const Written w = written(draw, true);
    const std::string name =
        std::array{"x", "left_rail", "rail2", "level at 7", "P2"}[below(draw, 5)];
    if (!w.allowed || !w.clear || w.text.size() > 60) continue;
    const Header found = parse_header(name + "_" + w.text);
    header.error(found.name == name && found.unit.dimension == w.dimension
                     ? off(found.unit.si, w.si, w.factors)
                     : 1);
  }
}

TEST_CASE("claim: a dimension's name reads back") {
  Claim claim("units::si_name");
  RandomStream draw(2);
  const auto power = [&] { return static_cast<int>(below(draw, 17)) - 8; };
  for (int k = 0; k < 3000; ++k) {
    const bool few = k % 2 == 0;
    const Dimension d{power(), few ? 1 : power(), power(), few ? 0 : power()};
    const Unit back = parse_unit(si_name(d));
    claim.error(back.dimension == d && back.si == 1 ? 0 : 1);
  }
}

TEST_CASE("claim: ranges hold what they hold") {
  Claim between("units::require_between"), positive("units::require_positive"),
      not_negative("units::require_non_negative"), finite("units::require_finite");
  using L = std::numeric_limits<double>;
  const std::array hard{0.0,      -0.0,        1.0,           L::denorm_min(), -L::denorm_min(),
                        L::max(), L::lowest(), L::infinity(), -L::infinity(),  L::quiet_NaN()};
  RandomStream draw(3);
  const auto any = [&] {
    return draw(0, 1) < 0.5 ? hard[below(draw, hard.size())] : std::round(draw(-3, 3));
  };
  for (int k = 0; k < 2000; ++k) {
    const double x = any(), low = any(), high = any();
    const bool there = x - x == 0;  // neither infinite nor no number
    const auto holds = [&](Claim& claim, bool inside, auto read) {
      double found = 0;
      const bool refused = refuses([&] { found = read(); });
      claim.error(refused != inside &&
                          (refused || (found == x && std::signbit(found) == std::signbit(x)))
                      ? 0
                      : 1);
    };
    holds(between, there && x >= low && x <= high,
          [&] { return require_between("x", x, low, high); });
    holds(positive, there && x > 0, [&] { return require_positive("x", x); });
    holds(not_negative, there && x >= 0, [&] { return require_non_negative("x", x); });
    holds(finite, there, [&] { return require_finite("x", x); });
  }
}

namespace {
// Left out, put in, changed or swapped, from the ends of both words.
std::size_t edits(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return a.size() + b.size();
  const std::string a1 = a.substr(1), b1 = b.substr(1);
  std::size_t least = edits(a1, b1) + (a[0] == b[0] ? 0 : 1);
  least = std::min({least, edits(a1, b) + 1, edits(a, b1) + 1});
  if (a.size() > 1 && b.size() > 1 && a[0] == b[1] && a[1] == b[0])
    least = std::min(least, edits(a.substr(2), b.substr(2)) + 1);
  return least;
}
}  // namespace

TEST_CASE("claim: the word that was meant takes at most a third of the letters to edit") {
  Claim claim("units::did_you_mean");
  RandomStream draw(7);
  int meant = 0;
  for (int k = 0; k < 4000; ++k) {
    const auto word = [&] {
      std::string text(1 + below(draw, 6), ' ');
      for (char& c : text) c = static_cast<char>('a' + below(draw, 3));
      return text;
    };
    const std::string typed = word();
    std::vector<std::string> there(below(draw, 3));
    for (std::string& one : there) one = word();
    const std::string* best = nullptr;
    std::size_t least = std::max<std::size_t>(1, typed.size() / 3) + 1;
    for (const std::string& one : there)
      if (const std::size_t far = edits(typed, one); far < least && far < one.size())
        least = far, best = &one;
    claim.error(did_you_mean(typed, there) ==
                        (best == nullptr ? "" : "; did you mean \"" + *best + "\"?")
                    ? 0
                    : 1);
    meant += best == nullptr ? 0 : 1;
  }
  CHECK(meant > 300);
}

namespace {
// A code point in `bytes` bytes; in more than it needs that is no UTF-8.
std::string coded(unsigned long point, std::size_t bytes) {
  if (bytes == 1) return {static_cast<char>(point)};
  std::string text(bytes, ' ');
  for (std::size_t i = bytes - 1; i > 0; --i, point >>= 6)
    text[i] = static_cast<char>(0x80 | (point & 0x3f));
  text[0] = static_cast<char>((0xf00 >> bytes & 0xff) | point);
  return text;
}

bool is_drawn(unsigned long point) {
  if (point < 0x20 || (point >= 0x7f && point < 0xa0)) return false;
  if (point > 0x10ffff || (point >= 0xd800 && point < 0xe000)) return false;
  for (const unsigned long turns :
       {0x61cUL, 0x200eUL, 0x200fUL, 0x2028UL, 0x2029UL, 0x202aUL, 0x202bUL, 0x202cUL, 0x202dUL,
        0x202eUL, 0x2066UL, 0x2067UL, 0x2068UL, 0x2069UL})
    if (point == turns) return false;
  return true;
}
}  // namespace

TEST_CASE("claim: text from outside is drawn or escaped, character by character") {
  Claim claim("units::printable");
  constexpr std::array edges{0x0UL,    0x20UL,   0x7fUL,   0x80UL,   0xa0UL,    0x61cUL,   0x7ffUL,
                             0x800UL,  0x200eUL, 0x2028UL, 0x202eUL, 0x2066UL,  0x2069UL,  0xd7ffUL,
                             0xd800UL, 0xdfffUL, 0xe000UL, 0xffffUL, 0x10000UL, 0x10ffffUL};
  RandomStream draw(8);
  for (int k = 0; k < 3000; ++k) {
    std::string text, shown;
    bool cut = false;
    const std::size_t most = 1 + below(draw, 40);
    for (std::size_t n = below(draw, 12); n > 0; --n) {
      const unsigned long beside = below(draw, 3), edge = edges[below(draw, edges.size())];
      unsigned long point = draw(0, 1) < 0.5
                                ? edge + beside - std::min(edge, 1UL)
                                : static_cast<unsigned long>(draw.decades(1, 0x1fffff));
      const std::size_t needed = point < 0x80 ? 1 : point < 0x800 ? 2 : point < 0x10000 ? 3 : 4;
      const std::size_t bytes = draw(0, 1) < 0.8 ? needed : needed + below(draw, 5 - needed);
      std::string one = coded(point, bytes);
      bool drawn = bytes == needed && is_drawn(point);
      if (bytes > 1 && draw(0, 1) < 0.1) {  // its rest is missing, or stands alone
        one = (draw(0, 1) < 0.5 ? one.substr(1) : one.substr(0, 1)) + "|";
        drawn = false;
      }
      for (std::size_t i = 0; i < one.size(); ++i) {
        const bool bare = one[i] == '|' || drawn;
        const std::size_t take = drawn ? one.size() : 1;
        cut = cut || text.size() + i + take > most;
        if (cut) break;
        char escape[5];
        std::snprintf(escape, sizeof escape, "\\x%02x", static_cast<unsigned char>(one[i]));
        shown += bare ? one.substr(i, take) : escape;
        if (drawn) break;
      }
      text += one;
    }
    if (cut) shown += "... (" + std::to_string(text.size()) + " bytes)";
    claim.error(printable(text, most) == shown ? 0 : 1);
  }
}
