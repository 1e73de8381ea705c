// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/particle_tables.hpp"

#include <algorithm>

#include "drivers/format/npy.hpp"
#include "drivers/system/input_bytes.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

std::string ParticleTable::name() const { return frame > 0 ? file + ", frame " + std::to_string(frame) : file; }

const ParticleArray* ParticleTable::array(std::string_view wanted) const {
  const auto found = std::ranges::find_if(arrays, [&](const ParticleArray& each) { return each.name == wanted; });
  return found == arrays.end() ? nullptr : &*found;
}

ParticleArray& ParticleTable::add(std::string name, std::size_t components) {
  ParticleArray& made = arrays.emplace_back(ParticleArray{std::move(name), components});
  made.values.reserve(rows * components);
  return made;
}

void read_particle_tables(const std::string& file, const TakeTable& take, const std::vector<std::string>& columns) {
  const std::string begin = InputBytes(file).text(0, 4096);
  if (is_npy(begin) || is_zip(begin)) return read_particle_numpy(file, take);
  if (begin.starts_with("\x89HDF\r\n\x1a\n")) return read_particle_hdf5(file, take);
  if (begin.find("<VTKFile") != begin.npos) return read_particle_vtk(file, take);
  if (begin.starts_with("ITEM: ")) return read_particle_dump(file, take);
  if (begin.starts_with("# vtk DataFile"))
    throw InputError({file, 1, 1}, "",
                     "is a legacy file of VTK: write VTU, or convert it (meshio convert A.vtk A.vtu)");
  if (begin.find('\0') != begin.npos)
    throw InputError({file, 0, 0}, "", "is binary, and none of NumPy's, HDF5's or VTK's files");
  read_particle_text(file, take, columns);
}

std::size_t ShapedArray::count() const {
  std::size_t product = 1;
  for (const std::size_t length : shape) product *= length;
  return product;
}

std::vector<double> ShapedArray::part(std::size_t first, std::size_t number) const {
  if (read) return read(first, number);
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(number)};
}

namespace {

bool is_time(const ShapedArray& array) {
  return (array.name == "t" || array.name == "time" || array.name == "times") && array.shape.size() <= 1;
}

/// Of rows that begin at number `first` of the array's own: `rows` of them.
ParticleArray part_of(const ShapedArray& array, std::size_t dimension, std::size_t first, std::size_t rows) {
  std::size_t components = 1;
  for (std::size_t d = dimension; d < array.shape.size(); ++d) components *= array.shape[d];
  return {array.name, components, array.part(first * components, rows * components)};
}

}  // namespace

void take_arrays(const std::string& file, int frame, std::vector<ShapedArray> arrays, std::optional<double> time,
                 const TakeTable& take) {
  const auto of_time = std::ranges::find_if(arrays, is_time);
  const auto fail = [&](const std::string& what) { throw InputError({file, 0, 0}, "", what); };
  if (of_time != arrays.end() && of_time->count() == 1 && !time) {
    time = of_time->part(0, 1)[0];
    arrays.erase(of_time);
  }
  std::erase_if(arrays, [](const ShapedArray& array) { return array.shape.empty(); });  // a number of the whole
  if (arrays.empty()) fail("holds no array of particles");
  constexpr std::size_t most_components = 9;
  const auto times = std::ranges::find_if(arrays, is_time);
  const auto moving = std::ranges::find_if(arrays, [&](const ShapedArray& array) {
    const std::size_t directions = array.shape.size();
    if (times == arrays.end() || directions < 2 || array.shape[0] != times->count()) return false;
    const bool tensors = directions == 3 && array.shape[1] == 3 && array.shape[2] == 3;
    return array.shape[1] > most_components || (directions > 2 && !tensors);
  });
  const bool by_time = moving != arrays.end();
  const std::size_t frames = by_time ? moving->shape[0] : 1;
  const ShapedArray& first = by_time ? *moving : arrays.front();
  const std::size_t rows = first.shape[by_time ? 1 : 0];
  const std::vector<double> at = by_time ? times->part(0, frames) : std::vector<double>();
  for (std::size_t k = 0; k < frames; ++k) {
    ParticleTable table{.file = file, .frame = by_time ? static_cast<int>(k) + 1 : frame, .rows = rows, .time = time};
    if (by_time) table.time = at[k];
    for (const ShapedArray& array : arrays) {
      if (by_time && &array == &*times) continue;
      const bool moves = by_time && array.shape.size() >= 2 && array.shape[0] == frames && array.shape[1] == rows;
      const std::size_t length = moves ? rows : array.shape[0];
      if (length != rows)
        fail("the array '" + shown(array.name, 40) + "' has " + std::to_string(length) + " rows, where '" +
             shown(first.name, 40) + "' has " + std::to_string(rows));
      table.arrays.push_back(part_of(array, moves ? 2 : 1, moves ? k * rows : 0, rows));
    }
    take(std::move(table));
  }
}

}  // namespace assay::drivers
