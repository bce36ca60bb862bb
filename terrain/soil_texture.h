// What a soil is made of, and the USCS classes for which Madsen (2014) prints it.
#pragma once

#include <string>
#include <vector>

namespace softsoil {

// Shares of the mass; they add up to 100.
struct Texture {
  double clay, silt, sand;  // [%]
};

// The average rating cone index behind a friction angle. The thesis prints 80 for CH, ML and SW,
// and none for its two Yolo loams, CL and MH.
enum class RatingConeIndex { k80, kYoloLoam };

// What the relations of pedotransfer.h ask about a soil.
struct Composition {
  Texture texture;
  double clay_index;        // [-]
  double grain_size_index;  // [-]
  RatingConeIndex cone_index;
};

// A soil of the Unified Soil Classification System as Madsen (2014) prints it.
struct UscsSoil {
  const char* name;  // "CH"
  Composition composition;
  const char* source;   // place in the thesis
  const char* caution;  // where the relations and the print disagree; may be empty
};
const std::vector<UscsSoil>& UscsSoils();

// Throws InputError that lists the known classes.
const UscsSoil& FindUscsSoil(const std::string& name);

// The soil of a texture, its indices by the relations of pedotransfer.h and the rating cone index
// of the thesis' example, 80. Throws InputError if a share is negative, if they do not add up to
// 100 within the 0.2 that rounding to 0.1 explains, or if one lies outside those of UscsSoils().
Composition CompositionOf(const Texture& texture);

// More than half is coarser than silt: coarse-grained in the sense of the USCS.
inline bool IsCoarse(const Texture& texture) { return texture.sand > 50; }

// "47.1 % clay, 24 % silt, 28.9 % sand"
std::string InWords(const Texture& texture);

}  // namespace softsoil
