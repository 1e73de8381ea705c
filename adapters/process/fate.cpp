// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/process/fate.hpp"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <climits>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <ctime>

namespace assay::adapters {

namespace {

Fate* marked = nullptr;
alignas(16) char handler_stack[1 << 16];  // a stack that overflowed cannot serve

/// Whether an address lies just below the stack pointer, as that of a call that found no room.
bool next_to_stack(const void* address, const void* context) {
#if defined(__x86_64__)
  const auto at = reinterpret_cast<std::uintptr_t>(address);
  const auto top = static_cast<std::uintptr_t>(static_cast<const ucontext_t*>(context)->uc_mcontext.gregs[REG_RSP]);
  constexpr std::uintptr_t reach = 1 << 20;
  return at < top + 4096 && at + reach > top;
#else
  static_cast<void>(address), static_cast<void>(context);
  return false;
#endif
}

void on_crash(int signal, siginfo_t* information, void* context) {
  if (marked && information->si_code > 0) {
    constexpr std::uintptr_t next_to_null = 1 << 16;
    const bool is_null = reinterpret_cast<std::uintptr_t>(information->si_addr) < next_to_null && signal == SIGSEGV &&
                         information->si_code == SEGV_MAPERR;
    const Death why = signal == SIGBUS && information->si_code == BUS_ADRALN ? Death::unaligned
                      : next_to_stack(information->si_addr, context)         ? Death::stack
                      : is_null                                              ? Death::null
                                                                             : Death::none;
    marked->claim.store(static_cast<std::uint32_t>(why));
  }
  std::signal(signal, SIG_DFL);  // it happens again when this returns
}

}  // namespace

void mark_crashes(Fate& fate) {
  marked = &fate;
  stack_t stack = {};
  stack.ss_sp = handler_stack;
  stack.ss_size = sizeof handler_stack;
  ::sigaltstack(&stack, nullptr);
  struct sigaction action = {};
  action.sa_sigaction = on_crash;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  for (const int signal : {SIGSEGV, SIGBUS}) sigaction(signal, &action, nullptr);
  for (const int signal : {SIGFPE, SIGILL, SIGABRT}) std::signal(signal, SIG_DFL);  // sanitizers have their own
}

bool crashes_are_marked() { return marked != nullptr; }

void end_by_word(const char* words) {
  if (marked) {
    std::strncpy(marked->death_words, words, words_size - 1);
    marked->claim.store(static_cast<std::uint32_t>(Death::ended));
  }
  ::_exit(1);
}

void wait_while(std::atomic<std::uint32_t>& word, std::uint32_t value, int milliseconds) {
  const timespec limit{milliseconds / 1000, (milliseconds % 1000) * 1000000L};
  ::syscall(SYS_futex, reinterpret_cast<std::uint32_t*>(&word), FUTEX_WAIT, value, milliseconds < 0 ? nullptr : &limit,
            nullptr, 0);
}

void wake_all(std::atomic<std::uint32_t>& word) {
  ::syscall(SYS_futex, reinterpret_cast<std::uint32_t*>(&word), FUTEX_WAKE, INT_MAX, nullptr, nullptr, 0);
}

std::string words_of_end(const Fate& fate) {
  const std::string number = std::to_string(fate.death_number), signal = "was ended by signal " + number;
  switch (fate.end()) {
    case Death::signal:
      return signal + " (" + strsignal(fate.death_number) + ")";
    case Death::stack:
      return signal + ": the stack overflowed";
    case Death::null:
      return signal + ": it used a null pointer";
    case Death::unaligned:
      return signal + ": it used an address that is not aligned";
    case Death::exit:
      return "ended the process with status " + number;
    default:
      return {fate.death_words, strnlen(fate.death_words, words_size)};
  }
}

}  // namespace assay::adapters
