#include "live.hpp"

#include <fmt/format.h>

#include <cmath>
#include <exception>
#include <stdexcept>

#include <railbook/units/input_error.hpp>

namespace railbook::live {

Inputs::Inputs(std::span<const Input> inputs, std::span<const double> values) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Input& in = inputs[i];
    values_[in.name] = units::require_between(in.name, values[i], in.low, in.high, in.unit);
  }
  rest_ = values.subspan(inputs.size());
}

double Inputs::operator[](const char* name) const {
  const auto found = values_.find(name);
  if (found == values_.end()) throw std::logic_error(fmt::format("no input {}", name));
  return found->second;
}

int Inputs::whole(const char* name) const {
  return static_cast<int>(std::lround((*this)[name]));
}

void Answer::value(const char* name, double x) {
  values_.emplace_back(name, x);
}

void Answer::table(const char* name, std::vector<std::string> columns) {
  tables_.push_back({name, std::move(columns), {}});
}

void Answer::row(std::initializer_list<double> numbers) {
  Table& table = tables_.back();
  if (numbers.size() != table.columns.size())
    throw std::logic_error(fmt::format("a row of {} numbers in {}", numbers.size(), table.name));
  table.numbers.insert(table.numbers.end(), numbers);
}

std::string Answer::layout() const {
  std::string text;
  for (const auto& [name, x] : values_) text += name + ' ';
  for (const Table& t : tables_)
    text += fmt::format("{}:{}:{} ", t.name, t.numbers.size() / t.columns.size(),
                        fmt::join(t.columns, ","));
  if (!text.empty()) text.pop_back();
  return text;
}

std::vector<double> Answer::numbers() const {
  std::vector<double> all;
  for (const auto& [name, x] : values_) all.push_back(x);
  for (const Table& t : tables_) all.insert(all.end(), t.numbers.begin(), t.numbers.end());
  return all;
}

const std::vector<Function>& functions() {
  static const std::vector<Function> all = [] {
    std::vector<Function> f;
    for (const auto part :
         {contact_functions(), hunting_functions(), creep_functions(), filters_functions(),
          psd_functions(), quality_functions(), track_functions(), wheel_on_rail_functions()})
      f.insert(f.end(), part.begin(), part.end());
    return f;
  }();
  return all;
}

namespace {

std::vector<double> buffer;
std::string text;  // of the last call: the layout of its answer, or why there is none

}  // namespace
}  // namespace railbook::live

using namespace railbook;

extern "C" {

// What there is, a line a function, its parts between tabs: name, list or "-", and each input as
// name|unit|default|low|high.
const char* live_describe() {
  static const std::string description = [] {
    std::string s;
    for (const live::Function& f : live::functions()) {
      s += fmt::format("{}\t{}", f.name, f.list != nullptr ? f.list : "-");
      for (const live::Input& i : f.inputs)
        s += fmt::format("\t{}|{}|{}|{}|{}", i.name, i.unit, i.value, i.low, i.high);
      s += '\n';
    }
    return s;
  }();
  return description.c_str();
}

// Room for `size` numbers that go into a call; with 0, where the numbers of the last answer stand.
double* live_buffer(int size) {
  if (size > 0) live::buffer.resize(static_cast<std::size_t>(size));
  return live::buffer.data();
}

// Calls a function with `count` numbers in the buffer, whose place the answer takes. Returns how
// many numbers it has, and -1 where there is none; live_text() says what they are, or why.
int live_call(int number, int count) {
  try {
    const live::Function& f = live::functions().at(static_cast<std::size_t>(number));
    const std::vector<double> values(live::buffer.begin(), live::buffer.begin() + count);
    live::Answer answer;
    f.run(live::Inputs{f.inputs, values}, answer);
    live::text = answer.layout();
    live::buffer = answer.numbers();
    return static_cast<int>(live::buffer.size());
  } catch (const std::exception& error) {
    live::text = error.what();
    return -1;
  }
}

const char* live_text() {
  return live::text.c_str();
}

}  // extern "C"
