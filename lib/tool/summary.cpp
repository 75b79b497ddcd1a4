#include <railbook/tool/summary.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include <railbook/tool/session.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::tool {

std::string to_digits_of(double value, double error) {
  if (!(error > 0)) return fmt::format("{:.7g}", value);
  if (std::isinf(error)) return fmt::format("{:.4g}", value);
  const double place = std::floor(std::log10(error));
  const double size = value == 0 ? place : std::floor(std::log10(std::abs(value)));
  const int digits = static_cast<int>(std::clamp(size - place + 1, 1.0, 7.0));
  const double unit = std::pow(10, size - digits + 1);
  if (size < -4 || size > 6) return fmt::format("{:.{}e}", value, digits - 1);
  return fmt::format("{:.{}f}", unit > 1 ? std::round(value / unit) * unit : value,
                     std::max(0, digits - 1 - static_cast<int>(size)));
}

void Summary::add(std::string key, std::string what, const Estimate& estimate, std::string unit,
                  std::string note) {
  const std::string error = std::isinf(estimate.error)
                                ? "error not known"
                                : "error about " + to_digits_of(estimate.error, estimate.error);
  add(std::move(key), std::move(what), estimate.value, std::move(unit),
      note.empty() ? error : fmt::format("{}; {}", error, note));
  lines_.back().text = to_digits_of(estimate.value, estimate.error);
  lines_.back().error = estimate.error;
}

void Summary::add(std::string key, std::string what, double value, std::string unit,
                  std::string note) {
  if (!std::isfinite(value)) {
    const auto begin = std::min(what.find_first_not_of(' '), what.size());
    const std::string name = begin < what.size() ? what.substr(begin) : key;
    throw InputError{
        fmt::format("{} ({}): the result is {}; the input leads out of the range of numbers", name,
                    key, std::isnan(value) ? "not a number" : "infinite")};
  }
  lines_.push_back({Line::Kind::number, std::move(key), std::move(what),
                    fmt::format("{:.7g}", value), std::move(unit), std::move(note), value});
}

void Summary::add(std::string key, std::string what, std::string text) {
  lines_.push_back({Line::Kind::text, std::move(key), std::move(what), std::move(text), "", "", 0});
}

void Summary::absent(std::string key, std::string what, std::string why) {
  lines_.push_back(
      {Line::Kind::absent, std::move(key), std::move(what), std::move(why), "", "", 0});
}

void Summary::flag(std::string key, std::string text) {
  flags_.emplace_back(std::move(key), std::move(text));
}

void Summary::print() const {
  std::FILE* const to = session().taken ? stderr : stdout;
  if (session().json) return fmt::print(to, "{}", json());
  std::size_t wide = 0;
  for (const Line& line : lines_) wide = std::max(wide, line.what.size());
  fmt::print(to, "{}\n", units::printable(title_, 1000));
  for (const auto& [key, text] : flags_)
    fmt::print(to, "  DOUBTFUL: {}\n", units::printable(text, 1000));
  for (const Line& line : lines_) {
    const auto safe = [](const std::string& text) { return units::printable(text, 1000); };
    fmt::print(to, "  {:<{}}  {}{}{}{}\n", safe(line.what), wide, safe(line.text),
               line.unit.empty() ? "" : " ", line.unit,
               line.note.empty() ? "" : "   (" + safe(line.note) + ")");
  }
}

std::string Summary::json() const {
  nlohmann::ordered_json values = nlohmann::ordered_json::object();
  nlohmann::ordered_json errors = nlohmann::ordered_json::object();
  nlohmann::ordered_json units = nlohmann::ordered_json::object();
  nlohmann::ordered_json notes = nlohmann::ordered_json::object();
  for (const Line& line : lines_) {
    if (line.kind == Line::Kind::number) values[line.key] = line.value;
    if (line.kind == Line::Kind::text) values[line.key] = line.text;
    if (line.kind == Line::Kind::absent) values[line.key] = nullptr;
    if (line.error) {
      auto& error = errors[line.key] = nullptr;
      if (std::isfinite(*line.error)) error = *line.error;
    }
    if (!line.unit.empty()) units[line.key] = line.unit;
    const std::string& note = line.kind == Line::Kind::absent ? line.text : line.note;
    if (!note.empty()) notes[line.key] = note;
  }
  const auto object = [](const auto& pairs) {
    nlohmann::ordered_json result = nlohmann::ordered_json::object();
    for (const auto& [key, text] : pairs) result[key] = text;
    return result;
  };
  const Session& asked = session();
  const nlohmann::ordered_json all{{"title", title_},
                                   {"values", values},
                                   {"errors", errors},
                                   {"units", units},
                                   {"notes", notes},
                                   {"flags", object(flags_)},
                                   {"program", asked.program},
                                   {"version", asked.version},
                                   {"command", asked.command},
                                   {"given", object(asked.given)},
                                   {"assumed", object(asked.assumed)}};
  return all.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace railbook::tool
