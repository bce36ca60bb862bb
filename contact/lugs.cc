#include "contact/lugs.h"

#include <algorithm>
#include <cmath>

#include "terrain/constants.h"

namespace softsoil {
namespace {

constexpr double kAgreement = 0.02;  // [-]  of void shares that say the same
constexpr double kThinnest = 0.001;  // [m]  lug and gap

double Fraction(double x) { return x - std::floor(x); }

double PitchAngle(const Lugs& lugs) { return 2 * kPi / lugs.count; }

void RequireTwo(const XmlEntry& entry, bool pitched, bool width, bool void_share) {
  if (entry.Has("lugs", "pitch") && entry.Has("lugs", "count")) {
    entry.Refuse("<lugs> must have a pitch or a count, not both");
  }
  if (pitched + width + void_share < 2) {
    entry.Refuse("<lugs> must have two of: width, void_share, and pitch or count");
  }
}

}  // namespace

bool operator==(const Lugs& a, const Lugs& b) {
  return a.height == b.height && a.count == b.count && a.angle == b.angle &&
         a.void_share == b.void_share && a.stagger == b.stagger;
}

double LugLead(const Lugs& lugs, double radius, double y) {
  const double lead = std::abs(y) * std::tan(lugs.angle) / radius;
  return y > 0 ? lead + lugs.stagger * PitchAngle(lugs) : lead;
}

bool IsLug(const Lugs& lugs, double radius, double theta, double y) {
  return Fraction((theta - LugLead(lugs, radius, y)) / PitchAngle(lugs)) < 1 - lugs.void_share;
}

double LugWidth(const Lugs& lugs, double radius) {
  return PitchAngle(lugs) * radius * (1 - lugs.void_share) * std::cos(lugs.angle);
}

double LugGap(const Lugs& lugs, double radius) {
  return PitchAngle(lugs) * radius * lugs.void_share;
}

Lugs ReadLugs(XmlEntry& entry, double radius, double least_radius) {
  Lugs lugs;
  if (!entry.Has("lugs")) return lugs;
  const auto has = [&](const char* name) { return entry.Has("lugs", name); };
  const auto number = [&](const char* name, const char* unit, Range range) {
    return entry.Number("lugs", name, unit, range);
  };
  lugs.height = number("height", "m", Range::kPositive);
  if (lugs.height >= least_radius) {
    entry.Refuse("height of the lugs must be < " + Shown(least_radius) +
                 " m, the radius at the edge of the tread, got " + Shown(lugs.height));
  }
  if (has("angle_deg")) lugs.angle = number("angle_deg", "deg", Range::kUpTo90Degrees) / kDegrees;
  if (has("stagger")) lugs.stagger = number("stagger", "", Range::kUpToOne);

  const bool pitched = has("pitch") || has("count");
  RequireTwo(entry, pitched, has("width"), has("void_share"));
  const double circumference = 2 * kPi * radius;
  const double along =  // [m]  a lug's extent along the circumference
      has("width") ? number("width", "m", Range::kPositive) / std::cos(lugs.angle) : 0;
  if (has("void_share")) {
    lugs.void_share = number("void_share", "", Range::kUpToOne);
    if (lugs.void_share <= 0 || lugs.void_share >= 1) {
      entry.Refuse("void_share must be > 0 and < 1, got " + Shown(lugs.void_share));
    }
  }
  double pitch = along / (1 - lugs.void_share);
  if (has("pitch")) pitch = number("pitch", "m", Range::kPositive);
  if (has("count")) {
    const double count = number("count", "", Range::kPositive);
    if (count != std::round(count))
      entry.Refuse("count must be a whole number, got " + Shown(count));
    pitch = circumference / count;
  }
  if (along >= pitch) {
    entry.Refuse("width / cos(angle) of a lug must be < the pitch, " + Shown(pitch) + " m, got " +
                 Shown(along));
  }
  if (pitch > circumference) {
    entry.Refuse("pitch must be <= the circumference, " + Shown(circumference) + " m, got " +
                 Shown(pitch));
  }
  if (has("width") && pitched) {
    const double from_width = 1 - along / pitch;
    if (has("void_share") && std::abs(lugs.void_share - from_width) > kAgreement) {
      entry.Refuse("void_share must be 1 - width / (cos(angle) pitch) = " + Shown(from_width) +
                   ", got " + Shown(lugs.void_share));
    }
    if (!has("void_share")) lugs.void_share = from_width;
  }
  lugs.count = static_cast<int>(std::lround(circumference / pitch));
  const double thinner = std::min(lugs.void_share, 1 - lugs.void_share) * pitch;
  if (thinner < kThinnest) {
    entry.Refuse("lugs and gaps must be >= 0.001 m along the circumference, got " + Shown(thinner));
  }
  return lugs;
}

double SideStress(double pressure, double height, double width) {
  return pressure / kPi * std::atan2(width, height);
}

}  // namespace softsoil
