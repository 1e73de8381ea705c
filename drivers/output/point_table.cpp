// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/point_table.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "drivers/format/csv.hpp"
#include "drivers/format/npy.hpp"
#include "drivers/format/zip.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/output_bytes.hpp"
#include "drivers/text/unseen.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

std::string_view bytes_of(std::span<const double> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

class CsvTableFile final : public PointTable {
 public:
  CsvTableFile(const std::string& file, const TableShape& shape)
      : out_(file), columns_(shape.wanted.columns.size()), text_(mapped(shape.wanted.columns, &PointColumn::name)) {}

  void add(std::span<const double> values) override {
    for (std::size_t at = 0; at < values.size(); at += columns_) text_.row(values.subspan(at, columns_));
    out_.append(text_.take());
  }
  void finish() override { out_.commit(); }

 private:
  OutputBytes out_;
  std::size_t columns_;
  CsvText text_;
};

class NpyTableFile final : public PointTable {
 public:
  NpyTableFile(const std::string& file, const TableShape& shape)
      : out_(file), header_(npy_header({shape.rows}, mapped(shape.wanted.columns, &PointColumn::name))) {}

  void add(std::span<const double> values) override {
    if (!header_.empty()) out_.append(std::exchange(header_, {}));
    out_.append(bytes_of(values));
  }
  void finish() override { out_.commit(); }

 private:
  OutputBytes out_;
  std::string header_;
};

class NpzTableFile final : public PointTable {
 public:
  NpzTableFile(const std::string& file, TableShape shape)
      : out_(file, OutputBytes::Order::any), columns_(shape.wanted.columns.size()) {
    for (PointField& field : shape.wanted.fields) {
      std::vector<std::uint64_t> lengths{shape.rows};
      if (field.columns.size() == 9)
        lengths.insert(lengths.end(), {3, 3});
      else if (field.columns.size() > 1)
        lengths.push_back(field.columns.size());
      std::string header = npy_header(lengths);
      const std::uint64_t bytes = shape.rows * field.columns.size() * sizeof(double);
      const std::size_t member = layout_.add(field.name + ".npy", header.size() + bytes);
      arrays_.push_back({std::move(field), std::move(header), layout_.begin(member)});
    }
  }

  void add(std::span<const double> values) override {
    for (std::size_t k = 0; k < arrays_.size(); ++k) {
      Array& array = arrays_[k];
      if (!array.header.empty()) put(k, std::exchange(array.header, {}));
      gathered_.clear();
      for (std::size_t at = 0; at < values.size(); at += columns_) {
        for (const int c : array.field.columns)
          gathered_.push_back(c < 0 ? 0 : values[at + static_cast<std::size_t>(c)]);
      }
      put(k, bytes_of(gathered_));
    }
  }
  void finish() override {
    for (const ZipLayout::Piece& piece : layout_.pieces()) out_.write_at(piece.at, piece.bytes);
    out_.commit();
  }

 private:
  struct Array {
    PointField field;
    std::string header;    ///< empty once it is written
    std::uint64_t at = 0;  ///< of the next bytes
  };
  void put(std::size_t k, std::string_view bytes) {
    layout_.count(k, bytes);
    out_.write_at(arrays_[k].at, bytes);
    arrays_[k].at += bytes.size();
  }

  OutputBytes out_;
  std::size_t columns_;
  ZipLayout layout_;
  std::vector<Array> arrays_;
  std::vector<double> gathered_;
};

}  // namespace

const std::vector<std::string>& names_of_formats() {
  static const std::vector<std::string> names{"csv", "npy", "npz", "vtu"};
  return names;
}

namespace {

std::string suffix_of(const std::string& file) {
  return small_letters(std::filesystem::path(file).extension().string());
}

/// Nothing for a suffix that is of no table.
std::optional<TableFormat> format_by_name(const std::string& file) {
  const std::string suffix = suffix_of(file);
  if (suffix == ".pvd") return TableFormat::vtu;
  if (is_one_of(suffix, {"", ".txt", ".dat"})) return TableFormat::csv;
  const std::size_t k = index_of(suffix.substr(1), names_of_formats());
  return k == names_of_formats().size() ? std::nullopt : std::optional(static_cast<TableFormat>(k));
}

}  // namespace

TableFormat format_of(const std::string& asked, const std::string& file) {
  const std::vector<std::string>& names = names_of_formats();
  const std::size_t k = index_of(asked, names);
  if (!asked.empty() && k == names.size())
    throw InputError({}, "--format", unknown("format '" + shown(asked, 40) + "'", asked, names), joined(names));
  if (!asked.empty()) return static_cast<TableFormat>(k);
  return format_by_name(file).value_or(TableFormat::csv);
}

void require_table_name(const std::string& asked, const std::string& file) {
  if (!asked.empty() || is_stream(file) || format_by_name(file)) return;
  throw InputError(
      {}, "-o",
      "no table ends in '" + shown(suffix_of(file), 40) + "': --format csv writes text into a file of any name",
      joined(names_of_formats()));
}

std::unique_ptr<PointTable> point_table(TableFormat format, const std::string& file, TableShape shape) {
  switch (format) {
    case TableFormat::npy:
      return std::make_unique<NpyTableFile>(file, shape);
    case TableFormat::npz:
      return std::make_unique<NpzTableFile>(file, std::move(shape));
    case TableFormat::vtu:
      return vtu_table(file, shape);
    default:
      return std::make_unique<CsvTableFile>(file, shape);
  }
}

}  // namespace assay::drivers
