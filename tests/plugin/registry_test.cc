#include "plugin/registry.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "tests/plugin/mjcf.h"

namespace softsoil {
namespace {

// Addresses as of mjData that follow one another in memory. Nothing is read there.
const mjData* Address(int i) {
  static const std::vector<mjData> memory(40);
  return &memory[i];
}

std::shared_ptr<SoilEntry> Entry(const std::string& name = "") {
  auto entry = std::make_shared<SoilEntry>();
  entry->lost_because = name;
  return entry;
}

// Name of the entry that is found; "none".
std::string NameAt(const mjData* d) {
  const std::shared_ptr<SoilEntry> entry = Registry::Get().Find(d);
  return entry == nullptr ? "none" : entry->lost_because;
}

void InAThread(const std::function<void()>& work) { std::thread(work).join(); }

class Registered : public testing::Test {
 protected:
  ~Registered() override {
    for (int i = 0; i < 40; ++i) Registry::Get().Erase(Address(i));
  }
  Registry& registry_ = Registry::Get();
};

TEST_F(Registered, IsFoundUntilErased) {
  EXPECT_EQ(NameAt(Address(0)), "none");
  registry_.Put(Address(0), Entry("a"));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(NameAt(Address(0)), "a");
  const std::shared_ptr<SoilEntry> erased = registry_.Erase(Address(0));
  ASSERT_NE(erased, nullptr);
  EXPECT_EQ(erased->lost_because, "a");
  for (int i = 0; i < 3; ++i) EXPECT_EQ(NameAt(Address(0)), "none") << "though it still lives";
  EXPECT_EQ(registry_.Erase(Address(0)), nullptr);
}

TEST_F(Registered, IsTheNewOneAtAnAddressThatIsUsedAgain) {
  for (const char* name : {"first", "second", "third"}) {
    registry_.Put(Address(0), Entry(name));
    EXPECT_EQ(NameAt(Address(0)), name);
    registry_.Erase(Address(0));
    EXPECT_EQ(NameAt(Address(0)), "none");
  }
}

TEST_F(Registered, IsReplacedAtOnce) {
  const std::shared_ptr<SoilEntry> old = Entry("old");
  registry_.Put(Address(0), old);
  EXPECT_EQ(NameAt(Address(0)), "old");
  registry_.Put(Address(0), Entry("new"));
  EXPECT_EQ(NameAt(Address(0)), "new");
}

TEST_F(Registered, DiesWhenErasedThoughThreadsFoundIt) {
  registry_.Put(Address(0), Entry());
  const std::weak_ptr<SoilEntry> entry = registry_.Find(Address(0));
  EXPECT_FALSE(entry.expired());
  registry_.Erase(Address(0));
  EXPECT_TRUE(entry.expired());
}

TEST_F(Registered, IsErasedAndReplacedFromAnotherThread) {
  registry_.Put(Address(0), Entry("mine"));
  EXPECT_EQ(NameAt(Address(0)), "mine");
  InAThread([&] { registry_.Erase(Address(0)); });
  EXPECT_EQ(NameAt(Address(0)), "none");
  InAThread([&] { registry_.Put(Address(0), Entry("theirs")); });
  EXPECT_EQ(NameAt(Address(0)), "theirs");
}

TEST_F(Registered, IsNotMistakenForAnother) {
  for (int i = 0; i < 40; ++i) registry_.Put(Address(i), Entry(std::to_string(i)));
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < 40; ++i) ASSERT_EQ(NameAt(Address(i)), std::to_string(i));
  }
}

// Each thread uses addresses of its own, again and again, while the others change the registry.
TEST_F(Registered, IsFoundByManyThreadsAtOnce) {
  std::atomic<int> wrong{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 500; ++i) {
        const mjData* d = Address(5 * t + i % 5);
        const std::string name = std::to_string(t) + "." + std::to_string(i);
        if (NameAt(d) != "none") ++wrong;
        registry_.Put(d, Entry(name));
        for (int k = 0; k < 5; ++k) wrong += NameAt(d) != name;
        registry_.Erase(d);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

// A host may step until the very end of the process, when this thread's memory is gone.
TEST(RegisteredDeathTest, IsFoundAndErasedAtTheEndOfTheProcess) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto exit_and_look = [] {
    Registry::Get().Put(Address(0), Entry("last"));
    if (NameAt(Address(0)) != "last") std::_Exit(1);
    std::atexit([] {
      const bool found = NameAt(Address(0)) == "last";
      Registry::Get().Erase(Address(0));
      std::_Exit(found && NameAt(Address(0)) == "none" ? 0 : 2);
    });
    std::exit(3);
  };
  EXPECT_EXIT(exit_and_look(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace softsoil
