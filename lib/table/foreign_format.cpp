#include <railbook/table/detail/foreign_format.hpp>

#include <algorithm>
#include <cctype>
#include <string>

namespace railbook::table {

namespace {

struct Format {
  std::string_view start, advice;
};

constexpr Format formats[] = {
    {"\xD0\xCF\x11\xE0",
     "a workbook of an old spreadsheet; save the sheet as CSV, for example by libreoffice "
     "--headless --convert-to csv"},
    {"%PDF-", "a PDF file; ask for the numbers as CSV"},
    {"PAR1", "a Parquet file; write it as CSV, for example with DuckDB or pandas"},
    {"SQLite format 3", "a SQLite database; write the table as CSV, for example by sqlite3 -csv"},
    {"version https://git-lfs",
     "a pointer of Git LFS without the data; fetch them by git lfs pull"},
    {"<!doctype html", "a web page; save the data themselves, not the page about them"},
    {"<html", "a web page; save the data themselves, not the page about them"},
    {"<?xml", "an XML file; write its table as CSV"},
    {"{", "a JSON file; write its table as CSV, for example with jq"},
    {"[{", "a JSON file; write its table as CSV, for example with jq"},
    {"[[", "a JSON file; write its table as CSV, for example with jq"},
};

bool starts_with(std::string_view text, std::string_view start) {
  return text.size() >= start.size() &&
         std::equal(start.begin(), start.end(), text.begin(), [](char a, char b) {
           return a == b || a == std::tolower(static_cast<unsigned char>(b));
         });
}

}  // namespace

std::string_view foreign_format(std::string_view first_line) {
  for (const Format& format : formats)
    if (starts_with(first_line, format.start)) return format.advice;
  return {};
}

}  // namespace railbook::table
