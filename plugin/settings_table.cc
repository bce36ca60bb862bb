#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "plugin/settings.h"
#include "plugin/words.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

using V = SettingValue;
constexpr SettingKind kText = SettingKind::kText, kNumber = SettingKind::kNumber,
                      kWholeNumber = SettingKind::kWholeNumber, kBodies = SettingKind::kBodies;
constexpr Limits kNoLimits = {};  // of what is no number
constexpr char kNone[] = "none";

// True for the second of two words, false for the first; throws for any other.
bool Choose(const std::string& text, const char* first, const char* second) {
  if (text == second) return true;
  if (text == first) return false;
  throw InputError("must be " + std::string(first) + " or " + second + ", got \"" + text + "\"");
}

StressBackend ParseStress(const std::string& text) {
  std::vector<std::string> names;
  for (const StressBackend backend : kStressBackends) {
    names.push_back(NameOf(backend));
    if (text == names.back()) return backend;
  }
  throw InputError("must be one of " + Listed(names) + ", got \"" + text + "\"");
}

// The entries of a list, at least one.
std::vector<std::string> Entries(const std::string& text) {
  std::vector<std::string> entries = Words(text, " \t\n,");
  if (entries.empty()) throw InputError("must name something, got \"" + text + "\"");
  return entries;
}

// Paths between commas; they may hold blanks.
std::vector<std::string> Files(const std::string& text) {
  std::vector<std::string> files;
  for (const std::string& part : Words(text, ",")) {
    const std::size_t first = part.find_first_not_of(" \t\n");
    if (first == std::string::npos) continue;
    files.push_back(part.substr(first, part.find_last_not_of(" \t\n") - first + 1));
  }
  if (files.empty()) throw InputError("must name something, got \"" + text + "\"");
  return files;
}

TireNames ParseTires(const std::string& text) {
  TireNames tires;
  bool for_all_given = false;
  for (const std::string& entry : Entries(text)) {
    const auto equals = entry.find('=');
    const std::string body = equals == std::string::npos ? "" : entry.substr(0, equals);
    const std::string name = equals == std::string::npos ? entry : entry.substr(equals + 1);
    const bool is_new = equals == std::string::npos
                            ? !std::exchange(for_all_given, true)
                            : !body.empty() && tires.of_body.emplace(body, name).second;
    if (!is_new || name.empty()) {
      throw InputError("must be one tire for all wheels, BODY=TIRE entries or both, got \"" + text +
                       "\"");
    }
    if (equals == std::string::npos) tires.of_all = name;
  }
  return tires;
}

// What `parse` makes of a text that is not kNone.
template <class Parse>
auto OrNone(const std::string& text, const Parse& parse) -> decltype(parse(text)) {
  if (text == kNone) return {};
  return parse(text);
}

std::vector<RegionNames> ParseRegions(const std::string& text) {
  std::vector<RegionNames> regions;
  if (text == kNone) return regions;
  std::set<std::string> sites;
  for (const std::string& entry : Entries(text)) {
    const auto equals = entry.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == entry.size()) {
      throw InputError("must be SITE=SOIL entries or none, got \"" + entry + "\"");
    }
    regions.push_back({entry.substr(0, equals), entry.substr(equals + 1)});
    if (sites.insert(regions.back().site).second) continue;
    throw InputError("must have one soil for each site, got two for \"" + regions.back().site +
                     "\"");
  }
  return regions;
}

// One number of a list.
double Within(Limits limits, const char* name, const std::string& unit, const std::string& number) {
  double value = 0;
  if (ParseNumber(number, &value) && Contains(limits, value)) return value;
  throw InputError(std::string(name) + " must be " + InWords(limits) + unit + ", got \"" + number +
                   "\"");
}

std::uint32_t ParseSeed(const std::string& text) {
  const double seed = Within(kBumpSeedLimits, "the seed", "", text);
  if (seed != std::floor(seed)) {
    throw InputError("the seed must be a whole number, got \"" + text + "\"");
  }
  return static_cast<std::uint32_t>(seed);
}

NurbsBumps ParseBumps(const std::string& text) {
  if (text == kNone) return NurbsBumps{};
  const std::vector<std::string> entries = Words(text, " \t\n,");
  const auto commas = static_cast<std::size_t>(std::count(text.begin(), text.end(), ','));
  if (commas + 1 != entries.size() || entries.size() < 2 || entries.size() > 3) {
    throw InputError("must be HEIGHT,SPACING or HEIGHT,SPACING,SEED or none, got \"" + text + "\"");
  }
  NurbsBumps bumps;
  bumps.height = Within(kBumpHeightLimits, "the height", " m", entries[0]);
  bumps.spacing = Within(kBumpSpacingLimits, "the spacing", " m", entries[1]);
  if (bumps.height > kSteepestBumps * bumps.spacing) {
    throw InputError("the height must be at most " + Shown(kSteepestBumps) +
                     " times the spacing, got \"" + text + "\"");
  }
  if (entries.size() == 3) bumps.seed = ParseSeed(entries[2]);
  return bumps;
}

}  // namespace

