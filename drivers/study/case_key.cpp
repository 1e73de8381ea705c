// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/case_key.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "adapters/needed_libraries.hpp"
#include "drivers/input_file.hpp"
#include "drivers/material/material_choice.hpp"
#include "drivers/program_identity.hpp"
#include "drivers/scene/sha256.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t largest_file = std::size_t{4} << 30, key_digits = 32;

std::string hash_of(const std::string& file) { return sha256_hex(read_bytes(file, largest_file)); }

/// A library that many cases take is read once.
const std::string& kept_hash_of(const std::string& file) {
  static std::map<std::string, std::string> known;
  const auto found = known.find(file);
  return found != known.end() ? found->second : known.emplace(file, hash_of(file)).first->second;
}

/// Files beside a model whose names stand in its code: it may find them by GETOUTDIR.
std::vector<std::string> files_beside(const ResolvedMaterial& material) {
  constexpr std::size_t least_name = 4, most_files = 1000;
  if (material.library.empty()) return {};
  const std::string code = read_bytes(material.library, largest_file);
  const std::filesystem::path own = material.source.empty() ? material.library : material.source;
  std::vector<std::string> found;
  std::error_code error;
  std::size_t count = 0;
  for (std::filesystem::directory_iterator at(own.parent_path(), error), end; at != end && ++count <= most_files;
       at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (name.size() >= least_name && at->path() != own && at->is_regular_file(error) && code.find(name) != code.npos)
      found.push_back(at->path().string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

std::string case_key(const Scene& scene, const std::string& resolved, int threads) {
  std::string all = loaded_identity() + "\n" + std::to_string(threads) + "\n" + resolved;
  const ResolvedMaterial material = resolve_material(scene);
  std::vector<std::string> files;
  if (!material.library.empty()) files = adapters::with_needed_libraries(material.library);
  if (!material.description.empty()) files.push_back(material.description);
  for (const ModelFile& file : material.files) files.push_back(file.path);
  for (const std::string& file : files_beside(material)) files.push_back(file);
  for (const std::string& file : files) all += "\n" + kept_hash_of(file);
  if (const auto* table = std::get_if<DeformationTable>(&scene.motion)) all += "\n" + kept_hash_of(table->source());
  return sha256_hex(all).substr(0, key_digits);
}

}  // namespace assay::drivers
