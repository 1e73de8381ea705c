// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/npy.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <optional>

#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

static_assert(std::endian::native == std::endian::little, "the files say <f8");

namespace {

constexpr std::string_view npy_mark = "\x93NUMPY";

/// The dictionary of a header, as Python writes it.
class NpyDictionary {
 public:
  NpyDictionary(std::string_view text, const Location& where) : text_(text), where_(where) {}

  NpyHeader read() {
    expect('{');
    while (!takes('}')) {
      const std::string key = word();
      expect(':');
      if (key == "descr")
        descr();
      else if (key == "fortran_order")
        header_.by_columns = truth();
      else if (key == "shape")
        shape();
      else
        fail("a key '" + shown(key, 40) + "'");
      if (!takes(',') && !sees('}')) fail("a key that does not end");
    }
    if (header_.fields.empty() || !has_shape_) fail("no type or no shape");
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(where_, "", "the header of the array has " + what);
  }
  void skip() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
  }
  bool sees(char c) {
    skip();
    return at_ < text_.size() && text_[at_] == c;
  }
  bool takes(char c) {
    const bool found = sees(c);
    at_ += found ? 1 : 0;
    return found;
  }
  void expect(char c) {
    if (!takes(c)) fail(std::string("no '") + c + "' where it belongs");
  }
  std::string word() {
    skip();
    const char quote = at_ < text_.size() ? text_[at_] : ' ';
    if (quote != '\'' && quote != '"') fail("no text in quotes where it belongs");
    const std::size_t end = text_.find(quote, at_ + 1);
    if (end == text_.npos) fail("a quote that is not closed");
    std::string found(text_.substr(at_ + 1, end - at_ - 1));
    at_ = end + 1;
    return found;
  }
  bool truth() {
    skip();
    for (const std::string_view word : {"True", "False"}) {
      if (text_.substr(at_).starts_with(word)) {
        at_ += word.size();
        return word == "True";
      }
    }
    fail("neither True nor False where it belongs");
  }
  void descr() {
    header_.fields.clear();
    if (!takes('[')) {
      header_.fields.push_back(field("", false));
      return;
    }
    while (!takes(']')) {
      expect('(');
      const std::string name = word();
      expect(',');
      header_.fields.push_back(field(name, name.empty()));
      takes(',');
      if (!takes(')')) fail("elements that are no plain numbers");
      takes(',');
    }
  }
  NpyField field(const std::string& name, bool may_be_padding) {
    if (sees('[') || sees('(')) fail("elements that are no plain numbers");
    const std::string type = word();
    const bool order = !type.empty() && std::string_view("<>|=").find(type[0]) != std::string_view::npos;
    NpyField found{name, 'f', 0, order && type[0] == '>'};
    const std::string kind = type.substr(order ? 1 : 0);
    const std::int64_t bytes =
        kind.empty() ? 0 : parse_integer(std::string_view(kind).substr(1)).value_or(0);  // 0: none
    const char letter = kind.empty() ? ' ' : kind[0];
    const bool real = letter == 'f' && (bytes == 4 || bytes == 8);
    const bool padding = may_be_padding && letter == 'V' && bytes > 0 && bytes < (1 << 20);
    const bool whole = (letter == 'i' || letter == 'u') && (bytes == 1 || bytes == 2 || bytes == 4 || bytes == 8);
    if (!real && !whole && !padding)
      fail("numbers of the type '" + shown(type, 40) + "': floats of 4 or 8 bytes and whole numbers are read");
    found.kind = letter, found.bytes = static_cast<int>(bytes);
    return found;
  }
  void shape() {
    has_shape_ = true;
    header_.shape.clear();
    expect('(');
    std::uint64_t all = 1;
    while (!takes(')')) {
      skip();
      const std::size_t end = std::min(text_.find_first_not_of("0123456789", at_), text_.size());
      const auto length = parse_integer(text_.substr(at_, end - at_));
      constexpr auto most = std::uint64_t{1} << 56;
      if (!length || *length < 0 || header_.shape.size() > 8) fail("a shape that is no list of at most 8 sizes");
      const auto n = static_cast<std::uint64_t>(*length);
      if (n > 0 && all > most / n) fail("a shape of too many numbers");
      all *= n;
      header_.shape.push_back(n);
      at_ = end;
      if (!takes(',') && !sees(')')) fail("a shape that is no list of at most 8 sizes");
    }
  }

