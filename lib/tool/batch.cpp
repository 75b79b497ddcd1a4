#include "tool/batch.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <deque>
#include <map>
#include <new>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "files/journal.hpp"
#include "files/staged.hpp"
#include "table/csv.hpp"
#include "tool/out_folder.hpp"
#include "tool/progress.hpp"
#include "tool/session.hpp"
#include "tool/summary.hpp"
#include "units/input_error.hpp"
#include "units/printable.hpp"

namespace railbook::tool {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Task {
  std::size_t index = 0;
  fs::path file;
  std::string key;  // of the file as it is, and the options
};

struct Shard {
  std::size_t number = 1, of = 1;
};

Shard shard_of(const std::string& text) {
  Shard shard;
  if (text.empty()) return shard;
  const std::size_t at = text.find('/');
  const auto whole = [&](std::string_view part, std::size_t& value) {
    const auto [end, status] = std::from_chars(part.data(), part.data() + part.size(), value);
    return status == std::errc{} && end == part.data() + part.size();
  };
  if (at == std::string::npos || !whole(std::string_view{text}.substr(0, at), shard.number) ||
      !whole(std::string_view{text}.substr(at + 1), shard.of) || shard.number < 1 ||
      shard.number > shard.of || shard.of > 100000)
    throw InputError{fmt::format("shard is \"{}\"; allowed: 1/4 to 4/4 and the like, to 100000",
                                 units::printable(text))};
  return shard;
}

std::vector<fs::path> records_of(const BatchWish& wish) {
  std::vector<fs::path> files = wish.files;
  if (wish.manifest) {
    table::LineSource lines{*wish.manifest};
    for (std::string line; lines.next(line);) {
      if (line.ends_with('\r')) line.pop_back();
      if (line.empty() || line.starts_with('#')) continue;
      if (line.find('\0') != std::string::npos)
        throw InputError{fmt::format("file {}, line {}: holds a zero byte: no list of files",
                                     files::shown(*wish.manifest), lines.line())};
      files.push_back(fs::path(line).is_absolute() || *wish.manifest == "-"
                          ? fs::path(line)
                          : wish.manifest->parent_path() / line);
    }
  }
  if (files.empty()) throw InputError{"there is no record; allowed: files, or --manifest"};
  std::set<fs::path> seen;
  for (const fs::path& file : files)
    if (!seen.insert(file).second)
      throw InputError{fmt::format("record {} is named twice", files::shown(file))};
  return files;
}

// FNV-1a: the same on every machine.
std::string hash(const std::string& text) {
  std::uint64_t h = 14695981039346656037U;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return fmt::format("{:016x}", h);
}

// What the answer depends on, but for the file's bytes: its size and time stand for them.
std::string key_of(const fs::path& file, const std::string& stamp) {
  std::string text = session().version + "\n" + stamp;
  static const std::set<std::string> ways{"jobs", "shard",      "manifest", "record",
                                          "out",  "no-figures", "figure"};
  for (const auto& [name, value] : session().given)
    if (ways.count(name) == 0) text.append("\n").append(name).append("=").append(value);
  std::error_code none;
  const auto size = fs::file_size(file, none);
  const auto time = fs::last_write_time(file, none).time_since_epoch().count();
  return hash(text + fmt::format("\n{}\n{}\n{}", file.string(), none ? 0 : size, none ? 0 : time));
}

Json row_of(const Task& task, const std::string& status, const std::string& reason) {
  return Json{{"record", task.file.string()}, {"status", status}, {"reason", reason}};
}

std::string line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

// The lines of a record; each says how many they are, so that what a kill cut off is not taken for all.
std::string group(const Task& task, const std::vector<Json>& rows) {
  std::string text;
  for (Json row : rows) {
    row["key"] = task.key;
    row["of"] = rows.size();
    text += line(row);
  }
  return text;
}

std::string answer(const Task& task, const RecordRows& work) {
  std::vector<Json> rows;
  try {
    for (const Row& row : work(task.file)) {
      Json json = row_of(task, "ok", "");
      for (const Row::Cell& cell : row.cells()) {
        if (cell.is_text)
          json[cell.key] = cell.text;
        else
          json[cell.key] = std::isfinite(cell.value) ? Json(cell.value) : Json(nullptr);
      }
      rows.push_back(std::move(json));
    }
  } catch (const InputError& error) {
    rows = {row_of(task, "refused", units::printable(error.what(), 1000))};
  } catch (const std::bad_alloc&) {
    rows = {row_of(task, "failed", "not enough memory")};
  } catch (const std::exception& error) {
    rows = {row_of(task, "failed", units::printable(error.what(), 1000))};
  }
  return group(task, rows);
}

struct Worker {
  Task task;
  pid_t process = 0;
  int pipe = -1;
  std::string said;
};

// A process for one record: whatever becomes of it, the others go on.
Worker start(const Task& task, const RecordRows& work) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0)
    throw std::system_error(errno, std::generic_category(), "a pipe to a worker");
  std::fflush(stdout);
  std::fflush(stderr);
  const pid_t process = fork();
  if (process < 0) throw std::system_error(errno, std::generic_category(), "a worker process");
  if (process == 0) {
    // What is staged is the parent's to remove.
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU}) ::signal(signal, SIG_DFL);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    close(ends[0]);
    const std::string text = answer(task, work);
    _exit(files::write_all(ends[1], text) == 0 ? 0 : 1);
  }
  close(ends[1]);
  return {task, process, ends[0], ""};
}

