// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_elsewhere.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <system_error>

#include "adapters/foreign/foreign_table.hpp"
#include "adapters/process/kept_process.hpp"
#include "drivers/system/own_files.hpp"
#include "harness/material/own_process.hpp"
#include "harness/material/progress_mark.hpp"

namespace assay::drivers {

namespace {

using Maker = std::function<check::History()>;

/// Row by row, each after its length.
std::string bytes_of(const check::History& rows) {
  std::vector<double> all;
  for (const auto& row : rows) {
    all.push_back(static_cast<double>(row.size()));
    all.insert(all.end(), row.begin(), row.end());
  }
  return {reinterpret_cast<const char*>(all.data()), all.size() * sizeof(double)};
}

check::History rows_of(const std::string& bytes) {
  std::vector<double> all(bytes.size() / sizeof(double));
  std::copy_n(bytes.data(), all.size() * sizeof(double), reinterpret_cast<char*>(all.data()));
  check::History rows;
  for (auto at = all.begin(); at != all.end();) {
    const auto begin = at + 1, end = begin + static_cast<std::ptrdiff_t>(*at);
    rows.emplace_back(begin, end);
    at = end;
  }
  return rows;
}

/// What it prints is nobody's, and neither is its end.
void fall_silent() {
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  keep_these_streams();
  std::signal(SIGSEGV, SIG_DFL);
  std::signal(SIGBUS, SIG_DFL);
}

}  // namespace

std::optional<check::History> made_elsewhere(const Maker& make, double limit_s) {
  const auto body = [&] {
    fall_silent();
    try {
      return bytes_of(make());
    } catch (const std::exception&) {
      adapters::leave_now(1);
    }
  };
  try {
    const adapters::Forked found = adapters::in_a_child(body, {.patience_s = limit_s, .apart = true});
    if (found.returned) return rows_of(found.text);
  } catch (const std::system_error&) {  // no process can be made
  }
  return std::nullopt;
}

check::History history_elsewhere(const Material& material, const check::Effort& effort, double limit_s) {
  const auto make = [&] { return check::history(material, check::amplitudes_of_first(effort).back()); };
  return made_elsewhere(make, limit_s).value_or(check::History());
}

namespace {

/// With other parameters, from a library that this process has not loaded.
Material made_of(const ResolvedMaterial& material, const std::string& library) {
  const std::map<std::string, double> parameters = check::other_parameters(material.material);
  if (material.foreign) {
    adapters::ForeignModel model = *material.foreign;
    if (model.folder.empty()) model.folder = std::filesystem::path(model.library).parent_path().string();
    model.library = library;
    return Material(adapters::foreign_table(model), parameters);
  }
  MaterialChoice choice = material.choice;
  choice.adapter = library + ":" + material.material.name();
  choice.parameters = parameters;
  choice.isolation = Isolation::none;
  return resolve_material(choice).material;
}

}  // namespace

check::History history_of_others(const ResolvedMaterial& material, const check::Effort& effort, double limit_s) {
  if (material.library.empty() || (!material.description.empty() && !material.foreign)) return {};
  if (material.foreign && material.foreign->each_its_element) return {};  // where elements are numbered otherwise
  std::error_code code;
  std::string folder = (std::filesystem::temp_directory_path(code) / "assay-XXXXXX").string();
  if (code || ::mkdtemp(folder.data()) == nullptr) return {};
  const std::filesystem::path copy = std::filesystem::path(folder) / "copy.so";
  std::filesystem::copy_file(material.library, copy, code);
  check::History found;
  if (!code) {
    const Maker make = [&] {
      return check::history(made_of(material, copy.string()), check::amplitudes_of_first(effort).back());
    };
    found = made_elsewhere(make, limit_s).value_or(check::History());
  }
  std::filesystem::remove_all(folder, code);
  return found;
}

}  // namespace assay::drivers
