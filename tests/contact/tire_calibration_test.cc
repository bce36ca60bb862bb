// Calibration finds the tire that made the data.
#include "contact/tire_calibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact/flat_plate.h"
#include "terrain/input_error.h"
#include "tests/contact/samples.h"
#include "tests/contact/tire_tables.h"

namespace softsoil {
namespace {

constexpr double TireSpring::*kTerms[] = {&TireSpring::linear, &TireSpring::quadratic,
                                          &TireSpring::cubic, &TireSpring::root};
const TireShape kTorus{0.91, 0.661, 0.467};
const TireShape kCylinder{0.4699, INFINITY, 0.3175};

LoadDeflection TestOf(const TireShape& shape, const TireSpring& spring, int rows,
                      double deepest = 0.12) {
  LoadDeflection test;
  for (int i = 1; i <= rows; ++i) {
    const double z = deepest * i / rows;
    test.deflection.push_back(z);
    test.load.push_back(FlatPlateLoad(shape, spring, z));
  }
  return test;
}

LoadDeflection WithNoise(LoadDeflection test, double share, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, share);
  for (double& load : test.load) load *= 1 + noise(random);
  return test;
}

// The name of the best form at one pressure.
std::string BestOf(const LoadDeflection& test) {
  return SpringForms()[BestForm({FitSprings(kTorus, test)}, test.load.back())].name;
}

// A spring of each form, none of its terms negligible.
TireSpring Known(int form) {
  const TireSpring known[] = {{1.314e6, 0, 0, 0},
                              {7.433e5, 8.63e6, 0, 0},
                              {2.289e5, 0, 0, 2.889e5},
                              {0, 0, 0, 3.469e5},
                              {6.991e5, 7.445e6, 7.29e6, 0}};
  return known[form];
}

TEST(SpringForms, AreTheFiveOfTables6_1To6_3) {
  for (int form = 0; form < 5; ++form) {
    TireSpring allowed;
    for (auto term : SpringForms()[form].terms) allowed.*term = 1;
    for (auto term : kTerms) EXPECT_EQ(allowed.*term > 0, Known(form).*term > 0) << form;
  }
}

TEST(TireCalibration, RecoversAKnownSpringFromExactData) {
  for (const TireShape& shape : {kTorus, kCylinder}) {
    for (int form = 0; form < 5; ++form) {
      const SpringFit fit = FitSpring(SpringForms()[form], shape, TestOf(shape, Known(form), 12));
      for (auto term : kTerms) {
        EXPECT_NEAR(fit.spring.*term, Known(form).*term, 1e-6 * Known(form).*term) << form;
      }
      EXPECT_LT(fit.rms, 1e-3);
      EXPECT_NEAR(fit.r_squared, 1, 1e-9);
    }
  }
}

// One term from a dozen rows.
TEST(TireCalibration, FindsASpringOfOneTermThroughNoiseOfTwoPercent) {
  for (int form : {0, 3}) {
    const LoadDeflection exact = TestOf(kTorus, Known(form), 12);
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const SpringFit fit = FitSpring(SpringForms()[form], kTorus, WithNoise(exact, 0.02, seed));
      for (auto term : SpringForms()[form].terms) {
        EXPECT_NEAR(fit.spring.*term, Known(form).*term, 0.05 * Known(form).*term) << seed;
      }
    }
  }
}

// Two terms trade with each other: it takes the rows of a recorder to tell them apart.
TEST(TireCalibration, TellsTwoTermsApartInADenseRecord) {
  for (int form : {1, 2}) {
    const LoadDeflection exact = TestOf(kTorus, Known(form), 4000);
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const SpringFit fit = FitSpring(SpringForms()[form], kTorus, WithNoise(exact, 0.02, seed));
      for (auto term : SpringForms()[form].terms) {
        const double error = std::abs(fit.spring.*term - Known(form).*term);
        EXPECT_LT(error, 0.05 * Known(form).*term) << form << " " << seed;
        EXPECT_LT(error, 2 * fit.confidence.*term) << form << " " << seed;
      }
    }
  }
}

