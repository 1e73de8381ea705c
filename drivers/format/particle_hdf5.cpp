// SPDX-License-Identifier: BSD-3-Clause
// Particles of HDF5 files: the datasets of a group are the arrays of a table, and each group that has some is one.
#include <algorithm>
#include <optional>

#include "drivers/format/particle_tables.hpp"
#include "drivers/system/input_bytes.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/natural_order.hpp"
#include "drivers/text/unseen.hpp"

#ifdef ASSAY_HDF5
#include <hdf5.h>
#endif

namespace assay::drivers {

#ifndef ASSAY_HDF5

void read_particle_hdf5(const std::string& file, const TakeTable&) {
  throw InputError({file, 0, 0}, "", "is an HDF5 file, and this assay was built without libhdf5: write NPZ or VTU");
}

#else

namespace {

/// A number of the library, and what closes it.
class Id {
 public:
  Id(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Id() {
    if (id_ >= 0) close_(id_);
  }
  Id(const Id&) = delete;
  Id& operator=(const Id&) = delete;
  operator hid_t() const { return id_; }  // NOLINT(google-explicit-constructor): it stands for the number
  bool good() const { return id_ >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

struct Group {
  std::string name;  ///< "/step_0001"
  std::vector<std::string> arrays, groups;
};

bool is_of_numbers(hid_t type) {
  const H5T_class_t kind = H5Tget_class(type);
  return kind == H5T_FLOAT || kind == H5T_INTEGER;
}

class Hdf5File {
 public:
  explicit Hdf5File(const std::string& file) : name_(file), file_(opened(file), H5Fclose) {
    if (!file_.good()) fail("cannot be opened by libhdf5: it is damaged, or of a later version");
  }

  void take_group(const std::string& path, const TakeTable& take, int& frame, int depth = 0) const {
    constexpr int deepest = 16;  // groups may hold one another
    if (depth > deepest) fail("has groups within groups beyond " + std::to_string(deepest) + ": " + shown(path, 60));
    const Id group(H5Gopen2(file_, path.c_str(), H5P_DEFAULT), H5Gclose);
    if (!group.good()) fail("the group " + shown(path, 60) + " cannot be read");
    Group found{path, {}, {}};
    H5Literate(group, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, note_member, &found);
    std::ranges::sort(found.groups, in_natural_order);
    std::vector<ShapedArray> arrays;
    for (const std::string& name : found.arrays) add_array(group, name, arrays);
    const bool has_rows = std::ranges::any_of(arrays, [](const ShapedArray& array) { return !array.shape.empty(); });
    const auto is_whole = [](const ShapedArray& array) { return array.shape.size() == 1 && array.shape[0] == 1; };
    if (has_rows && !(std::ranges::all_of(arrays, is_whole) && !found.groups.empty()))
      take_arrays(name_, ++frame, std::move(arrays), time_of(group), take);
    for (const std::string& name : found.groups)
      take_group(path == "/" ? path + name : path + "/" + name, take, frame, depth + 1);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError({name_, 0, 0}, "", what); }

  static hid_t opened(const std::string& file) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // it would print its own words
    return H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  }

  static herr_t note_member(hid_t group, const char* name, const H5L_info_t*, void* into) {
    auto& found = *static_cast<Group*>(into);
    const Id member(H5Oopen(group, name, H5P_DEFAULT), H5Oclose);
    if (!member.good()) return 0;  // a link that leads nowhere
    if (H5Iget_type(member) == H5I_DATASET) found.arrays.emplace_back(name);
    if (H5Iget_type(member) == H5I_GROUP) found.groups.emplace_back(name);
    return 0;
  }

  void add_array(hid_t group, const std::string& name, std::vector<ShapedArray>& arrays) const {
    const Id data(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose);
    const Id type(H5Dget_type(data), H5Tclose), space(H5Dget_space(data), H5Sclose);
    if (!is_of_numbers(type)) return;
    const int dimensions = H5Sget_simple_extent_ndims(space);
    if (dimensions < 0 || dimensions > 4) fail("the dataset " + shown(name, 40) + " has too many dimensions");
    std::vector<hsize_t> extents(static_cast<std::size_t>(dimensions));
    H5Sget_simple_extent_dims(space, extents.data(), nullptr);
    ShapedArray array{name, {extents.begin(), extents.end()}, {}};
    const hssize_t count = H5Sget_simple_extent_npoints(space);
    constexpr hssize_t most = hssize_t{1} << 30;
    if (count < 0 || count > most) fail("the dataset " + shown(name, 40) + " has too many numbers");
    array.values.resize(static_cast<std::size_t>(count));
    if (H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.values.data()) < 0)
      fail("the dataset " + shown(name, 40) + " cannot be read: it is damaged, or packed by a filter that is missing");
    arrays.push_back(std::move(array));
  }

  /// An attribute of the group.
  static std::optional<double> time_of(hid_t group) {
    for (const char* name : {"time", "Time", "t"}) {
      if (H5Aexists(group, name) <= 0) continue;
      const Id attribute(H5Aopen(group, name, H5P_DEFAULT), H5Aclose);
      const Id space(H5Aget_space(attribute), H5Sclose), type(H5Aget_type(attribute), H5Tclose);
      double value = 0;
      if (is_of_numbers(type) && H5Sget_simple_extent_npoints(space) == 1 &&
          H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) >= 0)
        return value;
    }
    return std::nullopt;
  }

  std::string name_;
  Id file_;
};

}  // namespace

void read_particle_hdf5(const std::string& file, const TakeTable& take) {
  const InputBytes input(file);  // refuses a folder, a device, what cannot be read
  int frame = 0;
  Hdf5File(file).take_group("/", take, frame);
  if (frame == 0) throw InputError({file, 0, 0}, "", "holds no array of numbers");
}

#endif

}  // namespace assay::drivers
