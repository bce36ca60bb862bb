// Settings as a text of the C API, and NAME=DATA as one <text name="softsoil_NAME" data="DATA"/> of
// a model.
#include "plugin/settings.h"
#include "terrain/input_error.h"
#include "tests/fuzz/fuzz_target.h"

namespace softsoil {
namespace {

void ReadFromModel(const std::string& name, const std::string& data) {
  std::string names = "softsoil_" + name, texts = data;  // end with a 0, as those of MuJoCo do
  int at_start = 0;
  mjModel m{};
  m.ntext = 1;
  m.names = names.data();
  m.name_textadr = &at_start;
  m.text_data = texts.data();
  m.text_adr = &at_start;
  SettingsOf(&m);
}

}  // namespace

void Read(const std::string& text) {
  const auto equals = text.find('=');
  if (equals != std::string::npos) {
    try {
      ReadFromModel(text.substr(0, equals), text.substr(equals + 1));
    } catch (const InputError&) {
    }
  }
  Settings settings;
  Override(text, &settings);
}

}  // namespace softsoil
