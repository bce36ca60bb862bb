#include "contact/slip_memory.h"

namespace softsoil {

void Write(const SlipMemory& slip, StateWriter& writer) {
  writer.Put(static_cast<std::uint64_t>(slip.size()));
  for (const NodeSlip& s : slip) {
    writer.Put(s.node);
    writer.Put(s.mobilisation.t);
    writer.Put(s.mobilisation.b);
    writer.Put(s.mobilisation.slip);
    writer.Put(s.deepest);
    writer.Put(s.pushed);
  }
}

SlipMemory ReadSlipMemory(StateReader& reader, std::size_t nodes) {
  SlipMemory slip(reader.Count(sizeof(int) + 5 * sizeof(double)));
  for (NodeSlip& s : slip) {
    s.node = reader.Get<int>();
    reader.Require(s.node >= 0 && static_cast<std::size_t>(s.node) < nodes, "a node of a tire");
    s.mobilisation = {reader.GetFinite(), reader.GetFinite(), reader.GetFinite()};
    s.deepest = reader.GetFinite();
    s.pushed = reader.GetFinite();
  }
  return slip;
}

}  // namespace softsoil
