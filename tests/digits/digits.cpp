// How many significant digits of each check's number are the same however arithmetic rounds, and
// whatever compiled it.
//
//   digits RESULTS TABLES [--accept]
//
// RESULTS holds results/NN-name.json, of arithmetic to nearest, and folders with the same of other
// runs: rounding-up, -down and -zero, another processor's mathematics, other compilers.
// TABLES/NN-name.csv says for each check how many digits all have in common; fewer than six have a
// reason in TABLES/reasons.csv, so has a check that fails in one of them. With --accept the tables
// are written anew. A number that holds fewer digits than its table says, by more than one, fails,
// and so does one without a reason, or a reason that is not needed when they are written.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <railbook/table/csv.hpp>

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int enough = 6, most = 15;

struct Found {
  int digits = most;
  bool fails = false;  // in another run
};

Json read(const fs::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file.string() + " cannot be read");
  return Json::parse(in);
}

std::map<std::string, const Json*> checks_of(const Json& record) {
  std::map<std::string, const Json*> all;
  for (const Json& check : record.at("checks")) all[check.at("id")] = &check;
  return all;
}

// Of numbers that should be one.
int common_digits(const std::vector<double>& values) {
  const auto [low, high] = std::ranges::minmax(values);
  const double size = std::max(std::abs(low), std::abs(high));
  if (high == low) return most;
  return std::clamp(static_cast<int>(std::floor(-std::log10((high - low) / size))), 0, most);
}

std::map<std::string, Found> digits_of(const fs::path& results, const std::string& name) {
  std::vector<Json> records{read(results / "results" / name)};
  for (const char* mode : {"up", "down", "zero"})
    records.push_back(read(results / ("rounding-" + std::string(mode)) / "results" / name));
  for (const auto& run : fs::directory_iterator(results))
    if (const fs::path record = run.path() / "results" / name;
        !run.path().filename().string().starts_with("rounding-") && fs::exists(record))
      records.push_back(read(record));
  std::vector<std::map<std::string, const Json*>> maps;
  for (const Json& record : records) maps.push_back(checks_of(record));
  std::map<std::string, Found> all;
  for (const auto& [id, check] : maps.front()) {
    Found found;
    std::vector<double> values;
    for (const auto& map : maps) {
      const auto at = map.find(id);
      if (at == map.end() || !at->second->at("pass").get<bool>()) found.fails = true;
      if (at != map.end() && at->second->at("computed").is_number())
        values.push_back(at->second->at("computed").get<double>());
    }
    if (values.size() > 1) found.digits = common_digits(values);
    if (values.size() > 1 || found.fails) all[id] = found;
  }
  return all;
}

// Of check and value, empty where there is no file.
std::map<std::string, std::string> pairs(const fs::path& file) {
  std::map<std::string, std::string> all;
  if (!fs::exists(file)) return all;
  for (const auto& row : railbook::table::read_table(file).rows) all[row.at(0)] = row.at(1);
  return all;
}

void write(const fs::path& file, const std::map<std::string, Found>& found,
           const std::map<std::string, std::string>& reasons, const std::string& chapter) {
  std::ofstream out(file);
  out << "check,digits,reason\n";
  for (const auto& [id, f] : found) {
    const auto reason = reasons.find(chapter + "/" + id);
    out << id << ',' << f.digits << ','
        << (reason == reasons.end() ? "" : railbook::table::csv_cell(reason->second)) << '\n';
  }
}

int compare(const fs::path& results, const fs::path& tables, bool accept) {
  const auto reasons = pairs(tables / "reasons.csv");
  std::map<std::string, bool> needed;
  int bad = 0, checks = 0, few = 0;
  const auto fail = [&bad](const std::string& text) {
    std::printf("%s\n", text.c_str());
    ++bad;
  };
  std::vector<fs::path> records;
  for (const auto& entry : fs::directory_iterator(results / "results"))
    if (entry.path().extension() == ".json") records.push_back(entry.path());
  std::ranges::sort(records);
  for (const fs::path& record : records) {
    const std::string chapter = record.stem().string();
    const auto found = digits_of(results, record.filename().string());
    const fs::path table = tables / (chapter + ".csv");
    if (accept) write(table, found, reasons, chapter);
    auto stated = pairs(table);
    for (const auto& [id, f] : found) {
      const std::string name = chapter + "/" + id;
      ++checks;
      if (f.digits < enough || f.fails) {
        ++few;
        needed[name] = true;
        if (!reasons.contains(name))
          fail(name + ": " + std::to_string(f.digits) + " digits hold" +
               (f.fails ? ", it fails in another run" : "") + ", without a reason");
      }
      if (!stated.contains(id))
        fail(name + " is not in its table: make accept-digits");
      else if (f.digits < std::stoi(stated.at(id)) - 1)
        fail(name + ": " + std::to_string(f.digits) + " digits hold, not " + stated.at(id));
      stated.erase(id);
    }
    for (const auto& [id, digits] : stated)
      fail(chapter + "/" + id + " is in its table, and no check: make accept-digits");
  }
  for (const auto& [name, reason] : reasons)
    if (accept && !needed.contains(name)) fail(name + " needs no reason");
  std::printf("%d checks, %d with a reason, %d bad\n", checks, few, bad);
  return bad == 0 && checks > 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::printf("usage: digits RESULTS TABLES [--accept]\n");
    return 2;
  }
  try {
    return compare(argv[1], argv[2], argc > 3 && std::string(argv[3]) == "--accept");
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
}
