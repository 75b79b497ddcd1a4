#include "spectra/record_file.hpp"

#include <utility>
#include <vector>

#include "table/csv.hpp"
#include "units/input_error.hpp"
#include "units/quantity.hpp"

namespace railbook::spectra {
namespace {

constexpr double bridged_length = 1;  // m

std::string quoted(const std::string& name) {
  return "column \"" + name + "\"";
}

// What one cell of the column of heights is in metres.
double metres_of_height(const RecordFile& wish, const std::string& header) {
  const units::Header named = units::parse_header(header);
  if (wish.unit.empty() && named.unit_text.empty())
    throw InputError{quoted(header) + " names no unit; give one with --unit, such as mm"};
  const units::Unit unit = wish.unit.empty() ? named.unit : units::parse_unit(wish.unit);
  if (!(unit.dimension == units::length))
    throw InputError{quoted(header) + " has the unit " +
                     (wish.unit.empty() ? named.unit_text : wish.unit) +
                     "; allowed: a length, such as mm"};
  if (!wish.unit.empty() && !named.unit_text.empty() && unit.si != named.unit.si)
    throw InputError{quoted(header) + " is in " + named.unit_text + " by its header, in " +
                     wish.unit + " by --unit"};
  return unit.si;
}

struct Positions {
  std::size_t column;
  double metre;
};

std::optional<Positions> positions_of(const RecordFile& wish, const table::CsvReader& reader) {
  const std::vector<std::string>& header = reader.header();
  std::string there;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const units::Header named = units::parse_header(header[i]);
    if (header[i] != wish.distance && named.name != wish.distance) {
      there += (i > 0 ? ", " : "") + header[i];
      continue;
    }
    if (!(named.unit.dimension == units::length))
      throw InputError{quoted(header[i]) + " names no length; allowed: a header such as " +
                       wish.distance + "_m"};
    return Positions{i, named.unit.si};
  }
  if (!wish.spacing)
    throw InputError{"file \"" + wish.file.string() + "\": no " + quoted(wish.distance) +
                     "; there are: " + there +
                     "; allowed: a column of positions (--distance) or --spacing, such as 1ft"};
  return std::nullopt;
}

}  // namespace

std::unique_ptr<const RecordStream> read_record(const RecordFile& wish, const RecordSink& sink) {
  table::CsvReader reader{wish.file};
  const std::size_t column = reader.column(wish.column);
  const double metre = metres_of_height(wish, reader.header()[column]);
  const auto positions = positions_of(wish, reader);
  std::unique_ptr<RecordStream> record;
  record = std::make_unique<RecordStream>(
      RecordOptions{.spacing = wish.spacing,
                    .bridge = wish.bridge.value_or(0),
                    .bridge_length = wish.bridge ? 0 : bridged_length},
      [&](std::span<const double> piece) { sink(piece, record->spacing()); });
  std::vector<std::string> cells;
  while (reader.next(cells)) {
    const double value = reader.number(cells, column) * metre;
    if (positions)
      record->add(reader.number(cells, positions->column) * positions->metre, value);
    else
      record->add(value);
  }
  record->finish();
  return record;
}

}  // namespace railbook::spectra
