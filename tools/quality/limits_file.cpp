#include "quality/limits_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <railbook/table/csv.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/quantity.hpp>

namespace railbook::quality_tool {
namespace {

constexpr std::array<std::pair<std::string_view, Kind>, 4> channels{
    {{"level", Kind::level},
     {"alignment", Kind::alignment},
     {"gauge", Kind::gauge},
     {"crosslevel", Kind::crosslevel}}};

// The row that the reader stands on.
class LimitRow {
 public:
  explicit LimitRow(const table::CsvReader& reader) : reader_(reader) {}

  std::string text(std::string_view column) const {
    const auto at = reader_.find(column);
    return at ? std::string{reader_.cell(*at)} : "";
  }
  double quantity(std::string_view column, const units::Dimension& dimension, double empty) const {
    const std::string cell = text(column);
    return cell.empty() ? empty : units::parse_quantity(column, cell, dimension);
  }

 private:
  const table::CsvReader& reader_;
};

void read_value(const std::string& text, Limit& limit) {
  const std::size_t blank = text.find(' ');
  const std::string name = text.substr(0, blank);
  const bool mean = name == "mean", peak = name == "mean-to-peak";
  limit.deviation = text == "sd";
  if (mean || peak) {
    limit.measure.mean = mean ? quality::Measure::Mean::taken : quality::Measure::Mean::subtracted;
    limit.measure.mean_length = units::require_positive(
        "length of the mean",
        units::parse_quantity("length of the mean",
                              blank == std::string::npos ? "" : text.substr(blank + 1),
                              units::length),
        "m");
  } else if (text != "peak" && !limit.deviation) {
    throw InputError{
        fmt::format("value is \"{}\"; allowed: peak, sd, mean LENGTH, mean-to-peak LENGTH", text)};
  }
}

Limit limit_of(const LimitRow& row) {
  Limit limit;
  const std::string channel = row.text("channel"), measure = row.text("measure"),
                    value = row.text("value");
  const auto* const kind =
      std::ranges::find(channels, channel, [](const auto& named) { return named.first; });
  if (kind == channels.end())
    throw InputError{
        fmt::format("channel is \"{}\"; allowed: level, alignment, gauge, crosslevel", channel)};
  limit.channel = kind->second;
  limit.measure = quality::parse_measure(measure);
  if (limit.is_twist() && limit.channel != Kind::crosslevel)
    throw InputError{fmt::format("twist of {}; allowed: of crosslevel", channel)};
  read_value(value, limit);
  limit.what =
      channel + (measure.empty() ? "" : " " + measure) + (value == "peak" ? "" : " " + value);
  limit.track_class = row.text("class");
  limit.speed_from = row.quantity("speed_from", units::speed, 0);
  limit.speed_to = row.quantity("speed_to", units::speed, units::infinity);
  const units::Dimension dimension = limit.is_twist() ? units::number : units::length;
  limit.low = row.quantity("low", dimension, -units::infinity);
  limit.high = row.quantity("high", dimension, units::infinity);
  if (std::isinf(limit.low) && std::isinf(limit.high))
    throw InputError{"neither low nor high has a limit"};
  if (!(limit.low < limit.high) || (limit.deviation && !(limit.high > 0)))
    throw InputError{fmt::format("low is {:g} and high {:g}; allowed: low below high{}", limit.low,
                                 limit.high, limit.deviation ? ", and high above 0" : "")};
  if (limit.speed_from >= limit.speed_to) throw InputError{"speed_from is not below speed_to"};
  return limit;
}

}  // namespace

std::vector<Limit> read_limits(const std::filesystem::path& file,
                               const std::vector<std::string>& classes,
                               std::optional<double> speed) {
  table::CsvReader reader{file};
  for (const char* const column : {"channel", "measure", "value", "low", "high"})
    (void)reader.column(column);
  std::vector<Limit> limits;
  std::vector<std::string> known;
  bool by_speed = false;
  while (reader.next()) {
    Limit limit;
    try {
      limit = limit_of(LimitRow{reader});
    } catch (const InputError& error) {
      throw InputError{fmt::format("{}: line {}: {}", file.string(), reader.line(), error.what())};
    }
    if (std::ranges::find(known, limit.track_class) == known.end())
      known.push_back(limit.track_class);
    if (!classes.empty() && !limit.track_class.empty() &&
        std::ranges::find(classes, limit.track_class) == classes.end())
      continue;
    const bool any = limit.speed_from == 0 && std::isinf(limit.speed_to);
    by_speed = by_speed || !any;
    if (any || !speed || (*speed > limit.speed_from && *speed <= limit.speed_to))
      limits.push_back(std::move(limit));
  }
  std::erase(known, "");
  for (const std::string& name : classes)
    if (std::ranges::find(known, name) == known.end())
      throw InputError{fmt::format("{} has no limits of class \"{}\"; allowed: {}", file.string(),
                                   name, fmt::join(known, ", "))};
  if (by_speed && !speed)
    throw InputError{
        fmt::format("limits of {} depend on the speed; give it with --speed", file.string())};
  if (limits.empty())
    throw InputError{
        speed ? fmt::format("{} has no limits at {:g} km/h; allowed: a speed within its ranges",
                            file.string(), *speed / units::kilometre_per_hour)
              : fmt::format("{} has no limits", file.string())};
  return limits;
}

}  // namespace railbook::quality_tool
