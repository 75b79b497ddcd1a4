#include <railbook/report/chapter.hpp>

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cfenv>
#include <cstdio>
#include <stdexcept>
#include <system_error>

#include <railbook/files/out_file.hpp>
#include <railbook/num/fp_flags.hpp>
#include <railbook/num/stopwatch.hpp>
#include <railbook/plot/plot.hpp>
#include <railbook/report/detail/inventory.hpp>
#include <railbook/report/run_folder.hpp>
#include <railbook/report/timing_lock.hpp>
#include <railbook/report/trial.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::report {
namespace {

struct PagedEntry {
  const Entry* entry;
  const char* page;
  std::string title = entry->title;
};

struct ReproduceOptions {
  std::vector<std::string> only;
  std::string level = "quick";
  std::string out = RAILBOOK_BUILD_DIR;
  bool no_figures = false;
  bool no_timings = false;
  std::string rounding = "nearest";
};

// The rounding of all arithmetic of this thread, and of those that it makes.
void round(const std::string& mode) {
  const int to = mode == "up" ? FE_UPWARD : mode == "down" ? FE_DOWNWARD : FE_TOWARDZERO;
  if (mode != "nearest" && std::fesetround(to) != 0)
    throw std::runtime_error{fmt::format("this processor does not round {}", mode)};
}

bool contains(const std::vector<std::string>& list, const std::string& text) {
  return std::find(list.begin(), list.end(), text) != list.end();
}

bool all_good(const ChapterRecord& record) {
  return !record.items.empty() && record.problems.empty() &&
         std::ranges::all_of(record.items, &std::string::empty, &ItemRecord::failure);
}

// "01-contact: of the paper 12 confirmed, 3 corrected; 21 verified; stability 14/14; checks
// 57/57; 3.2 s"
std::string summary_line(const ChapterRecord& record) {
  std::string outcomes;
  for (const char* outcome : {"confirmed", "consistent", "fitted", "corrected", "restored",
                              "not confirmed", "verified", "failed"}) {
    const auto n = std::count_if(record.checks.begin(), record.checks.end(),
                                 [&](const CheckRecord& c) { return c.outcome == outcome; });
    if (n > 0) outcomes += fmt::format("{}{} {}", outcomes.empty() ? "" : ", ", n, outcome);
  }
  const auto passed = [](const auto& records) {
    const auto n =
        std::count_if(records.begin(), records.end(), [](const auto& r) { return r.pass; });
    return fmt::format("{}/{}", n, records.size());
  };
  return fmt::format("{}: {}; checks {}, stability {}; {:.1f} s", record.chapter,
                     outcomes.empty() ? "no checks" : outcomes, passed(record.checks),
                     passed(record.stability), record.seconds);
}

void print_failures(const ChapterRecord& record) {
  for (const ItemRecord& item : record.items)
    if (!item.failure.empty()) fmt::print(stderr, "FAILED {}: {}\n", item.id, item.failure);
  for (const CheckRecord& c : record.checks) {
    if (c.pass) continue;
    fmt::print(stderr, "  {} ({}): {} {}, computed {} {}; error {:.3g}, allowed {:.3g} ({})\n",
               c.id, c.what, c.source, c.reference, c.computed_text, c.unit, c.error, c.allowed,
               c.kind);
  }
  for (const Stability& s : record.stability) {
    if (s.pass) continue;
    fmt::print(stderr,
               "  stability {} ({}): expected {}, found {}: {}; error {:.3g}, allowed {:.3g}\n",
               s.id, s.case_, s.expect, s.found, s.result, s.error, s.allowed);
  }
  for (const std::string& problem : record.problems)
    fmt::print(stderr, "  inventory: {}\n", problem);
}

std::vector<PagedEntry> in_order(const std::vector<Section>& paper,
                                 const std::vector<Section>& study) {
  std::vector<PagedEntry> all;
  const auto add = [&](const std::vector<Section>& sections, const char* page) {
    for (const Section& section : sections)
      for (const Entry& entry : section) {
        if (std::any_of(all.begin(), all.end(),
                        [&](const PagedEntry& e) { return e.entry->id == entry.id; }))
          throw std::logic_error{"item " + entry.id + " is named twice"};
        all.push_back({&entry, page});
      }
  };
  add(paper, "paper");
  add(study, "study");
  return all;
}

// Gives the entries that have no title of their own the caption of data/captions.csv. Throws
// InputError unless each of these has one row there, and no other item has any.
void read_captions(const std::filesystem::path& sources, std::vector<PagedEntry>& entries) {
  const std::filesystem::path file = sources / "data" / "captions.csv";
  if (std::filesystem::exists(file)) {
    const table::CsvTable captions = table::read_table(file);
    for (std::size_t row = 0; row < captions.rows.size(); ++row) {
      const std::string &id = captions.at(row, "item"), &caption = captions.at(row, "caption");
      const auto e = std::ranges::find_if(
          entries, [&](const PagedEntry& entry) { return entry.entry->id == id; });
      if (e == entries.end() || !e->title.empty())
        throw InputError{fmt::format(
            "file \"{}\", row {}: item is \"{}\"; allowed: an item of the chapter, once",
            file.string(), row + 1, id)};
      e->title = caption;
    }
  }
  for (const PagedEntry& e : entries)
    if (e.title.empty())
      throw InputError{
          fmt::format("file \"{}\": item {} has no caption", file.string(), e.entry->id)};
}

// Whether the world outside let it: a figure that gnuplot does not draw fails its item, a disk that
// is full ends the run.
bool compute(const PagedEntry& e, const RunSettings& settings, ChapterRecord& record) {
  bool let = true;
  const WorkSlot work;
  const num::Stopwatch watch;
  const double waited = seconds_waited();
  Item item{e.entry->id, e.entry->kind, e.title, settings};
  try {
    {
      const num::FpFlags flags;
      e.entry->compute(item);
      if (!flags.raised().empty())
        throw std::runtime_error{fmt::format("{} in its arithmetic", flags.raised())};
    }
    item.finish(record);
  } catch (const plot::PlotError& error) {
    let = false;
    item.fail(error.what(), record);
  } catch (const files::OutsideError&) {
    throw;
  } catch (const std::exception& error) {
    item.fail(error.what(), record);
  }
  record.items.back().page = e.page;
  record.items.back().seconds =
      settings.timings ? watch.seconds() - (seconds_waited() - waited) : 0;
  return let;
}

// What the chapter declares to vary and to claim, refused before anything is computed if it is not
// of the form.
template <class Row>
std::vector<Row> declared(const ChapterInfo& info, const char* name,
                          const std::vector<PagedEntry>& entries,
                          std::vector<Row> read(const std::filesystem::path&,
                                                const std::vector<std::string>&)) {
  const std::filesystem::path file = info.sources / "data" / name;
  if (!std::filesystem::exists(file)) return {};
  std::vector<std::string> items;
  items.reserve(entries.size());
  for (const PagedEntry& e : entries) items.push_back(e.entry->id);
  return read(file, items);
}

// Declared trials whose check is not there, or carries no trial.
std::vector<std::string> unused(const std::vector<TrialRow>& trials, const ChapterRecord& record) {
  std::vector<std::string> problems;
  for (const TrialRow& row : trials)
    if (std::none_of(record.checks.begin(), record.checks.end(), [&](const CheckRecord& c) {
          return c.id == row.check && !c.trial.varied.empty();
        }))
      problems.push_back(
          fmt::format("data/trials.csv: no check {} varies \"{}\"", row.check, row.choice));
  return problems;
}

int reproduce(const ReproduceOptions& options, const ChapterInfo& info,
              const std::vector<PagedEntry>& entries) {
  for (const std::string& id : options.only) {
    if (std::none_of(entries.begin(), entries.end(),
                     [&](const PagedEntry& e) { return e.entry->id == id; }))
      throw InputError{
          fmt::format("only is \"{}\"; allowed: a name that `{} list` shows", id, info.name)};
  }
  const bool whole = options.only.empty();
  const std::vector<TrialRow> trials = declared(info, "trials.csv", entries, read_trials);
  round(options.rounding);
  const std::filesystem::path out = options.out;
  RunFolder folder(options.rounding == "nearest" ? out : out / ("rounding-" + options.rounding),
                   info.id, whole);
  folder.forget_record();
  share_machine(folder.record().parent_path());
  RunSettings settings;
  settings.folder = &folder;
  settings.sources = info.sources;
  settings.results = folder.results();
  settings.figures = folder.figures();
  settings.full = options.level == "full";
  settings.draw = !options.no_figures;
  settings.timings = !options.no_timings;
  settings.trials = trials;
  settings.claims = declared(info, "claims.csv", entries, read_claims);

  ChapterRecord record;
  record.chapter = info.id;
  record.title = info.title;
  record.paper = info.paper;
  record.doi = info.doi;
  record.level = options.level;
  record.only = options.only;
  const num::Stopwatch watch;
  const double waited = seconds_waited();
  bool let = true;
  for (const PagedEntry& e : entries) {
    if (!whole && !contains(options.only, e.entry->id)) continue;
    let = compute(e, settings, record) && let;
  }
  record.seconds = options.no_timings ? 0 : watch.seconds() - (seconds_waited() - waited);

  const std::filesystem::path inventory = info.sources / "data" / "inventory.csv";
  if (whole && std::filesystem::exists(inventory)) {
    record.inventory = read_inventory(inventory);
    record.problems = audit(record.inventory, record);
  }
  if (whole)
    for (std::string& problem : unused(trials, record))
      record.problems.push_back(std::move(problem));
  folder.announce(settings.results / "checks.csv");
  files::write(settings.results / "checks.csv", checks_csv(record));
  const std::string summary = summary_line(record);
  files::write(folder.summary(), summary + "\n");
  files::flush_standard_output();
  write_record(record, folder.record());  // the last of all
  print_failures(record);
  fmt::print("{}\n", summary);
  if (!let) return 3;
  return all_good(record) ? 0 : 1;
}

}  // namespace

