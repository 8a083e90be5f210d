#include "app/base/forked_call.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace {

using app::CallOutput;
using app::CallResult;
using End = app::CallResult::End;
using testing::HasSubstr;

constexpr app::CallLimits kLimits = {.memory = 1 << 28, .cpu_seconds = 30, .wall_seconds = 60};

CallResult called(const std::function<void(const CallOutput&)>& work) {
  return app::forked_call(work, kLimits);
}

void put(const CallOutput& output, const std::string& text) { output({text.data(), text.size()}); }

TEST(ForkedCall, HandsBackWhatTheFunctionWrote) {
  const std::string long_text(1'000'000, 'x');
  const CallResult result = called([&](const CallOutput& output) {
    put(output, std::string("a\0b", 3));
    put(output, long_text);
  });
  EXPECT_EQ(result.end, End::returned);
  EXPECT_EQ(result.bytes, std::string("a\0b", 3) + long_text);
}

TEST(ForkedCall, AFunctionThatWritesNothingReturnsNothing) {
  const CallResult result = called([](const CallOutput&) {});
  EXPECT_EQ(result.end, End::returned);
  EXPECT_EQ(result.bytes, "");
}

TEST(ForkedCall, ASignalIsNamedAndDoesNotReachTheCaller) {
  const std::pair<int, const char*> signals[] = {
      {SIGSEGV, "segmentation fault"}, {SIGABRT, "aborted"}, {SIGFPE, "floating point exception"}};
  for (const auto& [number, name] : signals) {
    const CallResult result = called([number = number](const CallOutput& output) {
      put(output, "half of");
      ::raise(number);
    });
    EXPECT_EQ(result.end, End::ended) << name;
    EXPECT_EQ(result.cause, name);
  }
}

TEST(ForkedCall, AnExitOrAnExceptionIsNoReturn) {
  EXPECT_EQ(called([](const CallOutput&) { ::_exit(0); }).end, End::ended);
  EXPECT_EQ(called([](const CallOutput&) { ::_exit(3); }).cause, "exit code 3");
  EXPECT_EQ(called([](const CallOutput&) { throw 1; }).cause, "aborted");
}

// With the address sanitizer a child hung here where it was forked while a thread began or
// allocated.
TEST(ForkedCall, MayAllocateWhileOtherThreadsDo) {
  for (int round = 0; round < 20; ++round) {
    const auto allocate = [] {
      for (int i = 0; i < 5'000; ++i) std::make_unique<std::string>(100, 'x')->push_back('y');
    };
    std::vector<std::thread> threads;
    for (int i = 0; i < 3; ++i) threads.emplace_back(allocate);
    app::CallLimits limits = kLimits;
    limits.wall_seconds = 20;
    const CallResult result = app::forked_call([&](const CallOutput&) { allocate(); }, limits);
    for (std::thread& thread : threads) thread.join();
    ASSERT_EQ(result.end, End::returned) << round;
  }
}

TEST(ForkedCall, ComputingAndWaitingTooLongEndIt) {
  const auto compute = [](const CallOutput&) {
    for (std::atomic<long> i = 0;;) ++i;
  };
  const auto wait = [](const CallOutput&) {
    while (true) ::pause();
  };
  app::CallLimits limits = kLimits;
  limits.cpu_seconds = 1;
  EXPECT_EQ(app::forked_call(compute, limits).end, End::too_slow);
  limits.wall_seconds = 0.1;
  EXPECT_EQ(app::forked_call(wait, limits).end, End::too_slow);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(ForkedCall, TooMuchMemoryEndsIt) {
  const CallResult result = called([](const CallOutput& output) {
    const std::vector<char> much(std::size_t{1} << 29, 'x');
    output(much);
  });
  EXPECT_EQ(result.end, End::out_of_memory);
}
#endif

TEST(ForkedCall, TheFunctionCanWriteNoFile) {
  const std::string file = testing::TempDir() + "forked_call_file";
  const CallResult result = called([&](const CallOutput&) {
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT, 0600);
    if (::write(descriptor, "x", 1) == 1) ::_exit(7);
  });
  std::filesystem::remove(file);
  EXPECT_THAT(result.cause, HasSubstr("file size limit exceeded"));
}

TEST(ForkedCall, TheFunctionSeesNoOpenFile) {
  const int descriptor = ::open("/dev/null", O_RDONLY);
  ASSERT_GE(descriptor, 3);
  const CallResult result = called([&](const CallOutput& output) {
    put(output, ::fcntl(descriptor, F_GETFD) < 0 ? "closed" : "open");
  });
  ::close(descriptor);
  EXPECT_EQ(result.bytes, "closed");
}

TEST(ForkedCall, SeveralThreadsCallAtOnce) {
  std::vector<std::string> results(8);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < results.size(); ++i)
    threads.emplace_back([&results, i] {
      const std::string own(100'000, static_cast<char>('a' + i));
      results[i] = called([&](const CallOutput& output) { put(output, own); }).bytes;
    });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < results.size(); ++i)
    EXPECT_EQ(results[i], std::string(100'000, static_cast<char>('a' + i)));
}

}  // namespace
