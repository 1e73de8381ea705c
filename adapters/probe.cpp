// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/probe.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <vector>

#include "harness/material.hpp"

namespace assay::adapters {

namespace {

constexpr int patience_ms = 20000;  ///< far beyond any honest update of one point

/// What the child says when it got to its end without complaint: no crash and no exit() of the model can forge it.
constexpr char done_mark = '+';

double inside(double lower, double upper) {
  if (std::isfinite(lower) && std::isfinite(upper)) {
    return lower > 0 ? std::sqrt(lower) * std::sqrt(upper) : 0.5 * lower + 0.5 * upper;
  }
  return std::clamp(1.0, lower, upper);
}

bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

/// In the child.
std::string first_update(const assay_material* table, const std::map<std::string, double>& parameters) {
  const Material material(table, parameters);
  const std::vector<double> F{1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::vector<double> state0 = material.initial_state(1);
  std::vector<double> state1(state0.size(), NAN), cauchy(9, NAN);
  const UpdateReport report =
      material.update(0, 1e-3, 1, F.data(), F.data(), state0.data(), state1.data(), cauchy.data());
  if (report.worst == ASSAY_FAILED) return "fails on an undeformed point: " + report.message;
  if (!all_finite(state1)) return "gives a state that is not finite on an undeformed point";
  return {};
}

[[noreturn]] void run_child(int out, const assay_material* table, const std::map<std::string, double>& parameters) {
  std::string text;
  try {
    text = first_update(table, parameters);
  } catch (const ParameterError& error) {
    text = "parameter '" + error.key() + "': " + error.what();
    if (!error.known().empty()) text += "; known: " + error.known();
  } catch (const std::exception& error) {
    text = error.what();
  } catch (...) {
    text = "throws across the C interface";
  }
  text += done_mark;
  const bool written = ::write(out, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  ::_exit(written ? 0 : 1);
}

/// Reads to the end or until patience ends; true at the end.
bool read_all(int in, std::string& text) {
  for (;;) {
    pollfd waiting{in, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, patience_ms);
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return false;
    char buffer[1024];
    const ssize_t got = ::read(in, buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return true;
    text.append(buffer, static_cast<std::size_t>(got));
  }
}

}  // namespace

std::map<std::string, double> probe_parameters(const assay_material& table) {
  std::map<std::string, double> values;
  for (std::uint32_t i = 0; i < table.parameter_count; ++i) {
    const assay_parameter& p = table.parameters[i];
    values[p.name] = std::isnan(p.default_value) ? inside(p.lower, p.upper) : p.default_value;
  }
  return values;
}

std::optional<std::string> probe_defect(const assay_material* table, const std::map<std::string, double>& given) {
  std::map<std::string, double> parameters = probe_parameters(*table);
  for (const auto& [name, value] : given) parameters[name] = value;

  int ends[2];
  if (::pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  std::fflush(nullptr);  // or the child would write it a second time
  const pid_t child = ::fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    ::close(ends[0]);
    run_child(ends[1], table, parameters);
  }
  ::close(ends[1]);
  std::string text;
  const bool in_time = read_all(ends[0], text);
  ::close(ends[0]);
  if (!in_time) ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!in_time) return "hangs on an undeformed point";
  if (WIFSIGNALED(status)) return std::string("crashes on an undeformed point: ") + strsignal(WTERMSIG(status));
  if (text.empty() || text.back() != done_mark) return "ends the process on an undeformed point";
  text.pop_back();
  if (text.empty()) return std::nullopt;
  return text;
}

}  // namespace assay::adapters
