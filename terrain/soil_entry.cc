#include "terrain/soil_entry.h"

#include <tinyxml2.h>

#include <vector>

#include "terrain/constants.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

class EntryPrinter {
 public:
  explicit EntryPrinter(const SoilEntry& entry) : entry_(entry) {}

  std::string Text() {
    printer_.OpenElement("soils");
    printer_.OpenElement("soil");
    printer_.PushAttribute("name", entry_.soil.name.c_str());
    if (!entry_.soil.description.empty()) {
      printer_.PushAttribute("description", entry_.soil.description.c_str());
    }
    Bearing();
    Unloading();
    Shear();
    FromTable("compaction");
    Layers();
    Moisture();
    FromTable("stress");
    MaxStress();
    printer_.CloseElement();
    printer_.CloseElement();
    return printer_.CStr();
  }

 private:
  void Number(const char* name, double value) {
    printer_.PushAttribute(name, Rounded(value, 7).c_str());
  }
  void Numbers(const char* name, const std::vector<double>& values) {
    std::string text;
    for (double value : values) text += (text.empty() ? "" : " ") + Rounded(value, 7);
    printer_.PushAttribute(name, text.c_str());
  }
  void Open(const char* element) { printer_.OpenElement(element); }
  void Close(const char* element) {
    printer_.PushAttribute("source", entry_.source.at(element).c_str());
    printer_.CloseElement();
  }
  void TableOf(const std::string& element) {
    Soil soil = entry_.soil;
    for (const Attribute<Soil>& a : SoilAttributes(soil.bearing.form)) {
      if (a.element == element) Number(a.name, a.field(soil) / a.to_si);
    }
  }
  void FromTable(const char* element) {
    Open(element);
    TableOf(element);
    Close(element);
  }

  void Bearing() {
    Open("bearing");
    if (entry_.soil.bearing.form == BearingForm::kReece) printer_.PushAttribute("form", "reece");
    TableOf("bearing");
    Close("bearing");
  }
  void Unloading() {
    const softsoil::Unloading& unloading = entry_.soil.unloading;
    if (unloading.IsRigid()) return;
    Open("unloading");
    Number("k_0", unloading.k_0);
    Number("A_u", unloading.A_u);
    Close("unloading");
  }
  void Shear() {
    Open("shear");
    const bool humped = entry_.soil.shear.form == ShearForm::kHumped;
    if (humped) printer_.PushAttribute("form", "humped");
    TableOf("shear");
    if (humped) Number("residual", entry_.soil.shear.residual);
    if (entry_.soil.angle_of_repose) {
      Number("angle_of_repose_deg", *entry_.soil.angle_of_repose * kDegrees);
    }
    if (entry_.soil.slip_sinkage > 0) Number("slip_sinkage", entry_.soil.slip_sinkage);
    Close("shear");
  }
  void Layers() {
    if (entry_.soil.layers.empty()) return;
    std::vector<double> tops, densities;
    for (const DensityLayer& layer : entry_.soil.layers) {
      tops.push_back(layer.top);
      densities.push_back(layer.density);
    }
    Open("layers");
    Numbers("top", tops);
    Numbers("initial_density", densities);
    Close("layers");
  }
  void Moisture() {
    if (!entry_.moisture) return;
    Open("moisture");
    Number("slope", entry_.moisture->slope);
    Number("saturation", entry_.moisture->saturation);
    Number("reference_saturation", entry_.moisture->reference_saturation);
    Close("moisture");
  }
  void MaxStress() {
    if (!entry_.soil.max_stress) return;
    Open("max_stress");
    Number("c_1", entry_.soil.max_stress->c_1);
    Number("c_2", entry_.soil.max_stress->c_2);
    Close("max_stress");
  }

  const SoilEntry& entry_;
  tinyxml2::XMLPrinter printer_;
};

}  // namespace

std::string SoilXml(const SoilEntry& entry) { return EntryPrinter(entry).Text(); }

}  // namespace softsoil
