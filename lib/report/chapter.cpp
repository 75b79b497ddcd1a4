#include "report/chapter.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "files/out_file.hpp"
#include "num/fp_trap.hpp"
#include "num/stopwatch.hpp"
#include "units/input_error.hpp"

namespace railbook::report {
namespace {

template <class Records>
auto count_if(const Records& records, std::string_view verdict) {
  return std::count_if(records.begin(), records.end(),
                       [&](const auto& r) { return r.verdict == verdict; });
}

// "01-contact: 9 reproduced, 3 explained; checks 57/57, worst 93 % of its tolerance; 3.2 s"
std::string summary_line(const ChapterRecord& record) {
  std::string verdicts;
  for (const char* verdict :
       {"reproduced", "explained", "reconstructed", "sketch", "not-reproducible", "failed"}) {
    const auto n = count_if(record.items, verdict);
    if (n > 0) verdicts += fmt::format("{}{} {}", verdicts.empty() ? "" : ", ", n, verdict);
  }
  std::size_t passed = 0;
  double worst = 0;
  for (const CheckRecord& c : record.checks) {
    passed += c.pass ? 1 : 0;
    const bool has_share = c.allowed > 0 && c.kind != "at_most" && c.kind != "at_least";
    if (has_share && std::isfinite(c.error)) worst = std::max(worst, c.error / c.allowed);
  }
  return fmt::format("{}: {}; checks {}/{}, worst {:.0f} % of its tolerance; {:.1f} s",
                     record.chapter, verdicts, passed, record.checks.size(), 100 * worst,
                     record.seconds);
}

void print_failures(const ChapterRecord& record) {
  for (const ItemRecord& item : record.items)
    if (item.verdict == "failed") fmt::print(stderr, "FAILED {}: {}\n", item.id, item.reason);
  for (const CheckRecord& c : record.checks) {
    if (!c.pass) {
      fmt::print(stderr,
                 "  {} ({}): printed {}, computed {} {}; error {:.3g}, allowed {:.3g} ({})\n", c.id,
                 c.what, c.printed, c.computed_text, c.unit, c.error, c.allowed, c.kind);
    }
  }
}

// The bite test passes when no shifted check does.
int judge_bite(const ChapterRecord& record) {
  std::size_t toothless = 0;
  for (const CheckRecord& c : record.checks) {
    if (!c.pass) continue;
    ++toothless;
    fmt::print(stderr, "does not bite: {} (computed {}, kind {})\n", c.id, c.computed_text, c.kind);
  }
  fmt::print("{}: bite test, {} of {} shifted checks fail\n", record.chapter,
             record.checks.size() - toothless, record.checks.size());
  return toothless == 0 && !record.checks.empty() ? 0 : 1;
}

// The folder for what a run writes, before anything is computed.
void make_folder(const std::filesystem::path& folder, bool anew) {
  std::error_code error;
  if (anew) std::filesystem::remove_all(folder, error);
  std::filesystem::create_directories(folder, error);
  if (error)
    throw InputError{
        fmt::format("folder \"{}\": cannot be made: {}", folder.string(), error.message())};
}

}  // namespace

void Chapter::table(std::string id, std::string title, ItemFunction compute) {
  add(std::move(id), "table", std::move(title), std::move(compute));
}
void Chapter::figure(std::string id, std::string title, ItemFunction compute) {
  add(std::move(id), "figure", std::move(title), std::move(compute));
}

void Chapter::add(std::string id, std::string kind, std::string title, ItemFunction compute) {
  const auto same = [&](const Entry& e) { return e.id == id; };
  if (std::any_of(entries_.begin(), entries_.end(), same))
    throw std::logic_error{"item " + id + " is named twice"};
  entries_.push_back({std::move(id), std::move(kind), std::move(title), std::move(compute)});
}

void Chapter::list() const {
  for (const Entry& e : entries_) fmt::print("{:<22} {:<7} {}\n", e.id, e.kind, e.title);
}

int Chapter::reproduce(const Reproduce& wish) const {
  for (const std::string& id : wish.only) {
    if (std::none_of(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.id == id; }))
      throw InputError{
          fmt::format("only is \"{}\"; allowed: a name that `{} list` shows", id, info_.name)};
  }
  const std::filesystem::path out = wish.out;
  RunSettings settings;
  settings.sources = info_.sources;
  settings.results = out / "results" / info_.id;
  settings.figures = out / "figures" / info_.id;
  settings.full = wish.level == "full";
  settings.draw = !wish.no_figures;
  settings.timings = !wish.no_timings;
  settings.bite = wish.bite;

