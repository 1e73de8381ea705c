// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/step/run_kernels.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <mutex>

#include "mpm/data/crew.hpp"

namespace assay::mpm {

namespace {

/// Side by side with blocks; a step has fewer.
constexpr std::size_t most_kernels = 16;
/// Of this many blocks one is timed, pass by pass: reading the clock takes as long as two particles.
constexpr std::size_t timed_block = 8;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point& before) {
  const auto now = Clock::now();
  const double seconds = std::chrono::duration<double>(now - before).count();
  before = now;
  return seconds;
}

/// Kernels side by side.
class Group {
 public:
  Group(std::span<const Kernel* const> kernels, const Instant& now) : kernels_(kernels), now_(&now) {}

  void run_block(const Block& block, std::array<double, most_kernels>& seconds) {
    const bool timed = block.begin / block_size % timed_block == 0;
    Clock::time_point before;
    if (timed) before = Clock::now();
    for (std::size_t k = 0; k < kernels_.size(); ++k) {
      const std::size_t bad = kernels_[k]->block(*now_, block);
      if (timed) seconds[k] += seconds_since(before);
      if (bad == none_bad) continue;
      bad_[k].report(bad);
      break;
    }
  }

  std::optional<std::size_t> bad(std::size_t k) const { return bad_[k].found(); }

 private:
  std::span<const Kernel* const> kernels_;
  const Instant* now_;
  std::array<FirstBad, most_kernels> bad_;
};

/// to += from, which is zero afterwards.
template <int Dim>
void move_nodes(double* to, double* from, const NodeBox<Dim>& nodes, const GridGeometry<Dim>& grid,
                std::size_t stride) {
  for_lines<Dim>(nodes, grid.count, [&](std::size_t line) {
    const std::size_t start = line * static_cast<std::size_t>(grid.count[0]);
    const std::size_t begin = (start + static_cast<std::size_t>(nodes.first[0])) * stride;
    const std::size_t end = (start + static_cast<std::size_t>(nodes.end[0])) * stride;
    for (std::size_t c = begin; c < end; ++c) to[c] += from[c];
    std::fill(from + begin, from + end, 0.0);
  });
}

Block block_at(std::size_t b, std::size_t particles, double* inertia, double* force) {
  return {b * block_size, std::min(particles, (b + 1) * block_size), inertia, force};
}

template <int Dim>
void run_blocks(State<Dim>& s, Group& group, bool scatters, std::array<double, most_kernels>& seconds) {
  std::mutex adding;
  if (scatters) {
    for_tiles(s, s.inertia.data(), s.force.data(), [&](std::size_t first, std::size_t end, double* m, double* f) {
      std::array<double, most_kernels> mine{};
      for (std::size_t b = first; b < end; ++b) group.run_block(block_at(b, s.particles, m, f), mine);
      const std::lock_guard lock(adding);
      for (std::size_t k = 0; k < most_kernels; ++k) seconds[k] += mine[k];
    });
    return;
  }
  for_blocks(s.particles, s.setup.threads, [&](std::size_t begin, std::size_t end) {
    std::array<double, most_kernels> mine{};
    group.run_block({begin, end, nullptr, nullptr}, mine);
    if (begin / block_size % timed_block != 0) return;
    const std::lock_guard lock(adding);
    for (std::size_t k = 0; k < most_kernels; ++k) seconds[k] += mine[k];
  });
}

/// Kernels with blocks, together.
template <int Dim>
void run_group(State<Dim>& s, std::span<const Kernel* const> kernels, const Instant& now, std::span<double> seconds) {
  auto before = Clock::now();
  bool scatters = false;
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    if (kernels[k]->begin) kernels[k]->begin(now);
    scatters = scatters || kernels[k]->scatters;
    seconds[k] += seconds_since(before);
  }
  Group group(kernels, now);
  std::array<double, most_kernels> sampled{};
  run_blocks(s, group, scatters, sampled);
  double sum = 0;
  for (const double part : sampled) sum += part;
  const double all = seconds_since(before);
  for (std::size_t k = 0; k < kernels.size(); ++k) seconds[k] += sum > 0 ? all * sampled[k] / sum : 0;
  for (std::size_t k = 0; k < kernels.size() && !s.finding; ++k) {
    if (kernels[k]->end) kernels[k]->end(now, group.bad(k));
    seconds[k] += seconds_since(before);
  }
}

}  // namespace

template <int Dim>
void for_tiles(State<Dim>& s, double* inertia, double* force, const TileBody& body) {
  const std::size_t tiles = tiles_of(s.particles), blocks = blocks_of(s.particles);
  const auto run_tile = [&](std::size_t k, double* m, double* f) {
    body(k * blocks / tiles, (k + 1) * blocks / tiles, m, f);
  };
  if (tiles == 1) {
    run_tile(0, inertia, force);
    return;
  }
  const auto add_up = [&](std::size_t k, TileCopy<Dim>& copy) {
    NodeBox<Dim> nodes;
    for (std::size_t b = k * blocks / tiles; b < (k + 1) * blocks / tiles; ++b) nodes.include(s.reach[b]);
    if (inertia) move_nodes<Dim>(inertia, copy.inertia.data(), nodes, s.setup.grid, GridField<Dim + 1>::stride);
    if (force) move_nodes<Dim>(force, copy.force.data(), nodes, s.setup.grid, GridField<Dim>::stride);
  };
  std::atomic<std::uint32_t> next{0}, added{0};  // tiles
  with_crew(static_cast<int>(s.tile_copies.size()), [&](int member) {
    TileCopy<Dim>& copy = s.tile_copies[static_cast<std::size_t>(member)];
    for (std::uint32_t k = next++; k < tiles; k = next++) {
      if (k == 0) {
        run_tile(0, inertia, force);
      } else {
        run_tile(k, copy.inertia.data(), copy.force.data());
      }
      await(added, k);  // in their order
      if (k > 0) add_up(k, copy);
      added.store(k + 1, std::memory_order_release);
      added.notify_all();
    }
  });
}

template <int Dim>
void run(State<Dim>& s, std::span<const Kernel* const> kernels, const Instant& now, std::span<double> seconds) {
  for (std::size_t k = 0; k < kernels.size() && !s.finding;) {
    std::size_t end = k;
    while (end < kernels.size() && end - k < most_kernels && kernels[end]->block) ++end;
    if (end > k) {
      run_group(s, kernels.subspan(k, end - k), now, seconds.subspan(k, end - k));
      k = end;
    } else {
      auto before = Clock::now();
      kernels[k]->begin(now);
      seconds[k++] += seconds_since(before);
    }
  }
}

template <int Dim>
void run(State<Dim>& s, const Kernel& kernel, const Instant& now) {
  const Kernel* one = &kernel;
  double seconds = 0;
  run(s, std::span(&one, 1), now, std::span(&seconds, 1));
}

template void for_tiles(State<ASSAY_DIMENSION>&, double*, double*, const TileBody&);
template void run(State<ASSAY_DIMENSION>&, std::span<const Kernel* const>, const Instant&, std::span<double>);
template void run(State<ASSAY_DIMENSION>&, const Kernel&, const Instant&);

}  // namespace assay::mpm
