// SPDX-License-Identifier: BSD-3-Clause
// The pages of a study as one document: sections with tables, figures and notes, which is then written as lines of a
// terminal, Markdown, HTML and CSV.
#pragma once

#include <array>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace assay::drivers::study_page {

enum class Page { csv, terminal, markdown, html };

inline constexpr std::initializer_list<Page> every_page = {Page::csv, Page::terminal, Page::markdown, Page::html};

/// One value for each page, in their order.
template <class T>
struct Paged {
  T& operator[](Page page) { return of_[static_cast<std::size_t>(page)]; }
  const T& operator[](Page page) const { return of_[static_cast<std::size_t>(page)]; }
  std::array<T, 4> of_ = {};
};

/// What stands at one place of a table: plain words, and instead of them what a page has as it stands there.
struct Cell {
  Cell(std::string words) : text(std::move(words)) {}  // NOLINT: texts are cells
  Cell(const char* words) : text(words) {}             // NOLINT
  Cell&& on(Page page, std::string shown) && {
    instead[page] = std::move(shown);
    return std::move(*this);
  }

  std::string text;
  std::map<Page, std::string> instead = {};
};

/// A figure in words and as the number of a CSV file, where it is there.
Cell figure_cell(const std::optional<double>& value, const std::string& words);

/// A number with its unit, which HTML does not break.
Cell unbroken_cell(const std::optional<double>& value, const std::string& words);

/// Running text.
Cell words_cell(const std::string& text, const std::string& classes = "words");

/// Its heads on CSV, terminal, Markdown and HTML, as they stand there; where it has none it is not shown.
using Column = Paged<std::string>;

struct Table {
  std::vector<Column> columns = {};
  std::vector<std::vector<Cell>> rows = {};
};

/// A page shows it where it has something before the table, or rows of it.
struct Section {
  std::string heading = {};        ///< of Markdown and HTML; empty: none
  std::string file = {};           ///< the table's data, or those of the figure
  std::string remark = {};         ///< of HTML, below the table
  Paged<std::string> before = {};  ///< as it stands on the page; instead of the heads of a terminal's table
  Table table = {};
  Paged<std::string> after = {};
  std::vector<Page> pages = every_page;
};

struct Document {
  std::string title;
  std::vector<Section> sections;

  void add(Section section, std::vector<Page> pages = every_page);
};

/// Lines of at most 80 columns, as far as words allow.
std::string terminal_text(const Document& document);
std::string markdown_text(const Document& document);
std::string html_text(const Document& document, const std::string& style);
/// Name of the file to its text.
std::map<std::string, std::string> csv_files(const Document& document);

/// A line that ends with a blank where `begin` does; an end that is too long goes on below its own beginning.
std::string terminal_line(const std::string& begin, const std::string& end);

/// What begins a line, a blank at its end whatever its length.
std::string terminal_column(const std::string& text, std::size_t width);

/// Text that Markdown takes as it is, on one line.
std::string plain_markdown(const std::string& text);

/// HTML on one line.
std::string unbroken(const std::string& text);

}  // namespace assay::drivers::study_page
