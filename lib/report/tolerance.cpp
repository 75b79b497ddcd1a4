#include <railbook/report/tolerance.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include <railbook/units/input_error.hpp>

namespace railbook::report {
namespace {

using units::nan;

std::string without_spaces(std::string_view text) {
  std::string clean;
  for (char c : text)
    if (c != ' ' && c != '+' && c != ',') clean += c;
  return clean;
}

void require_sound(std::string_view printed, const Tolerance& t) {
  const bool strict = t.kind == ToleranceKind::last_digit || t.kind == ToleranceKind::exact;
  const bool bound = t.kind == ToleranceKind::at_most || t.kind == ToleranceKind::at_least ||
                     t.kind == ToleranceKind::not_the_print;
  if (!strict && t.why.empty())
    throw std::logic_error{std::string{name(t.kind)} + " tolerance without a reason"};
  if (!strict && !bound && !(std::isfinite(t.allowed) && t.allowed > 0))
    throw std::logic_error{std::string{name(t.kind)} + " tolerance is not a positive number"};
  if (!std::isfinite(printed_number(printed)))
    throw std::logic_error{"printed text \"" + std::string{printed} + "\" is not a number"};
}

}  // namespace

Tolerance last_digit() {
  return {};
}
Tolerance relative(double allowed, std::string why) {
  return {ToleranceKind::relative, allowed, std::move(why)};
}
Tolerance absolute(double allowed, std::string why) {
  return {ToleranceKind::absolute, allowed, std::move(why)};
}
Tolerance digitised(double share, double axis_span, std::string why) {
  return {ToleranceKind::digitised, share, std::move(why), axis_span};
}
Tolerance misprint(double corrected, double allowed, std::string why) {
  return {ToleranceKind::misprint, allowed, std::move(why), corrected};
}
Tolerance not_the_print(std::string why) {
  return {ToleranceKind::not_the_print, 0, std::move(why)};
}
Tolerance at_most(std::string why) {
  return {ToleranceKind::at_most, 0, std::move(why)};
}
Tolerance at_least(std::string why) {
  return {ToleranceKind::at_least, 0, std::move(why)};
}

double printed_number(std::string_view text) {
  const std::string clean = without_spaces(text);
  double value = nan;
  const auto [end, status] = std::from_chars(clean.data(), clean.data() + clean.size(), value);
  return status == std::errc{} && end == clean.data() + clean.size() ? value : nan;
}

int last_decade(std::string_view text) {
  const std::string clean = without_spaces(text);
  const std::size_t e = clean.find_first_of("eE");
  const std::string mantissa = clean.substr(0, e);
  int exponent = e == std::string::npos ? 0 : std::stoi(clean.substr(e + 1));
  const std::size_t point = mantissa.find('.');
  if (point != std::string::npos) exponent -= static_cast<int>(mantissa.size() - point - 1);
  return exponent;
}

double half_last_digit(std::string_view text) {
  return 0.5 * std::pow(10.0, last_decade(text));
}

Verdict compare(std::string_view printed, double computed, const Tolerance& t) {
  require_sound(printed, t);
  const double p = printed_number(printed);
  Verdict v{false, nan, t.allowed};
  if (!std::isfinite(computed)) return v;
  const double difference = std::abs(computed - p);
  switch (t.kind) {
    case ToleranceKind::last_digit:
      v.allowed = half_last_digit(printed);
      v.error = difference;
      break;
    case ToleranceKind::absolute:
      v.error = difference;
      break;
    case ToleranceKind::relative:
    case ToleranceKind::agrees_with:
      v.error = p == 0 ? (difference == 0 ? 0 : std::numeric_limits<double>::max())
                       : difference / std::abs(p);
      break;
    case ToleranceKind::digitised:
      v.error = difference / t.span;
      break;
    case ToleranceKind::misprint:
      v.error = std::abs(computed - t.span) / std::abs(t.span);
      v.pass = v.error <= v.allowed && difference > half_last_digit(printed);
      return v;
    case ToleranceKind::not_the_print:
      v.error = difference;
      v.allowed = half_last_digit(printed);
      v.pass = difference > v.allowed;
      return v;
    case ToleranceKind::at_most:
      v.error = computed;
      v.allowed = p;
      break;
    case ToleranceKind::at_least:
      v.error = computed;
      v.allowed = p;
      v.pass = computed >= p;
      return v;
    case ToleranceKind::exact:
      throw std::logic_error{"exact is for texts: use check_text"};
  }
  // A value that is exactly half a unit off rounds either way: leave room for its last bits.
  v.pass = v.error <= v.allowed + 1e-12 * std::abs(v.allowed);
  return v;
}

double beyond_tolerance(std::string_view printed, double computed, const Tolerance& t) {
  const double p = printed_number(printed);
  const auto away = [&](double centre, double step) {
    return computed + (computed < centre ? -2.0 : 2.0) * step;
  };
  switch (t.kind) {
    case ToleranceKind::last_digit:
      return away(p, half_last_digit(printed));
    case ToleranceKind::absolute:
      return away(p, t.allowed);
    case ToleranceKind::relative:
    case ToleranceKind::agrees_with:
      return away(p, t.allowed * std::abs(p));
    case ToleranceKind::digitised:
      return away(p, t.allowed * t.span);
    case ToleranceKind::misprint:
      return away(t.span, t.allowed * std::abs(t.span));
    case ToleranceKind::not_the_print:
      return p;
    // A bound has no width: move across it, twice as far as the value lies inside.
    case ToleranceKind::at_most:
      return p + std::max(p - computed, 1e-9 * std::max(std::abs(p), 1.0));
    case ToleranceKind::at_least:
      return p - std::max(computed - p, 1e-9 * std::max(std::abs(p), 1.0));
    case ToleranceKind::exact:
      break;
  }
  return nan;
}

std::string_view name(ToleranceKind kind) {
  switch (kind) {
    case ToleranceKind::last_digit:
      return "last_digit";
    case ToleranceKind::relative:
      return "relative";
    case ToleranceKind::absolute:
      return "absolute";
    case ToleranceKind::digitised:
      return "digitised";
    case ToleranceKind::agrees_with:
      return "agrees_with";
    case ToleranceKind::misprint:
      return "misprint";
    case ToleranceKind::not_the_print:
      return "not_the_print";
    case ToleranceKind::at_most:
      return "at_most";
    case ToleranceKind::at_least:
      return "at_least";
    case ToleranceKind::exact:
      return "exact";
  }
  return "";
}

}  // namespace railbook::report
