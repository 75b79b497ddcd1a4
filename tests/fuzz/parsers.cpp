// Everything that reads what people and recorders write, on any bytes: it gives an answer or
// refuses with InputError or OutsideError, and nothing else. The first byte says which parser.
// Built by fuzz.sh with libFuzzer; by ctest with replay.cpp.
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <railbook/files/outside.hpp>
#include <railbook/profiles/field_profile.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/tool/detail/toml.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/quantity.hpp>

#include "quality/limits_file.hpp"
#include "support/workbook.hpp"

using namespace railbook;

namespace {

void wrong(const char* what) {
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

// A file of these bytes, gone with the object.
class Held {
 public:
  explicit Held(std::string_view bytes) : file_(memfd_create("fuzz", 0)) {
    for (std::size_t done = 0; done < bytes.size();) {
      const auto n = write(file_, bytes.data() + done, bytes.size() - done);
      if (n <= 0) wrong("memory file");
      done += static_cast<std::size_t>(n);
    }
    lseek(file_, 0, SEEK_SET);
  }
  ~Held() { close(file_); }
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;
  std::string name() const { return "/proc/self/fd/" + std::to_string(file_); }

 private:
  int file_;
};

// The first and the last column of a table, cell by cell or so many rows at once, and the refusal
// that ends it.
std::string numbers_of(std::string_view bytes, std::size_t at_once) {
  const Held file(bytes);
  std::string told;
  try {
    table::CsvReader reader(file.name());
    std::vector<std::size_t> columns{0};
    if (reader.header().size() > 1) columns.push_back(reader.header().size() - 1);
    std::vector<double> values(columns.size() * std::max<std::size_t>(at_once, 1));
    const std::size_t room = values.size() / columns.size();
    while (true) {
      std::size_t rows = at_once > 0 ? reader.numbers(columns, values) : 0;
      if (rows == 0) {
        if (!reader.next()) break;
        for (std::size_t i = 0; i < columns.size(); ++i)
          values[i * room] = reader.number(columns[i]);
        rows = 1;
      }
      for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t i = 0; i < columns.size(); ++i)
          told += table::csv_number(values[i * room + row], 17) + " ";
    }
  } catch (const InputError& error) {
    const std::string_view why = error.what();
    told += why.substr(std::min(why.find("line"), why.size()));  // without the file's name
  }
  return told;
}

void parse(int which, std::string_view bytes) {
  switch (which) {
    case 0:
      if (std::isnan(units::parse_quantity("length", bytes, units::length)))
        wrong("a quantity that is no number was taken");
      break;
    case 1:
      if (!(units::parse_unit(bytes).si > 0)) wrong("a unit that is not positive");
      break;
    case 2:
      static_cast<void>(table::parse_column(bytes));
      break;
    case 3:
      static_cast<void>(units::parse_header(bytes));
      break;
    case 4: {
      const Held file(bytes);
      static_cast<void>(table::read_table(file.name()));
      break;
    }
    case 5: {
      if (numbers_of(bytes, 0) != numbers_of(bytes, 3)) wrong("rows read at once are others");
      break;
    }
    case 6: {
      const Held file(bytes);
      static_cast<void>(tool::read_toml(file.name()));
      break;
    }
    case 8:
    case 9: {
      using profiles::Body;
      const Body body = which == 8 ? Body::wheel : Body::rail;
      const std::optional<long> second = bytes.size() % 2 ? std::nullopt : std::optional{2L};
      if (auto read = profiles::parse_field_profile(bytes, body, {.section = second}))
        static_cast<void>(profiles::check_points(std::move(read->points), body));
      break;
    }
    case 'y': {  // a sheet, and behind a zero byte the texts that it shares
      const std::size_t end = std::min(bytes.find('\0'), bytes.size());
      const std::string strings{bytes.substr(std::min(end + 1, bytes.size()))};
      const Held file(workbook::zipped(workbook::book(std::string{bytes.substr(0, end)}, strings)));
      static_cast<void>(table::read_table(file.name()));
      break;
    }
    case 'l': {
      const Held file(bytes);
      for (const quality_tool::Limit& limit : quality_tool::read_limits(file.name(), {}, 25.0))
        if (!(limit.low < limit.high)) wrong("a limit that nothing keeps");
      break;
    }
    case 'e':  // the first line is an encoding, or a data set: the program that reads it may fail
    case 'h': {
      const std::size_t end = std::min(bytes.find('\n'), bytes.size());
      const std::string first{bytes.substr(0, end)};
      const Held file(bytes.substr(std::min(end + 1, bytes.size())));
      table::TextOptions options{.header_lines = 1 + bytes.size() % 2};
      if (which == 'h') options = {.dataset = first};
      if (which == 'e') options.encoding = first;
      table::CsvReader reader(file.name(), options);
      while (reader.next()) {
      }
      break;
    }
    default: {  // what is written is read as it was
      const std::string cell = table::csv_cell(bytes);
      const std::string text(bytes);
      if (text.find_first_of(std::string("\r\n\0", 3)) != std::string::npos) return;
      const Held file("a,b\n" + cell + ",1\n");
      table::CsvReader reader(file.name());
      if (!reader.next() || reader.cell(0) != text) wrong("a cell came back as another");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  try {
    const char first = static_cast<char>(data[0]);
    const bool letter = first == 'y' || first == 'e' || first == 'h' || first == 'l';
    parse(letter                         ? first
          : first == '8' || first == '9' ? first - '0'
                                         : data[0] % 8,
          {reinterpret_cast<const char*>(data) + 1, size - 1});
  } catch (const InputError&) {
  } catch (const files::OutsideError&) {
  }
  return 0;
}
