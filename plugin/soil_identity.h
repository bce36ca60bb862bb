// Which soil a state belongs to, in words: two soils whose identities agree give the same future.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "plugin/soil_plan.h"

namespace softsoil {

// Names and values of all that the soil of a plan follows from, in a fixed order.
using SoilIdentity = std::vector<std::pair<std::string, std::string>>;
SoilIdentity IdentityOf(const SoilPlan& plan);

// Throws InputError that tells the first difference between the soil that `whose` state is of and
// the soil `here`.
void RequireSame(const SoilIdentity& other, const SoilIdentity& here, const std::string& whose);

}  // namespace softsoil