Entry table(std::string id, ItemFunction compute) {
  return table(std::move(id), "", std::move(compute));
}
Entry figure(std::string id, ItemFunction compute) {
  return figure(std::move(id), "", std::move(compute));
}
Entry table(std::string id, std::string title, ItemFunction compute) {
  return {std::move(id), "table", std::move(title), std::move(compute)};
}
Entry figure(std::string id, std::string title, ItemFunction compute) {
  return {std::move(id), "figure", std::move(title), std::move(compute)};
}

namespace {

int run_command(int argc, char** argv, const ChapterInfo& info, const std::vector<Section>& paper,
                const std::vector<Section>& study) {
  CLI::App app{fmt::format("{}: {}", info.name, info.title), info.name};
  app.require_subcommand(1);
  app.set_version_flag("--version", fmt::format("{} {}", info.name, RAILBOOK_VERSION));
  ReproduceOptions options;
  CLI::App* reproduce_command =
      app.add_subcommand("reproduce", "recompute the paper's tables and figures and check them");
  reproduce_command->add_option("--only", options.only, "only these items (see list)")
      ->delimiter(',');
  reproduce_command
      ->add_option("--level", options.level, "quick, or full: longer Monte Carlo, finer references")
      ->check(CLI::IsMember({"quick", "full"}))
      ->capture_default_str();
  reproduce_command->add_option("--out", options.out, "folder for results/ and figures/")
      ->capture_default_str();
  reproduce_command->add_flag("--no-figures", options.no_figures, "do not draw");
  reproduce_command->add_flag("--no-timings", options.no_timings,
                              "measure no time: the same record on every run");
  reproduce_command
      ->add_option("--rounding", options.rounding,
                   "how arithmetic rounds; results of other modes than nearest go to a folder "
                   "rounding-up and so on in that of --out")
      ->check(CLI::IsMember({"nearest", "up", "down", "zero"}))
      ->capture_default_str();
  app.add_subcommand("list", "name the tables and figures");

  try {
    std::vector<PagedEntry> entries = in_order(paper, study);
    app.parse(argc, argv);
    read_captions(info.sources, entries);
    if (*reproduce_command) return reproduce(options, info, entries);
    for (const PagedEntry& e : entries)  // list
      fmt::print("{:<22} {:<7} {}\n", e.entry->id, e.entry->kind, e.title);
    return 0;
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "{}: {}\nTry `{} --help`.\n", info.name, error.what(), info.name);
    return 2;
  } catch (...) {
    return files::status_of_exception(info.name);
  }
}

}  // namespace

int run(int argc, char** argv, const ChapterInfo& info, const std::vector<Section>& paper,
        const std::vector<Section>& study) {
  files::prepare_process();
  ChapterInfo here = info;
  if (!std::filesystem::exists(here.sources)) here.sources = plot::shared("chapters/" + info.id);
  return files::finish_process(info.name, run_command(argc, argv, here, paper, study));
}

}  // namespace railbook::report
