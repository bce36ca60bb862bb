#include "plugin/cli/fit_tire_entry.h"

#include <tinyxml2.h>

#include <cmath>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

using tinyxml2::XMLPrinter;

void Push(XMLPrinter* xml, const char* name, double value) {
  xml->PushAttribute(name, Rounded(value, 7).c_str());
}

void Close(XMLPrinter* xml, const std::string& source) {
  xml->PushAttribute("source", source.c_str());
  xml->CloseElement();
}

void PushShape(XMLPrinter* xml, const TireShape& shape, const std::string& source) {
  const bool cylinder = std::isinf(shape.crown_radius);
  xml->OpenElement("shape");
  xml->PushAttribute("type", cylinder ? "cylinder" : "torus");
  Push(xml, "radius", shape.radius);
  if (!cylinder) Push(xml, "crown_radius", shape.crown_radius);
  Push(xml, "width", shape.width);
  Close(xml, source);
}

void PushSpring(XMLPrinter* xml, const Tire& tire, const std::string& source) {
  const TireSpring& spring = tire.spring;
  xml->OpenElement("spring");
  if (spring.linear > 0) Push(xml, "linear", spring.linear);
  if (spring.quadratic > 0) Push(xml, "quadratic", spring.quadratic);
  if (spring.cubic > 0) Push(xml, "cubic", spring.cubic);
  if (spring.root > 0) Push(xml, "root", spring.root);
  Push(xml, "damping", tire.damping);
  Close(xml, source);
}

void PushTire(XMLPrinter* xml, const Tire& tire, const TireSources& sources) {
  xml->OpenElement("tire");
  xml->PushAttribute("name", tire.name.c_str());
  xml->PushAttribute("description", tire.description.c_str());
  PushShape(xml, tire.shape, sources.shape);
  PushSpring(xml, tire, sources.spring);
  if (!tire.family.empty()) {
    xml->OpenElement("inflation");
    xml->PushAttribute("family", tire.family.c_str());
    Push(xml, "pressure", tire.inflation_pressure);
    Close(xml, sources.inflation);
  }
  xml->OpenElement("friction");
  Push(xml, "coefficient", tire.soil_friction);
  Close(xml, sources.friction);
  xml->CloseElement();
}

}  // namespace

std::string TireFileText(const std::vector<Tire>& tires, const std::vector<TireSources>& sources) {
  XMLPrinter xml;
  xml.OpenElement("tires");
  for (std::size_t i = 0; i < tires.size(); ++i) PushTire(&xml, tires[i], sources[i]);
  xml.CloseElement();
  return xml.CStr();
}

}  // namespace softsoil
