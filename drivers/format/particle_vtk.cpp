// SPDX-License-Identifier: BSD-3-Clause
// Particles of VTK's XML files: UnstructuredGrid and PolyData (.vtu, .vtp), their parallel heads (.pvtu, .pvtp) and
// collections over time (.pvd). Arrays are text, base64 or raw, inline or appended, compressed by zlib or not.
#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "drivers/format/particle_tables.hpp"
#include "drivers/format/vtk_arrays.hpp"
#include "drivers/system/input_bytes.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

namespace fs = std::filesystem;
using Tags = boost::property_tree::ptree;

std::string attribute(const Tags& tag, const std::string& name, const std::string& otherwise = {}) {
  return tag.get<std::string>("<xmlattr>." + name, otherwise);
}

/// What is in an element of that name; nothing where there is none.
const Tags& inside(const Tags& tag, const std::string& name) {
  static const Tags nothing;
  const auto found = tag.get_child_optional(name);
  return found ? *found : nothing;
}

class VtkFile {
 public:
  explicit VtkFile(const std::string& file, int depth = 0) : file_(file), depth_(depth) {
    constexpr int most = 2;  // a collection of parallel heads
    if (depth > most) fail("is named by files that name one another");
    const InputBytes input(file);
    text_ = input.text(0, input.size());
    const std::size_t appended = text_.find("<AppendedData");
    std::string xml = text_.substr(0, appended);
    if (text_.rfind("</VTKFile>") == text_.npos) fail("is cut off: it has no </VTKFile>");
    if (appended != text_.npos) {
      xml += "</VTKFile>";
      const std::size_t mark = text_.find('_', text_.find('>', appended));
      if (mark == text_.npos) fail("the appended data has no beginning");
      appended_ = std::string_view(text_).substr(mark + 1);
      const std::size_t head = text_.find('>', appended);
      appended_is_base64_ = text_.substr(appended, head - appended).find("base64") != std::string::npos;
    }
    try {
      std::istringstream in(xml);
      boost::property_tree::read_xml(in, root_, boost::property_tree::xml_parser::trim_whitespace);
    } catch (const boost::property_tree::xml_parser_error& error) {
      throw InputError({file, static_cast<int>(error.line()), 1}, "", "is no XML that can be read: " + error.message());
    }
    const auto top = root_.get_child_optional("VTKFile");
    if (!top) fail("has no element VTKFile");
    top_ = &*top;
    encoding_.swapped = attribute(*top_, "byte_order", "LittleEndian") == "BigEndian";
    encoding_.wide_headers = attribute(*top_, "header_type", "UInt32") == "UInt64";
    const std::string compressor = attribute(*top_, "compressor");
    encoding_.compressed = !compressor.empty();
    if (encoding_.compressed && compressor != "vtkZLibDataCompressor")
      fail("is compressed by " + shown(compressor, 40) + ": write it with vtkZLibDataCompressor, or without");
  }

  void take_tables(const TakeTable& take, std::optional<double> time) const {
    const std::string type = attribute(*top_, "type");
    if (type == "Collection") return take_collection(take);
    if (type == "UnstructuredGrid" || type == "PolyData") return take_grid(inside(*top_, type), take, time);
    if (type == "PUnstructuredGrid" || type == "PPolyData") return take_parts(inside(*top_, type), take, time);
    fail("is a file of the type '" + shown(type, 40) + "': particles are UnstructuredGrid or PolyData");
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError({file_, 0, 0}, "", what); }
  std::string beside(const std::string& name) const {
    const fs::path path(name);
    return path.is_absolute() ? name : (fs::path(file_).parent_path() / path).string();
  }

  void take_collection(const TakeTable& take) const {
    for (const auto& [name, tag] : inside(*top_, "Collection")) {
      if (name != "DataSet") continue;
      const std::string time = attribute(tag, "timestep"), part = attribute(tag, "file");
      if (part.empty()) fail("a DataSet without a file");
      VtkFile(beside(part), depth_ + 1).take_tables(take, parse_number(time));
    }
  }

  /// Parts of one table.
  void take_parts(const Tags& grid, const TakeTable& take, std::optional<double> time) const {
    ParticleTable whole{.file = file_};
    for (const auto& [name, tag] : grid) {
      if (name != "Piece") continue;
      const TakeTable join = [&](ParticleTable&& part) { append(std::move(part), whole); };
      VtkFile(beside(attribute(tag, "Source")), depth_ + 1).take_tables(join, time);
    }
    take(std::move(whole));
  }

  void append(ParticleTable&& part, ParticleTable& whole) const {
    if (whole.arrays.empty()) {
      const std::string file = whole.file;
      whole = std::move(part);
      whole.file = file;
      return;
    }
    for (ParticleArray& array : whole.arrays) {
      const ParticleArray* more = part.array(array.name);
      if (!more) fail("a piece has no array '" + shown(array.name, 40) + "', and others have it");
      array.values.insert(array.values.end(), more->values.begin(), more->values.end());
    }
    whole.rows += part.rows;
  }

