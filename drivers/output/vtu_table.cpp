// SPDX-License-Identifier: BSD-3-Clause
// Tables of exact values for ParaView: a file a time.
#include <algorithm>
#include <array>
#include <filesystem>

#include "drivers/output/point_table.hpp"
#include "drivers/output/vtu.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/output_bytes.hpp"
#include "drivers/system/whole_file.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t most_times = 10'000;  ///< files in a folder

int column_named(const std::vector<PointColumn>& columns, const std::string& name) {
  const auto found = std::ranges::find_if(columns, [&](const PointColumn& column) { return column.name == name; });
  return found == columns.end() ? -1 : static_cast<int>(found - columns.begin());
}

/// VTK has vectors of three components and tensors of nine.
std::vector<int> as_vtk_has_it(const PointField& field) {
  std::vector<int> columns = field.columns;
  if (field.is_tensor && columns.size() == 6) {
    std::vector<int> whole;
    for (const std::size_t k : {0, 3, 4, 3, 1, 5, 4, 5, 2}) whole.push_back(columns[k]);
    return whole;
  }
  if (columns.size() == 2) columns.push_back(-1);
  return columns;
}

class VtuTableFiles final : public PointTable {
 public:
  VtuTableFiles(const std::string& file, const TableShape& shape)
      : file_(file), columns_(shape.wanted.columns.size()), t_(column_named(shape.wanted.columns, "t")) {
    const bool several = shape.rows_at.size() > 1;
    const bool is_stream = file.empty() || file == standard_stream || is_standard_output(file);
    if (several && is_stream)
      throw InputError({}, "--format", "vtu writes a file for each of several times: name the first with -o NAME.vtu");
    if (!is_stream && std::filesystem::exists(file) && !std::filesystem::is_regular_file(file))
      throw InputError({}, "-o", "'" + shown(file, 60) + "' is no regular file, and vtu may write several beside it");
    if (shape.rows_at.size() > most_times)
      throw InputError({}, "-o",
                       "VTU files of " + std::to_string(shape.rows_at.size()) + " times, and " +
                           std::to_string(most_times) + " are the most: ask for fewer times");
    for (const PointField& field : shape.wanted.fields) {
      const bool is_position = field.name == "x" && field.columns.size() > 1;
      if (field.name == "t" || is_position) continue;  // TimeValue, and the points
      arrays_.push_back(as_vtk_has_it(field));
      parts_.push_back({field.name, static_cast<int>(arrays_.back().size())});
    }
    std::vector<int> position;
    for (const char* axis : {"x", "y", "z"}) position.push_back(column_named(shape.wanted.columns, axis));
    arrays_.push_back(position);
    const std::filesystem::path path(file);
    const bool is_list = path.extension() == ".pvd";
    if (several || is_list) list_ = std::filesystem::path(path).replace_extension(".pvd").string();
    int index = 0;
    for (const auto& [t, rows] : shape.rows_at) {
      const std::string name = list_.empty() ? file : numbered(path, index++);
      entries_.push_back({t, std::filesystem::path(name).filename().string()});
      files_.emplace(t, Piece{name, rows, 0, nullptr, nullptr});
    }
  }

  void add(std::span<const double> values) override {
    const std::size_t rows = values.size() / columns_;
    const auto time_of = [&](std::size_t row) { return values[row * columns_ + static_cast<std::size_t>(t_)]; };
    for (std::size_t begin = 0, end = 0; begin < rows; begin = end) {
      while (end < rows && time_of(end) == time_of(begin)) ++end;
      add_rows(files_.at(time_of(begin)), values.subspan(begin * columns_, (end - begin) * columns_));
    }
  }

  void finish() override {
    for (auto& [t, piece] : files_) piece.out->commit();
    if (!list_.empty()) write_file(list_, pvd_text(entries_));
  }

 private:
  struct Piece {
    std::string file;
    std::uint64_t rows, done;
    std::unique_ptr<VtuLayout> layout;  ///< once the first row came
    std::unique_ptr<OutputBytes> out;
  };

  static std::string numbered(const std::filesystem::path& path, int index) {
    std::string digits = std::to_string(index);
    if (digits.size() < 4) digits.insert(0, 4 - digits.size(), '0');
    return (path.parent_path() / (path.stem().string() + "_" + digits + ".vtu")).string();
  }

  void add_rows(Piece& piece, std::span<const double> values) {
    if (!piece.out) {
      piece.layout = std::make_unique<VtuLayout>(piece.rows, parts_, values[static_cast<std::size_t>(t_)]);
      piece.out = std::make_unique<OutputBytes>(piece.file, OutputBytes::Order::any);
      piece.layout->write_rest([&](std::uint64_t at, std::string_view bytes) { piece.out->write_at(at, bytes); });
    }
    for (std::size_t k = 0; k < arrays_.size(); ++k) {
      gathered_.clear();
      for (std::size_t at = 0; at < values.size(); at += columns_) {
        for (const int c : arrays_[k]) gathered_.push_back(c < 0 ? 0 : values[at + static_cast<std::size_t>(c)]);
      }
      piece.out->write_at(piece.layout->begin(k) + piece.done * arrays_[k].size() * sizeof(double),
                          {reinterpret_cast<const char*>(gathered_.data()), gathered_.size() * sizeof(double)});
    }
    piece.done += values.size() / columns_;
  }

  std::string file_, list_;  ///< list_: the .pvd, empty without
  std::size_t columns_;
  int t_;
  std::vector<VtuLayout::Part> parts_;
  std::vector<std::vector<int>> arrays_;  ///< columns of each part, and of the positions
  std::vector<PvdEntry> entries_;
  std::map<double, Piece> files_;
  std::vector<double> gathered_;
};

}  // namespace

std::unique_ptr<PointTable> vtu_table(const std::string& file, const TableShape& shape) {
  return std::make_unique<VtuTableFiles>(file, shape);
}

}  // namespace assay::drivers
