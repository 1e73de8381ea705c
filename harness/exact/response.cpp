// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/response.hpp"

#include <algorithm>
#include <array>

namespace assay {

namespace {

class SheetAtTime final : public ResponseAtTime {
 public:
  SheetAtTime(const Sheet& sheet, double t) : curve_(sheet.isochrone(t)), has_kinks_(sheet.has_kinks()) {}
  void at(double xi, Tensor& tau, Tensor& dtau_dxi) const override { curve_.at(xi, tau, dtau_dxi); }
  void many(std::span<const double> xi, unsigned wanted, double* tau, double* slopes) const override {
    curve_.many(xi, wanted, tau, slopes);
  }
  void plane_tau(std::span<const double> xi, std::span<double> tau, const InPieces& pieces) const override {
    pieces(xi.size(), [&](std::size_t begin, std::size_t end) { curve_.plane_tau(xi, tau, begin, end); });
  }
  std::vector<double> fronts() const override { return has_kinks_ ? curve_.kinks() : std::vector<double>(); }

 private:
  Isochrone curve_;
  bool has_kinks_;
};

class FormAtTime final : public ResponseAtTime {
 public:
  FormAtTime(const ClosedForm& form, double t) : form_(form), t_(t), g_(form.amplitude(t)) {}
  void at(double xi, Tensor& tau, Tensor& dtau_dxi) const override { form_.at(xi, t_, g_, tau, dtau_dxi); }
  void many(std::span<const double> xi, unsigned, double* tau, double* slopes) const override {
    std::array<double, 9 * ClosedForm::at_once> some_tau, some_slopes;
    const std::size_t n = xi.size();
    for (std::size_t first = 0; first < n; first += ClosedForm::at_once) {
      const std::size_t count = std::min(ClosedForm::at_once, n - first);
      form_.at(xi.subspan(first, count), t_, g_, some_tau.data(), some_slopes.data());
      for (std::size_t c = 0; c < 9; ++c) {
        std::copy_n(&some_tau[c * count], count, tau + c * n + first);
        std::copy_n(&some_slopes[c * count], count, slopes + c * n + first);
      }
    }
  }
  void plane_tau(std::span<const double> xi, std::span<double> tau, const InPieces&) const override {
    std::array<double, 9 * ClosedForm::at_once> values, slopes;
    for (std::size_t first = 0; first < xi.size(); first += ClosedForm::at_once) {
      const std::span some = xi.subspan(first, std::min(ClosedForm::at_once, xi.size() - first));
      form_.at(some, t_, g_, values.data(), slopes.data());
      for (std::size_t i = 0; i < some.size(); ++i) {
        for (const std::size_t c : {0, 1, 2, 3}) tau[c * xi.size() + first + i] = values[(c + c / 2) * some.size() + i];
      }
    }
  }

 private:
  ClosedForm form_;
  double t_, g_;
};

}  // namespace

void ResponseAtTime::many(std::span<const double> xi, unsigned, double* tau, double* slopes) const {
  Tensor value, slope;
  for (std::size_t i = 0; i < xi.size(); ++i) {
    at(xi[i], value, slope);
    put_tensor(value, tau, xi.size(), i);
    put_tensor(slope, slopes, xi.size(), i);
  }
}

void ResponseAtTime::plane_tau(std::span<const double> xi, std::span<double> tau, const InPieces&) const {
  const std::size_t n = xi.size();
  Tensor value, slope;
  for (std::size_t i = 0; i < n; ++i) {
    at(xi[i], value, slope);
    for (std::size_t c = 0; c < 4; ++c) tau[c * n + i] = value(static_cast<int>(c / 2), static_cast<int>(c % 2));
  }
}

void Response::at(double xi, double t, Tensor& tau, Tensor& dtau_dxi) const {
  if (const Sheet* table = sheet()) return table->at(xi, t, tau, dtau_dxi);
  at_time(t)->at(xi, tau, dtau_dxi);
}

std::shared_ptr<const ResponseAtTime> Response::at_time(double t) const {
  const std::lock_guard lock(last_->mutex);
  if (last_->tau && last_->t == t) return last_->tau;
  if (const Sheet* table = sheet()) {
    last_->tau = std::make_shared<const SheetAtTime>(*table, t);
  } else if (const auto* form = std::get_if<ClosedForm>(&source_)) {
    last_->tau = std::make_shared<const FormAtTime>(*form, t);
  } else {
    Shadow& points = *std::get<std::shared_ptr<Shadow>>(source_);
    points.advance(t);
    last_->tau = points.curve();
  }
  last_->t = t;
  return last_->tau;
}

const Shadow* Response::shadow() const {
  const auto* points = std::get_if<std::shared_ptr<Shadow>>(&source_);
  return points ? points->get() : nullptr;
}

}  // namespace assay
