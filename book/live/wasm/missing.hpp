// What the libc++ of Debian 12's emscripten lacks of C++20, as far as lib/ uses it. Included ahead
// of every source of the module; with a newer library the file can go.
#pragma once

#ifdef __cplusplus
#define FMT_STATIC_THOUSANDS_SEPARATOR ','  // else fmt brings in the locales, a tenth of the module

#include <algorithm>
#include <cfenv>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>
#include <span>
#include <string>
#include <thread>
#include <type_traits>

// WebAssembly has no floating-point flags: none is ever raised.
#ifndef FE_INVALID
#define FE_INVALID 1
#define FE_DIVBYZERO 4
#define FE_OVERFLOW 8
#endif

namespace std {

#ifndef __cpp_lib_bit_cast
template <class To, class From>
To bit_cast(const From& from) {
  static_assert(sizeof(To) == sizeof(From) && is_trivially_copyable_v<To>);
  To to;
  memcpy(&to, &from, sizeof to);
  return to;
}
#endif

// There are no threads; the constructor of std::thread throws, and lib/ then does without.
#ifndef __cpp_lib_jthread
struct jthread : thread {
  using thread::thread;
};
#endif

inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const string text(first, last);
  char* end = nullptr;
  const double read = strtod(text.c_str(), &end);
  if (end == text.c_str()) return {first, errc::invalid_argument};
  value = read;
  return {first + (end - text.c_str()), errc{}};
}

// Euler's integral of the first kind.
inline double beta(double x, double y) {
  return exp(lgamma(x) + lgamma(y) - lgamma(x + y));
}

namespace ranges {

template <class I, class P = identity>
auto compare_by(I less, P projection) {
  return [=](const auto& a, const auto& b) {
    return invoke(less, invoke(projection, a), invoke(projection, b));
  };
}

// min_element, max_element, minmax_element, sort, stable_sort: of a range or of two iterators.
#define RAILBOOK_BY_ORDER(name)                                             \
  template <class R, class L = less, class P = identity>                    \
  requires requires(R & r) {                                                \
    begin(r);                                                               \
  }                                                                         \
  auto name(R&& r, L less_ = {}, P projection = {}) {                       \
    return std::name(begin(r), end(r), compare_by(less_, projection));      \
  }                                                                         \
  template <input_or_output_iterator I, class L = less, class P = identity> \
  auto name(I first, I last, L less_ = {}, P projection = {}) {             \
    return std::name(first, last, compare_by(less_, projection));           \
  }
RAILBOOK_BY_ORDER(min_element)
RAILBOOK_BY_ORDER(max_element)
RAILBOOK_BY_ORDER(minmax_element)
RAILBOOK_BY_ORDER(sort)
RAILBOOK_BY_ORDER(stable_sort)
#undef RAILBOOK_BY_ORDER

// find_if, find_if_not, any_of, all_of, count_if.
#define RAILBOOK_BY_TEST(name)                                                             \
  template <class R, class T, class P = identity>                                          \
  requires requires(R & r) {                                                               \
    begin(r);                                                                              \
  }                                                                                        \
  auto name(R&& r, T test, P projection = {}) {                                            \
    return std::name(begin(r), end(r),                                                     \
                     [&](auto&& x) { return bool(invoke(test, invoke(projection, x))); }); \
  }                                                                                        \
  template <input_or_output_iterator I, class T, class P = identity>                       \
  auto name(I first, I last, T test, P projection = {}) {                                  \
    return std::name(first, last,                                                          \
                     [&](auto&& x) { return bool(invoke(test, invoke(projection, x))); }); \
  }
RAILBOOK_BY_TEST(find_if)
RAILBOOK_BY_TEST(find_if_not)
RAILBOOK_BY_TEST(any_of)
RAILBOOK_BY_TEST(all_of)
RAILBOOK_BY_TEST(count_if)
#undef RAILBOOK_BY_TEST

template <class R, class X, class L = less, class P = identity>
auto lower_bound(R&& r, const X& x, L less_ = {}, P projection = {}) {
  return std::lower_bound(begin(r), end(r), x, [&](const auto& a, const X& b) {
    return invoke(less_, invoke(projection, a), b);
  });
}
template <class R, class X, class L = less, class P = identity>
auto upper_bound(R&& r, const X& x, L less_ = {}, P projection = {}) {
  return std::upper_bound(begin(r), end(r), x, [&](const X& a, const auto& b) {
    return invoke(less_, a, invoke(projection, b));
  });
}
template <class R>
auto minmax(R&& r) {
  const auto found = std::minmax_element(begin(r), end(r));
  return pair{*found.first, *found.second};
}
template <class A, class B, class P, class Q>
bool equal(A&& a, B&& b, equal_to, P p, Q q) {
  return std::equal(begin(a), end(a), begin(b), end(b),
                    [&](const auto& x, const auto& y) { return invoke(p, x) == invoke(q, y); });
}
template <class R, class X>
auto count(R&& r, const X& x) {
  return std::count(begin(r), end(r), x);
}
template <class R, class X, class P = identity>
auto find(R&& r, const X& x, P projection = {}) {
  return std::find_if(begin(r), end(r), [&](auto&& y) { return invoke(projection, y) == x; });
}
template <class R, class X>
void fill(R&& r, const X& x) {
  std::fill(begin(r), end(r), x);
}
template <class R>
void reverse(R&& r) {
  std::reverse(begin(r), end(r));
}
template <class R, class O>
void copy(R&& r, O out) {
  std::copy(begin(r), end(r), out);
}
template <class R, class O>
void move(R&& r, O out) {
  std::move(begin(r), end(r), out);
}
template <class R, class O, class F>
void transform(R&& r, O out, F f) {
  std::transform(begin(r), end(r), out, f);
}
template <class R, class I>
void nth_element(R&& r, I nth) {
  std::nth_element(begin(r), nth, end(r));
}

}  // namespace ranges
}  // namespace std
#endif
