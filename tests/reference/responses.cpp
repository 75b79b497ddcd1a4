// Responses of filters and of the vehicle that the tests hold, from the formulas alone, in long
// double; strokes against bump stops by Runge and Kutta's fixed steps. Nothing of lib/ is used.
// Each line is "file: text that stands in it".
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdarg>
#include <cstdio>
#include <string>
#include <vector>

using Real = long double;
using Complex = std::complex<Real>;

namespace {

const Real pi = std::acos(-1.0L), foot = 0.3048L, mph = 0.44704L;

const char* filters = "tests/lib/filters/reference.cpp";

std::string text(const char* format, Real x) {
  char out[64];
  std::snprintf(out, sizeof out, format, x);
  return out;
}

void say(const char* file, const char* before, const std::vector<std::string>& numbers,
         const char* after) {
  std::string line = before;
  for (std::size_t k = 0; k < numbers.size(); ++k) line += (k > 0 ? ", " : "") + numbers[k];
  std::printf("%s: %s%s\n", file, line.c_str(), after);
}

Real sinc(Real theta) {
  return std::sin(theta / 2) / (theta / 2);
}
Complex analog(Real kappa, Real theta) {
  return 1.0L / Complex{1, theta / kappa};
}  // corner/(s + corner)
Complex digital(Real kappa, Real theta) {  // (y_k - a y_(k-1))/(1 - a)
  const Real a = std::exp(-kappa);
  return (1.0L - a * std::polar(1.0L, -theta)) / (1 - a);
}

void hybrid() {
  for (const double phi : {.001, .01, .02, .05, .1, .2, .3, .4, .5}) {
    const Real theta = 2 * pi * std::stold(text("%.3Lf", phi));
    std::array<Real, 2> B, C, BC, FG;
    for (const std::size_t k : {0u, 1u}) {
      const Real kappa = 2 * pi * foot / ((k > 0 ? 80 : 9) * mph);
      B[k] = std::abs(analog(kappa, theta));
      C[k] = std::abs(digital(kappa, theta));
      BC[k] = B[k] * C[k];
      FG[k] = BC[k] * BC[k];  // a double pole, undone twice
    }
    say(filters, "Row{",
        {text("%.3Lg", phi), text("%.5Lf", B[0]), text("%.5Lf", B[1]), text("%.5Lf", C[0]),
         text(C[1] > 10 ? "%.4Lf" : "%.5Lf", C[1]), text("%.5Lf", BC[0]), text("%.5Lf", BC[1]),
         text("%.5Lf", std::abs(sinc(theta))), text("%.5Lf", FG[0]), text("%.5Lf", FG[1])},
        "}");
  }
}

void deviations() {
  struct Row {
    int mph;
    const char *magnitude, *complex, *offset;
  };
  for (const Row& r : {Row{1, "%.4Lf, 1e-4", "%.3Lf, 1e-3", "%.0Lf, 1}"},
                       Row{5, "%.5Lf, 1e-5", "%.4Lf, 1e-4", "%.1Lf, 1e-1}"},
                       Row{9, "%.5Lf, 1e-5", "%.4Lf, 1e-4", "%.1Lf, 1e-1}"},
                       Row{15, "%.5Lf, 1e-5", "%.4Lf, 1e-4", "%.1Lf, 1e-1}"},
                       Row{30, "%.5Lf, 1e-5", "%.4Lf, 1e-4", "%.2Lf, 1e-2}"},
                       Row{80, "%.5Lf, 1e-5", "%.4Lf, 1e-4", "%.2Lf, 1e-2}"},
                       Row{120, "%.5Lf, 1e-5", "%.4Lf, 1e-4", "%.2Lf, 1e-2}"}}) {
    const Real kappa = 2 * pi * foot / (r.mph * mph), a = std::exp(-kappa);
    Real magnitude = 0, complex = 0;
    for (int i = 1; i <= 2000; ++i) {
      const Real theta = pi * i / 2000;
      const Complex bc = analog(kappa, theta) * digital(kappa, theta);
      magnitude = std::max(magnitude, std::abs(std::abs(bc) - sinc(theta)));
      complex = std::max(complex, std::abs(bc * std::polar(1.0L, theta / 2) - sinc(theta)));
    }
    const Real delay = 1 / kappa - a / (1 - a);
    say(filters, "Row{",
        {std::to_string(r.mph), text("%.4Lf", kappa), text(r.magnitude, magnitude),
         text(r.complex, complex), text("%.5Lf", delay),
         text(r.offset, (1 - 2 * delay) * foot / 1e-3L)},
        "");
  }
}

void approximate_exponentials() {
  for (const char* written : {"0.0535", "0.2", "0.476", "0.857"}) {
    const Real k = std::stold(written), a = std::exp(-k);
    std::vector<std::string> tails;
    for (const Real other : {1 - k, 1 / (1 + k), (1 - k / 2) / (1 + k / 2),
                             (1 - k / 2 + k * k / 12) / (1 + k / 2 + k * k / 12)}) {
      std::string tail = text("%.1Le", (a - other) / (1 - other));
      for (const char* zero : {"e-0", "e+0"})
        if (const auto at = tail.find(zero); at != std::string::npos) tail.erase(at + 2, 1);
      tails.push_back(tail);
    }
    say(filters, (std::string("Row{") + written + ", {").c_str(), tails, "}}");
  }
}

void chords() {
  for (const int wavelength : {20, 39, 50, 62, 78, 100, 124, 150, 200, 300, 500})
    say(filters, "Row{",
        {std::to_string(wavelength), text("%.5Lf", 1 - std::cos(62 * pi / wavelength))}, "}");
  Real square = 31 * 31;
  for (int k = 1; k < 31; ++k) square += 2 * k * k;
  say(filters, "same(std::sqrt(square), ", {text("%.4Lf", std::sqrt(square))}, ", 1e-4)");
  for (const int wavelength :
       {20, 62, 100, 124, 150, 175, 200, 250, 300, 400, 500, 700, 1000, 2000, 5000}) {
    const Real half = pi / wavelength, box = std::sin(151 * half) / (151 * std::sin(half));
    say(filters, "Row{", {std::to_string(wavelength), text("%.5Lf", 1 - box * box * box * box)},
        "}");
  }
}

void complementary() {
  const Real tau = 1 / (2 * pi * 0.3125L);
  say(filters, "same(tau, ", {text("%.4Lf", tau)}, ", 1e-4)");
  for (const auto& [poles, hertz] :
       {std::pair{1, "0.05"}, {1, "0.3125"}, {1, "1.25"}, {2, "0.3125"}, {2, "1.25"}}) {
    const Complex low = std::pow(1.0L / Complex{1, 2 * pi * std::stold(hertz) * tau}, poles);
    say(filters, "Row{",
        {std::to_string(poles), hertz, text("%.4Lf", std::abs(low)),
         text(poles == 1 ? "%.4Lf, 1e-4" : "%.3Lf, 1e-3", std::abs(1.0L - low))},
        "}");
  }
}

// |X/Z| of M x'' + b x' + k x = -M z'', and |G/Z| of m z'' + M y''; frequencies over the body's
// own.
Real stroke(Real ratio, Real damping) {
  return ratio * ratio / std::abs(Complex{1 - ratio * ratio, 2 * damping * ratio});
}
Real force(Real hertz) {
  const Real wheel = 800, body = 7000, own = 2, damping = 0.6L, r = hertz / own;
  const Complex y = Complex{1, 2 * damping * r} / Complex{1 - r * r, 2 * damping * r};
  return std::pow(2 * pi * hertz, 2.0L) * std::abs(wheel + body * y);
}
// The largest stroke gain, by halving steps up the hill.
Real peak(Real damping) {
  Real at = 1, step = 0.5L;
  for (int k = 0; k < 400; ++k) {
    if (stroke(at + step, damping) > stroke(at, damping))
      at += step;
    else if (at > step && stroke(at - step, damping) > stroke(at, damping))
      at -= step;
    else
      step /= 2;
  }
  return stroke(at, damping);
}

void vehicle() {
  const char* file = "tests/lib/quality/descriptor.cpp";
  for (const auto& [rho, format] :
       {std::pair{"0.2", "%.6Lf"}, {"0.01", "%.4Lf"}, {"0.5", "%.6Lf"}, {"0.7", "%.6Lf"}})
    say(file, (std::string("stroke_peak(") + rho + ").gain, WithinAbs(").c_str(),
        {text(format, peak(std::stold(rho)))}, ",");
  for (const auto& [metres, format] :
       {std::pair{"20", "%.6Lf"}, {"55", "%.6Lf"}, {"100", "%.6Lf"}, {"300", "%.7Lf"}})
    say(file, (std::string("stroke_gain(roll, speed / ") + metres + "), WithinAbs(").c_str(),
        {text(format, stroke(100 / 3.6L / std::stold(metres) / 0.5L, 0.2L))}, ",");
  for (const auto& [hertz, format] : {std::pair{"0.5", "%.2Lf"}, {"2", "%.1Lf"}, {"10", "%.1Lf"}})
    say(file, (std::string("std::abs(force_gain(car, ") + hertz + ")), WithinRel(").c_str(),
        {text(format, force(std::stold(hertz)))}, ",");
}

// The largest |x| [cm] from 120 to 180 s of x'' + 2 rho w x' + w^2 (x + kappa (|x| - gap)+ sgn x) =
// -z'', z a sine that grows for `ramp` seconds; from rest, 1/h steps a second.
Real settled(Real kappa, Real f, Real ramp, int h = 1000) {
  const Real amplitude = 0.009954726L, gap = 0.6L * 0.0254L, w = 2 * pi * 0.5L, o = 2 * pi * f;
  const auto acceleration = [&](Real t, Real x, Real v) {
    const Real grown = ramp > 0 && t < ramp ? t / ramp : 1,
               growing = ramp > 0 && t < ramp ? 1 / ramp : 0;
    const Real track =
        amplitude * (2 * growing * o * std::cos(o * t) - grown * o * o * std::sin(o * t));
    const Real stop = std::abs(x) > gap ? std::copysign(kappa * (std::abs(x) - gap), x) : 0;
    return -track - 0.4L * w * v - w * w * (x + stop);
  };
  Real x = 0, v = 0, most = 0;
  const Real d = 1.0L / h;
  for (int n = 0; n < 180 * h; ++n) {
    const Real t = n * d;
    const Real v1 = v, a1 = acceleration(t, x, v1);
    const Real v2 = v + d / 2 * a1, a2 = acceleration(t + d / 2, x + d / 2 * v1, v2);
    const Real v3 = v + d / 2 * a2, a3 = acceleration(t + d / 2, x + d / 2 * v2, v3);
    const Real v4 = v + d * a3, a4 = acceleration(t + d, x + d * v3, v4);
    const Real before = v;
    x += d / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    v += d / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    // Where v passes 0 within the step, x has turned: back by v^2/2a.
    if (t >= 120 && before * v <= 0)
      most = std::max(most, std::abs(x - v * v / (2 * (v - before) / d)));
  }
  return 100 * most;
}

void bump_stops() {
  const char* file = "tests/lib/quality/bump_stops.cpp";
  std::vector<std::string> strokes;
  for (const int kappa : {0, 1, 10, 100, 1000}) {
    std::string stroke = text("%.5Lf", settled(kappa, 0.5212860L, 0, kappa > 100 ? 4000 : 1000));
    strokes.push_back(stroke.substr(0, stroke.find_last_not_of('0') + 1));
  }
  say(file, "strokes[] = {", strokes, "}");
  say(file, "settled(10, 1.0, 0), WithinAbs(", {text("%.3Lf", settled(10, 1, 0))}, ",");
  say(file, "settled(10, 1.0, 60), WithinAbs(", {text("%.3Lf", settled(10, 1, 60))}, ",");
}

}  // namespace

int main() {
  hybrid();
  deviations();
  approximate_exponentials();
  chords();
  complementary();
  vehicle();
  bump_stops();
}
