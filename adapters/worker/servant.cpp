// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/servant.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <memory>
#include <stdexcept>

#include "adapters/worker/call_arrays.hpp"
#include "adapters/worker/fenced_model.hpp"
#include "adapters/worker/futex.hpp"
#include "adapters/worker/table_pack.hpp"
#include "adapters/worker/watched_call.hpp"
#include "harness/material/material.hpp"
#include "harness/material/offer.hpp"
#include "harness/material/progress_mark.hpp"
#include "harness/material/thrown.hpp"
#include "harness/numeric/arithmetic.hpp"

namespace assay::adapters {

namespace {

void say(char* out, std::size_t size, const std::string& text) { out[text.copy(out, size - 1)] = '\0'; }

/// The answers to one host about one table.
class Servant {
 public:
  /// Throws ModelThrew.
  Servant(WorkerFloor& floor, const assay_material* table)
      : floor_(floor), table_(*table), description_(packed(*table)) {
    for (std::uint32_t i = 0; i < table->state_count; ++i) {
      state_ += static_cast<std::size_t>(components_of_kind(table->state[i].kind));
    }
  }

  void serve(Operation operation) {
    CallArrays arrays(floor_.arrays, floor_.arrays_size);
    head_ = &arrays.head();
    if (operation == Operation::history) return history(arrays);
    const ForeignCall marks(floor_.control);
    try {
      call(operation, arrays);
    } catch (const ModelThrew& threw) {
      head_->status = ASSAY_FAILED;
      say(head_->message, ASSAY_MESSAGE_SIZE, threw.what());
    }
  }

 private:
  using Self = std::unique_ptr<void, void (*)(void*)>;

  /// Throws ModelThrew.
  void call(Operation operation, CallArrays& arrays) {
    switch (operation) {
      case Operation::describe: {
        auto* out = arrays.next<char>(description_.size(), "the table");
        head_->n = description_.size();
        std::copy(description_.begin(), description_.end(), out);
        head_->status = ASSAY_GOOD;
        return;
      }
      case Operation::create:
        return create(arrays);
      case Operation::initial_state:
        return initial_state(arrays);
      case Operation::update:
        return update(arrays);
      default:
        return extension(operation, arrays);
    }
  }

  void* self() const {
    const auto found = instances_.find(head_->instance);
    return found == instances_.end() ? nullptr : found->second.get();
  }

  void create(CallArrays& arrays) {
    const auto* parameters = arrays.next<double>(table_.parameter_count, "the parameters");
    const PhaseMark phase(CallPhase::creating);
    void* made = create_instance(&table_, parameters, head_->message);
    head_->status = made ? ASSAY_GOOD : ASSAY_FAILED;
    if (!made) return;
    histories_.erase(head_->instance);
    instances_.insert_or_assign(head_->instance, Self(made, table_.destroy));
    parameters_[head_->instance].assign(parameters, parameters + table_.parameter_count);
  }

  /// Each call of the model bears its own marks: the whole may take as long as it takes.
  void history(CallArrays& arrays) {
    const HistoryArrays numbers(arrays, head_->n);
    auto& fenced = histories_[head_->instance];
    if (!fenced) fenced = std::make_unique<FencedModel>(table_, self(), parameters_[head_->instance], floor_);
    const std::vector<double> answer = fenced->answer({numbers.task, head_->n});
    if (answer.size() > history_numbers) throw std::length_error("a history's answer has no room");
    std::copy(answer.begin(), answer.end(), numbers.answer);
    head_->n = answer.size();
    head_->status = ASSAY_GOOD;
    floor_.control.arithmetic.store(arithmetic_kept);
  }

  void initial_state(CallArrays& arrays) {
    const std::size_t n = head_->n;
    const auto* cauchy = arrays.next<double>(9 * n, "cauchy");
    auto* state = arrays.next<double>(state_ * n, "the initial state");
    const PhaseMark phase(CallPhase::beginning);
    head_->status = table_.initial_state
                        ? call_model(table_, "initial_state", table_.initial_state, self(), n, cauchy, state)
                        : ASSAY_GOOD;
    say_reason();
  }

  void update(CallArrays& arrays) {
    const std::size_t n = head_->n;
    const UpdateArrays a(arrays, n, state_);
    const assay_step step{head_->t, head_->dt, a.F0, a.F1};
    const std::string thrown = thrown_by(table_.update, [&] {
      table_.update(self(), &step, n, a.state0, a.state1, a.cauchy, a.status, &head_->dt_factor, head_->message);
    });
    if (thrown.empty()) return;
    std::fill_n(a.status, n, ASSAY_FAILED);
    head_->dt_factor = 0;
    say(head_->message, ASSAY_MESSAGE_SIZE, "the model " + thrown);
  }

