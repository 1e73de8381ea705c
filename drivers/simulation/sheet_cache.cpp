// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/sheet_cache.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <numbers>
#include <vector>

#include "adapters/elf_symbols.hpp"
#include "adapters/library.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/program_identity.hpp"
#include "drivers/system/whole_file.hpp"
#include "drivers/text/sha256.hpp"
#include "harness/history/point_driver.hpp"
#include "harness/numeric/norms.hpp"

namespace assay::drivers {

namespace {

constexpr std::string_view signature = "assay sheet 3\n";
constexpr std::size_t hash_length = 64;
constexpr std::size_t largest_file = std::size_t{4} << 30;
constexpr int samples_in_xi = 5, samples_in_t = 33;  ///< of the path, for the hash

std::string folder_of_sheets() {
  const std::string home = cache_home();
  return home.empty() ? home : home + "/sheets";
}

void append(std::string& bytes, double value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

/// F of the family at some places and at every time at which it turns (of a table: at every row); of a curved one all
/// that makes it, for between those times it may be anything.
std::string bytes_of(const Path& path, double end) {
  std::string bytes = path.name;
  std::vector<double> times = path.reversals(end);
  // irrational shares of the end: equal ones may all fall on the zeros of a periodic amplitude
  for (int j = 0; j < samples_in_t; ++j) times.push_back(end * std::fmod((j + 1) * std::numbers::phi, 1));
  for (int i = 0; i < samples_in_xi; ++i) {
    const double xi = path.parameter.lower + path.parameter.width() * i / (samples_in_xi - 1);
    append(bytes, xi);
    for (const double t : times) {
      const Tensor F = path.deformation_gradient(xi, t);
      for (const double component : nine_of(F)) append(bytes, component);
    }
  }
  for (const double t : times) append(bytes, t);
  for (const double d : path.material_direction) append(bytes, d);
  if (!path.initial_cauchy.isZero(0)) {
    for (const double component : nine_of(path.initial_cauchy)) append(bytes, component);
  }
  if (!path.straight()) {
    for (const double number : path.recipe) append(bytes, number);
  }
  return bytes;
}

}  // namespace

SheetCache::SheetCache(const Scene& scene, const Material& material, const Path& path, double end)
    : material_(material), path_(path), asked_until_(std::min(end, scene.motion->period())) {
  const std::string folder = folder_of_sheets(), library = adapters::file_of(&material.table());
  if (folder.empty() || library.empty()) return;
  is_our_own_ = library == adapters::own_file;
  try {
    std::string key(signature);
    key += program_identity();
    if (!is_our_own_) {
      for (const std::string& file : adapters::with_needed_libraries(library))
        key += sha256_hex(read_bytes(file, largest_file));
    }
    key += material.name();
    for (const double value : material.parameters()) append(key, value);
    append(key, end);
    append(key, scene.force.tolerance);
    key += bytes_of(path, end);
    key_ = sha256_hex(key);
    file_ = folder + "/" + key_ + ".sheet";
  } catch (const std::exception&) {
    file_.clear();  // a library that cannot be read: nothing is kept
  }
}

std::optional<Sheet> SheetCache::load() const {
  std::optional<Sheet> found = stored();
  if (found && !is_our_own_ && !is_still_right(*found)) found.reset();
  return found;
}

/// Histories to a few places, more exact than the comparison needs.
bool SheetCache::is_still_right(const Sheet& sheet) const {
  constexpr double tolerance = 1e-8,
                   alike = 1e-5;  // of a step; of the largest stress, and ten of the sheet's own error
  const Interval& range = path_.parameter;
  std::vector<double> xi, times;
  for (const double share : {0.0, 0.382, 0.786, 1.0}) xi.push_back(range.lower + share * range.width());
  for (const double share : {0.236, 0.618, 0.944}) times.push_back(share * asked_until_);
  const Histories asked = integrate_histories(material_, path_, xi, times, {.tolerance = tolerance});
  const double most = (alike + 10 * sheet.error_tau()) * sheet.error().tau_scale;
  for (std::size_t row = 0; row < times.size(); ++row) {
    for (std::size_t p = 0; p < xi.size(); ++p) {
      Tensor tau, slope;
      sheet.at(xi[p], times[row], tau, slope);
      if (!(largest_of(tensor_at(asked.tau[row].data(), xi.size(), p) - tau) <= most)) return false;
    }
  }
  return true;
}

std::optional<Sheet> SheetCache::stored() const {
  std::error_code code;
  if (file_.empty() || !std::filesystem::is_regular_file(file_, code)) return std::nullopt;
  try {
    const std::string bytes = read_bytes(file_, largest_file);
    const std::string begin = std::string(signature) + key_;  // whatever its name says
    const std::size_t head = begin.size() + hash_length;
    if (bytes.size() <= head || !bytes.starts_with(begin)) return std::nullopt;
    const std::string_view body = std::string_view(bytes).substr(head);
    if (body.size() % sizeof(double) != 0) return std::nullopt;
    if (sha256_hex(body) != std::string_view(bytes).substr(begin.size(), hash_length)) return std::nullopt;
    std::vector<double> numbers(body.size() / sizeof(double));
    std::memcpy(numbers.data(), body.data(), body.size());
    return Sheet(std::span<const double>(numbers));
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

void SheetCache::store(const Sheet& sheet) const {
  const std::vector<double> numbers = sheet.pack();
  if (file_.empty() || numbers.empty()) return;
  std::string body(numbers.size() * sizeof(double), '\0');
  std::memcpy(body.data(), numbers.data(), body.size());
  std::error_code code;
  std::filesystem::create_directories(std::filesystem::path(file_).parent_path(), code);
  if (code) return;
  try {
    if (std::filesystem::is_symlink(file_, code)) std::filesystem::remove(file_, code);  // not what it leads to
    write_file(file_, std::string(signature) + key_ + sha256_hex(body) + body);
  } catch (const std::exception&) {
    std::filesystem::remove(file_, code);  // a full disk is no reason to lose the run
  }
}

}  // namespace assay::drivers
