#include <railbook/report/item.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <system_error>

#include <railbook/files/out_file.hpp>
#include <railbook/num/stopwatch.hpp>
#include <railbook/plot/packed_picture.hpp>
#include <railbook/plot/plot.hpp>

namespace railbook::report {
namespace {

using units::nan;

// A computed value beside its printed text: two digits more than the paper gives.
std::string show(std::string_view printed, double computed) {
  if (!std::isfinite(computed)) return table::csv_number(computed);
  const double size = std::max(std::abs(computed), std::abs(printed_number(printed)));
  if (size == 0) return "0";
  const int digits = static_cast<int>(std::floor(std::log10(size))) - last_decade(printed) + 3;
  return fmt::format("{:.{}g}", computed, std::clamp(digits, 3, 15));
}

// A computed value beside the text it is compared with, to digits that hold on every machine.
std::string show(std::string_view reference, double computed, const Tolerance& tolerance) {
  if (tolerance.kind != ToleranceKind::at_most && tolerance.kind != ToleranceKind::at_least)
    return show(reference, computed);
  if (!std::isfinite(computed)) return table::csv_number(computed);
  const bool rounding =
      tolerance.kind == ToleranceKind::at_most && std::abs(printed_number(reference)) < 1e-6;
  return rounding ? below(computed) : fmt::format("{:.4g}", computed);
}

TrialRecord record_of(const Trial& trial) {
  TrialRecord record{trial.quantity(), trial.range(), {}};
  for (const Variation& v : trial.variations()) {
    TrialRecord::Varied& varied = record.varied.emplace_back();
    varied.choice = v.choice;
    varied.settings = v.settings;
    varied.range = trial.range_of(v);
    for (const double r : v.results) varied.results.push_back(trial.show(r));
  }
  return record;
}

// A verdict that one of the tried choices reverses does not pass.
void apply(const Trial& trial, CheckRecord& c) {
  c.trial = record_of(trial);
  if (trial.stands()) return;
  c.pass = false;
  c.kind += ", which its trial reverses: " + trial.objection();
}

}  // namespace

std::string below(double error) {
  if (!std::isfinite(error)) return table::csv_number(error);
  if (!(std::abs(error) > 1e-16)) return "below 1e-16";
  return fmt::format("below 1e{:+03d}", static_cast<int>(std::ceil(std::log10(std::abs(error)))));
}

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

Row::About Row::about(std::string_view column) const {
  const auto optional = [&](std::string_view name) {
    const auto& h = table_->header;
    return std::find(h.begin(), h.end(), name) == h.end() ? std::string{} : table_->at(key_, name);
  };
  const std::string what = optional("what");
  const std::string named = what.empty() ? key_ : what;
  return {fmt::format("{}-{}", key_, column),
          column == "printed" ? named : fmt::format("{}, {}", named, column), optional("unit")};
}

void Row::print(std::string_view column, double computed, const Expectation& expectation) const {
  const About a = about(column);
  item_->print(a.id, a.what, a.unit, printed(column), computed, expectation);
}

void Row::publication(std::string_view column, double computed, const Tolerance& tolerance,
                      const std::string& work) const {
  const About a = about(column);
  item_->publication(a.id, a.what, a.unit, printed(column), computed, tolerance, work);
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

CheckRecord& Item::add_check(const About& about, Source source, Outcome outcome) {
  CheckRecord& c = checks_.emplace_back();
  c.id = fmt::format("{}/{}", record_.id, about.id);
  c.item = record_.id;
  c.what = about.what;
  c.unit = about.unit;
  c.source = name(source);
  c.outcome = name(outcome);
  return c;
}

void Item::compare_with(const About& about, std::string_view reference, double computed,
                        Source source, const Expectation& expectation, const std::string& by) {
  const Tolerance& tolerance = expectation.tolerance;
  const Verdict verdict = compare(reference, computed, tolerance);
  CheckRecord& c = add_check(about, source, expectation.outcome);
  c.by = by;
  c.reference = reference;
  c.computed = computed;
  c.computed_text = show(reference, computed, tolerance);
  c.allowed = verdict.allowed;
  c.error = verdict.error;
  c.kind = name(tolerance.kind);
  c.why = tolerance.why;
  c.pass = verdict.pass;
  if (c.pass &&
      compare(reference, beyond_tolerance(reference, computed, tolerance), tolerance).pass) {
    c.pass = false;  // a check that cannot fail checks nothing
    c.kind += ", which passes shifted by twice its tolerance, too";
  }
  if (expectation.trial) {
    apply(*expectation.trial, c);
    // The reader compares the print with the computation, and with what the print's rounding
    // allows.
    const double p = printed_number(reference), scale = p == 0 ? 1 : std::abs(p);
    c.error = std::abs(computed - p) / scale;
    c.allowed = half_last_digit(reference) / scale;
  }
}

void Item::print(std::string_view id, std::string_view what, std::string_view unit,
                 std::string_view printed, double computed, const Expectation& expectation) {
  compare_with({id, what, unit}, printed, computed, Source::print, expectation, "");
}

void Item::publication(std::string_view id, std::string_view what, std::string_view unit,
                       std::string_view reference, double computed, const Tolerance& tolerance,
                       const std::string& work) {
  Expectation expectation{tolerance};
  expectation.outcome = Outcome::verified;
  compare_with({id, what, unit}, reference, computed, Source::publication, expectation, work);
}

void Item::agree(std::string_view id, std::string_view what, std::string_view unit, double computed,
                 double reference, double allowed, const std::string& method) {
  Expectation expectation{Tolerance{ToleranceKind::agrees_with, allowed, "against " + method}};
  expectation.outcome = Outcome::verified;
  // The reference is a number of ours, not a printed text: compared with all its digits, shown with
  // one digit more than are allowed to differ.
  compare_with({id, what, unit}, fmt::format("{:.17g}", reference), computed, Source::route,
               expectation, method);
  const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(allowed))) + 1, 3, 10);
  const auto shown = [&](double x) {
    return std::isfinite(x) ? fmt::format("{:.{}g}", x, digits) : table::csv_number(x);
  };
  checks_.back().reference = shown(reference);
  checks_.back().computed_text = shown(checks_.back().computed);
}

