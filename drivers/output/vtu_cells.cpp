// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/vtu_cells.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <string_view>

#include "drivers/output/vtu.hpp"
#include "drivers/output/vtu_parts.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t corners_of_cell = 8;
constexpr std::uint8_t vtk_hexahedron = 12;

/// The appended bytes of one array, as append_compressed lays them out. Its header comes first, and is known last.
/// Returns where it ends.
template <typename Value>
std::uint64_t put_compressed(const PutBytes& put, const MadeArray<Value>& array, std::size_t rows, std::uint64_t at) {
  constexpr std::size_t part = vtu_block_bytes / sizeof(Value);  // rows that fill whole blocks
  const auto width = static_cast<std::size_t>(array.components);
  const std::size_t bytes = rows * width * sizeof(Value), blocks = (bytes + vtu_block_bytes - 1) / vtu_block_bytes;
  std::vector<std::uint64_t> header{blocks, vtu_block_bytes, bytes % vtu_block_bytes};
  const std::uint64_t begin = at;
  at += (header.size() + blocks) * sizeof(std::uint64_t);
  std::vector<Value> values;
  std::string packed;
  for (std::size_t first = 0; first < rows; first += part) {
    values.resize(std::min(part, rows - first) * width);
    array.make(first, values.size() / width, values.data());
    const std::string_view raw(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
    packed.clear();
    for (std::size_t k = 0; k < raw.size(); k += vtu_block_bytes)
      header.push_back(vtu::append_block(packed, raw.substr(k, vtu_block_bytes)));
    put(at, packed);
    at += packed.size();
  }
  put(begin, {reinterpret_cast<const char*>(header.data()), header.size() * sizeof(std::uint64_t)});
  return at;
}

/// The text stands in front of the arrays and says where they are: it gets as much room as it needs at most.
class CellsFile {
 public:
  explicit CellsFile(std::size_t particles) : particles_(particles) {}

  template <typename Value>
  void add(const char* section, const char* type, MadeArray<Value> array, std::size_t rows, std::string more = {}) {
    Array added{section, type, array.name, array.components, std::move(more), {}};
    added.put = [array = std::move(array), rows](const PutBytes& put, std::uint64_t at) {
      return put_compressed(put, array, rows, at);
    };
    arrays_.push_back(std::move(added));
  }

  void write(const PutBytes& put) const {
    std::vector<std::uint64_t> offsets(arrays_.size(), std::numeric_limits<std::uint64_t>::max());
    const std::size_t room = text(offsets).size() + mark.size();
    std::uint64_t at = room;
    for (std::size_t k = 0; k < arrays_.size(); ++k) {
      offsets[k] = at - room;
      at = arrays_[k].put(put, at);
    }
    put(at, vtu::file_tail);
    std::string head = text(offsets);
    head.resize(room - mark.size(), ' ');
    put(0, head + std::string(mark));
  }

 private:
  static constexpr std::string_view mark = "<AppendedData encoding=\"raw\">\n_";

  struct Array {
    std::string section;
    const char* type;
    std::string name;
    int components;
    std::string more;
    std::function<std::uint64_t(const PutBytes&, std::uint64_t)> put;  ///< at a place; returns where it ends
  };

  std::string text(const std::vector<std::uint64_t>& offsets) const {
    std::string out = vtu::file_head("UnstructuredGrid", " compressor=\"vtkZLibDataCompressor\"") +
                      "\n<UnstructuredGrid>\n<FieldData>\n",
                section = "FieldData";
    for (std::size_t k = 0; k < arrays_.size(); ++k) {
      const Array& a = arrays_[k];
      if (a.section != section) {
        out += "</" + section + ">\n";
        if (section == "FieldData")
          out += "<Piece NumberOfPoints=\"" + std::to_string(corners_of_cell * particles_) + "\" NumberOfCells=\"" +
                 std::to_string(particles_) + "\">\n";
        section = a.section;
        out += "<" + section + ">\n";
      }
      out += vtu::array_line(a.name, a.type, a.components, a.more, offsets[k]);
    }
    return out + "</" + section + ">\n</Piece>\n</UnstructuredGrid>\n";
  }

  std::size_t particles_;
  std::vector<Array> arrays_;
};

MadeArray<double> one_number(const std::string& name, double value) {
  return {name, 1, [value](std::size_t, std::size_t, double* out) { *out = value; }};
}

/// begin stride, (begin + 1) stride, ...
MadeArray<std::int64_t> counted(const std::string& name, std::int64_t begin = 0, std::int64_t stride = 1) {
  return {name, 1, [=](std::size_t first, std::size_t count, std::int64_t* out) {
            for (std::size_t k = 0; k < count; ++k) out[k] = (begin + static_cast<std::int64_t>(first + k)) * stride;
          }};
}

}  // namespace

void write_cells(const PutBytes& put, std::size_t particles, const std::vector<MadeArray<double>>& arrays,
                 const MadeArray<double>& corners, double t, const std::optional<double>& velocity_t) {
  CellsFile file(particles);
  const std::string one = " NumberOfTuples=\"1\"";
  file.add("FieldData", "Float64", one_number("TimeValue", t), 1, one);
  if (velocity_t && *velocity_t != t) file.add("FieldData", "Float64", one_number("VelocityTime", *velocity_t), 1, one);
  file.add("CellData", "Int64", counted("id"), particles);
  for (const MadeArray<double>& array : arrays)
    file.add("CellData", "Float64", array, particles, vtu::component_names(array.components));
  // The points are rows of their own: three numbers for each of the corners.
  MadeArray<double> points{"Points", 3, {}};
  points.make = [&corners](std::size_t first, std::size_t count, double* out) {
    corners.make(first / corners_of_cell, count / corners_of_cell, out);
  };
  file.add("Points", "Float64", points, corners_of_cell * particles, vtu::component_names(3));
  file.add("Cells", "Int64", counted("connectivity"), corners_of_cell * particles);
  file.add("Cells", "Int64", counted("offsets", 1, corners_of_cell), particles);
  const MadeArray<std::uint8_t> types{
      "types", 1, [](std::size_t, std::size_t count, std::uint8_t* out) { std::fill_n(out, count, vtk_hexahedron); }};
  file.add("Cells", "UInt8", types, particles);
  file.write(put);
}

}  // namespace assay::drivers
