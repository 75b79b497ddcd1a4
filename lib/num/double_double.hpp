// Numbers of twice a double's digits, as the sum of two doubles ("double-double"): for systems
// whose condition takes more digits than a double has.
//
// Source: T. J. Dekker, A floating-point technique for extending the available precision,
// Numerische Mathematik 18 (1971). Sums and products of two doubles are split into what rounding
// keeps and what it drops, without a fused multiplication: the digits are the same on every
// processor that rounds to nearest.
#pragma once

namespace railbook::num {

// high + low, with |low| at most half a unit in the last place of high. An operation's error is
// below 2e-31 of the sum of the magnitudes it adds (+, -) or of the result (*, /), for magnitudes
// from 1e-140 to 1e140 and 0; nothing is checked.
struct DoubleDouble {
  double high = 0, low = 0;

  constexpr DoubleDouble(double value = 0) : high(value) {}
  constexpr explicit operator double() const { return high + low; }

  constexpr DoubleDouble& operator+=(const DoubleDouble& b) { return *this = *this + b; }
  constexpr DoubleDouble operator-() const { return {-high, -low}; }

  friend constexpr DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble sum = exact_sum(a.high, b.high);
    return renormalised(sum.high, sum.low + (a.low + b.low));
  }
  friend constexpr DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
    return a + -b;
  }
  friend constexpr DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble product = exact_product(a.high, b.high);
    return renormalised(product.high, product.low + (a.high * b.low + a.low * b.high));
  }
  friend constexpr DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
    const double quotient = a.high / b.high;
    const DoubleDouble rest = a - quotient * b;
    return renormalised(quotient, rest.high / b.high);
  }

 private:
  constexpr DoubleDouble(double h, double l) : high(h), low(l) {}

  // a + b for |a| >= |b|, or nearly so.
  static constexpr DoubleDouble renormalised(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
  }
  static constexpr DoubleDouble exact_sum(double a, double b) {
    const double sum = a + b, from_b = sum - a;
    return {sum, (a - (sum - from_b)) + (b - from_b)};
  }
  static constexpr DoubleDouble exact_product(double a, double b) {
    const DoubleDouble x = halves(a), y = halves(b);
    const double product = a * b;
    return {product,
            ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low};
  }
  // 26 binary digits each, so that their products are exact.
  static constexpr DoubleDouble halves(double a) {
    const double scaled = 134217729.0 * a, high = scaled - (scaled - a);  // 2^27 + 1
    return {high, a - high};
  }
};

}  // namespace railbook::num
