// SPDX-License-Identifier: BSD-3-Clause
// Particles of NumPy's arrays: .npy and .npz.
#include <optional>

#include "drivers/format/npy.hpp"
#include "drivers/format/particle_tables.hpp"
#include "drivers/format/zip.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

namespace {

/// The arrays of a member: one, or of elements with fields one a field.
void add_arrays(const std::string& name, const std::string& bytes, const std::string& file,
                std::vector<ShapedArray>& arrays) {
  const NpyHeader header = read_npy_header(bytes, {file, 0, 0});
  const auto count = static_cast<std::size_t>(header.elements());
  const std::size_t width = header.element_bytes();
  if (bytes.size() - header.size != count * width)
    throw InputError({file, 0, 0}, "", "the array '" + shown(name, 40) + "' is cut off, or something follows it");
  std::size_t offset = 0;
  for (const NpyField& field : header.fields) {
    ShapedArray array{field.name.empty() ? name : field.name, {header.shape.begin(), header.shape.end()}, {}};
    std::vector<std::size_t> step(header.shape.size(), 1);  // between neighbours along a direction, in elements
    for (std::size_t d = 1; d < step.size(); ++d) {
      if (header.by_columns) step[d] = step[d - 1] * array.shape[d - 1];
      const std::size_t back = step.size() - 1 - d;
      if (!header.by_columns) step[back] = step[back + 1] * array.shape[back + 1];
    }
    array.values.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
      std::size_t rest = k, at = 0;
      for (std::size_t d = step.size(); d-- > 0;) at += rest % array.shape[d] * step[d], rest /= array.shape[d];
      array.values.push_back(field.kind == 'V' ? 0
                                               : npy_number(bytes.data() + header.size + at * width + offset, field));
    }
    offset += static_cast<std::size_t>(field.bytes);
    if (field.kind != 'V') arrays.push_back(std::move(array));
  }
}

}  // namespace

void read_particle_numpy(const std::string& file, const TakeTable& take) {
  const InputBytes input(file);
  std::vector<ShapedArray> arrays;
  if (is_npy(input.text(0, 8))) {
    add_arrays("x", input.text(0, input.size()), file, arrays);
  } else {
    const ZipReader archive(input);
    for (std::size_t k = 0; k < archive.members().size(); ++k) {
      const auto& [name, size] = archive.members()[k];
      if (!name.ends_with(".npy")) continue;
      std::string bytes(size, '\0');
      bytes.resize(archive.read(k, 0, bytes.data(), bytes.size()));
      add_arrays(name.substr(0, name.size() - 4), bytes, file, arrays);
    }
  }
  take_arrays(file, 0, std::move(arrays), std::nullopt, take);
}

}  // namespace assay::drivers
