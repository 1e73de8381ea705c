// SPDX-License-Identifier: BSD-3-Clause
// The key of a case: a hash of all that its result depends on.
#include "drivers/study/plan/study.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "adapters/elf_symbols.hpp"
#include "drivers/material/material_choice.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/program_identity.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/sha256.hpp"
#include "harness/motion/kinds/deformation_table.hpp"

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
  std::ranges::sort(found);
  return found;
}

/// What the model answers along a short way in the plane, to five digits: it may read files or its environment, of
/// which no name tells. In a worker, which may die of it.
std::string answer_along_a_way(Scene scene) {
  constexpr int steps = 8;
  constexpr double length = 1e-2, digits = 1e5;  // [s]
  scene.material.isolation = Isolation::worker;
  const Material material = resolve_material(scene).material;
  std::vector<double> F0{1, 0, 0, 0, 1, 0, 0, 0, 1}, F1 = F0, cauchy(9), state0 = material.initial_state(1),
                                                     state1(state0.size());
  std::string text;
  for (int k = 1; k <= steps; ++k) {
    F1[0] = 1 + 0.02 * k, F1[1] = 0.03 * k, F1[3] = -0.01 * k, F1[4] = 1 - 0.005 * k;
    const UpdateReport report =
        material.update((k - 1) * length, length, 1, F0.data(), F1.data(), state0.data(), state1.data(), cauchy.data());
    if (report.worst < ASSAY_GOOD) return text + " refused";
    double largest = 0;
    for (const double component : cauchy) largest = std::max(largest, std::abs(component));
    text += " " + rounded_text(largest, 6);
    for (const double component : cauchy)
      text += " " + std::to_string(largest > 0 ? std::llround(digits * component / largest) : 0);
    std::swap(state0, state1), F0 = F1;
  }
  return text;
}

/// Asked once for all cases of the same material.
std::string kept_answer(const Scene& scene, const ResolvedMaterial& material) {
  static std::map<std::string, std::string> known;
  std::string what = material.library + "\n" + material.description;
  for (const auto& [name, value] : material.choice.parameters) what += "\n" + name + " " + rounded_text(value, 17);
  const auto found = known.find(what);
  if (found != known.end()) return found->second;
  std::string answer;
  try {
    answer = answer_along_a_way(scene);
  } catch (const std::runtime_error&) {
    answer = " refused";  // its runs will say why
  }
  return known.emplace(what, answer).first->second;
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
  if (!material.library.empty()) all += "\n" + kept_answer(scene, material);
  if (const auto* table = scene.motion.as<DeformationTable>()) all += "\n" + kept_hash_of(table->source());
  return sha256_hex(all).substr(0, key_digits);
}

}  // namespace assay::drivers
