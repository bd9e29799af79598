// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_MACHINE_SERIAL_WRITER_H
#define CGAL_JET_FITTING_3_INTERNAL_MACHINE_SERIAL_WRITER_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/machine/parallel.h>

#include <chrono>
#include <cstddef>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// Takes blocks of results from all threads. One thread at a time writes those that wait. No lock is held meanwhile:
/// what is called to write may itself start parallel work.
template <class Block>
class Serial_writer
{
public:
  /// A block to be filled, with the storage of one that was written.
  Block empty_block()
  {
    const std::lock_guard<Spin_mutex> lock(m_mutex);
    if (m_written.empty()) return Block();
    Block block = std::move(m_written.back());
    m_written.pop_back();
    return block;
  }

  /// Writes this block and those that wait by write(block), or leaves them to the thread that is writing.
  /// \return false once a call of write has returned false; then nothing more is written
  template <class Write>
  bool operator()(Block&& block, const Write& write)
  {
    if (!enqueue(std::move(block))) return keeps_pace();
    try {
      Block next;
      while (dequeue(next)) finish(std::move(next), write(next));
    } catch (...) {
      stop();
      throw;
    }
    const std::lock_guard<Spin_mutex> lock(m_mutex);
    return m_goes_on;
  }

private:
  /// \return whether this thread has become the one that writes
  bool enqueue(Block&& block)
  {
    const std::lock_guard<Spin_mutex> lock(m_mutex);
    m_waiting.push_back(std::move(block));
    if (m_is_writing) return false;
    return m_is_writing = true;
  }

  /// \return false if there is nothing left to write: then this thread is no longer the one that writes
  bool dequeue(Block& block)
  {
    const std::lock_guard<Spin_mutex> lock(m_mutex);
    m_is_writing = m_goes_on && !m_waiting.empty();
    if (!m_is_writing) return false;
    block = std::move(m_waiting.front());
    m_waiting.pop_front();
    return true;
  }

  void finish(Block&& block, bool goes_on)
  {
    const std::lock_guard<Spin_mutex> lock(m_mutex);
    m_written.push_back(std::move(block));
    m_goes_on = m_goes_on && goes_on;
  }

  void stop()
  {
    const std::lock_guard<Spin_mutex> lock(m_mutex);
    m_goes_on = m_is_writing = false;
  }

  /// Waits where writing takes longer than estimating, so that results do not pile up. But not for ever: what the user
  /// does in writing may wait for this thread.
  bool keeps_pace()
  {
    using Clock = std::chrono::steady_clock;
    const std::size_t most_waiting = 64;
    for (const auto end = Clock::now() + std::chrono::milliseconds(100);; std::this_thread::yield()) {
      const bool is_late = Clock::now() > end;
      const std::lock_guard<Spin_mutex> lock(m_mutex);
      if (!m_goes_on || !m_is_writing || m_waiting.size() <= most_waiting || is_late) return m_goes_on;
    }
  }

  Spin_mutex m_mutex;
  std::deque<Block> m_waiting;
  std::vector<Block> m_written;
  bool m_is_writing = false, m_goes_on = true;
};

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_MACHINE_SERIAL_WRITER_H
