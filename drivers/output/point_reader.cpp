// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/point_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "drivers/format/csv.hpp"
#include "drivers/format/npy_rows.hpp"
#include "drivers/system/input_error.hpp"

namespace assay::drivers {

namespace {

using Member = double ReferencePoint::*;
constexpr std::array<std::pair<const char*, Member>, 10> point_columns{{{"X", &ReferencePoint::X},
                                                                        {"Y", &ReferencePoint::Y},
                                                                        {"Z", &ReferencePoint::Z},
                                                                        {"t", &ReferencePoint::t},
                                                                        {"NX", &ReferencePoint::NX},
                                                                        {"NY", &ReferencePoint::NY},
                                                                        {"NZ", &ReferencePoint::NZ},
                                                                        {"HX", &ReferencePoint::HX},
                                                                        {"HY", &ReferencePoint::HY},
                                                                        {"HZ", &ReferencePoint::HZ}}};

constexpr const char* both_ways =
    "each row has its time in a column t, or --times gives the times at which all points are wanted";

}  // namespace

PointReader::PointReader(const InputBytes& input, std::vector<double> times) : input_(input), times_(std::move(times)) {
  rows_ = rows_of_input();
  find_columns();
}

std::unique_ptr<NumberRows> PointReader::rows_of_input() const {
  const std::string mark = input_.text(0, 8);
  if (is_npy(mark) || is_zip(mark)) {
    const auto names = mapped(point_columns, [](const auto& column) { return std::string(column.first); });
    return std::make_unique<NpyRows>(
        input_, names, NpyRows::Groups{{"X", {"X", "Y", "Z"}}, {"N", {"NX", "NY", "NZ"}}, {"H", {"HX", "HY", "HZ"}}},
        "X");
  }
  return std::make_unique<CsvRows>(CsvLines(input_), std::vector<std::string>{"X", "Y"},
                                   std::vector<std::string>{"t", "Z", "NX", "NY", "NZ", "HX", "HY", "HZ"});
}

void PointReader::find_columns() {
  const auto has = [&](const std::string& name) { return is_one_of(name, rows_->names()); };
  const auto refuse = [&](const std::string& what) {
    const int line = rows_->header_line();
    throw InputError({input_.file(), line, line > 0 ? 1 : 0}, {}, what, "X, Y, Z, t, NX, NY, NZ, HX, HY, HZ");
  };
  if (!has("X") || !has("Y")) refuse("no columns 'X' and 'Y'");
  for (const std::string letter : {"N", "H"}) {
    const bool X_of = has(letter + "X"), Y_of = has(letter + "Y"), Z_of = has(letter + "Z");
    if (X_of == Y_of && (X_of || !Z_of)) continue;
    const std::string both = letter + "X and " + letter + "Y";
    refuse(Z_of ? letter + "Z only comes with " + both : both + " only come together");
  }
  given_ = {has("Z"), has("t"), has("NX"), has("NZ"), has("HX"), has("HZ")};
  if (given_.times && !times_.empty())
    throw InputError({}, "--times", "the points have a column t: leave out the column or the option");
  if (!given_.times && times_.empty()) refuse(std::string("no column 't': ") + both_ways);
  for (const std::string& name : rows_->names()) {
    const auto column = std::ranges::find_if(point_columns, [&](const auto& each) { return each.first == name; });
    members_.push_back(column->second);
  }
}

ReferencePoint PointReader::point() const {
  ReferencePoint point;
  for (std::size_t c = 0; c < members_.size(); ++c) point.*members_[c] = row_[c];
  point.line = rows_->line();
  const auto refuse_if = [&](bool fault, const std::string& key, const std::string& what) {
    if (fault) throw InputError(Location{input_.file(), point.line, 1}, key, what);
  };
  if (given_.boxes) {
    if (!given_.third_edge) point.HZ = point.HX;
    refuse_if(!(std::min({point.HX, point.HY, point.HZ}) > 0), {}, "the half edges HX, HY, HZ must be greater than 0");
  }
  refuse_if(given_.normals && point.NX == 0 && point.NY == 0 && point.NZ == 0, {},
            std::string("the normal NX,NY") + (given_.third_normal ? ",NZ" : "") + " has no length");
  refuse_if(point.t < 0, "t", "negative: histories begin at t = 0");
  return point;
}

/// The next rows. Those of one time stay together, if they are no more than that.
void PointReader::read_rows(std::vector<ReferencePoint>& block, std::size_t most) {
  constexpr std::size_t enough = 1024;  // rows of one time, for a block of their own
  if (!rows_) rows_ = rows_of_input();
  if (ahead_) block.push_back(*std::exchange(ahead_, std::nullopt));
  const auto goes_on = std::exchange(of_one_time_, std::nullopt);  // the rest of a time is a block, too
  bool one_time = true;
  while (block.size() < most && rows_->next(row_)) {
    const ReferencePoint next = point();
    const bool same = block.empty() || next.t == block.front().t;
    if (one_time && !same && (block.size() >= enough || block.front().t == goes_on)) {
      ahead_ = next;
      return;
    }
    one_time = one_time && same;
    block.push_back(next);
  }
  if (one_time && !block.empty()) of_one_time_ = block.front().t;
}

bool PointReader::next(std::vector<ReferencePoint>& block, std::size_t most) {
  block.clear();
  if (times_.empty()) {
    read_rows(block, most);
    return !block.empty();
  }
  while (block.empty()) {
    if (time_ == times_.size()) return false;
    const bool begins = !rows_;
    if (is_all_)
      block = all_;
    else
      read_rows(block, most);
    const bool ends = is_all_ || block.size() < most;
    if (!is_all_ && begins && ends) all_ = block, is_all_ = true;
    for (ReferencePoint& point : block) point.t = times_[time_];
    if (ends) ++time_, rows_.reset();
  }
  return true;
}

void PointReader::rewind(std::vector<double> times) {
  times_ = std::move(times);
  time_ = 0;
  ahead_.reset(), of_one_time_.reset();
  rows_.reset();
}

}  // namespace assay::drivers
