// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/process/forked.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <exception>
#include <system_error>

#include "adapters/process/descendants.hpp"
#include "adapters/process/kept_process.hpp"
#include "harness/material/own_process.hpp"
#include "harness/material/progress_mark.hpp"
#include "harness/numeric/stopwatch.hpp"

namespace assay::adapters {

namespace {

/// What the copy says when the function has come back, and when it got to its end: no crash and no exit() of foreign
/// code can forge it.
constexpr char returned_mark = '-', done_mark = '+';

[[noreturn]] void run_copy(int out, const std::function<std::string()>& body, const std::function<void()>& after) {
  own_this_process();
  leave_no_marks();
  std::string text;
  try {
    text = body();
  } catch (const std::exception& error) {
    text = error.what();
  } catch (...) {
    text = "throws across the C interface";
  }
  end_a_copy();
  text += returned_mark;
  if (!write_all(out, text)) leave_now(1);
  if (after) after();
  end_a_copy();
  leave_now(write_all(out, {&done_mark, 1}) ? 0 : 1);
}

/// Orphans of its children are this process's own while this lives: a model may have ended their keeper.
class Adopting {
 public:
  Adopting() {
    ::prctl(PR_GET_CHILD_SUBREAPER, &before_);
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  }
  ~Adopting() { ::prctl(PR_SET_CHILD_SUBREAPER, before_); }
  Adopting(const Adopting&) = delete;
  Adopting& operator=(const Adopting&) = delete;

 private:
  int before_ = 0;
};

/// Until the copy has ended, whoever else may hold its pipe. What it may take does not stand in shared memory alone,
/// into which a model can write: `is_late` where it was ended here, because its keeper did not.
std::string heard_from(const KeptProcess& copy, int in, double patience_s, bool& is_late) {
  constexpr double keeper_grace_s = 2;
  const Stopwatch since;
  ::fcntl(in, F_SETFL, O_NONBLOCK);
  std::string text;
  bool open = true;
  for (bool over = false; !over;) {
    constexpr int look_ms = 10;
    if (!is_late && since.seconds() > patience_s + keeper_grace_s) is_late = true, copy.end();
    pollfd waiting{in, POLLIN, 0};
    open ? static_cast<void>(::poll(&waiting, 1, look_ms)) : wait_while(copy.fate().death, 0, look_ms);
    over = copy.is_over();  // before its last words are read
    char some[1 << 14];
    ssize_t length = 0;
    while ((length = ::read(in, some, sizeof some)) > 0) text.append(some, static_cast<std::size_t>(length));
    open = length < 0;
  }
  return text;
}

/// Takes the mark from the end of what the copy has said.
bool take_mark(std::string& text, char mark) {
  const bool there = !text.empty() && text.back() == mark;
  if (there) text.pop_back();
  return there;
}

Forked::End end_of(const Fate& fate, bool done) {
  switch (fate.end()) {
    case Death::lost:
      return Forked::End::lost;
    case Death::time_limit:
      return Forked::End::hangs;
    case Death::signal:
      return Forked::End::signal;
    case Death::shortage:
      throw std::system_error(fate.death_number, std::generic_category(), "fork");
    default:
      return done ? Forked::End::done : Forked::End::quit;
  }
}

}  // namespace

Forked in_a_child(const std::function<std::string()>& body, const ForkedHow& how) {
  const AwaitedChildren awaited;
  const Adopting adopting;
  Pipe said;
  const auto work = [&](Fate& fate) {
    fate.busy_since = now_ns();
    said.close_in();
    run_copy(said.out(), body, how.after);
  };
  const KeptProcess copy({.work = work,
                          .hears = false,
                          .own_group = how.apart,
                          .defers_signals = how.apart,
                          .ends_when_stopped = true,
                          .files_of_process = {said.out()}},
                         {.seconds = how.patience_s, .gigabytes = 0});
  said.close_out();
  Forked found;
  bool is_late = false;
  found.text = heard_from(copy, said.in(), how.patience_s, is_late);
  const bool at_end = found.text.ends_with(std::string{returned_mark, done_mark});
  const bool done = at_end && take_mark(found.text, done_mark);
  found.returned = take_mark(found.text, returned_mark);
  found.end = is_late ? Forked::End::hangs : end_of(copy.fate(), done);
  if (found.end == Forked::End::lost) found.returned = false, found.text.clear();  // it may have been cut short
  if (found.end == Forked::End::signal) found.signal = copy.fate().death_number;
  return found;
}

}  // namespace assay::adapters
