// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/html.hpp"

#include <cmath>
#include <cstdint>

#include "drivers/text/numbers.hpp"

namespace assay::drivers::html {

std::string figure(const Figure& value, int digits) {
  return value && std::isfinite(*value) ? rounded_text(*value, digits) : none;
}

std::string with_unit(const std::string& text, const std::string& unit) {
  return text == none || unit.empty() ? text : text + "\u202f" + unit;
}

std::string element(const std::string& tag, const std::string& content) {
  return "<" + tag + ">" + content + "</" + tag.substr(0, tag.find(' ')) + ">";
}

std::string section(const std::string& title, const std::string& content) {
  return "<section>\n" + element("h2", title) + "\n" + content + "</section>\n";
}

std::string table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows) {
  std::string out = "<div class=\"wide\"><table><thead><tr>";
  for (const std::string& cell : head) out += cell.starts_with("<th") ? cell : element("th scope=\"col\"", cell);
  out += "</tr></thead><tbody>\n";
  for (const auto& row : rows) {
    out += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      out += i == 0 ? element("th scope=\"row\"", row[i]) : row[i].starts_with("<td") ? row[i] : element("td", row[i]);
    }
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

std::string page(const std::string& title, const std::string& body, const std::string& more_style) {
  constexpr const char* style =
#include "report_style.inc"
      ;
  return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n" +
         element("title", title) + "\n<style>" + style + more_style + "</style>\n</head>\n<body>\n<main>\n" +
         element("h1", title) + "\n" + body + "</main>\n</body>\n</html>\n";
}

std::string fact(const std::string& name, const std::string& value) {
  return element("dt", name) + element("dd", value.empty() ? none : value) + "\n";
}

std::string base64(std::string_view bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    const std::size_t have = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k) word = word << 8 | (k < have ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) out += k <= have ? digits[word >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

}  // namespace assay::drivers::html