void Item::at_most(std::string_view id, std::string_view what, std::string_view unit,
                   double computed, double bound, const std::string& why) {
  Expectation expectation{report::at_most(why)};
  expectation.outcome = Outcome::verified;
  compare_with({id, what, unit}, fmt::format("{:.10g}", bound), computed, Source::route,
               expectation, why);
}

void Item::at_least(std::string_view id, std::string_view what, std::string_view unit,
                    double computed, double bound, const std::string& why) {
  Expectation expectation{report::at_least(why)};
  expectation.outcome = Outcome::verified;
  compare_with({id, what, unit}, fmt::format("{:.10g}", bound), computed, Source::route,
               expectation, why);
}

void Item::print_text(std::string_view id, std::string_view what, std::string_view printed,
                      std::string_view computed) {
  CheckRecord& c = add_check({id, what, ""}, Source::print, Outcome::confirmed);
  c.reference = printed;
  c.computed = nan;
  c.computed_text = computed;
  c.kind = name(ToleranceKind::exact);
  c.pass = c.reference == c.computed_text;
  c.error = c.pass ? 0 : 1;
}

CheckRecord& Item::judge_claim(std::string_view id, std::string_view what, bool pass,
                               Outcome outcome, std::string measured) {
  CheckRecord& c = add_check({id, what, ""}, Source::claim, outcome);
  c.pass = pass;
  c.computed = nan;
  c.computed_text = measured.empty() ? (pass ? "it does" : "it does not") : std::move(measured);
  c.kind = name(ToleranceKind::exact);
  c.error = c.pass ? 0 : 1;
  return c;
}

Trial Item::trial(std::string_view id, std::string quantity, std::string format,
                  Trial::Expected stands) const {
  const std::string check = fmt::format("{}/{}", record_.id, id);
  std::vector<TrialRow> rows;
  for (const TrialRow& row : settings_.trials)
    if (row.check == check) rows.push_back(row);
  if (rows.empty()) throw std::logic_error{"data/trials.csv has no row of the check " + check};
  return {std::move(quantity), std::move(format), std::move(stands), std::move(rows)};
}

void Item::claims(const std::vector<FoundClaim>& found) {
  for (const FoundClaim& f : found) judge_row(f);
}

