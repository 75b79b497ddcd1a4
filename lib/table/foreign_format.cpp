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
    {"CDF\x01", "a netCDF-3 file; nccopy -k nc4 IN OUT makes one of version 4, which is read"},
    {"CDF\x02", "a netCDF-3 file; nccopy -k nc4 IN OUT makes one of version 4, which is read"},
    {"\x93NUMPY", "a file of NumPy; write it as CSV by numpy.savetxt"},
    {"ARROW1", "a Feather file; write it as CSV, for example with pandas"},
    {"TDSm", "a TDMS file; write its channels as CSV, for example with nptdms"},
    {"MDF     ", "an MDF file; write its channels as CSV, for example with asammdf"},
    {"7z\xBC\xAF", "a 7-Zip archive; unpack it"},
    {"Rar!", "a RAR archive; unpack it"},
    {"BZh91AY&SY", "packed by bzip2; unpack it by bunzip2, or pipe bzcat into -"},
    {"\xFD"
     "7zXZ",
     "packed by xz; unpack it by unxz, or pipe xzcat into -"},
    {"\x28\xB5\x2F\xFD", "packed by zstd; unpack it by unzstd, or pipe zstdcat into -"},
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
