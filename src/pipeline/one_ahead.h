// SPDX-License-Identifier: BSD-3-Clause
// Two stages of a small machine's pipeline: the next item is made in a thread of its own while this one is
// worked on.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace armature {

// Makes the items 0, 1, ... count-1 in this order, never more than one ahead of those that were taken.
template <typename Item>
class OneAhead {
 public:
  OneAhead(size_t count, std::function<Item(size_t)> make)
      : thread_([this, count, make = std::move(make)] { Run(count, make); }) {}
  // Waits for the item that is being made; no further one is begun.
  ~OneAhead() {
    {
      const std::lock_guard lock(mutex_);
      stopped_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }
  OneAhead(const OneAhead&) = delete;
  OneAhead& operator=(const OneAhead&) = delete;

  // The next item, waited for; called at most `count` times. Throws what making it threw.
  Item Take() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return item_ || failure_; });
    if (failure_) std::rethrow_exception(failure_);
    Item item = std::move(*item_);
    item_.reset();
    lock.unlock();
    changed_.notify_all();
    return item;
  }

 private:
  void Run(size_t count, const std::function<Item(size_t)>& make) {
    try {
      for (size_t i = 0; i < count; ++i) {
        Item made = make(i);
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return !item_ || stopped_; });
        if (stopped_) return;
        item_ = std::move(made);
        lock.unlock();
        changed_.notify_all();
      }
    } catch (...) {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return !item_ || stopped_; });  // what came before is taken first
      failure_ = std::current_exception();
      lock.unlock();
      changed_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Item> item_;
  std::exception_ptr failure_;
  bool stopped_ = false;
  std::thread thread_;  // last: it uses the others
};

}  // namespace armature
