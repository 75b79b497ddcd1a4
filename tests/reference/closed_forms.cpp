// Numbers of the tests that have a closed form, in 113 bits (GCC's __float128), by routes of their
// own: Gauss' mean, tanh-sinh quadrature, bisection. Nothing of lib/ is used. Each line is "file:
// text that stands in it".
#include <quadmath.h>

#include <cstdio>
#include <functional>
#include <string>

using Quad = __float128;

namespace {

const Quad pi = M_PIq;

std::string digits(Quad x, const char* format) {
  char text[64];
  quadmath_snprintf(text, sizeof text, format, x);
  return text;
}

// Over (a, b) by the tanh-sinh rule; f gets x and the distances to both ends, which do not cancel.
Quad integral(const std::function<Quad(Quad, Quad, Quad)>& f, Quad a, Quad b) {
  const Quad half = (b - a) / 2, h = 1.0Q / 64;
  Quad sum = 0;
  for (int k = -64 * 5; k <= 64 * 5; ++k) {
    const Quad t = k * h, s = pi / 2 * sinhq(t), q = 1 / (expq(2 * fabsq(s)) + 1);
    const Quad near = 2 * half * q;  // the distance to the nearer end
    const Quad weight = half * pi / 2 * coshq(t) / (coshq(s) * coshq(s)) * h;
    if (weight < 1e-40Q || near == 0) continue;
    const Quad below = t < 0 ? near : 2 * half - near, above = t < 0 ? 2 * half - near : near;
    sum += weight * f(t < 0 ? a + near : b - near, below, above);
  }
  return sum;
}

Quad bisect(const std::function<Quad(Quad)>& f, Quad low, Quad high) {
  const bool rises = f(low) < 0;
  for (int k = 0; k < 200; ++k) {
    const Quad middle = (low + high) / 2;
    ((f(middle) < 0) == rises ? low : high) = middle;
  }
  return (low + high) / 2;
}

// K(m) and D(m) = (K - E)/m for m = 1 - m1.
struct Elliptic {
  Quad k, d;
};
Elliptic elliptic(Quad m1) {
  const Quad m = 1 - m1;
  Quad a = 1, g = sqrtq(m1), sum = 0.5Q, square = m, power = 1;  // square: c_n^2
  for (int n = 0; n < 12; ++n) {
    const Quad next = (a + g) / 2, half = square / (4 * next);  // c_(n+1) = c_n^2 / (4 a_(n+1))
    g = sqrtq(a * g), a = next;
    square = half * half;
    sum += power * square / m;
    power *= 2;
  }
  const Quad k = pi / (2 * a);
  return {k, k * sum};
}

// A = 1/m, B = q/m, approach 1 m, E* = 1 Pa: B/A = (K - D)/(m1 D), and the integrals for the rest.
void hertz() {
  for (const Quad q : {1.5Q, 36.5Q, 1e3Q, 1e7Q, 1e12Q, 1e16Q}) {
    const Quad log_m1 = bisect(
        [&](Quad l) {
          const Elliptic e = elliptic(expq(l));
          return (e.k - e.d) / (expq(l) * e.d) - q;
        },
        -90, -1e-3Q);
    const Quad m1 = expq(log_m1);
    const Elliptic e = elliptic(m1);
    const Quad a = sqrtq(e.d / e.k), b = a * sqrtq(m1);
    std::printf("tests/lib/contact/hertz.cpp: %s, %s, %s, %s}\n", digits(a, "%.24Qf").c_str(),
                digits(b * sqrtq(q), "%.24Qf").c_str(),
                digits(2 * pi * a / (3 * e.k), "%.24Qf").c_str(),
                digits(1 / (b * e.k * sqrtq(q)), "%.24Qf").c_str());
  }
}

// The rounded punch of Example 4, b = .5 in: the unreduced force, and Abel's integral of the
// pressure.
void punch() {
  const Quad modulus = 1.5e7Q / 0.91Q, b = 0.5Q, delta = 1e-3Q;
  for (const auto& [edge, name] : {std::pair{1.0Q, "1"}, {0.1Q, "0.1"}, {5.0Q, "5"}}) {
    const Quad R = edge;
    const Quad a = bisect(
        [&](Quad x) {
          const Quad s = sqrtq(x * x - b * b);
          return x / R * (s - b * atanq(s / b)) - delta;
        },
        b, 2 * b);
    const Quad s = sqrtq(a * a - b * b);
    const Quad force =
        2 * modulus *
        (delta * a - (s * s * s / 3 - a * a * b / 2 * acosq(b / a) + b * b * s / 2) / R);
    const auto pressure = [&](Quad r) {
      const Quad first = r > b ? r : b;  // t from here to a
      const auto f = [&](Quad t, Quad above_first, Quad) {
        const Quad past_b = first - b + above_first, past_r = first - r + above_first;
        const Quad root = sqrtq(past_b * (t + b));
        return (2 * root - b * atan2q(root, b)) / sqrtq(past_r * (t + r));
      };
      return modulus / (pi * R) * integral(f, first, a);
    };
    Quad low = b, high = b + (a - b) / 2;  // one maximum
    for (int k = 0; k < 60; ++k) {
      const Quad x = low + (high - low) * 0.382Q, y = low + (high - low) * 0.618Q;
      (pressure(x) < pressure(y) ? low : high) = pressure(x) < pressure(y) ? x : y;
    }
    std::printf("tests/chapters/01-contact/punch.cpp: Case{%s, %s, %s, %s, %s, %s}\n", name,
                digits(a, "%.14Qg").c_str(), digits(force, "%.14Qg").c_str(),
                digits(pressure(0), "%.12Qg").c_str(), digits(pressure(low), "%.11Qg").c_str(),
                digits(low, "%.6Qf").c_str());
  }
  const Quad z = bisect([](Quad x) { return x * tanhq(x) - 1; }, 1, 2);
  std::printf("tests/chapters/01-contact/punch.cpp: z = %s;\n", digits(z, "%.17Qg").c_str());
}

// -1/(4 pi) integral of ln R / sin^2(t/2), R = 4 sin^2(t/2) sum of (-1)^m sign(t + 2 pi m)/(t + 2
// pi m)^2.
void edge_offset() {
  const auto lattice = [](Quad t) {  // the alternating sum, ends averaged again and again
    constexpr int terms = 60, last = 20;
    Quad partial[last], sum = 1 / (t * t);
    for (int m = 1; m < terms + last; ++m) {
      const Quad after = 2 * pi * m + t, before = 2 * pi * m - t;
      sum += (m % 2 == 0 ? 1 : -1) * (1 / (after * after) - 1 / (before * before));
      if (m >= terms) partial[m - terms] = sum;
    }
    for (int n = last - 1; n > 0; --n)
      for (int k = 0; k < n; ++k) partial[k] = (partial[k] + partial[k + 1]) / 2;
    return partial[0];
  };
  const auto f = [&](Quad t, Quad, Quad) {
    const Quad s = sinq(t / 2);
    return t < 1e-8Q ? -1 / 3.0Q : logq(4 * s * s * lattice(t)) / (s * s);
  };
  std::printf("tests/lib/rolling/theory.cpp: edge_offset() == Approx(%s)\n",
              digits(-integral(f, 0, pi) / (4 * pi), "%.10Qf").c_str());
}

Quad sine_integral(Quad x) {
  Quad sum = 0, term = x;
  for (int n = 0; n < 120; ++n) {
    sum += term / (2 * n + 1);
    term *= -x * x / ((2 * n + 2) * (2 * n + 3));
  }
  return sum;
}

void spectra() {
  const char* file = "tests/lib/spectra/chord.cpp";
  std::printf("%s: sine_integral(1.0), WithinRel(%s,\n", file,
              digits(sine_integral(1), "%.15Qf").c_str());
  std::printf("%s: sine_integral(-10.0), WithinRel(%s,\n", file,
              digits(sine_integral(-10), "%.15Qf").c_str());
  std::printf("%s: chord_sigma(1.0, 1.0), WithinRel(%s,\n", file,
              digits(pi / sqrtq(2), "%.15Qf").c_str());
  const Quad z = bisect([](Quad x) { return 0.025Q - erfcq(x / sqrtq(2)) / 2; }, 1, 3);
  std::printf("tests/lib/spectra/synthetic.cpp: normal_quantile(0.975), WithinRel(%s,\n",
              digits(z, "%.15Qf").c_str());
  // Q_1 = (2 B/(3 pi))^2/2.
  std::printf("tests/lib/spectra/spectrum.cpp: Approx(%s)\n",
              digits(3 * pi / sqrtq(2), "%.9Qf").c_str());
}

void quality() {
  const char* file = "tests/lib/quality/index.cpp";
  const auto normal = [](Quad x) { return expq(-x * x / 2) / sqrtq(2 * pi); };
  const auto over = [](Quad x) { return erfcq(-x / sqrtq(2)) / 2; };  // Phi
  const auto risk = [&](Quad x, Quad, Quad) {
    return normal(x) * over((0.2Q + 0.25Q * x - 1) / 0.1Q);
  };
  std::printf("%s: failure_probability(0.2, 0.25, 1, 0.1), WithinRel(%s,\n", file,
              digits(integral(risk, -12, 12), "%.11Qf").c_str());
  const auto tail = [&](Quad x, Quad, Quad) { return normal(x); };
  std::printf("%s: share_above(0.2, 0.25, 1), WithinRel(%s,\n", file,
              digits(integral(tail, (1 - 0.2Q) / 0.25Q, 20), "%.6Qe").c_str());
  // The blob: h = (9/10 (x_N^2 - x^2))^(1/3) at t = 1, of area 1.
  const auto shape = [](Quad x, Quad below, Quad above) { return cbrtq(below * above + 0 * x); };
  const Quad front = powq(1 / (cbrtq(0.9Q) * integral(shape, -1, 1)), 0.6Q);
  std::printf("%s: blob_front(1), WithinAbs(%s,\n", file, digits(front, "%.8Qf").c_str());
  std::printf("%s: blob_height(0, 1), WithinAbs(%s,\n", file,
              digits(cbrtq(0.9Q * front * front), "%.8Qf").c_str());
}

void others() {
  Quad a = 1, g = sqrtq(2);
  for (int n = 0; n < 8; ++n) {
    const Quad next = (a + g) / 2;
    g = sqrtq(a * g), a = next;
  }
  std::printf("tests/lib/wheelset/conicity.cpp: lemniscate = %s;\n",
              digits(pi / (2 * a), "%.16Qf").c_str());
  const Quad x = bisect([](Quad y) { return y - cosq(y); }, 0, 1);
  std::printf("tests/lib/num/basics.cpp: Approx(%s)\n", digits(x, "%.16Qf").c_str());
}

}  // namespace

int main() {
  hertz();
  punch();
  edge_offset();
  spectra();
  quality();
  others();
}
