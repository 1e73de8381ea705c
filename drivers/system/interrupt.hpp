// SPDX-License-Identifier: BSD-3-Clause
// SIGINT, SIGTERM and SIGHUP as a flag that long loops poll, so that destructors run and nothing partial looks
// complete.
#pragma once

namespace assay::drivers {

/// From now on the first SIGINT, SIGTERM or SIGHUP only raises the flag and lets system calls that wait fail with
/// EINTR; another, 0.3 s later or more, ends the process at once with 128 + signal (a sooner one is the same stop:
/// timeout(1) sends two). Where nothing polls the flag for 8 s, as in a native model that does not come back, the
/// process ends likewise. To be called when the scene is read.
void watch_interrupts();

/// While one lives, as after watch_interrupts(); then as before. For what may take long before the scene is read. Where
/// somebody watches already, and in a library, it changes nothing.
class InterruptWatch {
 public:
  InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;
  ~InterruptWatch();

 private:
  bool mine_;
};

/// Whether a signal came since watch_interrupts().
bool interrupted();

/// The first signal that came, 0 when none did.
int interrupt_signal();

/// Whether that signal came from this process: from the code of a material, then.
bool interrupted_from_inside();

/// Thrown by whoever leaves its loop because interrupted(); main turns it into exit status 128 + signal.
struct Interrupted {
  int signal = 0;
};

/// Throws Interrupted when a signal came, TimeIsUp when the time of a Deadline is over.
void stop_if_interrupted();

/// While one lives, stop_if_interrupted() passes over the signal that came: what was found until then is written down.
class KeptAfterInterrupt {
 public:
  KeptAfterInterrupt();
  KeptAfterInterrupt(const KeptAfterInterrupt&) = delete;
  KeptAfterInterrupt& operator=(const KeptAfterInterrupt&) = delete;
  ~KeptAfterInterrupt();
};

struct TimeIsUp {};

/// While it lives, loops that poll stop after so many seconds of processor time, which a busy machine does not shorten.
/// One at a time.
class Deadline {
 public:
  explicit Deadline(double seconds);
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;
  ~Deadline();
};

}  // namespace assay::drivers
