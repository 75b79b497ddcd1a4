// What the live figures of the book call: functions from named numbers to named numbers and tables.
//
// A function of a chapter is a `Function` with its inputs, their units, defaults and ranges.
// live.cpp hands all of them to the page by three C functions: what there is (live_describe), a
// call (live_call), and the buffer through which numbers go both ways (live_buffer).
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

namespace railbook::live {

struct Input {
  const char* name;
  const char* unit;  // SI; "" for a pure number or a choice
  double value;      // default
  double low, high;  // what is allowed, ends included
};

// The numbers of a call, by name.
class Inputs {
 public:
  // Throws InputError naming the first value that is out of its range.
  Inputs(std::span<const Input> inputs, std::span<const double> values);
  double operator[](const char* name) const;
  int whole(const char* name) const;                      // rounded
  std::span<const double> rest() const { return rest_; }  // of a function that takes a list

 private:
  std::map<std::string, double, std::less<>> values_;
  std::span<const double> rest_;
};

// An answer: numbers, then tables, as one run of doubles with a text that says what they are.
class Answer {
 public:
  void value(const char* name, double x);
  // Begins a table; `row` then adds to it, one number a column.
  void table(const char* name, std::vector<std::string> columns);
  void row(std::initializer_list<double> numbers);

  // "force p_max cells:3:x,y,p" (names; of a table its rows and columns) and the numbers in that
  // order, a table row by row.
  std::string layout() const;
  std::vector<double> numbers() const;

 private:
  struct Table {
    std::string name;
    std::vector<std::string> columns;
    std::vector<double> numbers;
  };
  std::vector<std::pair<std::string, double>> values_;
  std::vector<Table> tables_;
};

struct Function {
  const char* name;
  const char* list;  // name of a list of numbers that it takes beside its inputs, or null
  std::vector<Input> inputs;
  void (*run)(const Inputs&, Answer&);
};

// Of each chapter, in the file of its name.
std::span<const Function> contact_functions();
std::span<const Function> hunting_functions();
std::span<const Function> creep_functions();
std::span<const Function> filters_functions();
std::span<const Function> psd_functions();
std::span<const Function> quality_functions();
std::span<const Function> track_functions();
std::span<const Function> wheel_on_rail_functions();

// All of them, in the order of the chapters.
const std::vector<Function>& functions();

}  // namespace railbook::live
