// What softsoil drawbar writes and prints.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "plugin/cli/drawbar.h"

namespace softsoil {

// drawbar.csv, one row per case.
void WriteDrawbarCsv(const std::string& folder, const std::vector<DrawbarCase>& cases);

// centre_line.csv. Each line has a name, the value of the column `key` [unit] in its rows.
using CentreLines = std::vector<std::pair<double, std::vector<CentreLinePoint>>>;
void WriteCentreLineCsv(const std::string& folder, const std::string& key,
                        const CentreLines& lines);

// summary.json of a curve, and of a history in mode torque.
void WriteDrawbarSummary(const DrawbarOptions& options, double radius, const DrawbarResult& result);
void WriteHistorySummary(const DrawbarOptions& options, double radius, bool settled);

// On stdout, not flushed.
void PrintDrawbar(const DrawbarOptions& options, double radius, const DrawbarResult& result);

}  // namespace softsoil