void Item::claim_if(std::string_view id, bool it_holds, std::vector<double> numbers) {
  judge_row({id, std::move(numbers)}, it_holds);
}

void Item::judge_row(const FoundClaim& f, std::optional<bool> condition) {
  const std::string check = fmt::format("{}/{}", record_.id, f.id);
  const auto row = std::find_if(settings_.claims.begin(), settings_.claims.end(),
                                [&](const ClaimRow& r) { return r.check == check; });
  if (row == settings_.claims.end())
    throw std::logic_error{"data/claims.csv has no row of the check " + check};
  if (row->holds.empty() && !f.trial && !condition)
    throw std::logic_error{check + ": a claim without a bound and without a trial cannot fail"};
  const bool pass = condition.value_or(true) && holds(*row, f.numbers);
  CheckRecord& c = judge_claim(f.id, row->claim, pass, row->outcome, found_text(*row, f.numbers));
  if (row->outcome == Outcome::verified) {
    c.source = name(Source::route);
    c.by = row->why;
  } else {
    c.why = row->why;
  }
  if (f.trial) apply(*f.trial, c);
  ++checked_claims_;
}

void Item::claim(std::string_view id, std::string_view what, const Trial& trial,
                 std::string measured) {
  apply(trial, judge_claim(id, what, true, Outcome::confirmed, std::move(measured)));
}

void Item::consistent(std::string_view id, std::string_view what, bool it_holds,
                      std::string measured, std::string why) {
  if (why.empty())
    throw std::logic_error{fmt::format("{}: a consistent claim says why it is no more", id)};
  judge_claim(id, what, it_holds, Outcome::consistent, std::move(measured)).why = std::move(why);
}

void Item::consistent(std::string_view id, std::string_view what, const Trial& trial,
                      std::string measured, std::string why) {
  consistent(id, what, true, std::move(measured), std::move(why));
  apply(trial, checks_.back());
}

void Item::verify(std::string_view id, std::string_view what, bool it_holds, std::string measured,
                  const std::string& method) {
  CheckRecord& c = judge_claim(id, what, it_holds, Outcome::verified, std::move(measured));
  c.source = name(Source::route);
  c.by = method;
}

void Item::refute(std::string_view id, std::string_view what, const Trial& trial,
                  std::string instead) {
  if (instead.empty())
    throw std::logic_error{fmt::format("{}: a refuted claim says what holds instead", id)};
  apply(trial, judge_claim(id, what, true, Outcome::not_confirmed, std::move(instead)));
}