  ChapterRecord record;
  record.chapter = info_.id;
  record.title = info_.title;
  record.paper = info_.paper;
  record.level = wish.level;
  record.only = wish.only;
  const bool anew = wish.only.empty() && !wish.bite;  // then nothing of an earlier run may remain
  make_folder(settings.results, anew);
  make_folder(settings.figures, anew);
  const num::Stopwatch total;
  for (const Entry& e : entries_) {
    if (!wish.only.empty() &&
        std::find(wish.only.begin(), wish.only.end(), e.id) == wish.only.end())
      continue;
    const num::Stopwatch one;
    Item item{e.id, e.kind, e.title, settings};
    try {
      {
        const num::FpTraps traps;
        e.compute(item);
      }
      item.finish(record);
    } catch (const std::exception& error) {
      item.fail(error.what(), record);
    }
    record.items.back().seconds = wish.no_timings ? 0 : one.seconds();
  }
  record.seconds = wish.no_timings ? 0 : total.seconds();
  if (wish.bite) return judge_bite(record);

  files::write(settings.results / "checks.csv", checks_csv(record));
  write_record(record, out / "results" / (info_.id + ".json"));
  const std::string summary = summary_line(record);
  files::write(out / "results" / (info_.id + ".txt"), summary + "\n");
  print_failures(record);
  fmt::print("{}\n", summary);
  const bool good = count_if(record.items, "failed") == 0 && !record.items.empty();
  return good ? 0 : 1;
}

int Chapter::run(int argc, char** argv) {
  CLI::App app{fmt::format("{}: {}", info_.name, info_.title), info_.name};
  app.require_subcommand(1);

  Reproduce wish;
  wish.out = RAILBOOK_BUILD_DIR;
  CLI::App* reproduce_command =
      app.add_subcommand("reproduce", "recompute the paper's tables and figures and check them");
  reproduce_command->add_option("--only", wish.only, "only these items (see list)")->delimiter(',');
  reproduce_command
      ->add_option("--level", wish.level, "quick, or full: longer Monte Carlo, finer references")
      ->check(CLI::IsMember({"quick", "full"}))
      ->capture_default_str();
  reproduce_command->add_option("--out", wish.out, "folder for results/ and figures/")
      ->capture_default_str();
  reproduce_command->add_flag("--no-figures", wish.no_figures, "do not draw");
  reproduce_command->add_flag("--no-timings", wish.no_timings,
                              "measure no time: the same record on every run");
  reproduce_command->add_flag(
      "--bite", wish.bite,
      "shift every computed value by twice its tolerance: every check must fail");
  CLI::App* list_command = app.add_subcommand("list", "name the tables and figures");

  try {
    app.parse(argc, argv);
    if (*reproduce_command) return reproduce(wish);
    if (*list_command) list();
    return 0;
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::CallForAllHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "{}: {}\nTry `{} --help`.\n", info_.name, error.what(), info_.name);
    return 2;
  } catch (const InputError& error) {
    fmt::print(stderr, "{}: {}\n", info_.name, error.what());
    return 2;
  } catch (const files::OutsideError& error) {
    return files::report(info_.name, error);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", info_.name, error.what());
    return 1;
  }
}

}  // namespace railbook::report
