#include "sensors_models/base/worker.h"

#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace drydock {
namespace {

TEST(Worker, WorksInOrderOnOneOtherThread) {
  std::vector<int> order;
  std::vector<std::thread::id> threads;
  {
    Worker worker;
    for (int i = 0; i < 20; ++i) {
      worker.Submit([&, i] {
        order.push_back(i);
        threads.push_back(std::this_thread::get_id());
      });
    }
  }  // Waits.
  ASSERT_EQ(order.size(), 20U);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(order[static_cast<std::size_t>(i)], i);
  for (const auto& id : threads) EXPECT_EQ(id, threads.front());
  EXPECT_NE(threads.front(), std::this_thread::get_id());
}

TEST(Worker, HandsErrorsOn) {
  Worker worker;
  EXPECT_THROW(worker.Run([] { throw std::runtime_error("no"); }), std::runtime_error);
  bool done = false;
  worker.Run([&] { done = true; });
  EXPECT_TRUE(done);
}

}  // namespace
}  // namespace drydock
