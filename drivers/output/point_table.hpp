// SPDX-License-Identifier: BSD-3-Clause
// A table of exact values as it goes into a file, block by block.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>

#include "drivers/output/point_columns.hpp"

namespace assay::drivers {

enum class TableFormat { csv, npy, npz, vtu };
const std::vector<std::string>& names_of_formats();

/// What `asked` says (--format); where it is empty, what the suffix of the file says (.vtu and .pvd are one), otherwise
/// CSV. Throws InputError.
TableFormat format_of(const std::string& asked, const std::string& file);

/// Throws InputError where nothing is asked for and the suffix is of no table.
void require_table_name(const std::string& asked, const std::string& file);

struct TableShape {
  PointColumns wanted;  ///< for VTU with the position and the time among the columns
  std::uint64_t rows = 0;
  std::map<double, std::uint64_t> rows_at = {};  ///< for VTU: rows of each time
};

/// Writes all rows in their order, [row * columns + column]. Nothing is left of it where finish() is not reached, but
/// for what a stream has taken already. Throws SystemError, Interrupted.
class PointTable {
 public:
  virtual ~PointTable() = default;
  virtual void add(std::span<const double> values) = 0;
  virtual void finish() = 0;
};

/// CSV; one array of NumPy whose elements have the columns as fields; an archive of arrays, one a field; or VTK's
/// vertices at their positions: one file a time, and where there are several times, a .pvd that lists them. file: empty
/// or "-" for standard output. Throws InputError where a stream cannot take several files.
std::unique_ptr<PointTable> point_table(TableFormat format, const std::string& file, TableShape shape);

/// The last of these.
std::unique_ptr<PointTable> vtu_table(const std::string& file, const TableShape& shape);

}  // namespace assay::drivers
