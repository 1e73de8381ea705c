// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/text_check.hpp"

#include "drivers/format/yaml_reader.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

bool is_utf16(std::string_view text) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return true;
  const auto is_zero = [&](std::size_t i) { return text[i] == '\0'; };
  return text.size() >= 4 && is_zero(0) == is_zero(2) && is_zero(1) == is_zero(3) && is_zero(0) != is_zero(1);
}

void check_text(std::string_view text, const std::string& name, std::size_t limit) {
  if (text.size() > limit) throw InputError({name, 0, 0}, "", "longer than " + std::to_string(limit) + " bytes");
  const bool in_file = name != set_option;
  Location where{name, in_file ? 1 : 0, in_file ? 1 : 0};
  if (text.starts_with("\x7f"
                       "ELF"))
    throw InputError(where, "",
                     "this is a library, not a text: a scene names it by material.adapter, and `assay check` takes it");
  if (is_utf16(text)) throw InputError(where, "", "UTF-16 text: save it as UTF-8");
  bool indenting = true;
  for (std::size_t i = 0; i < text.size();) {
    std::uint32_t code = 0;
    const std::size_t size = character_size(text.substr(i), code);
    const auto byte = static_cast<unsigned char>(text[i]);
    if (size == 0) throw InputError(where, "", "not UTF-8 text");
    if ((byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r') || byte == 0x7f) {
      throw InputError(where, "", "a control character, " + shown(text.substr(i, 1), 1) + "; not a text file?");
    }
    if (indenting && byte == '\t') {
      const std::size_t word = text.find_first_not_of(" \t\r", i);
      if (word != text.npos && text[word] != '\n' && text[word] != '#') {
        throw InputError(where, "", "a tab in the indentation; YAML needs spaces");
      }
    }
    if (byte != ' ' && byte != '\t') indenting = false;
    if (in_file) ++where.column;
    if (byte == '\n') {
      indenting = true;
      if (in_file) ++where.line, where.column = 1;
    }
    i += size;
  }
}

}  // namespace assay::drivers
