#include "terrain/state_stream.h"

#include <gmock/gmock.h>

#include <limits>
#include <set>
#include <string>
#include <vector>

#include "terrain/input_error.h"
#include "tests/terrain/written_bytes.h"

namespace softsoil {
namespace {

using testing::ElementsAre;
using testing::ThrowsMessage;

TEST(StateStream, IsReadAsItWasWritten) {
  const std::vector<double> numbers = {1, -0.0, 1e300};
  const auto bytes = WrittenBytes([&](StateWriter& to) {
    to.Put(std::uint32_t{7});
    to.PutAll(numbers);
    to.PutText("loam");
    to.Put(true);
    to.Put(0.25);
  });
  StateReader from(bytes.data(), bytes.size());
  EXPECT_EQ(from.Get<std::uint32_t>(), 7u);
  EXPECT_EQ(from.GetAll<double>(), numbers);
  EXPECT_EQ(from.GetText(), "loam");
  EXPECT_TRUE(from.GetFlag());
  EXPECT_EQ(from.GetFinite(), 0.25);
  EXPECT_EQ(from.left(), 0u);
}

TEST(StateStream, RefusesWhatIsNotThere) {
  const auto bytes = WrittenBytes([](StateWriter& to) { to.Put(~std::uint64_t{0}); });
  const auto reader = [&] { return StateReader(bytes.data(), bytes.size()); };
  const auto damaged = [](const char* what) {
    return ThrowsMessage<InputError>("the state is damaged: " + std::string(what) +
                                     " is not valid");
  };
  EXPECT_THAT([&] { reader().GetAll<double>(); }, damaged("its length"));
  EXPECT_THAT([&] { reader().GetText(); }, damaged("its length"));
  EXPECT_THAT([&] { reader().GetFinite(); }, damaged("a number")) << "all bits set: not a number";
  EXPECT_THAT([&] { reader().GetFlag(); }, damaged("a flag"));
}

// Of the numbers 1 to `count`, put in pieces of `piece` bytes.
std::uint64_t HashInPieces(int count, std::size_t piece) {
  std::vector<int> numbers;
  for (int i = 1; i <= count; ++i) numbers.push_back(i);
  const auto* bytes = reinterpret_cast<const unsigned char*>(numbers.data());
  const std::size_t size = numbers.size() * sizeof(int);
  StateWriter writer;
  for (std::size_t at = 0; at < size; at += piece) {
    writer.PutBytes(bytes + at, std::min(piece, size - at));
  }
  return writer.Finish();
}

TEST(StateStream, HasTheSameHashHoweverItIsCutIntoPieces) {
  for (const int count : {1, 3, 1000, 40001}) {
    const std::uint64_t whole = HashInPieces(count, 1 << 30);
    for (const std::size_t piece : {1, 3, 8, 4096}) EXPECT_EQ(HashInPieces(count, piece), whole);
  }
}

TEST(StateStream, HasAnotherHashIfAnyBitDiffers) {
  std::vector<unsigned char> bytes(100, 0);
  std::set<std::uint64_t> hashes;
  const auto enter = [&] {
    StateWriter writer;
    writer.PutBytes(bytes.data(), bytes.size());
    return hashes.insert(writer.Finish()).second;
  };
  EXPECT_TRUE(enter());
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] ^= 1u << bit % 8;
    EXPECT_TRUE(enter()) << bit;
    bytes[bit / 8] ^= 1u << bit % 8;
  }
  for (int more = 0; more < 20; ++more) {
    bytes.push_back(0);
    EXPECT_TRUE(enter()) << "zeros count too";
  }
}

}  // namespace
}  // namespace softsoil
