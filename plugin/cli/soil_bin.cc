#include "plugin/cli/soil_bin.h"

#include <tinyxml2.h>

#include <stdexcept>

#include "plugin/cli/paths.h"
#include "terrain/constants.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

using tinyxml2::XMLElement;

constexpr double kSprungShare = 0.9, kUnsprungShare = 0.05;  // [-]  of the mass, 6.3.1
// Rim of the 18.4R38, 38 in by 16 in, in a tire of 1.82 m by 18.4 in.
constexpr double kRimPerRadius = 0.4826 / 0.91, kRimPerWidth = 16 / 18.4;

// The element of a kind and name, anywhere below `parent`; null if there is none.
XMLElement* Search(XMLElement* parent, const std::string& kind, const std::string& name) {
  for (XMLElement* e = parent->FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    if (e->Name() == kind && (name.empty() || e->Attribute("name", name.c_str()) != nullptr)) {
      return e;
    }
    if (XMLElement* below = Search(e, kind, name)) return below;
  }
  return nullptr;
}

// How far the rig differs from the scene.
struct Scale {
  double length;  // [-]  along and up
  double width;   // [-]  across
  double mass;    // [-]
};

// The numbers of an attribute, each times the factor of its place.
void Multiply(XMLElement* element, const char* attribute, const std::vector<double>& factors) {
  const char* text = element->Attribute(attribute);
  if (text == nullptr) return;
  std::string scaled;
  std::string rest = text;
  for (std::size_t k = 0; !rest.empty(); ++k) {
    const std::size_t end = rest.find(' ');
    double value = 0;
    if (k >= factors.size() || !ParseNumber(rest.substr(0, end), &value)) {
      throw std::runtime_error("soil_bin.xml:" + std::to_string(element->GetLineNum()) + ": " +
                               attribute + " cannot be scaled: \"" + text + "\"");
    }
    scaled += (k > 0 ? " " : "") + Shown(value * factors[k]);
    rest = end == std::string::npos ? "" : rest.substr(end + 1);
  }
  element->SetAttribute(attribute, scaled.c_str());
}

// Cylinders lie across, or are thin rods whose ends `fromto` tells.
void ScaleLengths(XMLElement* body, const Scale& s) {
  for (XMLElement* e = body->FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    const bool box = e->Attribute("type", "box") != nullptr;
    Multiply(e, "pos", {s.length, s.width, s.length});
    Multiply(e, "fromto", {s.length, s.width, s.length, s.length, s.width, s.length});
    Multiply(e, "size", {s.length, s.width, box ? s.length : 1});
    if (std::string(e->Name()) == "body") ScaleLengths(e, s);
  }
}

class Editor {
 public:
  explicit Editor(const SoilBin& bin) : bin_(bin), file_(SceneFile("soil_bin")) {
    if (document_.LoadFile(file_.c_str()) != tinyxml2::XML_SUCCESS) {
      throw std::runtime_error(file_ + ": " + document_.ErrorStr());
    }
    const XMLElement& wheel = *Find("geom", "wheel");
    double radius = 0, half_width = 0;
    const std::string size = wheel.Attribute("size");
    const std::size_t blank = size.find(' ');
    ParseNumber(size.substr(0, blank), &radius);
    ParseNumber(size.substr(blank + 1), &half_width);
    double sprung_mass = 0;
    Body("sprung_mass", "inertial")->QueryDoubleAttribute("mass", &sprung_mass);
    scale_ = {bin.tire.shape.radius / radius, bin.tire.shape.width / 2 / half_width,
              kSprungShare * bin.load / kGravity / sprung_mass};
  }

  std::string Edited() {
    Describe();
    SetLengths();
    SetMasses();
    SetDrives();
    SetSoil();
    TouchSoilAlone();
    tinyxml2::XMLPrinter printer;
    document_.Print(&printer);
    return printer.CStr();
  }

 private:
  XMLElement* Find(const std::string& kind, const std::string& name = "") {
    XMLElement* const found = Search(document_.RootElement(), kind, name);
    if (found == nullptr) throw std::runtime_error(file_ + ": has no <" + kind + "> " + name);
    return found;
  }

  // The child of a body.
  XMLElement* Body(const char* body, const char* child) {
    XMLElement* const found = Find("body", body)->FirstChildElement(child);
    if (found == nullptr) throw std::runtime_error(file_ + ": " + body + " has no " + child);
    return found;
  }