  template <class Extension>
  Offer<Extension> offered() const {
    return {table_, self()};
  }

  void extension(Operation operation, CallArrays& arrays) {
    const std::size_t n = head_->n;
    const auto in = [&](std::size_t size, const char* name) { return arrays.next<double>(size, name); };
    if (operation == Operation::tangent) {
      const double *F0 = in(9 * n, "F0"), *F1 = in(9 * n, "F1"), *state0 = in(state_ * n, "state0");
      const assay_step step{head_->t, head_->dt, F0, F1};
      head_->status = offered<assay_tangent>()(&step, n, state0, in(81 * n, "the tangent"));
    } else if (operation == Operation::energy) {
      const double *F = in(9 * n, "F"), *state = in(state_ * n, "state");
      head_->status = offered<assay_energy>()(n, F, state, in(n, "the energy"));
    } else if (operation == Operation::rate) {
      const double *F = in(9 * n, "F"), *l = in(9 * n, "l"), *cauchy = in(9 * n, "cauchy"),
                   *state = in(state_ * n, "state");
      double *cauchy_rate = in(9 * n, "the rate of stress"), *state_rate = in(state_ * n, "the rate of state");
      head_->status = offered<assay_rate>()(head_->t, n, F, l, cauchy, state, cauchy_rate, state_rate);
    } else if (operation == Operation::wave_speed) {
      const double *F = in(9 * n, "F"), *cauchy = in(9 * n, "cauchy"), *state = in(state_ * n, "state");
      head_->status = offered<assay_wave_speed>()(head_->density, n, F, cauchy, state, in(n, "the speed"));
    } else if (operation == Operation::closed_form) {
      const double* eps = in(n, "eps");
      double *tau = in(9 * n, "tau"), *slope = in(9 * n, "the slope");
      head_->status = offered<assay_closed_form>()(head_->baseline, n, eps, tau, slope);
    }
    say_reason();
  }

  void say_reason() {
    if (head_->status != ASSAY_FAILED) return;
    const std::string reason = reason_of(table_, self());
    if (!reason.empty()) say(head_->message, ASSAY_MESSAGE_SIZE, reason);
  }

  WorkerFloor& floor_;
  const assay_material& table_;
  std::string description_;
  std::size_t state_ = 0;
  CallHead* head_ = nullptr;
  std::map<std::uint64_t, Self> instances_;
  std::map<std::uint64_t, std::vector<double>> parameters_;
  std::map<std::uint64_t, std::unique_ptr<FencedModel>> histories_;
};

}  // namespace

namespace {

std::uint32_t answered = 0;  ///< requests; where no model writes over it

}  // namespace

std::uint32_t next_request(Control& control) {
  for (;;) {
    const std::uint32_t asked = control.request.load();
    if (asked == answered + 1) return control.operation.load();
    if (changes_within(control.request, asked, control.spin_us.load())) continue;
    wait_while(control.request, asked, control.worker_sleeps);
  }
}

void answer(Control& control) {
  control.reply.store(++answered);
  if (wake_sleeper(control.reply, control.host_sleeps)) control.wake_ups.fetch_add(1);
}

void serve_model(WorkerFloor& floor, const std::function<const assay_material*()>& find) {
  const WatchedProcess watched(floor.control);
  std::unique_ptr<Servant> servant;
  ModelRefused refused;
  const auto load = [&] {
    const ForeignCall marks(floor.control);
    try {
      const assay_material* table = find();
      reset_arithmetic();  // a library that was linked with -ffast-math changes it when it is loaded
      const PhaseMark phase(CallPhase::loading);  // it asks for the extensions
      servant = std::make_unique<Servant>(floor, table);
    } catch (const ModelRefused& why) {
      refused = why;
    } catch (const ModelThrew& threw) {
      refused = {"library", std::string("cannot serve: ") + threw.what(), ""};
    } catch (const std::exception& error) {
      refused = {"", error.what(), ""};
    }
  };
  for (bool loaded = false;; loaded = true) {
    const auto operation = static_cast<Operation>(next_request(floor.control));
    if (operation == Operation::end) return answer(floor.control);
    if (!loaded) load();
    if (servant) {
      servant->serve(operation);
    } else {
      CallArrays arrays(floor.arrays, floor.arrays_size);
      arrays.head().status = ASSAY_FAILED;
      char* words = arrays.next<char>(3 * words_size, "the reason");
      say(words, words_size, refused.key);
      say(words + words_size, words_size, refused.what);
      say(words + 2 * words_size, words_size, refused.known);
    }
    answer(floor.control);
  }
}

}  // namespace assay::adapters
