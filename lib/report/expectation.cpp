#include <railbook/report/expectation.hpp>

#include <stdexcept>

namespace railbook::report {
namespace {

Tolerance with_reason(Tolerance t, std::string why) {
  if (why.empty()) throw std::logic_error{"an outcome without a reason"};
  t.why = t.why.empty() ? std::move(why) : why + "; " + t.why;
  return t;
}

}  // namespace

Expectation::Expectation(Tolerance t)
    : outcome(t.kind == ToleranceKind::last_digit ? Outcome::confirmed : Outcome::consistent),
      tolerance(std::move(t)) {}

Expectation fitted(std::string why, Tolerance tolerance) {
  return {Outcome::fitted, with_reason(std::move(tolerance), std::move(why))};
}
Expectation restored(std::string why, Tolerance tolerance) {
  return {Outcome::restored, with_reason(std::move(tolerance), std::move(why))};
}
Expectation corrected(double value, double allowed, std::string why, Trial trial) {
  return {Outcome::corrected, misprint(value, allowed, std::move(why)), std::move(trial)};
}
Expectation not_confirmed(std::string why, Trial trial) {
  return {Outcome::not_confirmed, not_the_print(std::move(why)), std::move(trial)};
}

std::string_view name(Source source) {
  switch (source) {
    case Source::print:
      return "print";
    case Source::claim:
      return "claim";
    case Source::publication:
      return "publication";
    case Source::route:
      return "route";
  }
  return "";
}

std::string_view name(Outcome outcome) {
  switch (outcome) {
    case Outcome::confirmed:
      return "confirmed";
    case Outcome::consistent:
      return "consistent";
    case Outcome::fitted:
      return "fitted";
    case Outcome::corrected:
      return "corrected";
    case Outcome::restored:
      return "restored";
    case Outcome::not_confirmed:
      return "not confirmed";
    case Outcome::verified:
      return "verified";
  }
  return "";
}

}  // namespace railbook::report