// What a worker has left behind; a row that says how it ended when that is not a whole answer.
std::string finish(Worker& worker) {
  close(worker.pipe);
  int status = 0;
  while (waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && worker.said.ends_with('\n'))
    return worker.said;
  const std::string how = WIFSIGNALED(status)
                              ? fmt::format("the process ended by signal {}", WTERMSIG(status))
                              : "the process ended without an answer";
  return group(worker.task, {row_of(worker.task, "failed", how)});
}

// Rows that files of earlier runs hold, by the key of their record.
using Rows = std::map<std::string, std::vector<Json>>;

void collect(std::string_view text, Rows& done, Rows& failed) {
  Rows open;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const Json json = Json::parse(text.substr(0, end), nullptr, false);
    text.remove_prefix(std::min(end + 1, text.size()));
    const auto text_of = [&](const char* name) {
      return json.is_object() && json.contains(name) && json[name].is_string()
                 ? json[name].get<std::string>()
                 : std::string{};
    };
    const std::string key = text_of("key"), status = text_of("status");
    if (key.empty() || status.empty() || !json.contains("of")) continue;
    auto& rows = open[key];
    rows.push_back(json);
    if (json["of"] != rows.size()) continue;
    Rows& to = status == "failed" ? failed : done;
    to.emplace(key, std::move(rows));
    open.erase(key);
  }
}

std::string contents(const fs::path& file) {
  table::LineSource source{file};
  std::string text;
  for (std::string_view part; source.next(part);) text += std::string{part} + "\n";
  return text;
}

Rows rows_in(const fs::path& folder, const std::string& name) {
  Rows done;
  std::error_code none;
  std::set<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const std::string file = entry.path().filename().string();
    if (file.starts_with(name + "-") && file.ends_with(".jsonl") && entry.is_regular_file(none))
      files.insert(entry.path());
  }
  Rows failed;
  for (const fs::path& file : files) collect(contents(file), done, failed);
  return done;
}

std::string csv_cell(const Json& value) {
  if (value.is_string()) return table::csv_cell(value.get<std::string>());
  if (value.is_number()) return table::csv_number(value.get<double>());
  return "";
}

// All rows with the columns of all, in the order of the records.
struct Table {
  std::string csv, jsonl;
  std::map<std::string, std::size_t> counts;  // records by status
  std::size_t rows = 0;
};

Table table_of(const std::vector<Task>& tasks, const Rows& done) {
  std::vector<std::string> columns;
  std::set<std::string> known{"key", "of"};
  for (const Task& task : tasks)
    for (const Json& row : done.at(task.key))
      for (const auto& item : row.items())
        if (known.insert(item.key()).second) columns.push_back(item.key());
  Table table;
  for (const std::string& column : columns)
    table.csv += (table.csv.empty() ? "" : ",") + table::csv_cell(column);
  table.csv += "\n";
  for (const Task& task : tasks) {
    const std::vector<Json>& rows = done.at(task.key);
    for (const Json& row : rows) {
      std::string text;
      for (const std::string& column : columns)
        text += (column == columns.front() ? "" : ",") +
                (row.contains(column) ? csv_cell(row[column]) : std::string{});
      table.csv += text + "\n";
    }
    table.jsonl += group(task, rows);
    table.rows += rows.size();
    ++table.counts[rows.empty() ? "ok" : rows.front()["status"].get<std::string>()];
  }
  return table;
}

