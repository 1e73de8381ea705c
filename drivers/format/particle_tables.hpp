// SPDX-License-Identifier: BSD-3-Clause
// Particles as other codes write them: arrays of numbers under the file's own names, a table a time.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace assay::drivers {

/// `components` numbers a particle, side by side. What is no number is NaN.
struct ParticleArray {
  std::string name;
  std::size_t components = 1;
  std::vector<double> values = {};
};

/// Particles of one time, or of the times that one of the arrays has.
struct ParticleTable {
  std::string file;                       ///< its name, for messages
  int frame = 0;                          ///< in the file, from 1; 0: the file is one
  std::size_t rows = 0;                   ///< particles
  std::optional<double> time{};           ///< as the file says, in its own unit
  std::optional<double> velocity_time{};  ///< likewise, of the velocities
  std::optional<double> step{};           ///< number of the time step, where the file says that
  std::vector<ParticleArray> arrays{};
  std::map<std::string, std::string> words{};  ///< columns of a text that hold words: the first one of each

  /// "dump.17, frame 3".
  std::string name() const;
  /// Null where there is none.
  const ParticleArray* array(std::string_view name) const;
  ParticleArray& add(std::string name, std::size_t components = 1);
};

using TakeTable = std::function<void(ParticleTable&&)>;

/// Hands over the tables of a file one after the other. By its first bytes it is an archive or array of NumPy, HDF5, a
/// VTU, VTP or PVD file, a dump of LAMMPS, else separated text. columns: names of those of a text without a header.
/// Throws InputError with the place in the file.
void read_particle_tables(const std::string& file, const TakeTable& take, const std::vector<std::string>& columns = {});

/// Each of the formats alone; `read_particle_tables` chooses.
void read_particle_text(const std::string& file, const TakeTable& take, const std::vector<std::string>& columns);
void read_particle_dump(const std::string& file, const TakeTable& take);
void read_particle_vtk(const std::string& file, const TakeTable& take);
void read_particle_numpy(const std::string& file, const TakeTable& take);
void read_particle_hdf5(const std::string& file, const TakeTable& take);

/// An array of a file that keeps several: numbers in the order of C.
struct ShapedArray {
  std::string name;
  std::vector<std::size_t> shape;
  std::vector<double> values = {};
  /// Reads some of the numbers; where it is set there are no values yet.
  std::function<std::vector<double>(std::size_t first, std::size_t count)> read = {};

  std::size_t count() const;
  std::vector<double> part(std::size_t first, std::size_t count) const;
};

/// Hands over the tables that arrays of one file are: (rows), (rows, components) or (rows, 3, 3) each; or, where an
/// array of times (t or time) is as long as all others, (times, rows, ...). `frame`: of the tables, 0 where the file
/// holds these arrays alone. Throws InputError where the arrays are of different lengths.
void take_arrays(const std::string& file, int frame, std::vector<ShapedArray> arrays, std::optional<double> time,
                 const TakeTable& take);

}  // namespace assay::drivers
