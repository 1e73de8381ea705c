// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/yaml_writer.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "drivers/system/input_error.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

std::string digits_of(double value, std::chars_format format) {
  char text[64];
  return std::string(text, std::to_chars(text, text + sizeof text, value, format).ptr);
}

/// Text to every reader: YAML 1.1 has more words for truth than 1.2, and PyYAML knows them in three spellings.
bool is_plain_text(const std::string& text) {
  const auto letter = [](char c) { return is_letter(c) || c == '_'; };
  const auto plain = [&](char c) { return letter(c) || is_digit(c) || c == '-' || c == '.' || c == '/'; };
  if (text.empty() || !(letter(text[0]) || (text[0] == '/' && text.size() > 1))) return false;
  if (!std::all_of(text.begin(), text.end(), plain)) return false;
  return !is_one_of(small_letters(text), {"null", "true", "false", "yes", "no", "on", "off", "y", "n"});
}

/// What stands for the character at the beginning of `text`, and its bytes; nothing where it may stand as it is. YAML
/// 1.1 ends a line at U+0085, U+2028 and U+2029, and some readers refuse what cannot be printed.
std::pair<std::string, std::size_t> escape(std::string_view text) {
  const auto byte = static_cast<unsigned char>(text[0]);
  const auto hexadecimal = [](unsigned value) {
    return std::string{"0123456789abcdef"[value >> 4], "0123456789abcdef"[value & 15u]};
  };
  if (byte == '"' || byte == '\\') return {std::string("\\") + text[0], 1};
  if (byte < 0x20 || byte == 0x7f) return {"\\x" + hexadecimal(byte), 1};
  if (byte == 0xc2 && text.size() > 1) {
    const auto next = static_cast<unsigned char>(text[1]);
    if (next >= 0x80 && next < 0xa0) return {"\\x" + hexadecimal(next), 2};
  }
  if (text.starts_with("\xe2\x80\xa8")) return {"\\u2028", 3};
  if (text.starts_with("\xe2\x80\xa9")) return {"\\u2029", 3};
  if (text.starts_with("\xef\xbb\xbf")) return {"\\ufeff", 3};
  if (text.starts_with("\xef\xbf\xbe")) return {"\\ufffe", 3};
  if (text.starts_with("\xef\xbf\xbf")) return {"\\uffff", 3};
  return {};
}

}  // namespace

std::string yaml_number(double value) {
  if (std::isnan(value)) return ".nan";
  if (std::isinf(value)) return value > 0 ? ".inf" : "-.inf";
  if (value == 0) return std::signbit(value) ? "-0.0" : "0";  // a whole -0 has lost its sign
  std::string text = digits_of(value, std::chars_format::scientific);
  const std::size_t e = text.find('e');
  std::string mantissa = text.substr(0, e), exponent = text.substr(e + 2);
  if (mantissa.find('.') == mantissa.npos) mantissa += ".0";
  exponent.erase(0, std::min(exponent.find_first_not_of('0'), exponent.size() - 1));
  text = mantissa + "e" + text[e + 1] + exponent;
  const double size = std::abs(value);
  if (size < 1e-5 || size >= 1e15) return text;  // longer without an exponent
  std::string fixed = digits_of(value, std::chars_format::fixed);
  return fixed.size() <= text.size() ? fixed : text;
}

std::string yaml_scalar(const std::string& text) {
  if (is_plain_text(text)) return text;
  std::string quoted = "\"";
  for (std::size_t i = 0; i < text.size();) {
    const auto [words, bytes] = escape(std::string_view(text).substr(i));
    quoted += bytes == 0 ? std::string(1, text[i]) : words;
    i += std::max<std::size_t>(bytes, 1);
  }
  return quoted + "\"";
}

std::string yaml_list(const std::vector<std::string>& texts) {
  std::vector<std::string> scalars(texts.size());
  std::transform(texts.begin(), texts.end(), scalars.begin(), yaml_scalar);
  return "[" + joined(scalars) + "]";
}

}  // namespace assay::drivers
