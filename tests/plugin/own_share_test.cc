#include "plugin/own_share.h"

#include <gtest/gtest.h>

namespace softsoil {
namespace {

const WrenchRow kShare = {1, 2, 3, 4, 5, 6};
const WrenchRow kPush = {10, 0, -10, 0, 0, 20};

void ExpectRow(const double* row, const WrenchRow& host, const WrenchRow& share) {
  for (int k = 0; k < 6; ++k) EXPECT_EQ(row[k], host[k] + share[k]) << k;
}

struct Body {
  double row[6] = {};
  OwnShare own;
};

TEST(OwnShare, DoesNotGrowInAHostThatNeverClears) {
  Body body;
  for (int step = 0; step < 1000; ++step) body.own.Write(kShare, body.row);
  ExpectRow(body.row, {}, kShare);
}

TEST(OwnShare, IsCompleteInAHostThatClears) {
  Body body;
  for (int step = 0; step < 3; ++step) {
    for (double& value : body.row) value = 0;
    body.own.Write(kShare, body.row);
    ExpectRow(body.row, {}, kShare);
  }
}

TEST(OwnShare, AddsToAPerturbationThatIsWrittenEveryStep) {
  Body body;
  for (int step = 0; step < 3; ++step) {
    for (int k = 0; k < 6; ++k) body.row[k] = kPush[k];
    body.own.Write(kShare, body.row);
    ExpectRow(body.row, kPush, kShare);
  }
}

TEST(OwnShare, AddsToAPerturbationThatIsAddedAfterClearing) {
  Body body;
  for (int step = 0; step < 3; ++step) {
    for (double& value : body.row) value = 0;
    for (int k = 0; k < 6; ++k) body.row[k] += kPush[k];
    body.own.Write(kShare, body.row);
    ExpectRow(body.row, kPush, kShare);
  }
}

TEST(OwnShare, KeepsAPerturbationThatWasWrittenOnce) {
  Body body;
  for (int k = 0; k < 6; ++k) body.row[k] = kPush[k];
  for (int step = 0; step < 1000; ++step) body.own.Write(kShare, body.row);
  ExpectRow(body.row, kPush, kShare);
}

TEST(OwnShare, SurvivesAHostThatWritesOneComponentOnly) {
  Body body;
  for (int step = 0; step < 3; ++step) {
    body.own.Write(kShare, body.row);
    body.row[0] = 7;
  }
  body.own.Write(kShare, body.row);
  ExpectRow(body.row, {7, 0, 0, 0, 0, 0}, kShare);
}

TEST(OwnShare, LeavesWhatTheHostWroteWhenItIsRemoved) {
  Body body;
  for (int k = 0; k < 6; ++k) body.row[k] = kPush[k];
  body.own.Write(kShare, body.row);
  body.own.Remove(body.row);
  ExpectRow(body.row, kPush, {});
}

}  // namespace
}  // namespace softsoil