  void take_grid(const Tags& grid, const TakeTable& take, std::optional<double> time) const {
    ParticleTable whole{.file = file_};
    std::optional<double> velocity_time;
    for (const auto& [name, array] : inside(grid, "FieldData")) {
      const std::string word = small_letters(attribute(array, "Name"));
      if (name != "DataArray" || (word != "timevalue" && word != "time" && word != "velocitytime")) continue;
      const std::vector<double> values = values_of(array);
      if (values.size() == 1) (word == "velocitytime" ? velocity_time : time) = values[0];
    }
    for (const auto& [name, piece] : grid) {
      if (name == "Piece") append(table_of(piece), whole);
    }
    if (whole.arrays.empty()) fail("holds no points");
    whole.time = time, whole.velocity_time = velocity_time;
    take(std::move(whole));
  }

  /// Of its points; of its cells, if these have a position and points have no values.
  ParticleTable table_of(const Tags& piece) const {
    const Tags& of_cells = inside(piece, "CellData");
    const bool is_of_cells =
        inside(piece, "PointData").count("DataArray") == 0 && std::ranges::any_of(of_cells, [](const auto& array) {
          return array.first == "DataArray" && attribute(array.second, "Name") == "position";
        });
    const char* number = is_of_cells ? "NumberOfCells" : "NumberOfPoints";
    const auto rows = parse_integer(attribute(piece, number));
    if (!rows || *rows < 0) fail(std::string("a Piece without ") + number);
    ParticleTable table{.file = file_, .rows = static_cast<std::size_t>(*rows)};
    if (!is_of_cells) add_arrays(inside(piece, "Points"), "Points", table);
    add_arrays(is_of_cells ? of_cells : inside(piece, "PointData"), "", table);
    return table;
  }

  /// name: of its array; empty: each has its own.
  void add_arrays(const Tags& section, const std::string& name, ParticleTable& table) const {
    for (const auto& [tag, array] : section) {
      if (tag != "DataArray") continue;
      const std::string called = name.empty() ? attribute(array, "Name") : name;
      std::vector<double> values = values_of(array);
      const auto components = parse_integer(attribute(array, "NumberOfComponents", name.empty() ? "1" : "3"));
      const auto width = static_cast<std::size_t>(std::max<std::int64_t>(components.value_or(1), 1));
      if (values.size() != table.rows * width)
        fail("the array '" + shown(called, 40) + "' has " + std::to_string(values.size()) + " numbers, where " +
             std::to_string(table.rows) + " particles of " + std::to_string(width) + " need " +
             std::to_string(table.rows * width));
      table.add(called, width).values = std::move(values);
    }
  }

  std::vector<double> values_of(const Tags& array) const {
    const std::string format = attribute(array, "format", "ascii"), name = attribute(array, "Name", "Points");
    std::vector<double> values;
    if (format == "ascii") {
      std::string_view rest = array.data();
      for (std::size_t at = rest.find_first_not_of(" \t\r\n"); at != rest.npos;
           at = rest.find_first_not_of(" \t\r\n")) {
        rest.remove_prefix(at);
        const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r\n"));
        const std::string small = small_letters(std::string(word));
        const bool none = small.find("nan") != small.npos;
        const auto number = none ? std::optional(std::nan("")) : parse_number(word);
        if (!number) fail("the array '" + shown(name, 40) + "' has '" + shown(word, 40) + "' for a number");
        values.push_back(*number);
        rest.remove_prefix(word.size());
      }
      return values;
    }
    std::string_view data = array.data();
    bool base64 = true;
    if (format == "appended") {
      const auto offset = parse_integer(attribute(array, "offset"));
      if (!offset || *offset < 0 || static_cast<std::uint64_t>(*offset) > appended_.size())
        fail("the array '" + shown(name, 40) + "' lies beyond the end of the file");
      data = appended_.substr(static_cast<std::size_t>(*offset));
      base64 = appended_is_base64_;
    } else if (format != "binary") {
      fail("the array '" + shown(name, 40) + "' has the format '" + shown(format, 40) + "'");
    }
    const std::optional<std::string> bytes = vtk_bytes(data, base64, encoding_);
    if (!bytes) fail("the array '" + shown(name, 40) + "' is cut off or damaged");
    if (!append_vtk_numbers(*bytes, attribute(array, "type"), encoding_.swapped, values))
      fail("the array '" + shown(name, 40) + "' has numbers of the type '" + shown(attribute(array, "type"), 40) + "'");
    return values;
  }

  std::string file_, text_;
  std::string_view appended_;
  bool appended_is_base64_ = false;
  VtkEncoding encoding_;
  int depth_;  ///< files that name this one
  Tags root_;
  const Tags* top_ = nullptr;
};

}  // namespace

void read_particle_vtk(const std::string& file, const TakeTable& take) {
  VtkFile(file).take_tables(take, std::nullopt);
}

}  // namespace assay::drivers
