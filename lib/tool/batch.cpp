#include <railbook/tool/batch.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include <railbook/files/outside.hpp>
#include <railbook/num/parallel.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/tool/digits.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/tool/progress.hpp>
#include <railbook/tool/session.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::tool {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::vector<fs::path> records_of(const RecordFiles& records) {
  std::vector<fs::path> files = records.files;
  if (records.manifest) {
    table::LineSource lines{*records.manifest};
    for (std::string line; lines.next(line);) {
      if (line.ends_with('\r')) line.pop_back();
      if (line.empty() || line.starts_with('#')) continue;
      if (line.find('\0') != std::string::npos)
        throw InputError{fmt::format("file {}, line {}: holds a zero byte: no list of files",
                                     files::quoted_name(*records.manifest), lines.line())};
      files.push_back(fs::path(line).is_absolute() || *records.manifest == "-"
                          ? fs::path(line)
                          : records.manifest->parent_path() / line);
    }
  }
  if (files.empty()) throw InputError{"there is no record; allowed: files, or --manifest"};
  std::set<fs::path> seen;
  for (const fs::path& file : files)
    if (!seen.insert(file).second)
      throw InputError{fmt::format("record {} is named twice", files::quoted_name(file))};
  return files;
}

// What came of one record: the status and the reason of its rows, and the rows.
struct Answer {
  fs::path record;
  std::string status, reason;
  std::vector<Json> rows;
};

// Status and reason where the row has its own, and its cells.
Json json_of(const Row& row) {
  Json json = Json::object();
  if (row.refused())
    json = {{"status", "refused"}, {"reason", units::printable(*row.refused(), 1000)}};
  for (const Row::Cell& cell : row.cells()) {
    if (cell.is_text)
      json[cell.key] = cell.text;
    else
      json[cell.key] = std::isfinite(cell.value) ? Json(cell.value) : Json(nullptr);
  }
  return json;
}

Answer answer(const fs::path& record, const RecordRows& work) {
  Answer a{record, "ok", "", {}};
  std::optional<std::string> row_refused;
  try {
    for (const Row& row : work(record)) {
      a.rows.push_back(json_of(row));
      if (!row_refused) row_refused = row.refused();
    }
  } catch (const InputError& error) {
    a.status = "refused", a.reason = error.what();
  } catch (const std::bad_alloc&) {
    a.status = "failed", a.reason = "not enough memory";
  } catch (const files::ClosedPipe&) {
    throw;
  } catch (const std::exception& error) {
    a.status = "failed", a.reason = error.what();
  }
  a.reason = units::printable(a.reason, 1000);
  if (a.status != "ok") a.rows.assign(1, Json::object());
  for (Json& row : a.rows) {
    Json whole{{"record", record.string()}, {"status", a.status}, {"reason", a.reason}};
    whole.update(row);
    row = std::move(whole);
  }
  if (row_refused) a.status = "refused", a.reason = units::printable(*row_refused, 1000);
  return a;
}

std::string lines_of(const Answer& a) {
  std::string text;
  for (const Json& row : a.rows)
    text += row.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  return text;
}

std::string csv_cell(const Json& value) {
  if (value.is_string()) return table::csv_cell(value.get<std::string>());
  if (value.is_number()) return table::csv_number(value.get<double>());
  return "";
}

// All rows with the columns of all.
std::string csv_of(const std::vector<Answer>& answers) {
  std::vector<std::string> columns;
  std::set<std::string> known;
  for (const Answer& a : answers)
    for (const Json& row : a.rows)
      for (const auto& item : row.items())
        if (known.insert(item.key()).second) columns.push_back(item.key());
  const auto join = [&](const auto& cell_of) {
    std::string line;
    for (const std::string& column : columns)
      line += (column == columns.front() ? "" : ",") + cell_of(column);
    return line + "\n";
  };
  std::string text = join([](const std::string& column) { return table::csv_cell(column); });
  for (const Answer& a : answers)
    for (const Json& row : a.rows)
      text += join([&](const std::string& column) {
        return row.contains(column) ? csv_cell(row[column]) : std::string{};
      });
  return text;
}

// How many records came to an end with this status, and the reason of the first.
struct Tally {
  std::size_t count = 0;
  std::string first;
};

Tally tally(const std::vector<Answer>& answers, std::string_view status) {
  Tally t;
  for (const Answer& a : answers)
    if (a.status == status && t.count++ == 0)
      t.first = fmt::format("{}: {}", files::quoted_name(a.record), a.reason);
  return t;
}

// "class 5, A_m2_cycle_per_m 2e-07": the first numbers of a row but for those that say where it is
// and how much of it was read.
std::string numbers_of(const Json& row) {
  static const std::set<std::string> aside{"from_m",  "to_m",    "spacing_m", "samples",
                                           "missing", "bridged", "faulty"};
  constexpr int most = 40;
  std::string text;
  int count = 0;
  for (const auto& item : row.items())
    if (item.value().is_number() && !aside.contains(item.key()) && ++count <= most)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", item.key(),
                          to_text(item.value().get<double>()));
  if (count > most) text += fmt::format(", and {} more", count - most);
  return text;
}

