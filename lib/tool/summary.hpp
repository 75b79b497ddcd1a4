// What a tool answers: named quantities, printed for people and written as JSON for programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace railbook::tool {

class Summary {
 public:
  explicit Summary(std::string title) : title_(std::move(title)) {}

  // A number in the unit it is shown in. `key` is its JSON name ("force_N" style names carry the unit).
  void add(std::string key, std::string what, double value, std::string unit,
           std::string note = "");
  void add(std::string key, std::string what, std::string text);

  // The table on standard output: what, value, unit, note.
  void print() const;
  // {"title": ..., "values": {key: value, ...}, "units": {key: unit, ...}, "notes": ...}; NaN is null.
  void write_json(const std::filesystem::path& file) const;

 private:
  struct Line {
    std::string key, what, text, unit, note;
    double value;
  };
  std::string title_;
  std::vector<Line> lines_;
};

}  // namespace railbook::tool
