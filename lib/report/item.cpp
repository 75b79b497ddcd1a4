#include "report/item.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "files/out_file.hpp"
#include "plot/plot.hpp"

namespace railbook::report {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A computed value beside its printed text: two digits more than the paper gives.
std::string show(std::string_view printed, double computed) {
  if (!std::isfinite(computed)) return table::csv_number(computed);
  const double digit = 2 * half_last_digit(printed);
  const double size = std::max(std::abs(computed), std::abs(printed_number(printed)));
  if (!(size > 0) || !(digit > 0)) return fmt::format("{:.6g}", computed);
  const int digits =
      static_cast<int>(std::floor(std::log10(size)) - std::round(std::log10(digit))) + 3;
  return fmt::format("{:.{}g}", computed, std::clamp(digits, 3, 15));
}

bool one_of(std::string_view text, std::initializer_list<std::string_view> allowed) {
  return std::find(allowed.begin(), allowed.end(), text) != allowed.end();
}

}  // namespace

Data::Data(std::string file, const std::vector<std::string>& columns)
    : file_(std::move(file)), columns_(columns.size()) {
  for (const std::string& column : columns)
    text_ += (text_.empty() ? "" : ",") + table::csv_cell(column);
  text_ += "\n";
}

void Data::add_row(std::initializer_list<std::string> cells) {
  if (cells.size() != columns_)
    throw std::logic_error{
        fmt::format("{}: {} cells for {} columns", file_, cells.size(), columns_)};
  bool first = true;
  for (const std::string& cell : cells) {
    if (!first) text_ += ',';
    text_ += cell;
    first = false;
  }
  text_ += '\n';
}

Data& Data::holds_to(std::string_view column, double relative, double absolute,
                     std::string_view why) {
  if (why.empty()) throw std::logic_error{file_ + ": an accuracy without a reason"};
  notes_ += fmt::format("# holds to relative {:g}, absolute {:g} in {}: {}\n", relative, absolute,
                        column, why);
  return *this;
}

Data& Data::not_compared(std::string_view why) {
  if (why.empty()) throw std::logic_error{file_ + ": not compared, without a reason"};
  notes_ += fmt::format("# not compared: {}\n", why);
  return *this;
}

void Row::check(std::string_view column, double computed, const Tolerance& tolerance) const {
  const auto optional = [&](std::string_view name) {
    const auto& h = table_->header;
    return std::find(h.begin(), h.end(), name) == h.end() ? std::string{} : table_->at(key_, name);
  };
  const std::string what = optional("what");
  item_->check(fmt::format("{}-{}", key_, column),
               fmt::format("{}, {}", what.empty() ? key_ : what, column), optional("unit"),
               printed(column), computed, tolerance);
}

Item::Item(std::string id, std::string kind, std::string title, const RunSettings& settings)
    : settings_(settings) {
  record_.id = std::move(id);
  record_.kind = std::move(kind);
  record_.title = std::move(title);
}

table::CsvTable Item::printed(std::string_view file) const {
  return table::read_table(settings_.sources / "data" / file);
}

void Item::check(std::string_view id, std::string_view what, std::string_view unit,
                 std::string_view printed, double computed, const Tolerance& tolerance) {
  if (settings_.bite) computed = bitten(printed, computed, tolerance);
  const Verdict verdict = compare(printed, computed, tolerance);
  CheckRecord c;
  c.id = fmt::format("{}/{}", record_.id, id);
  c.item = record_.id;
  c.what = what;
  c.unit = unit;
  c.printed = printed;
  c.computed = computed;
  c.computed_text = show(printed, computed);
  c.allowed = verdict.allowed;
  c.error = verdict.error;
  c.kind = name(tolerance.kind);
  c.why = tolerance.why;
  c.pass = verdict.pass;
  checks_.push_back(std::move(c));
}

void Item::check_text(std::string_view id, std::string_view what, std::string_view printed,
                      std::string_view computed) {
  CheckRecord c;
  c.id = fmt::format("{}/{}", record_.id, id);
  c.item = record_.id;
  c.what = what;
  c.printed = printed;
  c.computed = nan;
  c.computed_text = settings_.bite ? "not " + std::string{computed} : std::string{computed};
  c.kind = name(ToleranceKind::exact);
  c.pass = c.printed == c.computed_text;
  c.error = c.pass ? 0 : 1;
  checks_.push_back(std::move(c));
}

void Item::agree(std::string_view id, std::string_view what, std::string_view unit, double computed,
                 double reference, double allowed, const std::string& method) {
  Tolerance t{ToleranceKind::agrees_with, allowed, "against " + method};
  // The reference is a number of ours, not a printed text: written with all its digits.
  check(id, what, unit, fmt::format("{:.17g}", reference), computed, t);
  checks_.back().printed = fmt::format("{:.10g}", reference);
  const double shown = checks_.back().computed;
  checks_.back().computed_text =
      std::isfinite(shown) ? fmt::format("{:.10g}", shown) : table::csv_number(shown);
}