  // The scene's own words are about one tire and load.
  void Describe() {
    for (auto* node = document_.FirstChild(); node != nullptr; node = node->NextSibling()) {
      if (node->ToComment() == nullptr) continue;
      const std::string text =
          " Soil bin of Madsen (2014), 6.3.1, made by softsoil drawbar: " + bin_.tire.name + ", " +
          bin_.soil + ", " + Shown(bin_.load) + " N. ";
      node->SetValue(text.c_str());
      return;
    }
  }

  void SetLengths() {
    Multiply(Find("statistic"), "center", {scale_.length, scale_.width, scale_.length});
    Multiply(Find("statistic"), "extent", {scale_.length});
    XMLElement* const rig = Find("body", "sprung_mass");
    Multiply(rig, "pos", {1, 1, scale_.length});
    ScaleLengths(rig, scale_);
  }

  void SetInertia(const char* body, double mass, const std::vector<double>& inertia) {
    XMLElement* const inertial = Body(body, "inertial");
    std::string numbers;
    for (const double value : inertia) numbers += (numbers.empty() ? "" : " ") + Shown(value);
    inertial->SetAttribute("mass", Shown(mass).c_str());
    inertial->SetAttribute("diaginertia", numbers.c_str());
  }

  // Of a body that never turns: its inertia plays no part.
  void SetMass(const char* body, double mass) {
    XMLElement* const inertial = Body(body, "inertial");
    inertial->SetAttribute("mass", Shown(mass).c_str());
    Multiply(inertial, "diaginertia", {scale_.mass, scale_.mass, scale_.mass});
  }

  void SetMasses() {
    const double mass = bin_.load / kGravity;
    SetMass("sprung_mass", kSprungShare * mass);
    SetMass("spindle", kUnsprungShare * mass);
    // A solid cylinder of the rim's size, 6.3.1.
    const double rim = kRimPerRadius * bin_.tire.shape.radius,
                 width = kRimPerWidth * bin_.tire.shape.width;
    const double across = kUnsprungShare * mass * (3 * rim * rim + width * width) / 12;
    const double spin = kUnsprungShare * mass * rim * rim / 2;
    SetInertia("wheel", kUnsprungShare * mass, {across, spin, across});
    XMLElement* const suspension = Find("joint", "suspension");
    Multiply(suspension, "stiffness", {scale_.mass});
    Multiply(suspension, "damping", {scale_.mass});
  }

  void SetServo(const char* name) {
    const double damping = kServoPerLoad * bin_.load;
    Find("joint", name)->SetAttribute("damping", Shown(damping).c_str());
    Find("motor", name)->SetAttribute("gear", Shown(damping).c_str());
  }

  void SetDrives() {
    SetServo(kForward);
    SetServo(kSpin);
    for (const char* name : {kForward, kSpin}) {
      XMLElement* const motor = Find("motor", name);
      motor->SetAttribute("ctrllimited", "false");  // the range is that of sliders
    }
    if (bin_.mode == BinMode::kSlip) return;
    Find("joint", kForward)->DeleteAttribute("damping");
    Find("actuator")->DeleteChild(Find("motor", kForward));
    if (bin_.mode == BinMode::kSpin) return;
    Find("joint", kSpin)->DeleteAttribute("damping");
    XMLElement* const motor = Find("motor", kSpin);
    const std::string most = Shown(bin_.load * bin_.tire.shape.radius);
    motor->SetAttribute("name", kTorque);
    motor->SetAttribute("gear", "1");
    motor->SetAttribute("ctrlrange", ("-" + most + " " + most).c_str());
  }

  void SetSoil() {
    Find("text", "softsoil_soil")->SetAttribute("data", bin_.soil.c_str());
    Find("text", "softsoil_tire")->SetAttribute("data", bin_.tire.name.c_str());
    XMLElement* const custom = Find("custom");
    for (const auto& [key, value] : bin_.settings) {
      double number = 0;
      const bool numeric = ParseNumber(value, &number);
      XMLElement* const entry = custom->InsertNewChildElement(numeric ? "numeric" : "text");
      entry->SetAttribute("name", ("softsoil_" + key).c_str());
      entry->SetAttribute("data", value.c_str());
    }
  }

  // In a valley of bumpy ground the rigid plane, which stays flat, would carry the sprung mass.
  void TouchSoilAlone() {
    XMLElement* const mass = Find("geom", "sprung_mass");
    for (const char* bits : {"contype", "conaffinity"}) mass->SetAttribute(bits, "0");
  }

  const SoilBin& bin_;
  std::string file_;
  tinyxml2::XMLDocument document_;
  Scale scale_ = {};
};

}  // namespace

std::string SoilBinModel(const SoilBin& bin) { return Editor(bin).Edited(); }

}  // namespace softsoil
