#include "plugin/settings.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "plugin/model_geometry.h"
#include "plugin/words.h"
#include "terrain/input_error.h"
#include "terrain/processors.h"

namespace softsoil {
namespace {

constexpr char kPrefix[] = "softsoil_";

const char* ElementOf(SettingKind kind) {
  switch (kind) {
    case SettingKind::kText: return "text";
    case SettingKind::kBodies: return "tuple";
    default: return "numeric";
  }
}

bool IsNumber(SettingKind kind) {
  return kind == SettingKind::kNumber || kind == SettingKind::kWholeNumber;
}

// Throws InputError that lists the known keys.
const Setting& Find(const std::string& name, const std::string& prefix) {
  std::vector<std::string> known;
  for (const Setting& setting : SettingTable()) {
    if (name == setting.name) return setting;
    known.push_back(prefix + setting.name);
  }
  throw InputError("unknown key; known are: " + Listed(known));
}

void CheckNumber(const Setting& setting, double value) {
  const std::string unit = *setting.unit ? std::string(" ") + setting.unit : "";
  if (!Contains(setting.limits, value)) {
    throw InputError("must be " + InWords(setting.limits) + unit + ", got " + Shown(value));
  }
  if (setting.kind == SettingKind::kWholeNumber && value != std::floor(value)) {
    throw InputError("must be a whole number, got " + Shown(value));
  }
}

void Apply(const Setting& setting, const SettingValue& value, Settings* settings) {
  if (IsNumber(setting.kind)) CheckNumber(setting, value.number);
  if (setting.kind == SettingKind::kText && value.text.empty()) {
    throw InputError("must not be empty");
  }
  if (setting.kind == SettingKind::kBodies && value.names.empty()) {
    throw InputError("must name a body");
  }
  setting.set(*settings, value);
}

// One pass over the <text>, <numeric> or <tuple> elements of a model.
class CustomReader {
 public:
  CustomReader(const mjModel* m, Settings* settings) : m_(m), settings_(settings) {}

  // read(i) gives the value of element i.
  template <class Read>
  void ReadAll(const char* element, int count, const int* name_address, const Read& read) {
    for (int i = 0; i < count; ++i) {
      const std::string name = m_->names + name_address[i];
      if (name.rfind(kPrefix, 0) != 0) continue;
      At("<custom> " + name, [&] {
        const Setting& setting = Find(name.substr(std::strlen(kPrefix)), kPrefix);
        if (std::strcmp(ElementOf(setting.kind), element) != 0) {
          throw InputError("must be a <" + std::string(ElementOf(setting.kind)) + ">, got a <" +
                           element + ">");
        }
        Apply(setting, read(i), settings_);
      });
    }
  }

 private:
  const mjModel* m_;
  Settings* settings_;
};

SettingValue Numeric(const mjModel* m, int i) {
  if (m->numeric_size[i] != 1) {
    throw InputError("must be one number, got " + std::to_string(m->numeric_size[i]));
  }
  SettingValue value;
  value.number = m->numeric_data[m->numeric_adr[i]];
  return value;
}

SettingValue Text(const mjModel* m, int i) {
  SettingValue value;
  value.text = m->text_data + m->text_adr[i];
  return value;
}

SettingValue Tuple(const mjModel* m, int i) {
  SettingValue value;
  for (int k = m->tuple_adr[i]; k < m->tuple_adr[i] + m->tuple_size[i]; ++k) {
    if (m->tuple_objtype[k] != mjOBJ_BODY) {
      throw InputError("must refer to bodies; element " + std::to_string(k - m->tuple_adr[i] + 1) +
                       " does not");
    }
    value.names.push_back(WheelName(m, m->tuple_objid[k]));
  }
  return value;
}

double Number(const std::string& text) {
  double number = 0;
  if (!ParseNumber(text, &number)) {
    throw InputError("must be a finite number, got \"" + text + "\"");
  }
  return number;
}

Settings Defaults() {
  Settings settings;
  const double processors = Processors();
  settings.terrain.threads =
      static_cast<int>(std::clamp(processors, kThreadsLimits.least, kThreadsLimits.most));
  return settings;
}

}  // namespace

Settings SettingsOf(const mjModel* m) {
  Settings settings = Defaults();
  CustomReader reader(m, &settings);
  reader.ReadAll("text", m->ntext, m->name_textadr, [m](int i) { return Text(m, i); });
  reader.ReadAll("numeric", m->nnumeric, m->name_numericadr, [m](int i) { return Numeric(m, i); });
  reader.ReadAll("tuple", m->ntuple, m->name_tupleadr, [m](int i) { return Tuple(m, i); });
  return settings;
}

void Override(const std::string& text, Settings* settings) {
  std::set<std::string> given;
  for (const std::string& entry : Words(text, " \t\n;")) {
    const auto equals = entry.find('=');
    const std::string key = entry.substr(0, equals);
    At("settings: " + key, [&] {
      const Setting& setting = Find(key, "");
      if (equals == std::string::npos) throw InputError("must be followed by = and a value");
      if (!given.insert(key).second) throw InputError("is given twice");
      SettingValue value;
      value.text = entry.substr(equals + 1);
      if (IsNumber(setting.kind)) value.number = Number(value.text);
      if (setting.kind == SettingKind::kBodies) value.names = Words(value.text, ",");
      Apply(setting, value, settings);
    });
  }
}

}  // namespace softsoil
