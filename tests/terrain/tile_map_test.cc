#include "terrain/tile_map.h"

#include <gmock/gmock.h>

#include <memory>
#include <vector>

#include "tests/terrain/written_bytes.h"

namespace softsoil {
namespace {

using testing::ElementsAre;

struct Tile {
  int value = 0;
};
using Map = TileMap<Tile>;

Tile& Touch(Map& map, TileIndex index) {
  return map.Touch(index, [] { return Tile{}; });
}

std::vector<int> Values(const Map& map) {
  std::vector<int> values;
  map.ForEach([&](TileIndex, const Tile& tile) { values.push_back(tile.value); });
  return values;
}

TEST(Cow, IsCopiedByItsFirstWriterAlone) {
  Cow<int> a = Cow<int>::Make(1);
  const Cow<int> b = a;
  EXPECT_EQ(a.get(), b.get());
  EXPECT_TRUE(a.IsShared());
  a.Own() = 2;
  EXPECT_EQ(*b, 1);
  EXPECT_FALSE(a.IsShared());
  EXPECT_FALSE(b.IsShared());
  const int* place = a.get();
  a.Own() = 3;
  EXPECT_EQ(a.get(), place) << "what is its own it need not copy";
}

TEST(Cow, GivesBackItsValueWithItsLastOwner) {
  const auto value = std::make_shared<int>(7);
  {
    const auto a = Cow<std::shared_ptr<int>>::Make(value);
    Cow<std::shared_ptr<int>> b = a, c;
    c = b;
    b = {};
    EXPECT_EQ(value.use_count(), 2);
  }
  EXPECT_EQ(value.use_count(), 1);
}

TEST(TileMap, FindsWhatWasTouchedAndNothingElse) {
  Map map;
  for (const TileIndex index : {TileIndex{0, 0}, {-1, -1}, {-17, 40}, {15, 16}}) {
    EXPECT_EQ(map.Find(index), nullptr);
    Touch(map, index).value = index.i;
    ASSERT_NE(map.Find(index), nullptr);
    EXPECT_EQ(map.Find(index)->value, index.i);
  }
  EXPECT_EQ(map.size(), 4u);
  EXPECT_EQ(map.Find({-1, 0}), nullptr);
}

TEST(TileMap, IsVisitedInAnOrderThatDoesNotDependOnHowItWasMade) {
  const std::vector<TileIndex> indices = {{3, 1}, {-20, 5}, {3, -40}, {0, 0}, {17, 17}};
  Map forward, backward;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    Touch(forward, indices[i]).value = static_cast<int>(i);
    const std::size_t j = indices.size() - 1 - i;
    Touch(backward, indices[j]).value = static_cast<int>(j);
  }
  EXPECT_EQ(Values(forward), Values(backward));
}

TEST(TileMap, SharesTilesWithCopiesUntilOneWrites) {
  Map a;
  Touch(a, {0, 0}).value = 1;
  Touch(a, {0, 1}).value = 2;
  Map b = a;
  EXPECT_EQ(a.Find({0, 0}), b.Find({0, 0}));
  Touch(b, {0, 0}).value = 3;
  EXPECT_THAT(Values(a), ElementsAre(1, 2));
  EXPECT_THAT(Values(b), ElementsAre(3, 2));
  EXPECT_EQ(a.Find({0, 1}), b.Find({0, 1})) << "this one nobody has written to";
  Touch(a, {5, 5});
  EXPECT_EQ(b.Find({5, 5}), nullptr);
  EXPECT_EQ(a.copied(), 0u);
  EXPECT_EQ(b.copied(), 1u);
}

TEST(TileMap, KeepsTilesWhereTheyAreWhileItIsNotCopied) {
  Map map;
  const Tile* first = &Touch(map, {0, 0});
  for (int i = 1; i < 500; ++i) Touch(map, {i, i});
  EXPECT_EQ(&Touch(map, {0, 0}), first);
}

TEST(TileMap, IsReadAsItWasWritten) {
  Map map;
  for (const TileIndex index : {TileIndex{3, 1}, {-20, 5}, {3, -40}}) {
    Touch(map, index).value = 100 * index.i + index.j;
  }
  const std::vector<unsigned char> bytes = WrittenBytes([&](StateWriter& writer) {
    map.Write(writer, [](StateWriter& to, const Tile& tile) { to.Put(tile.value); });
  });

  const auto read = [&](std::size_t count) {
    Map copy;
    StateReader reader(bytes.data(), count);
    copy.Read(
        reader, sizeof(int), [](TileIndex) { return Tile{}; },
        [](StateReader& from, Tile& tile) { tile.value = from.Get<int>(); });
    return copy;
  };
  EXPECT_EQ(Values(read(bytes.size())), Values(map));
  for (std::size_t count = 0; count < bytes.size(); ++count) {
    EXPECT_THROW(read(count), std::runtime_error) << count;
  }
}

}  // namespace
}  // namespace softsoil