// A dozen rows do not: the interval is half of the term, and says so truly.
TEST(TireCalibration, TellsThatADozenRowsDoNotDetermineTwoTerms) {
  constexpr int kSamples = 100;
  const LoadDeflection exact = TestOf(kTorus, Known(2), 12);
  const double truth = Known(2).linear;
  double confidence = 0;
  int inside = 0;
  for (unsigned seed = 1; seed <= kSamples; ++seed) {
    const SpringFit fit = FitSpring(SpringForms()[2], kTorus, WithNoise(exact, 0.02, seed));
    confidence += fit.confidence.linear / kSamples;
    inside += std::abs(fit.spring.linear - truth) < fit.confidence.linear ? 1 : 0;
  }
  EXPECT_GT(confidence, 0.4 * truth);
  EXPECT_GT(inside, 0.85 * kSamples);
}

// What the terms carry together is found from a dozen rows in any case.
TEST(TireCalibration, FindsTheLoadThroughNoiseOfTwoPercent) {
  for (int form = 0; form < 5; ++form) {
    const LoadDeflection exact = TestOf(kTorus, Known(form), 12);
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const SpringFit fit = FitSpring(SpringForms()[form], kTorus, WithNoise(exact, 0.02, seed));
      for (double z : {0.06, 0.09, 0.12}) {
        const double load = FlatPlateLoad(kTorus, Known(form), z);
        EXPECT_NEAR(FlatPlateLoad(kTorus, fit.spring, z), load, 0.05 * load) << form << " " << seed;
      }
    }
  }
}

TEST(TireCalibration, StatesItsConfidence) {
  int inside = 0;
  constexpr int kSamples = 200;
  for (unsigned seed = 1; seed <= kSamples; ++seed) {
    LoadDeflection test = TestOf(kTorus, Known(3), 12);
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, 300);  // [N]
    for (double& load : test.load) load += noise(random);
    const SpringFit fit = FitSpring(SpringForms()[3], kTorus, test);
    inside += std::abs(fit.spring.root - Known(3).root) < fit.confidence.root ? 1 : 0;
  }
  EXPECT_GT(inside, 0.90 * kSamples);  // 95 % of them
  EXPECT_LT(inside, 0.99 * kSamples);
}

// The least error among springs without a negative term: no such neighbour is better.
TEST(TireCalibration, KeepsEveryTermFromBeingNegative) {
  const LoadDeflection rootlike = TestOf(kTorus, Known(3), 12);
  const auto squares = [&](const TireSpring& spring) {
    double sum = 0;
    for (std::size_t i = 0; i < rootlike.load.size(); ++i) {
      const double error = FlatPlateLoad(kTorus, spring, rootlike.deflection[i]) - rootlike.load[i];
      sum += error * error;
    }
    return sum;
  };
  for (const SpringForm& form : SpringForms()) {
    const SpringFit fit = FitSpring(form, kTorus, rootlike);
    const double least = squares(fit.spring);
    EXPECT_NEAR(std::sqrt(least / 12), fit.rms, 1e-6 + 1e-6 * fit.rms);
    for (auto term : form.terms) {
      EXPECT_GE(fit.spring.*term, 0) << form.name;
      for (double step : {1e3, -1e3}) {
        TireSpring neighbour = fit.spring;
        neighbour.*term += step;
        if (neighbour.*term < 0) continue;
        EXPECT_GE(squares(neighbour), least) << form.name;
      }
    }
  }
  // A stiffening polynomial bends the wrong way for a root: only its linear term is left.
  const SpringFit cubic = FitSpring(SpringForms()[4], kTorus, rootlike);
  EXPECT_EQ(cubic.terms, 1);
  EXPECT_EQ(cubic.spring.quadratic, 0);
  EXPECT_EQ(cubic.confidence.quadratic, 0);
}

