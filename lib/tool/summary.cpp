#include <railbook/tool/summary.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include <railbook/tool/digits.hpp>
#include <railbook/tool/session.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::tool {

void Summary::add(std::string key, std::string what, const Estimate& estimate, std::string unit,
                  std::string note) {
  const auto& [value, error] = estimate;
  if (std::isinf(error)) note = note.empty() ? "error not known" : "error not known; " + note;
  add(std::move(key), std::move(what), value, std::move(unit), std::move(note));
  lines_.back().text = with_error(value, error);
  lines_.back().error = error;
}

void Summary::add_rounded(std::string key, std::string what, double value, double last,
                          std::string unit, std::string note) {
  add(std::move(key), std::move(what), value, std::move(unit), std::move(note));
  lines_.back().text = to_digits_of(value, last);
}

void Summary::add_error(std::string key, std::string what, double error, std::string unit,
                        std::string note) {
  add(std::move(key), std::move(what), error, std::move(unit), std::move(note));
  lines_.back().text = to_significant(error, 2);
}

void Summary::add_to_json(std::string key, double value, std::string unit) {
  add(std::move(key), "", value, std::move(unit));
  lines_.back().kind = Line::Kind::hidden;
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
  lines_.push_back({Line::Kind::number, std::move(key), std::move(what), to_text(value),
                    std::move(unit), std::move(note), value});
}

void Summary::add(std::string key, std::string what, std::string text) {
  lines_.push_back({Line::Kind::text, std::move(key), std::move(what), std::move(text), "", "", 0});
}

void Summary::absent(std::string key, std::string what, std::string why) {
  lines_.push_back(
      {Line::Kind::absent, std::move(key), std::move(what), std::move(why), "", "", 0});
}

void Summary::warn(std::string key, std::string text) {
  warnings_.push_back({std::move(key), std::move(text)});
}

void Summary::print() const {
  std::FILE* const to = session().taken ? stderr : stdout;
  if (session().json) return fmt::print(to, "{}", json());
  std::size_t wide = 0;
  for (const Line& line : lines_) wide = std::max(wide, line.what.size());
  fmt::print(to, "{}\n", units::printable(title_, 1000));
  for (const auto& [key, text] : warnings_)
    fmt::print(to, "  WARNING: {}\n", units::printable(text, 1000));
  for (const Line& line : lines_) {
    if (line.kind == Line::Kind::hidden) continue;
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
    if (line.kind == Line::Kind::number || line.kind == Line::Kind::hidden)
      values[line.key] = line.value;
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
                                   {"warnings", object(warnings_)},
                                   {"program", asked.program},
                                   {"version", asked.version},
                                   {"command", asked.command},
                                   {"given", object(asked.given)},
                                   {"assumed", object(asked.assumed)}};
  return all.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace railbook::tool
