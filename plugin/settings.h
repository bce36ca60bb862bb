// What a model, or the program that links the library, chooses.
//
// In MJCF, for example:
//   <custom>
//     <text name="softsoil_soil" data="tilled_yolo_loam"/>
//     <numeric name="softsoil_clock" data="0.005"/>
//     <tuple name="softsoil_wheels"> <element objtype="body" objname="left"/> </tuple>
//   </custom>
// In the C API the same without the prefix: "soil=tilled_yolo_loam clock=0.005 wheels=left,right".
#pragma once

#include <mujoco/mujoco.h>

#include <map>
#include <string>
#include <vector>

#include "terrain/ground.h"
#include "terrain/limits.h"
#include "terrain/nurbs_bumps.h"

namespace softsoil {

constexpr char kAutoTire[] = "auto";  // made from the wheel's geom

struct TireNames {
  std::string of_all = kAutoTire;
  std::map<std::string, std::string> of_body;  // exceptions by name of the body
};

struct RegionNames {
  std::string site, soil;
};

constexpr Limits kHistoryLimits = {0, 1e6};  // [MB]
constexpr double kMegabyte = 1e6;            // [bytes]

struct Settings {
  std::string soil;                  // name in the catalogue; empty: the model wants no soil
  std::vector<RegionNames> regions;  // of other soils, later ones on earlier ones
  std::string ground;                // name of the plane geom; empty: the only one there is
  NurbsBumps bumps;                  // on that plane
  TireNames tires;
  std::vector<std::string> wheels;                  // names of bodies; empty: find them
  std::vector<std::string> shapes;                  // names of geoms that press with their surface
  std::vector<std::string> soil_files, tire_files;  // catalogues besides ours
  bool remove_rigid_contact = false;                // else warn of it
  GroundSettings terrain;
  double history = 100;  // [MB]  past states of the soil that marks in userdata name; 0: no marks
};

struct SettingValue {
  std::string text;
  double number = 0;
  std::vector<std::string> names;
};

// One key. The same table reads models and strings and documents the keys.
enum class SettingKind { kText, kNumber, kWholeNumber, kBodies };
struct Setting {
  const char* name;      // in a model: softsoil_<name>
  SettingKind kind;      // <text>, <numeric>, <numeric>, <tuple>
  Limits limits;         // of numbers
  const char* unit;      // of numbers
  const char* fallback;  // in words
  const char* meaning;
  void (*set)(Settings& settings, const SettingValue& value);
};
const std::vector<Setting>& SettingTable();

// Settings of a model. Throws InputError for an unknown key, a wrong kind or value.
Settings SettingsOf(const mjModel* m);

// Overrides `settings` by those in a text: KEY=VALUE, separated by spaces or semicolons; lists are
// separated by commas. Throws InputError.
void Override(const std::string& text, Settings* settings);

}  // namespace softsoil