const std::vector<Setting>& SettingTable() {
  static const std::vector<Setting> table = {
      {"soil", kText, kNoLimits, "", "none: no soft soil", "soil by its name in the catalogue",
       [](Settings& s, const V& v) { s.soil = v.text; }},
      {"regions", kText, kNoLimits, "", kNone,
       "other soils as SITE=SOIL entries: in the part of the ground that the box of a site cuts "
       "out; later ones on earlier ones",
       [](Settings& s, const V& v) { s.regions = ParseRegions(v.text); }},
      {"tire", kText, kNoLimits, "", kAutoTire,
       "tire of all wheels by its name in the catalogue, FAMILY@PRESSURE, BODY=TIRE entries, or "
       "both; auto: a stiff tire of the geom's size",
       [](Settings& s, const V& v) { s.tires = ParseTires(v.text); }},
      {"ground", kText, kNoLimits, "", "the only plane of the world",
       "name of the plane geom that is the undisturbed ground",
       [](Settings& s, const V& v) { s.ground = v.text; }},
      {"bumps", kText, kNoLimits, "", kNone,
       "bumpy ground: HEIGHT,SPACING or HEIGHT,SPACING,SEED; most height [m] above and below the "
       "plane, along z, and distance [m] of the bumps",
       [](Settings& s, const V& v) { s.bumps = ParseBumps(v.text); }},
      {"wheels", kBodies, kNoLimits, "", "found by their geoms and hinges", "bodies with a tire",
       [](Settings& s, const V& v) { s.wheels = v.names; }},
      {"shapes", kText, kNoLimits, "", kNone,
       "geoms, meshes or boxes, that meet the soil with their own surface: in place of a wheel's "
       "tire, rigid unless that is named, or as plate, blade or belly",
       [](Settings& s, const V& v) { s.shapes = OrNone(v.text, &Entries); }},
      {"mode", kText, kNoLimits, "", "flow",
       "how the surface sinks: flow, or compaction alone as in the thesis",
       [](Settings& s, const V& v) {
         s.terrain.mode =
             Choose(v.text, "flow", "compaction") ? SurfaceMode::kCompaction : SurfaceMode::kFlow;
       }},
      {"rigid_contact", kText, kNoLimits, "", "warn",
       "what to do if wheels also touch the rigid plane: warn or remove",
       [](Settings& s, const V& v) { s.remove_rigid_contact = Choose(v.text, "warn", "remove"); }},
      {"soil_file", kText, kNoLimits, "", kNone, "XML files with more soils",
       [](Settings& s, const V& v) { s.soil_files = OrNone(v.text, &Files); }},
      {"tire_file", kText, kNoLimits, "", kNone, "XML files with more tires",
       [](Settings& s, const V& v) { s.tire_files = OrNone(v.text, &Files); }},
      {"grid_spacing", kNumber, kGridSpacingLimits, "m", "0.025", "spacing of the soil columns",
       [](Settings& s, const V& v) { s.terrain.grid_spacing = v.number; }},
      {"volume_height", kNumber, kVolumeHeightLimits, "m", "0.025", "height of a soil volume",
       [](Settings& s, const V& v) { s.terrain.volume_height = v.number; }},
      {"volumes", kWholeNumber, kVolumesLimits, "", "30", "soil volumes in a column",
       [](Settings& s, const V& v) { s.terrain.volumes = static_cast<int>(v.number); }},
      {"clock", kNumber, kSoilClockLimits, "s", "0.01", "simulated time between soil updates",
       [](Settings& s, const V& v) { s.terrain.soil_clock = v.number; }},
      {"sync",
       kWholeNumber,
       {0, 1},
       "",
       "0",
       "1: update the soil in place instead of in the background",
       [](Settings& s, const V& v) { s.terrain.sync = v.number == 1; }},
      {"threads", kWholeNumber, kThreadsLimits, "", "one per processor",
       "threads of the soil update; no influence on results",
       [](Settings& s, const V& v) { s.terrain.threads = static_cast<int>(v.number); }},
      {"stress", kText, kNoLimits, "", "direct",
       "stress in the soil: direct, every pair of a force and a volume; gaussian, sums of "
       "Gaussians, much faster and up to 1 % of the peak stress off; auto: gaussian where it is "
       "faster",
       [](Settings& s, const V& v) { s.terrain.stress = ParseStress(v.text); }},
      {"history", kNumber, kHistoryLimits, "MB", "100",
       "past states of the soil, for mjData that are copied or restored; needs room in "
       "userdata, nuserdata of 2 or more; 0: none",
       [](Settings& s, const V& v) { s.history = v.number; }},
  };
  return table;
}

}  // namespace softsoil