  std::string_view text_;
  const Location& where_;
  std::size_t at_ = 0;
  NpyHeader header_;
  bool has_shape_ = false;
};

template <class Value>
double value_of(const char* bytes, bool swapped) {
  std::array<char, sizeof(Value)> own;
  std::copy(bytes, bytes + own.size(), own.begin());
  if (swapped) std::reverse(own.begin(), own.end());
  return static_cast<double>(std::bit_cast<Value>(own));
}

}  // namespace

std::uint64_t NpyHeader::elements() const {
  std::uint64_t all = 1;
  for (const std::uint64_t n : shape) all *= n;
  return all;
}

std::size_t NpyHeader::element_bytes() const {
  std::size_t bytes = 0;
  for (const NpyField& field : fields) bytes += static_cast<std::size_t>(field.bytes);
  return bytes;
}

std::string npy_header(const std::vector<std::uint64_t>& shape, const std::vector<std::string>& names) {
  std::string text = "{'descr': ";
  if (names.empty()) text += "'<f8'";
  for (const std::string& name : names) text += (&name == &names.front() ? "[('" : ", ('") + name + "', '<f8')";
  text += names.empty() ? ", 'fortran_order': False, 'shape': (" : "], 'fortran_order': False, 'shape': (";
  for (const std::uint64_t& n : shape)
    text += std::to_string(n) + (shape.size() == 1 || &n != &shape.back() ? "," : "");
  text += "), }";
  constexpr std::size_t before = 10, alignment = 64;  // mark, version and length; of the numbers
  text.resize((before + text.size() + alignment) / alignment * alignment - before, ' ');
  text.back() = '\n';
  std::string header(npy_mark);
  header += {'\1', '\0', static_cast<char>(text.size() & 0xff), static_cast<char>(text.size() >> 8)};
  return header + text;
}

NpyHeader read_npy_header(std::string_view text, const Location& where) {
  if (!is_npy(text) || text.size() < 12) throw InputError(where, "", "no array of NumPy");
  const auto byte = [&](std::size_t k) { return static_cast<std::size_t>(static_cast<unsigned char>(text[k])); };
  const std::size_t version = byte(6);
  if (version < 1 || version > 3)
    throw InputError(where, "", "an array of NumPy of version " + std::to_string(version) + ": 1 to 3 are read");
  const std::size_t begin = version == 1 ? 10 : 12;
  const std::size_t length = byte(8) + (byte(9) << 8) + (version == 1 ? 0 : (byte(10) << 16) + (byte(11) << 24));
  if (length > longest_npy_header || text.size() < begin + length)
    throw InputError(where, "", "the header of the array is cut off");
  NpyHeader header = NpyDictionary(text.substr(begin, length), where).read();
  header.size = begin + length;
  return header;
}

bool is_npy(std::string_view text) { return text.starts_with(npy_mark); }

bool is_zip(std::string_view text) { return text.starts_with("PK\3\4") || text.starts_with("PK\5\6"); }

double npy_number(const char* bytes, const NpyField& field) {
  const bool swapped = field.big_endian;
  if (field.kind == 'f') return field.bytes == 8 ? value_of<double>(bytes, swapped) : value_of<float>(bytes, swapped);
  const bool has_sign = field.kind == 'i';
  switch (field.bytes) {
    case 1:
      return has_sign ? value_of<std::int8_t>(bytes, false) : value_of<std::uint8_t>(bytes, false);
    case 2:
      return has_sign ? value_of<std::int16_t>(bytes, swapped) : value_of<std::uint16_t>(bytes, swapped);
    case 4:
      return has_sign ? value_of<std::int32_t>(bytes, swapped) : value_of<std::uint32_t>(bytes, swapped);
    default:
      return has_sign ? value_of<std::int64_t>(bytes, swapped) : value_of<std::uint64_t>(bytes, swapped);
  }
}

}  // namespace assay::drivers
