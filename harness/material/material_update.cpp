// SPDX-License-Identifier: BSD-3-Clause
// One call of a material's `update`, whose answer is not trusted.
#include <algorithm>
#include <cmath>

#include "harness/material/material.hpp"
#include "harness/material/thrown.hpp"
#include "harness/numeric/arithmetic.hpp"

namespace assay {

namespace {

/// Whether all n values are numbers. Four sums of 0 * v: independent, so that they do not wait for one another.
bool all_finite(const double* v, std::size_t n) {
  double sum[4] = {};
  std::size_t k = 0;
  for (; k + 4 <= n; k += 4) {
    for (std::size_t j = 0; j < 4; ++j) sum[j] += 0 * v[k + j];
  }
  for (; k < n; ++k) sum[0] += 0 * v[k];
  return sum[0] + sum[1] + sum[2] + sum[3] == 0;
}

/// First point and component of several of which one is not finite.
std::pair<std::size_t, std::size_t> first_not_finite(const double* values, std::size_t components, std::size_t n) {
  for (std::size_t p = 0; p < n; ++p) {
    for (std::size_t c = 0; c < components; ++c) {
      if (!std::isfinite(values[c * n + p])) return {p, c};
    }
  }
  return {0, 0};
}

std::string message_text(char* message) {
  message[ASSAY_MESSAGE_SIZE - 1] = '\0';
  return message[0] ? one_line_of(message) : "the material refused the step";
}

/// What is none of the ABI's three is as bad as the worst of them.
void take_statuses(const std::int32_t* status, std::size_t n, char* message, UpdateReport& report) {
  const auto [worst, best] = std::minmax_element(status, status + n);
  const std::int32_t* unknown = *best > ASSAY_GOOD ? best : *worst < ASSAY_FAILED ? worst : nullptr;
  if (unknown) {
    report.worst = ASSAY_FAILED;
    report.worst_point = static_cast<std::size_t>(unknown - status);
    report.message = "the material returned the status " + std::to_string(*unknown) + ", which is none of the ABI's";
  } else if (*worst < ASSAY_GOOD) {
    report.worst = *worst;
    report.worst_point = static_cast<std::size_t>(worst - status);
    report.message = message_text(message);
  }
}

}  // namespace

UpdateReport Material::update(double t, double dt, std::size_t n, const double* F0, const double* F1,
                              const double* state0, double* state1, double* cauchy,
                              std::span<const double> fields1) const {
  const assay_step step{pace_ * t, pace_ * dt, F0, F1};
  UpdateReport report;
  char message[ASSAY_MESSAGE_SIZE] = "";
  std::int32_t status[ASSAY_BATCH_MAX];
  std::fill_n(status, n, ASSAY_GOOD);
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    const Field& field = fields_[k];
    const std::size_t at = field.component * n;
    if (k < fields1.size() || field.value) {
      std::fill_n(state1 + at, n, k < fields1.size() ? fields1[k] : field.value(t + dt));
    } else {
      std::copy_n(state0 + at, n, state1 + at);
    }
  }
  const std::string thrown = thrown_by(table_->update, [&] {
    table_->update(self_.get(), &step, n, state0, state1, cauchy, status, &report.dt_factor, message);
  });
  if (!thrown.empty()) {
    put_arithmetic_right();
    report.worst = ASSAY_FAILED;
    report.dt_factor = 0;
    report.message = "the model " + thrown;
    return report;
  }
  if (const std::string words = arithmetic_words(put_arithmetic_right()); !words.empty()) {
    report.worst = ASSAY_FAILED;
    report.message = arithmetic_prefix + ("the material " + words);
    return report;
  }
  take_statuses(status, n, message, report);
  if (!(report.dt_factor >= 0)) {
    report.worst = ASSAY_FAILED;
    report.message = std::string("the material returned a dt_factor that is ") +
                     (std::isnan(report.dt_factor) ? "no number" : "negative") + ", which is none of the ABI's";
    report.dt_factor = 1;
  }
  report.not_finite = report.worst == ASSAY_FAILED && report.message.starts_with(not_finite_words);
  const auto require_finite = [&](const double* values, std::size_t components, const char* what) {
    if (report.worst == ASSAY_FAILED || all_finite(values, components * n)) return;
    const auto [point, component] = first_not_finite(values, components, n);
    report.worst = ASSAY_FAILED;
    report.not_finite = true;
    report.worst_point = point;
    report.message = std::string("the material returned a ") + what + " that is not finite" +
                     (values == state1 ? ": '" + variable_at(*table_, component) + "'" : "");
  };
  require_finite(cauchy, 9, "stress");
  require_finite(state1, state_size(), "state");
  return report;
}

}  // namespace assay
