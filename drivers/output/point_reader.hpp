// SPDX-License-Identifier: BSD-3-Clause
// The reference points that `eval` is asked for, in blocks and again and again.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/format/number_rows.hpp"
#include "drivers/system/input_bytes.hpp"

namespace assay::drivers {

/// A reference point at a time, with the outward unit normal of a surface element where one is given.
struct ReferencePoint {
  double X = 0, Y = 0, Z = 0;     ///< [m]
  double t = 0;                   ///< [s]
  double NX = 0, NY = 0, NZ = 0;  ///< [1], as given
  double HX = 0, HY = 0, HZ = 0;  ///< half edges of the box around it over which b is averaged [m]; 0: at the point
  int line = 0;                   ///< in the file, from 1; of arrays the row
};

struct PointsGiven {
  bool z = false, times = false, normals = false, third_normal = false, boxes = false, third_edge = false;
};

/// CSV with columns X,Y and perhaps t, Z, NX and NY (both or neither), with them perhaps NZ, not all zero; HX and HY
/// likewise, with them perhaps HZ, all above 0. NumPy's arrays of these names, where X, N and H may have two or three
/// columns; a .npy without fields is X. Throws InputError as CsvRows and NpyRows do, and for t < 0.
class PointReader {
 public:
  /// times [s]: all points at each of them, one time after the other; empty: each point has its own, in the column t.
  explicit PointReader(const InputBytes& input, std::vector<double> times = {});

  const PointsGiven& given() const { return given_; }

  /// Replaces what is in the block by the next points, at most so many; points of one time, where there are many, have
  /// blocks of their own. False: there are none.
  bool next(std::vector<ReferencePoint>& block, std::size_t most);

  double share() const { return rows_ ? rows_->share() : 1; }  ///< of the input that was read

  /// All begins anew, with other times.
  void rewind(std::vector<double> times);
  void rewind() { rewind(times_); }

 private:
  std::unique_ptr<NumberRows> rows_of_input() const;
  void find_columns();
  ReferencePoint point() const;
  void read_rows(std::vector<ReferencePoint>& block, std::size_t most);

  const InputBytes& input_;
  std::vector<double> times_;
  std::size_t time_ = 0;
  PointsGiven given_;
  std::unique_ptr<NumberRows> rows_;
  std::vector<double ReferencePoint::*> members_;  ///< of each column
  std::vector<double> row_;
  std::optional<ReferencePoint> ahead_;  ///< the first row of the next block
  std::optional<double> of_one_time_;    ///< all rows of the last block, which is full
  std::vector<ReferencePoint> all_;      ///< where they are few: those of one time
  bool is_all_ = false;
};

}  // namespace assay::drivers
