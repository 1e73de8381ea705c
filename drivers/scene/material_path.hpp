// SPDX-License-Identifier: BSD-3-Clause
// How a material is named, by a registered name or by the path of a library or a description, and where its code runs.
#pragma once

#include <array>
#include <filesystem>
#include <string>

namespace assay::drivers {

/// .f, .for, .ftn, .f90, .f95, .f03, .f08, .fpp, in small or large letters.
bool is_fortran_source(const std::string& file);

/// Whether a file's name is that of one: .inp.
bool is_deck(const std::string& file);

struct MaterialName {
  bool is_path = false;
  std::string file;  ///< the path, or the name
  std::string
      table;  ///< `name` of `lib.so:name`, of a deck `job.inp:name`, of a source `model.f:name`; empty: the only one
};

/// A path contains '/' or ends in .so, .yaml, .yml, .inp or as a Fortran source does; `:name` may follow.
MaterialName parse_material(const std::string& adapter);

/// A path made absolute, from `folder` where it is relative (empty: the working directory); names stay as they are.
std::string absolute_material(const std::string& adapter, const std::filesystem::path& folder);

/// Letters, digits, '_', '-' and '.', beginning with a letter or digit, and not a path.
bool is_material_name(const std::string& name);

enum class Isolation {
  automatic,  ///< foreign interfaces in workers, native libraries and built-in models in this process
  worker,     ///< in processes of its own, which may die; built-in models stay here
  none,       ///< in this process
};
constexpr std::array<const char*, 3> names_of(Isolation) { return {"automatic", "worker", "none"}; }

}  // namespace assay::drivers
