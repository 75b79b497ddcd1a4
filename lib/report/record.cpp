#include <railbook/report/record.hpp>

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include <railbook/files/out_file.hpp>
#include <railbook/report/detail/headline.hpp>
#include <railbook/table/csv.hpp>

namespace railbook::report {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json json(const TrialRecord& t) {
  Json varied = Json::array();
  for (const TrialRecord::Varied& v : t.varied)
    varied.push_back({{"choice", v.choice},
                      {"settings", v.settings},
                      {"results", v.results},
                      {"range", v.range}});
  return {{"quantity", t.quantity}, {"range", t.range}, {"varied", varied}};
}

Json json(const CheckRecord& c) {
  Json j{{"id", c.id},
         {"item", c.item},
         {"what", c.what},
         {"unit", c.unit},
         {"source", c.source},
         {"outcome", c.outcome},
         {"place", c.place},
         {"by", c.by},
         {c.source == "print" ? "printed" : "reference", c.reference},
         {"computed",
          std::isnan(c.computed) && c.kind == "exact" ? Json(c.computed_text) : number(c.computed)},
         {"computed_text", c.computed_text},
         {"allowed", number(c.allowed)},
         {"error", number(c.error)},
         {"kind", c.kind},
         {"why", c.why},
         {"pass", c.pass}};
  if (!c.trial.varied.empty()) j["trial"] = json(c.trial);
  return j;
}

Json json(const ItemRecord& i) {
  Json j{{"id", i.id},       {"kind", i.kind},     {"title", i.title},     {"page", i.page},
         {"input", i.input}, {"reason", i.reason}, {"failure", i.failure}, {"png", i.png},
         {"csv", i.csv},     {"script", i.script}, {"seconds", i.seconds}};
  if (!i.not_drawn.empty()) j["not_drawn"] = i.not_drawn;
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
          {"seconds_q1", number(w.seconds_q1)},
          {"seconds_median", number(w.seconds_median)},
          {"seconds_q3", number(w.seconds_q3)},
          {"samples", w.samples},
          {"work", number(w.work)},
          {"work_unit", w.work_unit},
          {"converged", w.converged},
          {"reason", w.reason}};
}

Json json(const Stability& s) {
  return {{"id", s.id},
          {"case", s.case_},
          {"stress", s.stress},
          {"result", s.result},
          {"reference", s.reference},
          {"error", number(s.error)},
          {"allowed", number(s.allowed)},
          {"expect", s.expect},
          {"found", s.found},
          {"seconds", s.seconds},
          {"pass", s.pass}};
}

Json json(const InventoryRow& r) {
  return {{"place", r.place},     {"kind", r.kind},     {"number", r.number}, {"what", r.what},
          {"treated", r.treated}, {"symbol", r.symbol}, {"test", r.test},     {"reason", r.reason}};
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

// What the times were measured on; the load is the mean number of waiting processes of the last
// minute.
Json machine() {
  double load = 0;
  if (std::ifstream average{"/proc/loadavg"}) average >> load;
  return {{"processor", processor()},
          {"cores", std::thread::hardware_concurrency()},
          {"compiler", compiler},
          {"flags", RAILBOOK_CXX_FLAGS},
          {"load", load}};
}

}  // namespace

void write_record(const ChapterRecord& r, const std::filesystem::path& file) {
  const Json j{{"chapter", r.chapter},
               {"version", RAILBOOK_VERSION},
               {"title", r.title},
               {"paper", r.paper},
               {"doi", r.doi},
               {"level", r.level},
               {"seconds", r.seconds},
               {"only", r.only},
               {"headline", headline(r)},
               {"machine", machine()},
               {"checks", array(r.checks)},
               {"items", array(r.items)},
               {"values", array(r.values)},
               {"work_precision", array(r.work_precision)},
               {"stability", array(r.stability)},
               {"inventory", array(r.inventory)},
               {"problems", r.problems}};
  files::write(file, j.dump(1) + "\n");
}

std::string checks_csv(const ChapterRecord& record) {
  std::string text =
      "id,place,source,outcome,what,unit,printed,reference,by,computed,error,allowed,kind\n";
  for (const CheckRecord& c : record.checks) {
    text += fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{}\n", table::csv_cell(c.id), table::csv_cell(c.place),
        c.source, c.outcome, table::csv_cell(c.what), table::csv_cell(c.unit),
        table::csv_cell(c.source == "print" ? c.reference : ""),
        table::csv_cell(c.source == "print" ? "" : c.reference), table::csv_cell(c.by),
        std::isnan(c.computed) ? table::csv_cell(c.computed_text) : table::csv_number(c.computed),
        table::csv_number(c.error), table::csv_number(c.allowed), c.kind);
  }
  return text;
}

}  // namespace railbook::report
