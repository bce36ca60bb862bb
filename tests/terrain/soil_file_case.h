// A soil file made from the table of attributes, so it holds every attribute that there is.
#pragma once

#include <string>

#include "terrain/soil.h"
#include "tests/terrain/catalogue_case.h"

namespace softsoil {

// A value in the range of every attribute, different for each: 3.1, 3.2 and on; stresses are
// 100,000 times that.
inline double SampleValue(std::size_t attribute) {
  const bool stress = std::string(SoilAttributes()[attribute].unit) == "Pa";
  return (31 + static_cast<double>(attribute)) * (stress ? 1e4 : 1) / (stress ? 1 : 10);
}

// One element a line, from line 3 on, each attribute as ` name="value"`. Without `dropped`.
inline std::string SoilXml(const std::string& name, const Attribute<Soil>* dropped = nullptr) {
  std::string xml = "<soils>\n<soil name=\"" + name + "\">\n";
  std::string element;
  const std::vector<Attribute<Soil>>& table = SoilAttributes();
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table[i].element != element) {
      xml += element.empty() ? "" : "/>\n";
      element = table[i].element;
      xml += "<" + element + " source=\"a test\"";
    }
    if (&table[i] == dropped) continue;
    xml += " " + std::string(table[i].name) + "=\"" + Shown(SampleValue(i)) + "\"";
  }
  return xml + "/>\n</soil>\n</soils>\n";
}

// The sentence after the file's name with which its text is refused; empty if it is taken.
inline std::string SoilRefusal(const std::string& xml) {
  const std::string path = WriteFile("soil.xml", xml);
  return RefusalAt(path, [&] { SoilCatalogue().AddFile(path); });
}

}  // namespace softsoil
