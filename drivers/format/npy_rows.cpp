// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/npy_rows.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/system/input_error.hpp"
#include "drivers/text/unseen.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

constexpr std::uint64_t rows_at_once = 4096;

std::string in_marks(const std::string& name) { return "'" + shown(name, 40) + "'"; }

}  // namespace

NpyRows::NpyRows(const InputBytes& input, const std::vector<std::string>& known, const Groups& groups,
                 const std::string& of_file)
    : input_(input), known_(known) {
  if (is_npy(input.text(0, 8))) {
    add(no_member, of_file, groups);
  } else {
    archive_.emplace(input);
    for (std::size_t k = 0; k < archive_->members().size(); ++k) {
      const std::string& name = archive_->members()[k].name;
      if (!name.ends_with(".npy")) refuse("has a member " + in_marks(name) + " that is no array");
      add(k, name.substr(0, name.size() - 4), groups);
    }
  }
  if (columns_.empty()) refuse("holds no array");
  if (rows_ == 0) refuse("holds no row of numbers");
}

void NpyRows::refuse(const std::string& what) const { throw InputError({input_.file(), 0, 0}, "", what); }

void NpyRows::add(std::size_t member, const std::string& name, const Groups& groups) {
  constexpr std::size_t enough = longest_npy_header + 16;
  const std::uint64_t all = archive_ ? archive_->members()[member].size : input_.size();
  std::string text(std::min<std::uint64_t>(all, enough), '\0');
  text.resize(archive_ ? archive_->read(member, 0, text.data(), text.size())
                       : input_.read(0, text.data(), text.size()));
  const NpyHeader header = read_npy_header(text, {input_.file(), 0, 0});
  const std::size_t dimensions = header.shape.size();
  if (all - header.size != header.elements() * header.element_bytes())
    refuse("the array " + in_marks(name) + " is cut off, or something follows it");
  if (dimensions == 0 || dimensions > 2 ||
      (dimensions == 2 && (header.fields.size() > 1 || header.fields[0].kind == 'V')))
    refuse("the array " + in_marks(name) + " has " + std::to_string(dimensions) + " dimensions: one row a point");
  if (!columns_.empty() && header.shape[0] != rows_)
    refuse("the array " + in_marks(name) + " has " + std::to_string(header.shape[0]) + " rows, where another has " +
           std::to_string(rows_));
  rows_ = header.shape[0];
  std::size_t offset = 0;
  if (dimensions == 1) {
    parts_.push_back({member, header.size, header.element_bytes()});
    for (const NpyField& field : header.fields) {
      if (field.kind != 'V') add_column(field.name.empty() ? name : field.name, {parts_.size() - 1, offset, field});
      offset += static_cast<std::size_t>(field.bytes);
    }
    return;
  }
  const auto group = groups.find(name);
  const std::size_t width = header.shape[1];
  if (group == groups.end() || width < 2 || width > group->second.size())
    refuse("the array " + in_marks(name) + " has " + std::to_string(width) + " columns" +
           (group == groups.end() ? ", where one belongs; arrays of several are " +
                                        joined(groups, [](const auto& each) { return each.first; })
                                  : ", where 2 or " + std::to_string(group->second.size()) + " belong"));
  const NpyField& field = header.fields.front();
  const auto bytes = static_cast<std::size_t>(field.bytes);
  if (!header.by_columns) parts_.push_back({member, header.size, width * bytes});
  for (std::size_t c = 0; c < width; ++c) {
    if (header.by_columns) parts_.push_back({member, header.size + c * rows_ * bytes, bytes});
    add_column(group->second[c], {parts_.size() - 1, header.by_columns ? 0 : c * bytes, field});
  }
}

void NpyRows::add_column(const std::string& name, const Column& column) {
  if (!is_one_of(name, known_))
    throw InputError({input_.file(), 0, 0}, "", unknown("array " + in_marks(name), name, known_), joined(known_));
  if (is_one_of(name, names_)) refuse("column " + in_marks(name) + " twice");
  names_.push_back(name);
  columns_.push_back(column);
}

void NpyRows::fill() {
  held_from_ = row_;
  held_ = std::min(rows_at_once, rows_ - row_);
  for (Part& part : parts_) {
    part.held.resize(held_ * part.row_bytes);
    const std::uint64_t at = part.begin + row_ * part.row_bytes;
    const std::size_t got = archive_ ? archive_->read(part.member, at, part.held.data(), part.held.size())
                                     : input_.read(at, part.held.data(), part.held.size());
    if (got != part.held.size()) refuse("is cut off");
  }
}

bool NpyRows::next(std::vector<double>& row) {
  if (row_ == rows_) return false;
  if (row_ == held_from_ + held_) fill();
  row.resize(columns_.size());
  const std::uint64_t k = row_++ - held_from_;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    const auto& [part, offset, field] = columns_[c];
    row[c] = npy_number(parts_[part].held.data() + k * parts_[part].row_bytes + offset, field);
    if (!std::isfinite(row[c]))
      throw InputError({input_.file(), line(), static_cast<int>(c) + 1}, names_[c], "is no finite number");
  }
  return true;
}

}  // namespace assay::drivers
