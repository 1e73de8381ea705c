// SPDX-License-Identifier: BSD-3-Clause
// Threads that help the calling one with a loop. They stay from loop to loop, and wait for the next awake for a moment,
// then asleep. Who comes late is not waited for: another program on their core costs what it takes of it, no more.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace assay::mpm {

/// part(member) on the calling thread, which is member 0, and on each of threads - 1 others that comes before that has
/// ended. Ends when all that have begun have ended. A part takes pieces of the work until none is left: it may be
/// alone. It must not throw. Within a part, part(member) of the same member alone. Where the system gives no more
/// threads, with those that there are.
void with_crew(int threads, const std::function<void(int member)>& part);

/// That of the calling thread within a part; 0 elsewhere.
int crew_member();

/// Waits until `value` is `wanted`: awake for a moment, then asleep until it is notified.
void await(const std::atomic<std::uint32_t>& value, std::uint32_t wanted);

/// body(i) for i = 0 .. count - 1, each once. Members begin at different places, with neighbours one after the other,
/// and then help the others.
void share_out(int threads, std::size_t count, const auto& body) {
  if (threads <= 1 || count <= 1) {
    for (std::size_t i = 0; i < count; ++i) body(i);
    return;
  }
  struct alignas(64) Share {
    std::atomic<std::size_t> next{0};
  };
  const auto shares = static_cast<std::size_t>(threads);
  std::vector<Share> begun(shares);
  for (std::size_t k = 0; k < shares; ++k) begun[k].next = k * count / shares;
  with_crew(threads, [&](int member) {
    for (std::size_t k = 0; k < shares; ++k) {
      const std::size_t of = (static_cast<std::size_t>(member) + k) % shares, end = (of + 1) * count / shares;
      for (std::size_t i = begun[of].next++; i < end; i = begun[of].next++) body(i);
    }
  });
}

}  // namespace assay::mpm
