// SPDX-License-Identifier: BSD-3-Clause
// Particles of NumPy's arrays: .npy and .npz.
#include <algorithm>
#include <functional>
#include <optional>

#include "drivers/format/npy.hpp"
#include "drivers/format/particle_tables.hpp"
#include "drivers/format/zip.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

namespace {

/// Bytes of a member from a place on; it lives as long as the arrays.
using ReadBytes = std::function<std::size_t(std::uint64_t at, char* into, std::size_t most)>;

/// Numbers of a field of elements that lie one behind the other, some at a time.
std::vector<double> numbers_of(const std::string& file, const ReadBytes& read, std::uint64_t begin, std::size_t width,
                               std::size_t offset, const NpyField& field, std::size_t first, std::size_t count) {
  constexpr std::size_t at_once = 65536;
  std::vector<double> values;
  values.reserve(count);
  std::string bytes(std::min(count, at_once) * width, '\0');
  for (std::size_t done = 0; done < count; done += at_once) {
    const std::size_t some = std::min(at_once, count - done);
    if (read(begin + (first + done) * width, bytes.data(), some * width) != some * width)
      throw InputError({file, 0, 0}, "", "an array is cut off");
    for (std::size_t k = 0; k < some; ++k) values.push_back(npy_number(bytes.data() + k * width + offset, field));
  }
  return values;
}

/// In the order of C, of an array whose first index is the fastest.
std::vector<double> by_rows(const std::vector<double>& by_columns, const std::vector<std::size_t>& shape) {
  std::vector<std::size_t> step(shape.size(), 1);  // between neighbours along a direction
  for (std::size_t d = 1; d < step.size(); ++d) step[d] = step[d - 1] * shape[d - 1];
  std::vector<double> values;
  values.reserve(by_columns.size());
  for (std::size_t k = 0; k < by_columns.size(); ++k) {
    std::size_t rest = k, at = 0;
    for (std::size_t d = step.size(); d-- > 0;) at += rest % shape[d] * step[d], rest /= shape[d];
    values.push_back(by_columns[at]);
  }
  return values;
}

/// The arrays of a member: one, or of elements with fields one a field. size: of the member [bytes].
void add_arrays(const std::string& name, std::uint64_t size, const ReadBytes& read, const std::string& file,
                std::vector<ShapedArray>& arrays) {
  std::string begin(std::min<std::uint64_t>(size, longest_npy_header + 16), '\0');
  begin.resize(read(0, begin.data(), begin.size()));
  const NpyHeader header = read_npy_header(begin, {file, 0, 0});
  const auto count = static_cast<std::size_t>(header.elements());
  const std::size_t width = header.element_bytes();
  if (size - header.size != count * width)
    throw InputError({file, 0, 0}, "", "the array '" + shown(name, 40) + "' is cut off, or something follows it");
  std::size_t offset = 0;
  for (const NpyField& field : header.fields) {
    ShapedArray array{field.name.empty() ? name : field.name, {header.shape.begin(), header.shape.end()}};
    const auto some = [file, read, at = header.size, width, offset, field](std::size_t first, std::size_t number) {
      return numbers_of(file, read, at, width, offset, field, first, number);
    };
    if (header.by_columns) {
      array.values = by_rows(some(0, count), array.shape);
    } else {
      array.read = some;
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
    const auto read = [&](std::uint64_t at, char* into, std::size_t most) { return input.read(at, into, most); };
    add_arrays("x", input.size(), read, file, arrays);
    take_arrays(file, 0, std::move(arrays), std::nullopt, take);
    return;
  }
  const ZipReader archive(input);
  for (std::size_t k = 0; k < archive.members().size(); ++k) {
    const auto& [name, size] = archive.members()[k];
    if (!name.ends_with(".npy")) continue;
    const auto read = [&archive, k](std::uint64_t at, char* into, std::size_t most) {
      return archive.read(k, at, into, most);
    };
    add_arrays(name.substr(0, name.size() - 4), size, read, file, arrays);
  }
  take_arrays(file, 0, std::move(arrays), std::nullopt, take);
}

}  // namespace assay::drivers