void Item::claim(std::string_view id, std::string_view what, bool it_holds, std::string measured) {
  judge_claim(id, what, it_holds, Outcome::confirmed, std::move(measured));
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

void Item::columns(std::vector<Heading> headings) {
  record_.columns.clear();
  formats_.clear();
  for (Heading& heading : headings) {
    record_.columns.push_back(std::move(heading.text));
    formats_.push_back(std::move(heading.format));
  }
}

void Item::add_row(const std::vector<std::string>& cells) {
  if (cells.size() != record_.columns.size())
    throw std::logic_error{fmt::format("{}: {} cells for {} columns", record_.id, cells.size(),
                                       record_.columns.size())};
  record_.rows.push_back(cells);
}

void Item::add_cells(std::initializer_list<Cell> cells) {
  std::vector<std::string> texts;
  for (const Cell& cell : cells) {
    const std::size_t i = texts.size();
    texts.push_back(!cell.is_number || i >= formats_.size() ? cell.text
                    : std::isnan(cell.number)
                        ? "–"
                        : fmt::format(fmt::runtime(formats_[i]), cell.number));
  }
  add_row(texts);
}

Data& Item::data(std::string_view name, const std::vector<std::string>& columns) {
  const std::string file =
      name.empty() ? record_.id + ".csv" : fmt::format("{}-{}.csv", record_.id, name);
  data_.push_back(std::make_unique<Data>(file, columns));
  return *data_.back();
}

void Item::from(std::string input, std::string why) {
  if (why.empty()) throw std::logic_error{record_.id + ": " + input + " without a reason"};
  record_.input = std::move(input);
  record_.reason = std::move(why);
}

void Item::add(std::vector<WorkPrecision> points) {
  work_precision_.insert(work_precision_.end(), points.begin(), points.end());
}

namespace {

std::string_view name(Expected stands) {
  switch (stands) {
    case Expected::accurate:
      return "holds";
    case Expected::degraded:
      return "degrades";
    case Expected::refused:
      return "refused";
  }
  return "";
}

}  // namespace

void Item::stability(const StabilityCase& c, const std::function<Found()>& run) {
  if (c.expect != Expected::refused && !(std::isfinite(c.allowed) && c.allowed > 0))
    throw std::logic_error{fmt::format("stability case {} has no bound of its error", c.id)};
  Stability s{c.id, c.what, c.stress, "", c.reference, nan, c.allowed, std::string{name(c.expect)},
              "",   0,      false};
  const num::Stopwatch watch;
  try {
    const Found found = run();
    s.result = found.text;
    s.error = found.error;
    s.found = c.expect != Expected::refused && std::abs(s.error) <= c.allowed ? s.expect : "fails";
  } catch (const InputError& refusal) {
    s.result = refusal.what();
    s.found = "refused";
  } catch (const NoAnswer& refusal) {
    s.result = refusal.what();
    s.found = "refused";
  } catch (const std::exception& error) {
    s.result = error.what();
    s.found = "fails";
  }
  s.pass = s.found == s.expect;
  s.seconds = settings_.timings ? watch.seconds() : 0;
  stability_.push_back(std::move(s));
}

void Item::draw() {
  const auto announce = [&](const std::filesystem::path& file) {
    if (settings_.folder != nullptr) settings_.folder->announce(file);
  };
  std::vector<std::filesystem::path> files;
  for (const auto& data : data_) {
    files.push_back(settings_.results / data->file());
    announce(files.back());
    files::write(files.back(), data->text());
    record_.csv.push_back(data->file());
  }
  if (record_.kind != "figure") return;
  if (!image_ && script_.empty()) script_ = record_.id + ".gp";
  if (!script_.empty()) record_.script = script_.filename().string();
  if (!settings_.draw) return;
  record_.png = record_.id + ".png";
  const std::filesystem::path png = settings_.figures / record_.png;
  announce(png);
  if (image_) {
    try {
      image_(png);
    } catch (const std::system_error& error) {
      if (error.code() != std::errc::function_not_supported) throw;
      record_.not_drawn = error.what();  // this build has no way to draw it; all else stands
      record_.png.clear();
    }
  } else {
    const auto script = settings_.sources / script_;
    const std::string drawn = plot::draw(script, files), svg = plot::draw_svg(script, files);
    const bool shown = svg.size() > drawn.size();  // a page shows the smaller of the two
    files::write(png, shown ? plot::packed_png(drawn) : drawn);
    if (shown) return;
    const std::filesystem::path beside = settings_.figures / (record_.id + ".svg");
    announce(beside);
    files::write(beside, svg);
  }
}

std::string Item::failure() const {
  const auto count_failed = [](const auto& records) {
    return std::count_if(records.begin(), records.end(), [](const auto& r) { return !r.pass; });
  };
  const auto failed = count_failed(checks_), fallen = count_failed(stability_);
  const auto claimed =
      std::count_if(settings_.claims.begin(), settings_.claims.end(),
                    [&](const ClaimRow& r) { return r.check.starts_with(record_.id + "/"); });
  if (claimed != checked_claims_)
    return fmt::format("{} claims made, data/claims.csv has {}", checked_claims_, claimed);
  const auto others = static_cast<int>(checks_.size()) - checked_claims_;
  if (expected_checks_ != others)
    return fmt::format("{} checks made, {} announced", others, expected_checks_);
  if (failed > 0) return fmt::format("{} of {} checks failed", failed, checks_.size());
  if (fallen > 0) return fmt::format("{} of {} stability cases failed", fallen, stability_.size());
  if (checks_.empty() && stability_.empty() && record_.input == "paper")
    return "no check, and not declared rebuilt, added, a sketch or lost";
  return "";
}

void Item::finish(ChapterRecord& record) {
  draw();
  record_.failure = failure();
  for (CheckRecord& c : checks_)
    if (!c.pass) c.outcome = "failed";
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
  record_.failure = std::move(why);
  record_.png.clear();
  record.items.push_back(std::move(record_));
}

}  // namespace railbook::report
