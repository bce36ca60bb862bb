#include "terrain/csv_lines.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

std::string Trimmed(const std::string& text) {
  const char* blank = " \t\r";
  const std::size_t first = text.find_first_not_of(blank);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::vector<std::string> Cells(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t start = 0;
  for (std::size_t comma = 0; comma != std::string::npos; start = comma + 1) {
    comma = line.find(',', start);
    cells.push_back(Trimmed(line.substr(start, comma - start)));
  }
  return cells;
}

}  // namespace

CsvLines::CsvLines(const std::string& file) : file_(file), stream_(file) {
  if (!stream_) throw InputError(file + ": cannot read: " + std::strerror(errno));
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) {
    throw InputError(file + ": is a folder, not a file");
  }
}

bool CsvLines::Next(std::vector<std::string>* cells) {
  std::string line;
  while (std::getline(stream_, line)) {
    ++number_;
    constexpr char kByteOrderMark[] = "\xEF\xBB\xBF";  // spreadsheets write it
    if (number_ == 1 && line.compare(0, 3, kByteOrderMark) == 0) line.erase(0, 3);
    line = Trimmed(line);
    if (line.empty() || line[0] == '#') continue;
    *cells = Cells(line);
    return true;
  }
  return false;
}

double CsvLines::Number(const std::string& name, const std::string& cell) const {
  if (cell.empty()) Refuse(name + " is missing");
  double value = 0;
  if (!ParseNumber(cell, &value)) Refuse(name + " must be a finite number, got \"" + cell + "\"");
  return value;
}

void CsvLines::RequireWidth(const std::vector<std::string>& cells, std::size_t width) const {
  if (cells.size() == width) return;
  Refuse("there must be " + std::to_string(width) + " cells as in the header, got " +
         std::to_string(cells.size()));
}

void CsvLines::Refuse(int line, const std::string& rule) const {
  throw InputError(file_ + ":" + std::to_string(std::max(line, 1)) + ": " + rule);
}

}  // namespace softsoil
