// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/study_file.hpp"

#include <filesystem>

#include "drivers/study/study_json.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"

namespace assay::drivers {

namespace {

namespace fs = std::filesystem;

/// Above what a study of 10,000 cases with their histories takes.
constexpr std::size_t study_limit = std::size_t{1} << 30;

bool is_study_yaml(const fs::path& path) { return path.extension() == ".yaml" || path.extension() == ".yml"; }

}  // namespace

std::string StoredStudy::case_folder(const StudyCase& one) const {
  return one.key.empty() ? std::string() : (fs::path(folder) / "cases" / one.key).string();
}

StoredStudy stored_study(const std::string& given, const std::string& out) {
  if (given.empty()) throw InputError({}, "", "'' is not the name of a study");
  std::error_code ignored;
  const bool is_folder = fs::is_directory(given, ignored);
  const bool is_yaml = !is_folder && is_study_yaml(given);
  if (!out.empty() && !is_yaml) throw InputError({given, 0, 0}, "", "-o goes with the YAML file of a study");
  if (!is_folder && !is_stream(given) && !fs::exists(given, ignored))
    throw InputError({given, 0, 0}, "", "is not there");
  StoredStudy stored;
  stored.folder = is_folder     ? given
                  : !is_yaml    ? fs::path(given).parent_path().string()
                  : out.empty() ? (fs::path("results") / fs::path(given).stem()).string()
                                : out;
  stored.file = is_folder || is_yaml ? (fs::path(stored.folder) / "study.json").string() : given;
  if (!is_stream(stored.file) && !fs::exists(stored.file, ignored)) {
    throw InputError(
        {stored.file, 0, 0}, "",
        is_yaml ? "is not there: assay study " + given + " makes it" : "is not there: no result of a study");
  }
  stored.findings = findings_of_json(read_bytes(stored.file, study_limit), stored.file);
  return stored;
}

}  // namespace assay::drivers
