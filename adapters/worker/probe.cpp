// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/probe.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <vector>

#include "adapters/elf_symbols.hpp"
#include "adapters/library.hpp"
#include "adapters/process/kept_process.hpp"
#include "adapters/worker/remote_table.hpp"
#include "adapters/worker/table_pack.hpp"
#include "harness/material/material.hpp"
#include "harness/material/material_failure.hpp"

namespace assay::adapters {

namespace {

double inside(double lower, double upper) {
  if (std::isfinite(lower) && std::isfinite(upper)) {
    return lower > 0 ? std::sqrt(lower) * std::sqrt(upper) : 0.5 * lower + 0.5 * upper;
  }
  return std::clamp(1.0, lower, upper);
}

/// In the child.
std::string first_update(const assay_material* table, const std::map<std::string, double>& parameters) {
  const Material material(table, parameters);
  const std::vector<double> F{1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::vector<double> state0 = material.initial_state(1);
  std::vector<double> state1(state0.size(), NAN), cauchy(9, NAN);
  const UpdateReport report =
      material.update(0, 1e-3, 1, F.data(), F.data(), state0.data(), state1.data(), cauchy.data());
  if (report.worst != ASSAY_FAILED) return {};
  const bool ended = report.dt_factor == 0;
  return (ended ? "fails on an undeformed point: " : refuses_rest) + report.message;
}

std::string complaint_of(const assay_material* table, const std::map<std::string, double>& parameters) {
  try {
    return first_update(table, parameters);
  } catch (const ParameterError& error) {
    const std::string known = error.known().empty() ? "" : "; known: " + error.known();
    return "parameter '" + error.key() + "': " + error.what() + known;
  } catch (const std::exception& error) {
    return error.what();
  }
}

/// How a copy of this process came to an end that was not its own; empty where it was.
std::string fault_of(const Forked& found, const std::string& when, const std::string& watched) {
  switch (found.end) {
    case Forked::End::hangs:
      return "hangs" + when;
    case Forked::End::signal:
      return "crashes" + when + ": " + strsignal(found.signal);
    case Forked::End::quit:
      return "ends the process" + when;
    case Forked::End::lost:
      return "ends or stops the process that watches " + watched + when;
    case Forked::End::done:
      break;
  }
  return {};
}

}  // namespace

// weak: libassay has another in its place
[[gnu::weak]] void try_library(const std::string& path) {
  check_shared_library(path);
  constexpr char between = '\x1f';  // of an error's two parts
  const auto load = [&] {
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, STDOUT_FILENO), ::dup2(nowhere, STDERR_FILENO);
    try {
      for (const assay_material* table : tables_of_library(path)) static_cast<void>(packed(*table));
    } catch (const LibraryError& error) {
      return error.what() + (between + error.known());
    } catch (const ModelThrew& threw) {
      return std::string("cannot serve: ") + threw.what() + between;
    }
    return std::string();
  };
  const auto unload = [&] {
    void* library = dlopen(std::filesystem::absolute(path).c_str(), RTLD_NOW | RTLD_LOCAL);
    for (int k = 0; library && k < 2; ++k) dlclose(library);  // its own end, as at the end of the program
  };
  const Forked found = in_a_child(load, {.after = unload});
  const std::string when = std::string(" when it is ") + (found.returned ? "unloaded" : "loaded");
  if (const std::string fault = fault_of(found, when, "its trial"); !fault.empty()) throw LibraryError(fault);
  const std::size_t at = found.text.find(between);
  if (at != std::string::npos) throw LibraryError(found.text.substr(0, at), found.text.substr(at + 1));
}

std::map<std::string, double> probe_parameters(const assay_material& table, std::map<std::string, double> given) {
  for (const assay_parameter& p : std::span(table.parameters, table.parameter_count))
    given.emplace(p.name, std::isnan(p.default_value) ? inside(p.lower, p.upper) : p.default_value);
  return given;
}

std::optional<std::string> probe_defect(const assay_material* table, const std::map<std::string, double>& given) {
  const std::map<std::string, double> parameters = probe_parameters(*table, given);
  if (!start_of(table).task.empty()) {  // in a process of its own as it is
    const std::string complaint = complaint_of(table, parameters);
    return complaint.empty() ? std::nullopt : std::optional(complaint);
  }
  const Forked found = in_a_child([&] { return complaint_of(table, parameters); });
  const std::string fault = fault_of(found, " on an undeformed point", "it,");
  if (!fault.empty()) return fault;
  if (found.text.empty()) return std::nullopt;
  return found.text;
}

bool depends_on_duration(const assay_material* table, const std::map<std::string, double>& given) {
  constexpr double strain = 1e-4, alike = 1e-6;
  const std::map<std::string, double> parameters = probe_parameters(*table, given);
  try {
    const Material material(table, parameters);
    const std::vector<double> F0{1, 0, 0, 0, 1, 0, 0, 0, 1}, F1{1 + strain, strain, 0, 0, 1, 0, 0, 0, 1};
    const std::vector<double> state0 = material.initial_state(1);
    std::vector<double> state1(state0.size());
    double largest = 0, apart = 0, first[9], second[9];
    const auto taken = [&](double dt, double* cauchy) {
      return material.update(0, dt, 1, F0.data(), F1.data(), state0.data(), state1.data(), cauchy).worst !=
             ASSAY_FAILED;
    };
    if (!taken(1e-3, first) || !taken(1, second)) return false;
    for (int c = 0; c < 9; ++c) {
      largest = std::max({largest, std::abs(first[c]), std::abs(second[c])});
      apart = std::max(apart, std::abs(first[c] - second[c]));
    }
    return apart > alike * largest;
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace assay::adapters
