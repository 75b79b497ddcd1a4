// `make bench`: what the solvers cost beside what the machine asks for the same work, beside a
// plain way in this tree, and beside scipy where there is one. speed OUT.json [PEERS.json
// [KEY...]]: a table on standard output, and the same as JSON, of all rows or of those named.
//
// Each row is a process of its own, so that its peak memory is its own; ours, the limit and the
// plain way take turns, and the best of the rounds counts.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include <railbook/bench/timing.hpp>
#include <railbook/files/out_file.hpp>
#include <railbook/files/staged.hpp>

#include "rows.hpp"

using namespace railbook;
using Json = nlohmann::ordered_json;
using bench_rows::Row, bench_rows::Way;

namespace {

double peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

// Ours, the limit and the plain way in turn, three times or for two seconds of each.
Json measured(const Row& row) {
  const std::vector<const Way*> ways = {&row.ours, &row.limit, &row.plain};
  std::vector<double> best(ways.size(), INFINITY);
  double spent = 0, memory = 0;
  for (int round = 0; round < 5 && (round < 2 || spent < 4); ++round)
    for (std::size_t i = 0; i < ways.size(); ++i) {
      if (!ways[i]->run) continue;
      const double seconds = bench::seconds_of(ways[i]->run);
      if (i == 0 && round == 0) memory = peak_bytes();
      best[i] = std::min(best[i], seconds);
      spent += seconds;
    }
  Json json = {{"key", row.key},      {"what", row.what}, {"method", row.ours.what},
               {"work", row.work},    {"unit", row.unit}, {"seconds", best[0]},
               {"peak_bytes", memory}};
  if (row.count) json["count"] = row.count();
  if (row.limit.run)
    json["limit"] = {
        {"what", row.limit.what}, {"seconds", best[1]}, {"share_reached", best[1] / best[0]}};
  if (row.plain.run)
    json["plain"] = {{"what", row.plain.what},
                     {"seconds", best[2] / row.share},
                     {"times_as_long", best[2] / row.share / best[0]}};
  return json;
}

// Set up and measured in a process of its own.
Json in_a_process(const std::function<Row()>& make) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    std::string text;
    try {
      text = measured(make()).dump();
    } catch (const std::exception& error) {
      text = Json{{"failed", error.what()}}.dump();
    }
    close(ends[0]);
    const auto wrote = write(ends[1], text.data(), text.size());
    _exit(wrote == static_cast<ssize_t>(text.size()) ? 0 : 1);
  }
  close(ends[1]);
  std::string text;
  char piece[4096];
  for (ssize_t n = 0; (n = read(ends[0], piece, sizeof piece)) > 0;)
    text.append(piece, static_cast<std::size_t>(n));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (status != 0 || text.empty()) throw std::runtime_error("a measurement ended by itself");
  return Json::parse(text);
}

void add_peer(Json& row, const Json& peers) {
  const std::string key = row.value("key", "");
  if (!peers.contains(key)) return;
  // Peers do as much work a sample; they may do fewer samples.
  const double seconds = peers[key].at("seconds").get<double>() * row.at("work").get<double>() /
                         peers[key].at("work").get<double>();
  row["peer"] = {{"what", peers[key].at("what")},
                 {"seconds", seconds},
                 {"times_as_long", seconds / row.at("seconds").get<double>()}};
}

std::string line(const Json& row) {
  if (row.contains("failed")) return fmt::format("FAILED: {}\n", row["failed"].get<std::string>());
  const double seconds = row.at("seconds"), work = row.at("work");
  std::string text = fmt::format("{} ({})\n  {}", row["what"].get<std::string>(),
                                 row["method"].get<std::string>(), bench::duration(seconds));
  text += fmt::format(
      ", {} a {}", bench::duration(seconds / work),
      row["unit"].get<std::string>().substr(0, row["unit"].get<std::string>().size() - 1));
  text += fmt::format("; at most {:.0f} MB\n", row.at("peak_bytes").get<double>() / 1e6);
  if (row.contains("count")) text += fmt::format("  {}\n", row["count"].get<std::string>());
  if (row.contains("limit"))
    text += fmt::format("  the machine's limit, {}: {}; {:.0f} % reached\n",
                        row["limit"]["what"].get<std::string>(),
                        bench::duration(row["limit"]["seconds"]),
                        100 * row["limit"]["share_reached"].get<double>());
  for (const char* other : {"plain", "peer"})
    if (row.contains(other))
      text += fmt::format("  {}: {}, {:.2g} times as long\n", row[other]["what"].get<std::string>(),
                          bench::duration(row[other]["seconds"]),
                          row[other]["times_as_long"].get<double>());
  return text;
}

int run(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "speed OUT.json [PEERS.json [KEY...]]\n");
    return 2;
  }
  Json peers = Json::object();
  if (argc > 2) peers = Json::parse(std::ifstream(argv[2]));
  files::PrivateFolder folder;
  const std::vector<std::string> wanted(argv + std::min(argc, 3), argv + argc);
  Json all = Json::array();
  bool failed = false;
  for (const auto& [key, make] : bench_rows::all(folder.path())) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), key) == wanted.end()) continue;
    Json row = in_a_process(make);
    add_peer(row, peers);
    fmt::print("{}\n", line(row));
    failed = failed || row.contains("failed");
    all.push_back(std::move(row));
  }
  if (peers.empty()) fmt::print("scipy (Debian's python3-scipy) is not there: no peers.\n");
  files::write(argv[1], all.dump(1) + "\n");
  return failed ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "speed: {}\n", error.what());
    return 1;
  }
}
