// SPDX-License-Identifier: BSD-3-Clause
// The four writers of a document.
#include "drivers/study/pages/document.hpp"

#include <algorithm>

#include "drivers/format/csv.hpp"
#include "drivers/output/html.hpp"
#include "drivers/picture/drawing.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers::study_page {

namespace {

using Texts = std::vector<std::string>;

/// The text with a blank after every `most` characters of a word.
std::string with_short_words(const std::string& text, std::size_t most) {
  std::string split;
  std::size_t length = 0;
  for (const char c : text) {
    if (c == ' ') length = 0;
    const bool begins = (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;  // a character of UTF-8
    if (c != ' ' && begins && ++length > most) split += ' ', length = 1;
    split += c;
  }
  return split;
}

std::string as_it_is(const std::string& words) { return words; }

/// The columns that a page shows, its heads first; `shown` writes the words of a cell there.
std::vector<Texts> lines_on(Page page, const Table& table, const auto& shown) {
  std::vector<Texts> lines(1 + table.rows.size());
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const std::string& head = table.columns[k][page];
    if (head.empty()) continue;
    lines[0].push_back(head);
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const Cell& cell = table.rows[i][k];
      const auto instead = cell.instead.find(page);
      lines[i + 1].push_back(instead == cell.instead.end() ? shown(cell.text) : instead->second);
    }
  }
  return lines;
}

/// All columns but the last are equally wide.
std::string terminal_table(const Table& table, bool has_heads) {
  constexpr std::size_t width = 10;
  const std::vector<Texts> lines = lines_on(Page::terminal, table, as_it_is);
  std::string text;
  for (std::size_t i = has_heads ? 0 : 1; i < lines.size(); ++i) {
    std::string begin = "  ";
    for (std::size_t k = 0; k + 1 < lines[i].size(); ++k) begin += terminal_column(lines[i][k], width);
    text += terminal_line(begin, lines[i].back());
  }
  return text;
}

std::string markdown_table(const Table& table) {
  std::vector<Texts> lines = lines_on(Page::markdown, table, plain_markdown);
  lines.insert(lines.begin() + 1, Texts(lines[0].size(), "---"));
  std::string text;
  for (const Texts& line : lines) text += markdown_line(line);
  return text;
}

std::string html_table(const Table& table) {
  std::vector<Texts> lines = lines_on(Page::html, table, escaped);
  const Texts head = lines.front();
  lines.erase(lines.begin());
  return html::table(head, lines);
}

/// What a page shows of each section, its table as `written`, in one text; `whole` adds its heading.
std::string all_of(const Document& document, Page page, const auto& written, const auto& whole) {
  std::string text;
  for (const Section& section : document.sections) {
    const auto& pages = section.pages;
    if (std::ranges::find(pages, page) == pages.end()) continue;
    const auto& columns = section.table.columns;
    const bool has_table = !section.table.rows.empty() &&
                           std::ranges::any_of(columns, [&](const Column& each) { return !each[page].empty(); });
    if (has_table || !section.before[page].empty()) {
      text += whole(section, section.before[page] + (has_table ? written(section) : "") + section.after[page]);
    }
  }
  return text;
}

}  // namespace

Cell figure_cell(const std::optional<double>& value, const std::string& words) {
  if (!value) return Cell(html::none).on(Page::terminal, "-").on(Page::csv, "");
  return Cell(words).on(Page::markdown, words).on(Page::csv, csv_number(value));
}

Cell unbroken_cell(const std::optional<double>& value, const std::string& words) {
  return figure_cell(value, words).on(Page::html, value ? unbroken(words) : html::none);
}

Cell words_cell(const std::string& text, const std::string& classes) {
  return Cell(text).on(Page::html, html::element("td class=\"" + classes + "\"", escaped(text)));
}

void Document::add(Section section, std::vector<Page> pages) {
  section.pages = std::move(pages);
  sections.push_back(std::move(section));
}

std::string terminal_text(const Document& document) {
  return all_of(
      document, Page::terminal,
      [](const Section& section) { return terminal_table(section.table, section.before[Page::terminal].empty()); },
      [](const Section&, const std::string& content) { return content; });
}

std::string markdown_text(const Document& document) {
  return "# " + plain_markdown(document.title) + "\n" +
         all_of(
             document, Page::markdown, [](const Section& section) { return markdown_table(section.table); },
             [](const Section& section, const std::string& content) {
               return (section.heading.empty() ? "" : "\n## " + section.heading + "\n\n") + content;
             });
}

std::string html_text(const Document& document, const std::string& style) {
  const auto whole = [](const Section& section, std::string content) {
    const std::string &file = section.file, &remark = section.remark;
    if (!remark.empty()) content += html::element("p class=\"tally\"", html::element("small", remark)) + "\n";
    if (!file.empty()) content += "<p class=\"data\">Data: <a href=\"" + file + "\">" + file + "</a></p>\n";
    return section.heading.empty() ? content : html::section(section.heading, content);
  };
  const std::string body = all_of(
      document, Page::html, [](const Section& section) { return html_table(section.table); }, whole);
  return html::page(escaped(document.title), body, style);
}

std::map<std::string, std::string> csv_files(const Document& document) {
  std::map<std::string, std::string> files;
  for (const Section& section : document.sections) {
    const std::vector<Texts> lines = lines_on(Page::csv, section.table, as_it_is);
    if (lines[0].empty() || files.contains(section.file)) continue;
    CsvText out(lines[0]);
    for (std::size_t i = 1; i < lines.size(); ++i) out.row(lines[i]);
    files[section.file] = out.text();
  }
  return files;
}

std::string terminal_column(const std::string& text, std::size_t width) { return padded(text + " ", width); }

std::string terminal_line(const std::string& begin, const std::string& end) {
  constexpr std::size_t columns = 80, least = 20;  // of an end
  const std::size_t room = columns - std::min(columns - least, characters(begin));
  if (characters(begin) + characters(end) <= columns) return begin + end + "\n";
  const std::string below(columns - room, ' ');  // of as many characters as `begin`, which may have more bytes
  return begin + wrapped(with_short_words(end, room), below, below).substr(below.size());
}

std::string plain_markdown(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("\\`*_{}[]<>#|").find(c) != std::string_view::npos) out += '\\';
    out += static_cast<unsigned char>(c) < 32 ? ' ' : c;
  }
  return out;
}

std::string unbroken(const std::string& text) {
  std::string out;
  for (const char c : escaped(text)) out += c == ' ' ? std::string("\u00a0") : std::string(1, c);
  return out;
}

}  // namespace assay::drivers::study_page
