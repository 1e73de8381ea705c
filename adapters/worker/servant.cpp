// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/worker.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <memory>
#include <stdexcept>
#include <vector>

#include "adapters/worker/fenced_model.hpp"
#include "adapters/worker/operations.hpp"
#include "adapters/worker/table_pack.hpp"
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
      : floor_(floor), table_(*table), description_(packed(*table)), state_(state_size_of(*table)) {}

  void serve(Operation operation) {
    CallArrays arrays(floor_.arrays, floor_.arrays_size);
    head_ = &arrays.head();
    instance_ = &instances_[head_->instance];
    if (operation == Operation::history) return history(arrays);
    const ForeignCall marks(floor_.control);
    try {
      call(operation, arrays, StatusExtensions{});
    } catch (const ModelThrew& threw) {
      head_->status = ASSAY_FAILED;
      say(head_->message, ASSAY_MESSAGE_SIZE, threw.what());
    }
  }

 private:
  struct Instance {
    std::unique_ptr<void, void (*)(void*)> self{nullptr, nullptr};
    std::vector<double> parameters;
    std::unique_ptr<FencedModel> histories;
  };

  /// Throws ModelThrew.
  template <class... Extensions>
  void call(Operation operation, CallArrays& arrays, FunctionList<Extensions...>) {
    if (operation == Operation::describe) return describe(arrays);
    if (operation == Operation::create) return create(arrays);
    if (operation == Operation::update) return update(arrays);
    const auto serve_if = [&]<class Function, class Pointer>(const Function*, Pointer function) {
      if (operation == operation_of<Function>) status_of<Function>(arrays, function);
    };
    (serve_if(static_cast<Extensions*>(nullptr), PointerOf<Extensions>()), ...);
    serve_if(static_cast<InitialState*>(nullptr), PointerOf<InitialState>());
  }

  void describe(CallArrays& arrays) {
    head_->n = description_.size();
    std::copy(description_.begin(), description_.end(), arrays.next<char>(description_.size(), "the table"));
    head_->status = ASSAY_GOOD;
  }

  void create(CallArrays& arrays) {
    const auto* parameters = arrays.next<double>(table_.parameter_count, "the parameters");
    const PhaseMark phase(CallPhase::creating);
    void* made = create_instance(&table_, parameters, head_->message);
    head_->status = made ? ASSAY_GOOD : ASSAY_FAILED;
    if (!made) return;
    instance_->histories.reset();
    instance_->self = {made, table_.destroy};
    instance_->parameters.assign(parameters, parameters + table_.parameter_count);
  }

  /// Each call of the model bears its own marks: the whole may take as long as it takes.
  void history(CallArrays& arrays) {
    const HistoryArrays numbers(arrays, head_->n);
    auto& fenced = instance_->histories;
    if (!fenced) fenced = std::make_unique<FencedModel>(table_, instance_->self.get(), instance_->parameters, floor_);
    const std::vector<double> answer = fenced->answer({numbers.task, head_->n});
    if (answer.size() > history_numbers) throw std::length_error("a history's answer has no room");
    std::copy(answer.begin(), answer.end(), numbers.answer);
    head_->n = answer.size();
    head_->status = ASSAY_GOOD;
    floor_.control.arithmetic.store(arithmetic_kept);
  }

  void update(CallArrays& arrays) {
    const std::size_t n = head_->n;
    const UpdateArrays a(arrays, n, state_);
    const assay_step step{head_->t, head_->dt, a.F0, a.F1};
    const std::string thrown = thrown_by(table_.update, [&] {
      table_.update(instance_->self.get(), &step, n, a.state0, a.state1, a.cauchy, a.status, &head_->dt_factor,
                    head_->message);
    });
    if (thrown.empty()) return;
    std::fill_n(a.status, n, ASSAY_FAILED);
    head_->dt_factor = 0;
    say(head_->message, ASSAY_MESSAGE_SIZE, "the model " + thrown);
  }

  template <class Function, class... Arguments>
  void status_of(CallArrays& arrays, std::int32_t (*)(void*, Arguments...)) {
    const PhaseMark phase(operation_of<Function> == Operation::initial_state ? CallPhase::beginning
                                                                             : CallPhase::updating);
    CallPassage passage(arrays, operation_of<Function>, head_->n, state_);
    void* self = instance_->self.get();
    head_->status = std::apply([&](Arguments... arguments) { return call_here<Function>(table_, self, arguments...); },
                               passage.take_all<Arguments...>());
    if (head_->status != ASSAY_FAILED) return;
    const std::string reason = reason_of(table_, self);
    if (!reason.empty()) say(head_->message, ASSAY_MESSAGE_SIZE, reason);
  }

  WorkerFloor& floor_;
  const assay_material& table_;
  std::string description_;
  std::size_t state_;
  CallHead* head_ = nullptr;
  Instance* instance_ = nullptr;
  std::map<std::uint64_t, Instance> instances_;
};

std::uint32_t answered = 0;  ///< requests; where no model writes over it

}  // namespace

std::uint32_t next_request(Control& control) {
  for (;;) {
    const std::uint32_t asked = control.request.load();
    if (asked == answered + 1) return control.operation.load();
    if (!changes_within(control.request, asked, control.spin_us.load()))
      sleep_while(control.request, asked, control.worker_sleeps);
  }
}

void answer(Control& control) {
  control.reply.store(++answered);
  wake_sleeper(control, control.reply, control.host_sleeps);
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
