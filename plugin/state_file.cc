#include "plugin/state_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "plugin/soil_identity.h"
#include "terrain/input_error.h"
#include "terrain/output_file.h"

namespace softsoil {
namespace {

constexpr std::array<char, 16> kMagic = {'s', 'o', 'f', 't', 's', 'o', 'i',  'l',
                                         ' ', 's', 't', 'a', 't', 'e', '\n', '\x1a'};

void Write(const SoilIdentity& identity, StateWriter& writer) {
  writer.Put(static_cast<std::uint64_t>(identity.size()));
  for (const auto& [name, value] : identity) {
    writer.PutText(name);
    writer.PutText(value);
  }
}

SoilIdentity ReadIdentity(StateReader& reader) {
  SoilIdentity identity(reader.Count(2 * sizeof(std::uint64_t)));
  for (auto& [name, value] : identity) {
    name = reader.GetText();
    value = reader.GetText();
  }
  return identity;
}

constexpr std::size_t kHead = kMagic.size() + sizeof(std::uint32_t);

// What stands before the contents.
void CheckHead(const std::vector<unsigned char>& bytes) {
  if (bytes.size() < kHead || !std::equal(kMagic.begin(), kMagic.end(), bytes.begin())) {
    throw InputError("is no file of softsoil_save()");
  }
  std::uint32_t version = 0;
  std::memcpy(&version, bytes.data() + kMagic.size(), sizeof version);
  if (version != kStateFileVersion) {
    throw InputError("has version " + std::to_string(version) + "; this softsoil reads version " +
                     std::to_string(kStateFileVersion));
  }
}

// Other files may be larger than the memory: the head comes first.
std::vector<unsigned char> Bytes(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (is_directory(status)) throw InputError("is a folder");
  // Of a pipe to which no one writes even the opening takes for ever.
  if (exists(status) && !is_regular_file(status)) throw InputError("is not a regular file");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (file == nullptr) throw InputError(std::string("cannot read: ") + std::strerror(errno));
  const auto size = std::filesystem::file_size(path, error);
  if (error) throw InputError("cannot read: " + error.message());
  std::vector<unsigned char> bytes(std::min<std::size_t>(size, kHead));
  const auto read = [&](std::size_t from) {
    const std::size_t count = bytes.size() - from;
    if (std::fread(bytes.data() + from, 1, count, file.get()) != count) {
      throw InputError("cannot read");
    }
  };
  read(0);
  CheckHead(bytes);
  bytes.resize(size);
  read(kHead);
  return bytes;
}

// The contents between the version and the checksum.
StateReader Checked(const std::vector<unsigned char>& bytes) {
  CheckHead(bytes);
  constexpr std::size_t kTail = sizeof(std::uint64_t);
  if (bytes.size() < kHead + kTail) throw InputError("is damaged: it ends too early");
  StateWriter hash;
  hash.PutBytes(bytes.data(), bytes.size() - kTail);
  std::uint64_t checksum = 0;
  std::memcpy(&checksum, bytes.data() + bytes.size() - kTail, kTail);
  if (checksum != hash.Finish()) throw InputError("is damaged: its checksum is wrong");
  return {bytes.data() + kHead, bytes.size() - kHead - kTail};
}

}  // namespace

void WriteState(const SoilState& state, const ModelData* data, const StateWriter::Sink& sink) {
  StateWriter writer(sink);
  writer.PutBytes(kMagic.data(), kMagic.size());
  writer.Put(kStateFileVersion);
  Write(IdentityOf(*state.plan), writer);
  Write(state, writer);
  for (const OwnShare& share : state.shares) share.Write(writer);
  writer.Put(data != nullptr);
  if (data != nullptr) {
    // A mark names nothing in another process.
    const bool is_marked = HasRoomForMark(data->m->nuserdata) && state.plan->history > 0;
    Write(data->m, data->d, is_marked ? kMarkSize : 0, writer);
  }
  const std::uint64_t checksum = writer.Finish();
  sink(&checksum, sizeof checksum);
}

void SaveState(const std::string& path, const SoilState& state, const ModelData* data) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw InputError(path + ": is a folder");
  OutputFile file(path);
  try {
    WriteState(state, data, [&](const void* bytes, std::size_t n) { file.Write(bytes, n); });
    file.Finish();
  } catch (...) {
    file.Discard();
    throw;
  }
}

SavedState ParseState(const std::vector<unsigned char>& bytes, const SoftWheels& wheels,
                      const SoilState& undisturbed, const mjModel* m) {
  StateReader reader = Checked(bytes);
  RequireSame(ReadIdentity(reader), IdentityOf(*undisturbed.plan), "the state");
  SavedState state{ReadSoilState(reader, wheels, undisturbed), {}};
  for (OwnShare& share : state.soil.shares) share.Read(reader);
  const bool has_data = reader.GetFlag();
  if (m == nullptr) return state;
  if (!has_data) throw InputError("holds the soil alone, not the state of the mjData");
  state.mujoco = ReadMujocoState(reader, m);
  return state;
}

SavedState LoadState(const std::string& path, const SoftWheels& wheels,
                     const SoilState& undisturbed, const mjModel* m) {
  return At(path, [&] { return ParseState(Bytes(path), wheels, undisturbed, m); });
}

}  // namespace softsoil
