#include "app/base/background.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

/// These tests run under the thread sanitizer too.

namespace {

using app::Background;

/// What a task throws when its disk is full.
class Full : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

void fill() { throw Full("the disk is full"); }

/// What the background throws; none: "".
template <class Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const Full& error) {
    return error.what();
  }
  return "";
}

TEST(Background, DoesTasksInTheirOrder) {
  for (const int threads : {1, 2}) {
    std::vector<int> done;
    std::vector<int> put;
    Background background(threads, 3);
    for (int i = 0; i < 1000; ++i) {
      put.push_back(i);
      background.put([&done, i] { done.push_back(i); });
    }
    background.finish();
    EXPECT_EQ(done, put) << threads;
  }
}

TEST(Background, WorksOnAThreadOfItsOwnIfThereMayBeTwo) {
  for (const int threads : {1, 2}) {
    std::thread::id worker;
    Background background(threads, 1);
    background.put([&worker] { worker = std::this_thread::get_id(); });
    background.finish();
    EXPECT_EQ(worker == std::this_thread::get_id(), threads == 1);
  }
}

TEST(Background, LetsTheCallerGoOnWhileATaskIsDone) {
  std::atomic<bool> gone_on = false;
  Background background(2, 1);
  background.put([&gone_on] { gone_on.wait(false); });
  gone_on = true;
  gone_on.notify_one();
  background.finish();
}

TEST(Background, LetsNoMoreTasksWaitThanItMay) {
  constexpr long kMost = 4;
  for (const int threads : {1, 2}) {
    const auto token = std::make_shared<int>();
    long most = 0;
    Background background(threads, kMost);
    for (int i = 0; i < 1000; ++i) {
      background.put([token] { std::this_thread::yield(); });
      most = std::max(most, token.use_count() - 1);
    }
    // Those that wait and the one that is done.
    EXPECT_LE(most, threads == 1 ? 0 : kMost + 1);
    background.finish();
    EXPECT_EQ(token.use_count(), 1);
  }
}

TEST(Background, CanBeFinishedAndGoOn) {
  for (const int threads : {1, 2}) {
    int done = 0;
    Background background(threads, 2);
    background.finish();
    for (int i = 1; i <= 100; ++i) {
      background.put([&done] { ++done; });
      background.finish();
      EXPECT_EQ(done, i);
    }
  }
}

TEST(Background, TellsAtTheNextPutThatATaskFailed) {
  for (const int threads : {1, 2}) {
    Background background(threads, 2);
    EXPECT_EQ(error_of([&] {
                background.put(fill);
                for (;;) background.put([] {});
              }),
              "the disk is full");
    EXPECT_EQ(error_of([&] { background.put([] {}); }), "the disk is full");
  }
}

TEST(Background, TellsAtTheFinishThatATaskFailed) {
  for (const int threads : {1, 2}) {
    Background background(threads, 2);
    EXPECT_EQ(error_of([&] {
                background.put(fill);
                background.finish();
              }),
              "the disk is full");
    EXPECT_EQ(error_of([&] { background.finish(); }), "the disk is full");
  }
}

TEST(Background, DoesNothingAfterATaskThatFailed) {
  for (const int threads : {1, 2}) {
    const auto token = std::make_shared<int>();
    int done = 0;
    {
      Background background(threads, 3);
      error_of([&] {
        background.put([&done] { ++done; });
        background.put(fill);
        for (int i = 0; i < 10; ++i) background.put([&done, token] { ++done; });
        background.finish();
      });
    }
    EXPECT_EQ(done, 1);
    EXPECT_EQ(token.use_count(), 1);
  }
}

TEST(Background, DoesWhatWaitsBeforeItGoes) {
  for (const int threads : {1, 2}) {
    int done = 0;
    {
      Background background(threads, 100);
      for (int i = 0; i < 100; ++i) background.put([&done] { ++done; });
    }
    EXPECT_EQ(done, 100);
  }
}

TEST(Background, KeepsAnErrorThatNobodyAsksForToItself) {
  int done = 0;
  {
    Background background(2, 3);
    background.put(fill);
  }
  {
    Background background(2, 3);
    background.put([&done] { ++done; });
  }
  EXPECT_EQ(done, 1);
}

}  // namespace
