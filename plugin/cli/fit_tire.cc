#include "plugin/cli/fit_tire.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "contact/tire_family.h"
#include "plugin/cli/catalogues.h"
#include "plugin/cli/entry_output.h"
#include "plugin/cli/fit_tire_entry.h"
#include "plugin/cli/fit_tire_table.h"
#include "plugin/cli/picture.h"
#include "plugin/cli/standard_output.h"
#include "plugin/settings.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

namespace fs = std::filesystem;

constexpr double kDampingRatio = 0.05;  // of critical, as the tires that come along

void RequireIn(Range range, const char* option, const char* unit, double value) {
  if (Contains(range, value)) return;
  throw InputError(std::string(option) + " must be " + InWords(range) + unit + ", got " +
                   Shown(value));
}

void CheckNumbers(const FitTireOptions& options) {
  RequireIn(Range::kTireSize, "--radius", " m", options.radius);
  RequireIn(Range::kTireSize, "--width", " m", options.width);
  if (options.crown_radius) {
    RequireIn(Range::kTireSize, "--crown-radius", " m", *options.crown_radius);
  }
  if (options.damping) RequireIn(Range::kNotNegative, "--damping", " Pa s/m", *options.damping);
  if (options.load) RequireIn(Range::kPositive, "--load", " N", *options.load);
  if (options.friction) RequireIn(Range::kPositive, "--friction", "", *options.friction);
  const int crowns = (options.crown_radius ? 1 : 0) + (options.contact_width.empty() ? 0 : 1) +
                     (options.cylinder ? 1 : 0);
  if (crowns != 1) {
    throw InputError("one of --crown-radius, --contact-width and --cylinder must be given, got " +
                     std::to_string(crowns));
  }
}

std::vector<std::string> TakenNames(const Catalogue<Tire>& tires) {
  std::vector<std::string> taken = {kAutoTire};
  for (const Tire& tire : tires.entries()) taken.push_back(tire.name);
  for (const TireFamily& family : TireFamilies(tires)) taken.push_back(family.name);
  return taken;
}

// What an entry needs beyond the data.
void CheckEntry(const FitTireOptions& options, const Catalogue<Tire>& tires) {
  if (!options.out) return;
  RequireEntryName(options.name, "tire", TakenNames(tires));
  if (!options.damping && !options.load) {
    throw InputError("--out needs --damping, or --load to estimate it");
  }
  if (!options.friction && options.like.empty()) {
    throw InputError("--out needs --friction, or --like a tire that it is taken from");
  }
}

std::size_t FormNamed(const std::string& name) {
  std::vector<std::string> known;
  for (std::size_t form = 0; form < SpringForms().size(); ++form) {
    known.emplace_back(SpringForms()[form].name);
    if (known.back() == name) return form;
  }
  throw InputError("--spring must be one of " + Listed(known) + ", got \"" + name + "\"");
}

void FitShape(const FitTireOptions& options, FittedTire* tire) {
  tire->shape = {options.radius, std::numeric_limits<double>::infinity(), options.width};
  if (options.crown_radius) tire->shape.crown_radius = *options.crown_radius;
  if (!options.contact_width.empty()) {
    const ContactWidths widths = ReadContactWidths(options.contact_width, options.radius);
    tire->crown =
        At(options.contact_width, [&] { return FitCrownRadius(widths.deflection, widths.width); });
    tire->shape.crown_radius = tire->crown->crown_radius;
  }
  const std::string fault = ShapeFault(tire->shape);
  if (!fault.empty()) throw InputError("the tire's " + fault);
}

void FitSpringsOf(const FitTireOptions& options, FittedTire* tire) {
  tire->tests = ReadLoadDeflection(options.data, options.radius);
  double largest = 0;
  for (const PressureTest& test : tire->tests) {
    tire->fits.push_back(At(options.data + ": " + PressureOf(test),
                            [&] { return FitSprings(tire->shape, test.rows); }));
    largest = std::max(largest, *std::max_element(test.rows.load.begin(), test.rows.load.end()));
  }
  tire->best = BestForm(tire->fits, largest);
  tire->chosen = options.spring.empty() ? tire->best : FormNamed(options.spring);
  if (!HasTheSameTerms(tire->fits, tire->chosen)) {
    throw InputError("--spring: the form " + options.spring +
                     " loses a term at one pressure and not at another, so no pressure between can "
                     "be interpolated");
  }
}

