// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/worker.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>
#include <memory>
#include <stdexcept>

#include "adapters/foreign/host_values.hpp"
#include "adapters/library.hpp"
#include "adapters/process/kept_process.hpp"
#include "adapters/process/process_watch.hpp"
#include "adapters/process/shortage.hpp"
#include "adapters/worker/operations.hpp"
#include "adapters/worker/table_pack.hpp"
#include "adapters/worker/worker_process.hpp"
#include "harness/material/material.hpp"
#include "harness/material/offer.hpp"
#include "harness/material/own_process.hpp"
#include "harness/material/progress_mark.hpp"
#include "harness/material/thrown.hpp"
#include "harness/numeric/arithmetic.hpp"

namespace assay::adapters {

namespace {

/// Looks at what the model has done to its process: after each of the first calls, then at most once a millisecond.
class Lookout {
 public:
  explicit Lookout(const Control& control) : memory_limit_(control.memory_limit) {}

  void look(Control& control, std::int64_t now) {
    constexpr int first_calls = 16;
    constexpr std::int64_t pause_ns = 1000000;
    if (++calls_ > first_calls && now - last_ns_ < pause_ns) return;
    last_ns_ = now;
    control.habits.fetch_or(process_.habits_so_far());
    if (data_bytes(::getpid()) <= begin_bytes_ + memory_limit_) return;
    control.claim.store(static_cast<std::uint32_t>(Death::memory));
    ::_exit(1);
  }

 private:
  ProcessWatch process_;
  std::uint64_t begin_bytes_ = data_bytes(::getpid()), memory_limit_;
  std::int64_t last_ns_ = 0;
  int calls_ = 0;
};

std::unique_ptr<Lookout> lookout;

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
      write_message(head_->message, threw.what());
    }
  }

 private:
  struct Instance {
    std::unique_ptr<void, void (*)(void*)> self{nullptr, nullptr};
    std::vector<double> parameters;
    FencedModel histories;
  };

  /// Throws ModelThrew.
  template <class... Extensions>
  void call(Operation operation, CallArrays& arrays, FunctionList<Extensions...>) {
    if (operation == Operation::describe) return describe(arrays);
    if (operation == Operation::create) return create(arrays);
    const auto serve_if = [&]<class Function, class Pointer>(const Function*, Pointer function) {
      if (operation == operation_of<Function>) status_of<Function>(arrays, function);
    };
    serve_if(static_cast<Update*>(nullptr), PointerOf<Update>());
    serve_if(static_cast<InitialState*>(nullptr), PointerOf<InitialState>());
    (serve_if(static_cast<Extensions*>(nullptr), PointerOf<Extensions>()), ...);
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
    instance_->histories = nullptr;
    instance_->self = {made, table_.destroy};
    instance_->parameters.assign(parameters, parameters + table_.parameter_count);
  }

  /// Each call of the model bears its own marks: the whole may take as long as it takes.
  void history(CallArrays& arrays) {
    const HistoryArrays numbers(arrays, head_->n);
    auto& fenced = instance_->histories;
    if (!fenced) fenced = fenced_model(table_, instance_->self.get(), instance_->parameters, floor_);
    const std::vector<double> answer = fenced({numbers.task, head_->n});
    if (answer.size() > history_numbers) throw std::length_error("a history's answer has no room");
    std::copy(answer.begin(), answer.end(), numbers.answer);
    head_->n = answer.size();
    head_->status = ASSAY_GOOD;
    floor_.control.arithmetic.store(arithmetic_kept);
  }

  template <class Function, class... Arguments>
  void status_of(CallArrays& arrays, std::int32_t (*type)(void*, Arguments...)) {
    const PhaseMark phase(operation_of<Function> == Operation::initial_state ? CallPhase::beginning
                                                                             : CallPhase::updating);
    CallPassage passage(arrays, operation_of<Function>, head_->n, state_);
    void* self = instance_->self.get();
    head_->status = std::apply([&](Arguments... arguments) { return call_here<Function>(table_, self, arguments...); },
                               passage.take_all(type));
    if (head_->status != ASSAY_FAILED || head_->message[0]) return;
    const std::string reason = reason_of(table_, self);
    if (!reason.empty()) write_message(head_->message, reason);
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

int run_worker(const std::function<void(WorkerFloor&)>& work, const std::string& own, const std::string& host) {
  const SharedMemory memory = SharedMemory::of_file(memory_file);
  auto* base = static_cast<char*>(memory.data());
  if (!host.empty() && host != own) {
    own.copy(base + memory.size() - refusal_size, refusal_size - 1);
    return 2;
  }
  WorkerFloor floor{*static_cast<Control*>(memory.data()), base + task_offset, base + arrays_offset,
                    memory.size() - arrays_offset - refusal_size};
  enlarge_stack(std::size_t{1} << 26);
  const auto worker = [&](Fate& fate) {
    int status = 0;
    mark_crashes(fate);
    own_this_process();
    try {
      work(floor);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
      status = 1;
    }
    std::fflush(nullptr);
    leave_now(status);
  };
  return keep({.work = worker}, floor.control, lifeline_file);
}

ForeignCall::ForeignCall(Control& control) : control_(control) {
  control_.point.store(no_point);
  reset_arithmetic();
  control_.busy_since.store(now_ns());
}

ForeignCall::~ForeignCall() {
  end_a_copy();
  const std::int64_t now = now_ns();
  control_.busy_ns.store(now - control_.busy_since.load());
  control_.busy_since.store(0);
  control_.arithmetic.store(put_arithmetic_right());
  lookout->look(control_, now);
}

ModelCall::ModelCall(Control& control) : control_(control), begin_(now_ns()) {
  control_.point.store(no_point, std::memory_order_relaxed);
  control_.busy_since.store(begin_, std::memory_order_release);
}

ModelCall::~ModelCall() {
  end_a_copy();
  control_.busy_since.store(0, std::memory_order_release);
  lookout->look(control_, begin_);  // the clock is not read again
}

WatchedProcess::WatchedProcess(Control& control) {
  probes_beyond = true;
  point_mark = &control.point;
  phase_mark = &control.phase;
  lookout = std::make_unique<Lookout>(control);
}

WatchedProcess::~WatchedProcess() {
  lookout.reset();
  probes_beyond = false;
  phase_mark = nullptr;
  point_mark = nullptr;
}

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
  ModelRefused refused("", "");
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
      refused = LibraryError(std::string("cannot serve: ") + threw.what());
    } catch (const std::exception& error) {
      refused = ModelRefused("", error.what());
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
      for (const std::string& part : {refused.key(), std::string(refused.what()), refused.known()})
        write_message(arrays.next<char>(ASSAY_MESSAGE_SIZE, "the reason"), part);
    }
    answer(floor.control);
  }
}

}  // namespace assay::adapters
