#include "report/record.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "files/out_file.hpp"
#include "table/csv.hpp"

namespace railbook::report {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json json(const CheckRecord& c) {
  return {{"id", c.id},
          {"item", c.item},
          {"what", c.what},
          {"unit", c.unit},
          {"printed", c.printed},
          {"computed", std::isnan(c.computed) && c.kind == "exact" ? Json(c.computed_text)
                                                                   : number(c.computed)},
          {"computed_text", c.computed_text},
          {"allowed", number(c.allowed)},
          {"error", number(c.error)},
          {"kind", c.kind},
          {"why", c.why},
          {"status", c.status},
          {"pass", c.pass}};
}

Json json(const ItemRecord& i) {
  Json j{{"id", i.id},           {"kind", i.kind},     {"title", i.title},
         {"verdict", i.verdict}, {"reason", i.reason}, {"png", i.png},
         {"csv", i.csv},         {"script", i.script}, {"seconds", i.seconds}};
  if (!i.columns.empty()) {
    j["columns"] = i.columns;
    j["rows"] = i.rows;
  }
  return j;
}

Json json(const ValueRecord& v) {
  return {{"id", v.id}, {"text", v.text}, {"value", number(v.value)}, {"unit", v.unit}};
}

Json json(const WorkPrecision& w) {
  return {{"id", w.id},
          {"quantity", w.quantity},
          {"method", w.method},
          {"setting", w.setting},
          {"error", number(w.error)},
          {"reference_uncertainty", number(w.reference_uncertainty)},
          {"seconds_min", number(w.seconds_min)},
          {"seconds_median", number(w.seconds_median)},
          {"noise", number(w.noise)},
          {"work", number(w.work)},
          {"converged", w.converged},
          {"reason", w.reason}};
}

Json json(const Stability& s) {
  return {{"id", s.id},         {"case", s.case_},          {"stress", s.stress},
          {"result", s.result}, {"error", number(s.error)}, {"status", s.status}};
}

template <class Record>
Json array(const std::vector<Record>& records) {
  Json all = Json::array();
  for (const Record& r : records) all.push_back(json(r));
  return all;
}

#ifdef __clang__
constexpr const char* compiler = __VERSION__;  // "Debian Clang 14.0.6"
#else
constexpr const char* compiler = "GCC " __VERSION__;
#endif

std::string processor() {
  std::ifstream cpuinfo{"/proc/cpuinfo"};
  for (std::string line; std::getline(cpuinfo, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

}  // namespace

void write_record(const ChapterRecord& r, const std::filesystem::path& file) {
  const Json j{{"chapter", r.chapter},
               {"title", r.title},
               {"paper", r.paper},
               {"level", r.level},
               {"seconds", r.seconds},
               {"only", r.only},
               {"machine", {{"processor", processor()}, {"compiler", compiler}}},
               {"checks", array(r.checks)},
               {"items", array(r.items)},
               {"values", array(r.values)},
               {"work_precision", array(r.work_precision)},
               {"stability", array(r.stability)}};
  files::write(file, j.dump(1) + "\n");
}

std::string checks_csv(const ChapterRecord& record) {
  std::string text = "id,what,unit,printed,computed,error,allowed,kind,status\n";
  for (const CheckRecord& c : record.checks) {
    text += fmt::format(
        "{},{},{},{},{},{},{},{},{}\n", table::csv_cell(c.id), table::csv_cell(c.what),
        table::csv_cell(c.unit), table::csv_cell(c.printed),
        std::isnan(c.computed) ? table::csv_cell(c.computed_text) : table::csv_number(c.computed),
        table::csv_number(c.error), table::csv_number(c.allowed), c.kind, c.status);
  }
  return text;
}

}  // namespace railbook::report
