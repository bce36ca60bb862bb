#include "plugin/cli/number_range.h"

#include <gmock/gmock.h>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

using testing::ElementsAre;
using testing::ThrowsMessage;

void ExpectRefused(const std::string& text, const std::string& rule) {
  EXPECT_THAT([&] { NumbersIn("--slip", text); }, ThrowsMessage<InputError>("--slip: " + rule))
      << text;
}

TEST(NumbersIn, AreOneOrAList) {
  EXPECT_THAT(NumbersIn("--slip", "0.2"), ElementsAre(0.2));
  EXPECT_THAT(NumbersIn("--slip", "-3e-2"), ElementsAre(-0.03));
  EXPECT_THAT(NumbersIn("--slip", "0.3,0.05,2"), ElementsAre(0.3, 0.05, 2));
}

TEST(NumbersIn, AreARangeWithBothEnds) {
  EXPECT_THAT(NumbersIn("--slip", "0.1:0.7:0.2"), ElementsAre(0.1, 0.3, 0.5, 0.7));
  EXPECT_THAT(NumbersIn("--slip", "-0.1:0.1:0.1"), ElementsAre(-0.1, 0, 0.1));
  EXPECT_THAT(NumbersIn("--slip", "0.4:0.4:1"), ElementsAre(0.4));
}

TEST(NumbersIn, EndBelowALastNumberThatNoStepLeadsTo) {
  EXPECT_THAT(NumbersIn("--slip", "0.1:0.45:0.2"), ElementsAre(0.1, 0.3));
}

// 0.1 + 2 * 0.1 is 0.30000000000000004 in binary.
TEST(NumbersIn, AreTheDoublesThatOneWouldWrite) {
  const std::vector<double> numbers = NumbersIn("--slip", "0:1:0.01");
  ASSERT_EQ(numbers.size(), 101u);
  for (int k = 0; k <= 100; ++k) EXPECT_EQ(numbers[k], k / 100.0);
}

TEST(NumbersIn, MixRangesAndNumbers) {
  EXPECT_THAT(NumbersIn("--slip", "0.01,0.1:0.3:0.1,0.5"), ElementsAre(0.01, 0.1, 0.2, 0.3, 0.5));
}

TEST(NumbersIn, RefuseWhatIsNoNumber) {
  const std::string rule = "must be numbers as in 0.2 or 0.05,0.1,0.3, or first:last:step, got ";
  for (const std::string word : {"", "forty", "0.1x", " 0.1", "nan", "inf", "1e999"}) {
    ExpectRefused(word, rule + '"' + word + '"');
    ExpectRefused("0.1," + word, rule + '"' + word + '"');
    ExpectRefused("0.1:" + word + ":0.1", rule + '"' + word + '"');
  }
  ExpectRefused("0.1,", rule + "\"\"");
}

TEST(NumbersIn, RefuseAMalformedRange) {
  ExpectRefused("0.1:0.7", "a range must be first:last:step, got \"0.1:0.7\"");
  ExpectRefused("0.1:0.7:0.1:0.1", "a range must be first:last:step, got \"0.1:0.7:0.1:0.1\"");
  ExpectRefused("0.1:0.7:0", "the step of a range must be > 0, got 0");
  ExpectRefused("0.7:0.1:-0.1", "the step of a range must be > 0, got -0.1");
  ExpectRefused("0.7:0.1:0.1", "a range must not end below its first number 0.7, got 0.1");
}

TEST(NumbersIn, RefuseMoreThanAnyoneMeans) {
  ExpectRefused("0:1:0.00001", "must be at most 10000 numbers, got 100001");
  ExpectRefused("0:1e300:1e-300", "must be at most 10000 numbers, got inf");
  ExpectRefused("1:6000:1,1:6000:1", "must be at most 10000 numbers, got 12000");
}

}  // namespace
}  // namespace softsoil
