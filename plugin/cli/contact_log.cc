#include "plugin/cli/contact_log.h"

#include <algorithm>
#include <cmath>

#include "plugin/cli/csv_cell.h"
#include "terrain/constants.h"

namespace softsoil {
namespace {

using Wheel = softsoilWheel;
using Contact = softsoilContact;

// Distance [m] that a node is ahead of the axle, along the ground.
double Ahead(const Wheel& wheel, const Contact& contact) {
  double squares = -contact.lateral * contact.lateral;
  for (int k = 0; k < 3; ++k) squares += std::pow(contact.position[k] - wheel.centre[k], 2);
  return std::sqrt(std::max(0.0, squares)) * std::sin(contact.angle);
}

struct ContactColumn {
  const char* heading;  // with the unit
  double (*value)(const Wheel&, const Contact&);
};

const ContactColumn kColumns[] = {
    {"x [m]", [](const Wheel&, const Contact& c) { return c.position[0]; }},
    {"y [m]", [](const Wheel&, const Contact& c) { return c.position[1]; }},
    {"z [m]", [](const Wheel&, const Contact& c) { return c.position[2]; }},
    {"angle [deg]", [](const Wheel&, const Contact& c) { return c.angle * kDegrees; }},
    {"ahead [m]", Ahead},
    {"lateral [m]", [](const Wheel&, const Contact& c) { return c.lateral; }},
    {"pressure [Pa]", [](const Wheel&, const Contact& c) { return c.pressure; }},
    {"shear [Pa]", [](const Wheel&, const Contact& c) { return c.shear; }},
    {"shear_across [Pa]", [](const Wheel&, const Contact& c) { return c.shear_across; }},
    {"area [m^2]", [](const Wheel&, const Contact& c) { return c.area; }},
    {"depth [m]", [](const Wheel&, const Contact& c) { return c.depth; }},
};

}  // namespace

ContactLog::ContactLog(const std::string& path) : file_(path) {
  std::string header = "time [s],wheel";
  for (const ContactColumn& column : kColumns) header += std::string(",") + column.heading;
  file_.Write(header + "\n");
}

void ContactLog::Write(double time, const Wheel& wheel, const std::vector<Contact>& contacts) {
  const std::string start = CsvCell(time) + "," + CsvCell(std::string(wheel.name));
  for (const Contact& contact : contacts) {
    std::string row = start;
    for (const ContactColumn& column : kColumns) row += "," + CsvCell(column.value(wheel, contact));
    file_.Write(row + "\n");
  }
  file_.Flush();
}

}  // namespace softsoil
