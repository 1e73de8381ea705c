// SPDX-License-Identifier: BSD-3-Clause
// Rows of numbers from NumPy's arrays.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "drivers/format/npy.hpp"
#include "drivers/format/number_rows.hpp"
#include "drivers/format/zip.hpp"

namespace assay::drivers {

/// One array (.npy) or several of equal lengths (.npz), of floats or whole numbers. An array of one dimension is a
/// column of its name, and its fields are columns where it has any. An array of two dimensions holds several columns:
/// `groups` says which, "X" may stand for X, Y, Z, as many as the array has. A .npy without fields is the group
/// `of_file`. Throws InputError: another name or shape, lengths that differ, no row, what is not finite, damage.
class NpyRows final : public NumberRows {
 public:
  using Groups = std::map<std::string, std::vector<std::string>>;
  NpyRows(const InputBytes& input, const std::vector<std::string>& known, const Groups& groups,
          const std::string& of_file);

  bool next(std::vector<double>& row) override;
  double share() const override { return static_cast<double>(row_) / static_cast<double>(rows_); }
  int line() const override { return static_cast<int>(row_); }

 private:
  static constexpr std::size_t no_member = static_cast<std::size_t>(-1);
  /// What is read in one piece: rows one behind the other.
  struct Part {
    std::size_t member;
    std::uint64_t begin;
    std::size_t row_bytes;
    std::vector<char> held = {};
  };
  struct Column {
    std::size_t part, offset;
    NpyField field;
  };
  [[noreturn]] void refuse(const std::string& what) const;
  void add(std::size_t member, const std::string& name, const Groups& groups);
  void add_column(const std::string& name, const Column& column);
  void fill();

  const InputBytes& input_;
  std::optional<ZipReader> archive_;
  std::vector<std::string> known_;
  std::vector<Part> parts_;
  std::vector<Column> columns_;
  std::uint64_t rows_ = 0, row_ = 0, held_ = 0, held_from_ = 0;
};

}  // namespace assay::drivers