// All tasks through at most `jobs` workers; `finished` takes each one's lines.
void work_off(std::deque<Task> tasks, std::size_t jobs, const RecordRows& work,
              const std::function<void(const std::string&)>& finished) {
  std::vector<Worker> running;
  while (!tasks.empty() || !running.empty()) {
    while (!tasks.empty() && running.size() < jobs) {
      running.push_back(start(tasks.front(), work));
      tasks.pop_front();
    }
    std::vector<pollfd> polled;
    polled.reserve(running.size());
    for (const Worker& worker : running) polled.push_back({worker.pipe, POLLIN, 0});
    if (poll(polled.data(), polled.size(), -1) < 0 && errno != EINTR)
      throw std::system_error(errno, std::generic_category(), "waiting for workers");
    for (std::size_t i = running.size(); i-- > 0;) {
      if (polled[i].revents == 0) continue;
      std::array<char, 1 << 16> buffer{};
      const ssize_t got = ::read(running[i].pipe, buffer.data(), buffer.size());
      if (got < 0 && errno == EINTR) continue;
      if (got > 0) {
        running[i].said.append(buffer.data(), static_cast<std::size_t>(got));
        continue;
      }
      const std::string said = finish(running[i]);
      running.erase(running.begin() + static_cast<std::ptrdiff_t>(i));
      finished(said);
    }
  }
}

void report(const Table& table, std::size_t records, std::size_t before, const std::string& name) {
  if (session().json) return fmt::print("{}", table.jsonl);
  Summary answer{fmt::format("{} of {} records", name, records)};
  const auto count = [&](const char* status) {
    const auto at = table.counts.find(status);
    return static_cast<double>(at == table.counts.end() ? 0 : at->second);
  };
  if (const double n = count("refused"); n > 0)
    answer.flag("refused",
                fmt::format("{:g} of {} records refused; their rows say why", n, records));
  if (const double n = count("failed"); n > 0)
    answer.flag("failed", fmt::format("{:g} of {} records failed; their rows say how, and a rerun "
                                      "tries them again",
                                      n, records));
  answer.add("records", "records", static_cast<double>(records), "");
  answer.add("answered", "  answered", count("ok"), "");
  answer.add("refused", "  refused", count("refused"), "");
  answer.add("failed", "  failed", count("failed"), "");
  answer.add("before", "  done in an earlier run", static_cast<double>(before), "");
  answer.add("rows", "rows of the table", static_cast<double>(table.rows), "");
  answer.print();
}

}  // namespace

bool BatchWish::many() const {
  return files.size() > 1 || manifest || !shard.empty();
}

const std::filesystem::path& BatchWish::only() const {
  if (files.empty()) throw InputError{"there is no record; allowed: a file, or --manifest"};
  return files.front();
}

void run_batch(const BatchWish& wish, const Destination& out, const std::string& name,
               const RecordRows& rows) {
  if (out.figure) throw InputError{"figure is given with many records; allowed: with one"};
  const Shard shard = shard_of(wish.shard);
  if (!wish.shard.empty() && !out.folder)
    throw InputError{"shard is given without out; allowed: with the folder that all shards share"};
  const std::vector<fs::path> files = records_of(wish);
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < files.size(); ++i)
    if (i % shard.of == shard.number - 1)
      tasks.push_back({i, files[i], key_of(files[i], wish.stamp)});
  const bool part = shard.of > 1;
  OutFolder folder(part ? Destination{} : out, {name + "-table.csv", name + "-table.jsonl"});
  Rows done, failed;
  std::optional<files::Journal> journal;
  const fs::path log =
      !out.folder ? fs::path{}
      : part      ? *out.folder / fmt::format("{}-{}-of-{}.jsonl", name, shard.number, shard.of)
                  : *out.folder / (name + "-begun.jsonl");
  if (out.folder) {
    files::MadeFolder made(*out.folder);
    made.keep();
    done = rows_in(*out.folder, name);
    journal.emplace(log);
  }
  std::deque<Task> to_do;
  for (const Task& task : tasks)
    if (done.count(task.key) == 0) to_do.push_back(task);
  const std::size_t before = tasks.size() - to_do.size();
  Progress progress("records", static_cast<double>(to_do.size()));
  work_off(to_do, static_cast<std::size_t>(wish.jobs), rows, [&](const std::string& lines) {
    if (journal) journal->append(lines);
    collect(lines, done, failed);
    progress.step();
  });
  progress.end();
  for (const Task& task : tasks)
    if (done.count(task.key) == 0) done[task.key] = failed.at(task.key);
  const Table table = table_of(tasks, done);
  report(table, tasks.size(), before, name);
  if (folder) {
    folder.add(name + "-table.csv", table.csv);
    folder.add(name + "-table.jsonl", table.jsonl);
    folder.commit();
    journal.reset();
    files::remove(log);
  }
  if (!tasks.empty() && table.counts.count("ok") == 0)  // a shard may have none
    throw InputError{fmt::format("none of {} records could be answered; the first: {}",
                                 tasks.size(),
                                 done.at(tasks.front().key).front()["reason"].get<std::string>())};
}

}  // namespace railbook::tool