void print(const std::vector<Answer>& answers, const std::string& name) {
  Summary summary{fmt::format("{} of {} records", name, answers.size())};
  std::size_t rows = 0;
  for (const Answer& a : answers) rows += a.rows.size();
  const auto add = [&](const char* key, std::size_t count, const char* what) {
    summary.add(key, what, static_cast<double>(count), "");
  };
  for (const char* status : {"refused", "failed"})
    if (const Tally t = tally(answers, status); t.count > 0)
      summary.warn(status, fmt::format("{} of {} records {}; their rows say why", t.count,
                                       answers.size(), status));
  std::size_t warned = 0;
  std::set<std::string> warnings;
  for (const Answer& a : answers)
    for (const Json& row : a.rows)
      if (const std::string keys = row.value("warnings", ""); !keys.empty())
        ++warned, warnings.insert(keys);
  if (warned > 0)
    summary.warn("rows", fmt::format("{} of {} rows have warnings ({})", warned, rows,
                                     fmt::join(warnings, "; ")));
  add("records", answers.size(), "records");
  add("answered", tally(answers, "ok").count, "  answered");
  add("refused", tally(answers, "refused").count, "  refused");
  add("failed", tally(answers, "failed").count, "  failed");
  add("rows", rows, "rows of the table");
  constexpr std::size_t most = 20;
  std::size_t shown = 0;
  for (const Answer& a : answers)
    for (const Json& row : a.rows)
      if (row.value("status", "") == "ok" && row.value("kind", "record") == "record" &&
          ++shown <= most)
        summary.add(fmt::format("row_{}", shown),
                    files::quoted_name(a.record) +
                        (row.contains("column") ? ", " + row.value("column", "") : std::string{}),
                    numbers_of(row));
  if (shown > most) summary.add("more", "  and more", fmt::format("{} rows", shown - most));
  summary.print();
}

}  // namespace

bool RecordFiles::many() const {
  return files.size() > 1 || manifest;
}

const std::filesystem::path& RecordFiles::only() const {
  if (files.empty()) throw InputError{"there is no record; allowed: a file, or --manifest"};
  return files.front();
}

Row row_of(const Summary& answer) {
  const Json json = Json::parse(answer.json());
  Row row;
  for (const auto& item : json.at("values").items()) {
    const Json& value = item.value();
    if (value.is_string())
      row.add(item.key(), value.get<std::string>());
    else
      row.add(item.key(), value.is_number() ? value.get<double>() : units::nan);
    if (const Json& errors = json.at("errors"); errors.contains(item.key())) {
      const Json& error = errors.at(item.key());
      row.add(item.key() + "_error", error.is_number() ? error.get<double>() : units::nan);
    }
  }
  for (const auto& item : json.at("warnings").items()) row.warn(item.key());
  return row;
}

void run_batch(const RecordFiles& given, const Destination& out, const std::string& name,
               const RecordRows& rows, int threads) {
  if (out.figure) throw InputError{"figure is given with many records; allowed: with one"};
  const std::vector<fs::path> records = records_of(given);
  OutFolder folder(out, {name + "-table.csv", name + "-table.jsonl"});
  std::vector<Answer> answers;
  Progress progress("records", static_cast<double>(records.size()));
  answers.reserve(records.size());
  // Some at once for each thread, since they take unlike times.
  const std::size_t at_once = threads > 1 ? 16 * static_cast<std::size_t>(threads) : 1;
  while (answers.size() < records.size()) {
    const std::size_t first = answers.size(), count = std::min(at_once, records.size() - first);
    for (Answer& one : num::map_in_parallel(
             count, [&](std::size_t k) { return answer(records[first + k], rows); }, threads)) {
      answers.push_back(std::move(one));
      if (session().json) {
        fmt::print("{}", lines_of(answers.back()));
        files::flush_standard_output();
      }
      progress.step();
    }
  }
  progress.end();
  if (!session().json) print(answers, name);
  if (folder) {
    std::string lines;
    for (const Answer& a : answers) lines += lines_of(a);
    folder.add(name + "-table.csv", csv_of(answers));
    folder.add(name + "-table.jsonl", lines);
    folder.commit();
  }
  const auto not_all = [&](const Tally& t, const char* what) {
    return fmt::format("{} of {} records {}; the first: {}", t.count, records.size(), what,
                       t.first);
  };
  if (const Tally t = tally(answers, "failed"); t.count > 0)
    throw files::OutsideError{not_all(t, "failed")};
  if (const Tally t = tally(answers, "refused"); t.count > 0)
    throw InputError{not_all(t, "refused")};
}

}  // namespace railbook::tool