struct Friction {
  double coefficient;
  std::string source;
};

Friction FrictionOf(const FitTireOptions& options, const Catalogue<Tire>& tires) {
  if (options.friction) return {*options.friction, "given to softsoil fit-tire"};
  if (options.like.empty()) return {0, ""};
  return {At("--like", [&] { return FindTire(tires, options.like); }).soil_friction,
          "that of " + options.like};
}

// The damping of a tire and how it was found.
std::string SetDamping(const FitTireOptions& options, Tire* tire) {
  if (options.damping) {
    tire->damping = *options.damping;
    return "damping given to softsoil fit-tire";
  }
  const PlateStiffness s = StiffnessUnder(*options.load, tire->shape, tire->spring);
  tire->damping = std::round(EstimatedDamping(kDampingRatio, *options.load, s));
  char text[120];
  std::snprintf(text, sizeof text, "damping estimated: zeta %g, %g kN, k %.0f kN/m, A %.3f m^2",
                kDampingRatio, *options.load / 1e3, s.stiffness / 1e3, s.area);
  return text;
}

std::string FileName(const std::string& path) { return fs::path(path).filename(); }

std::string ShapeSource(const FitTireOptions& options, const FittedTire& fitted) {
  if (!fitted.crown) return "size given to softsoil fit-tire";
  const std::string source =
      "size given; crown radius fitted to " + FileName(options.contact_width);
  if (!std::isfinite(fitted.crown->plateau)) return source;
  return source + ", widths up to " + Rounded(fitted.crown->plateau, 4) + " m";
}

std::string EntriesOf(const FitTireOptions& options, const FittedTire& fitted,
                      const Friction& friction) {
  std::vector<Tire> tires;
  std::vector<TireSources> sources;
  const std::string data = FileName(options.data);
  for (std::size_t t = 0; t < fitted.tests.size(); ++t) {
    const PressureTest& test = fitted.tests[t];
    const SpringFit& fit = fitted.fits[t][fitted.chosen];
    Tire tire{};
    tire.name = tire.description = options.name;
    if (test.inflation_pressure > 0) {
      const std::string kilopascal = Shown(std::round(test.inflation_pressure) / 1e3);
      tire.family = options.name;
      tire.inflation_pressure = test.inflation_pressure;
      tire.name += "_" + kilopascal + "kPa";
      tire.description += ", " + kilopascal + " kPa";
    }
    tire.shape = fitted.shape;
    tire.spring = fit.spring;
    tire.soil_friction = friction.coefficient;
    const std::string damping = SetDamping(options, &tire);
    char error[80];
    std::snprintf(error, sizeof error, " rows, rms error %.3g N; ", fit.rms);
    tires.push_back(tire);
    sources.push_back(
        {ShapeSource(options, fitted),
         "fitted to " + data + ", " + std::to_string(test.rows.load.size()) + error + damping,
         friction.source, data});
  }
  return TireFileText(tires, sources);
}

// The catalogue with these entries: what a scene refuses is refused here.
void RequireReadable(Catalogue<Tire> tires, const std::string& entries, const std::string& file) {
  At("the entries must be such as a scene can use", [&] { tires.AddText(entries, file); });
}

}  // namespace

void FitTire(const FitTireOptions& options) {
  CheckNumbers(options);
  const EntryFiles files = EntryFilesOf({options.out, options.picture, options.no_picture}, true);
  const Catalogue<Tire> tires = TiresWith(options.tire_files);
  CheckEntry(options, tires);
  FittedTire tire{};
  FitShape(options, &tire);
  FitSpringsOf(options, &tire);
  const Friction friction = FrictionOf(options, tires);
  const std::string entries = options.out ? EntriesOf(options, tire, friction) : "";
  if (options.out) RequireReadable(tires, entries, *options.out);
  const std::string python = files.picture.empty() ? "" : PythonThatPlots();
  std::vector<std::string> inputs = options.tire_files;
  inputs.push_back(options.data);
  if (!options.contact_width.empty()) inputs.push_back(options.contact_width);
  PrepareEntryFiles(files, options.force, inputs);

  PrintFits(tire);
  const std::string title = options.name.empty() ? FileName(options.data) : options.name;
  WriteEntryFiles(files, {entries, FitsAsJson(tire, title)}, python, "tire_fit.py");
  FlushStandardOutput();
}

}  // namespace softsoil