TEST(TireCalibration, FindsTheFormThatMadeTheData) {
  for (int form = 0; form < 5; ++form) {
    const LoadDeflection test = TestOf(kTorus, Known(form), 12);
    EXPECT_EQ(BestOf(test), SpringForms()[form].name);
  }
}

// Only the linear spring has the same terms for a root and a stiffening tire.
TEST(TireCalibration, TakesOneFormForAllPressures) {
  const LoadDeflection soft = TestOf(kTorus, Known(3), 12), hard = TestOf(kTorus, Known(1), 12);
  const std::vector<std::vector<SpringFit>> fits = {FitSprings(kTorus, soft),
                                                    FitSprings(kTorus, hard)};
  EXPECT_FALSE(HasTheSameTerms(fits, 1));
  EXPECT_FALSE(HasTheSameTerms(fits, 2));
  EXPECT_TRUE(HasTheSameTerms(fits, 0) && HasTheSameTerms(fits, 3));
  const std::size_t best = BestForm(fits, soft.load.back());
  const std::size_t other = best == 0 ? 3 : 0;
  const auto squares = [&](std::size_t form) {
    return std::pow(fits[0][form].rms, 2) + std::pow(fits[1][form].rms, 2);
  };
  EXPECT_TRUE(HasTheSameTerms(fits, best));
  EXPECT_LT(squares(best), squares(other));
}

TEST(TireCalibration, PrefersFewerTermsAmongEquallyGoodFits) {
  const LoadDeflection test = WithNoise(TestOf(kTorus, Known(3), 40), 0.02, 7);
  const std::vector<SpringFit> fits = FitSprings(kTorus, test);
  EXPECT_LE(fits[2].rms, fits[3].rms);  // linear + root contains root
  EXPECT_GT(fits[2].rms, 0.97 * fits[3].rms);
  EXPECT_EQ(BestOf(test), "root");
}

// Of the simulation's own nodes, 2.5 cm apart.
TEST(TireCalibration, ReproducesItsDataInTheSimulatedTire) {
  const LoadDeflection test = TestOf(kTorus, {2e5, 0, 0, 3e5}, 12);
  Tire tire = AgriculturalTire();
  tire.spring = FitSpring(SpringForms()[2], kTorus, test).spring;
  for (double z : {0.05, 0.08, 0.12}) {
    const double load = FlatPlateLoad(kTorus, {2e5, 0, 0, 3e5}, z);
    EXPECT_NEAR(FlatPlateLoad(tire, z, 0.025) / load, 1, 0.02) << z;
  }
}

TEST(TireCalibration, NeedsARowForEachTerm) {
  const LoadDeflection test = TestOf(kTorus, Known(0), 2);
  EXPECT_NO_THROW(FitSpring(SpringForms()[1], kTorus, test));
  EXPECT_THROW(FitSpring(SpringForms()[4], kTorus, test), InputError);
}

// A linear cylinder nearly carries a z^(3/2) (Hertz): k = 1.5 F / z, A = 2 w sqrt(2 r z).
TEST(PlateStiffness, IsTheSlopeOfTheLoad) {
  const TireSpring spring{2.17e6, 0, 0, 0};
  const double z = 0.002, load = FlatPlateLoad(kCylinder, spring, z);
  const PlateStiffness s = StiffnessUnder(load, kCylinder, spring);
  EXPECT_NEAR(s.deflection / z, 1, 1e-9);
  EXPECT_NEAR(s.stiffness * z / load, 1.5, 0.01);
  EXPECT_NEAR(s.area / (0.635 * std::sqrt(2 * 0.4699 * z)), 1, 0.01);
  EXPECT_THROW(StiffnessUnder(1e9, kCylinder, spring), InputError);
}

TEST(EstimatedDamping, IsTheShareOfCriticalOverTheContact) {
  const PlateStiffness s{0.07, 3e5, 0.25};
  const double mass = 18e3 / 9.81;
  EXPECT_NEAR(EstimatedDamping(0.05, 18e3, s) * s.area, 2 * 0.05 * std::sqrt(s.stiffness * mass),
              1e-9);
}

}  // namespace
}  // namespace softsoil
