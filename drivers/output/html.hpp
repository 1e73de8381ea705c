// SPDX-License-Identifier: BSD-3-Clause
// Pieces of HTML for report.html.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drivers/result/result.hpp"

namespace assay::drivers::html {

inline constexpr const char* none = "\u2013";  ///< a figure that was not reached

/// A number, or `none`.
std::string figure(const Figure& value, int digits = 4);

std::string with_unit(const std::string& text, const std::string& unit);

/// tag: name and attributes; content is HTML.
std::string element(const std::string& tag, const std::string& content);

std::string section(const std::string& title, const std::string& content);

/// Cells are HTML, with their own <th> or <td> where they begin with one; the first of a row is its header.
std::string table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows);

/// A whole page; title and body are HTML. more_style: behind the style sheet of all pages.
std::string page(const std::string& title, const std::string& body, const std::string& more_style = {});

/// A term of a list of facts.
std::string fact(const std::string& name, const std::string& value);

/// RFC 4648.
std::string base64(std::string_view bytes);

}  // namespace assay::drivers::html