void Item::value(std::string_view id, double number, std::string_view unit,
                 std::string_view format) {
  std::string text =
      std::isnan(number) ? "NaN" : fmt::format(fmt::runtime(format), number);  // fmt compares NaNs
  if (!unit.empty()) text += " " + std::string{unit};
  values_.push_back({std::string{id}, std::move(text), number, std::string{unit}});
}

void Item::value(std::string_view id, std::string_view text) {
  values_.push_back({std::string{id}, std::string{text}, nan, ""});
}

void Item::columns(std::vector<std::string> headings) {
  record_.columns = std::move(headings);
}

void Item::add_row(std::vector<std::string> cells) {
  if (cells.size() != record_.columns.size())
    throw std::logic_error{fmt::format("{}: {} cells for {} columns", record_.id, cells.size(),
                                       record_.columns.size())};
  record_.rows.push_back(std::move(cells));
}

Data& Item::data(std::string_view name, const std::vector<std::string>& columns) {
  const std::string file =
      name.empty() ? record_.id + ".csv" : fmt::format("{}-{}.csv", record_.id, name);
  data_.push_back(std::make_unique<Data>(file, columns));
  return *data_.back();
}

void Item::declare(std::string verdict, std::string why) {
  if (why.empty()) throw std::logic_error{record_.id + ": " + verdict + " without a reason"};
  record_.verdict = std::move(verdict);
  record_.reason = std::move(why);
}

void Item::add(std::vector<WorkPrecision> points) {
  work_precision_.insert(work_precision_.end(), points.begin(), points.end());
}

void Item::stability(std::string_view id, std::string_view case_, std::string_view stress,
                     std::string_view result, double error, std::string_view status) {
  if (!one_of(status, {"holds", "refused", "degraded", "fails"}))
    throw std::logic_error{fmt::format("stability case {}: status \"{}\"", id, status)};
  stability_.push_back({std::string{id}, std::string{case_}, std::string{stress},
                        std::string{result}, error, std::string{status}});
}

void Item::draw() {
  std::vector<std::filesystem::path> files;
  for (const auto& data : data_) {
    files.push_back(settings_.results / data->file());
    files::write(files.back(), data->text());
    record_.csv.push_back(data->file());
  }
  if (record_.kind != "figure") return;
  if (!image_ && script_.empty()) script_ = record_.id + ".gp";
  if (!script_.empty()) record_.script = script_.filename().string();
  if (!settings_.draw) return;
  record_.png = record_.id + ".png";
  const std::filesystem::path png = settings_.figures / record_.png;
  if (image_) {
    image_(png);
  } else {
    plot::render(script_.is_absolute() ? script_ : settings_.sources / script_, files, png);
  }
}

void Item::settle() {
  const auto fail_as = [&](const std::string& why) {
    record_.verdict = "failed";
    record_.reason = why;
  };
  const bool reconstructed = record_.verdict == "reconstructed";
  std::size_t failed = 0;
  bool plain = true;
  for (CheckRecord& c : checks_) {
    failed += c.pass ? 0 : 1;
    const bool to_print = one_of(c.kind, {"last_digit", "exact", "at_most", "at_least"});
    plain = plain && to_print;
    if (!c.pass) {
      c.status = "failed";
    } else if (c.kind == "misprint") {
      c.status = "misprint";
    } else if (reconstructed) {
      c.status = "reconstructed";
    } else {
      c.status = to_print ? "reproduced" : "explained";
    }
  }
  if (expected_checks_ != static_cast<int>(checks_.size()) &&
      !(expected_checks_ < 0 && checks_.empty())) {
    fail_as(
        fmt::format("{} checks made, {} announced", checks_.size(), std::max(expected_checks_, 0)));
  } else if (failed > 0) {
    fail_as(fmt::format("{} of {} checks failed", failed, checks_.size()));
  } else if (record_.verdict.empty() && checks_.empty()) {
    fail_as("no check, and not declared explained, reconstructed, a sketch or not reproducible");
  } else if (record_.verdict.empty()) {
    record_.verdict = plain ? "reproduced" : "explained";
  }
}

void Item::finish(ChapterRecord& record) {
  draw();
  settle();
  const auto move_all = [](auto& from, auto& to) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  move_all(checks_, record.checks);
  move_all(values_, record.values);
  move_all(work_precision_, record.work_precision);
  move_all(stability_, record.stability);
  record.items.push_back(std::move(record_));
}

void Item::fail(std::string why, ChapterRecord& record) {
  record_.verdict = "failed";
  record_.reason = std::move(why);
  record_.png.clear();
  record.items.push_back(std::move(record_));
}

}  // namespace railbook::report
