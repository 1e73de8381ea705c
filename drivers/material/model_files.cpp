// SPDX-License-Identifier: BSD-3-Clause
// The files that a model's description names.
#include "drivers/material/material_description.hpp"

#include <algorithm>

#include "drivers/format/yaml_values.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/whole_file.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

bool leads_out(const fs::path& name) {
  return name.is_absolute() || std::any_of(name.begin(), name.end(), [](const fs::path& part) { return part == ".."; });
}

void add_model_file(const Tree& tree, fs::path name, const fs::path& folder, std::vector<ModelFile>& files) {
  const std::string said = text_value(tree, "files");
  const std::string path = absolute_path(folder / said);
  std::error_code code;
  if (!fs::is_regular_file(path, code)) {
    throw InputError(tree.where, "files",
                     "'" + one_line(path, 200) + (fs::exists(path, code) ? "' is no file" : "': no such file"));
  }
  if (name.empty()) name = leads_out(fs::path(said).lexically_normal()) ? fs::path(path).filename() : fs::path(said);
  name = name.lexically_normal();
  if (name.empty() || !name.has_filename() || leads_out(name)) {
    throw InputError(tree.where, "files", "'" + one_line(name.string(), 200) + "' is no name of a file in a folder");
  }
  for (const ModelFile& other : files) {
    if (other.name == name.string()) {
      throw InputError(tree.where, "files", "'" + one_line(name.string(), 200) + "' is there twice");
    }
    const bool holds_it = other.name.starts_with(name.string() + "/");
    if (holds_it || name.string().starts_with(other.name + "/")) {
      throw InputError(tree.where, "files",
                       "'" + one_line(holds_it ? name.string() : other.name, 200) +
                           "' cannot be a file and the folder of another one");
    }
  }
  files.push_back({name.string(), path});
}

}  // namespace

std::vector<ModelFile> read_model_files(const Tree& tree, const fs::path& folder) {
  std::vector<ModelFile> files;
  if (tree.kind == Tree::Kind::sequence) {
    for (const Tree& item : tree.items) add_model_file(item, {}, folder, files);
    return files;
  }
  require_map(tree, "files", "a list of files, or names in the model's folder and files");
  for (const Tree::Entry& entry : tree.entries) {
    if (entry.key.empty()) throw InputError(entry.value.where, "files", "a file needs a name");
    add_model_file(entry.value, entry.key, folder, files);
  }
  return files;
}

void place_model_files(const std::vector<ModelFile>& files) {
  for (const ModelFile& file : files) {
    std::error_code code;
    const fs::path name(file.name);
    if (name.has_parent_path()) fs::create_directories(name.parent_path(), code);
    if (!code) fs::copy_file(file.path, name, fs::copy_options::skip_existing, code);
    if (code) fail(file.path, "cannot be copied to the folder of the model as " + file.name, code);
  }
}

}  // namespace assay::drivers
