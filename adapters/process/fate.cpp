// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/process/fate.hpp"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <climits>
#include <cstring>
#include <ctime>

namespace assay::adapters {

namespace {

Fate* marked = nullptr;

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

/// The text between the quotes behind `at`; empty: none in that line.
std::string quoted_behind(const std::string& text, std::size_t at) {
  const std::size_t end = std::min(text.find('\n', at), text.size());
  const std::size_t open = text.find_first_of("'\"", at);
  const std::size_t close = open < end ? text.find(text[open], open + 1) : text.npos;
  return close < end ? text.substr(open + 1, close - open - 1) : "";
}

std::string advice_for(const std::string& file, const std::string& what) {
  const std::string shown = last_line(file);
  if (shown.starts_with('/')) return "; it " + what + " '" + shown + "', a file that is not there or holds too little";
  if (shown == "stdin") return "; it reads standard input, which is empty for a model: read a file with OPEN";
  const std::string item = shown.starts_with("./") ? shown.substr(2) : shown;
  return "; it " + what + " '" + shown + "' in its own working folder: files: [" + item +
         "] in its description copies a file there";
}

}  // namespace

void use_handler_stack() {
  alignas(16) static char handler_stack[1 << 16];
  stack_t stack = {};
  if (::sigaltstack(nullptr, &stack) != 0 || (stack.ss_flags & SS_DISABLE) == 0) return;
  stack.ss_sp = handler_stack;
  stack.ss_size = sizeof handler_stack;
  stack.ss_flags = 0;
  ::sigaltstack(&stack, nullptr);
}

void mark_crashes(Fate& fate) {
  marked = &fate;
  use_handler_stack();
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

std::string last_line(std::string text) {
  if (const std::size_t calls = text.rfind("\nError termination. Backtrace:"); calls != text.npos) text.resize(calls);
  if (const std::size_t asks = text.rfind("\nTo resume execution, type go."); asks != text.npos) text.resize(asks);
  // behind an error of a FORMAT stand the FORMAT and where in it
  if (const std::size_t error = text.rfind("Fortran runtime error: "); error != text.npos)
    text.resize(std::min(text.find('\n', error), text.size()));
  while (!text.empty() && static_cast<unsigned char>(text.back()) <= ' ') text.pop_back();
  constexpr std::size_t longest = 200;
  text = text.substr(text.find_last_of('\n') + 1).substr(0, longest);
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = '?';  // of any terminal, of XML
  }
  return text;
}

std::string missing_file_words(const std::string& printed) {
  for (const std::string words : {"Cannot open file ", "File '", "cannot open ", "Cannot open "}) {
    const std::size_t at = printed.rfind(words);
    if (at == printed.npos) continue;
    const std::string line = printed.substr(at, printed.find('\n', at) - at);
    const bool absent = line.find("No such file") != line.npos || line.find("does not exist") != line.npos;
    const std::string file = quoted_behind(printed, at);
    if (absent && !file.empty()) return advice_for(file, "looks for");
  }
  if (printed.rfind("To resume execution, type go.") != printed.npos)
    return "; PAUSE waits for standard input, which is empty for a model: remove it";
  // An absent file is made when it is opened, and then it is empty.
  const std::size_t end_of_file = printed.rfind("Fortran runtime error: End of file");
  const std::size_t unit = end_of_file == printed.npos ? printed.npos : printed.rfind("file = '", end_of_file);
  if (unit != printed.npos && printed.find('\n', unit) + 1 == end_of_file) {
    const std::string file = quoted_behind(printed, unit);
    if (!file.empty()) return advice_for(file, "finds nothing to read in");
  }
  const std::size_t other = printed.rfind(": No such file or directory");
  if (other == printed.npos) return {};
  const std::size_t begin = printed.find_last_of(" \n", other) + 1;
  const std::string name = printed.substr(begin, other - begin);
  if (name.find('.') != name.npos) return advice_for(name, "looks for");
  return "; the model looks for files in its own working folder: `files` in its description copies files there";
}

}  // namespace assay::adapters
