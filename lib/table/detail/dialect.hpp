#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace railbook::table {

// A comment, or nothing but blanks.
bool is_skipped(std::string_view line);

// What parts the cells, by the header and lines after it: of tab, semicolon, comma and stroke the
// one that the header and the next line have as often, else the one that the header has most of. A
// blank where the header has none of them and one of the lines is of as many words, two of them
// numbers.
char separator_of(std::string_view header, const std::vector<std::string>& lines);

// The words of a line whose cells are parted by blanks. A date and a time after it are one, where
// there are otherwise more words than columns (0: not known).
std::vector<std::string_view> words_of(std::string_view line, std::size_t columns = 0);

// The same of its headers, which may hold single blanks where two or more part them: as many as
// there are columns, or else words.
std::vector<std::string_view> headers_of(std::string_view line, std::size_t columns);

}  // namespace railbook::table
