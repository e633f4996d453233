#pragma once

#include <cstddef>
#include <cstdint>

// Feeds one input to one of the program's own parsers, which its first byte picks:
//   M  a reader's manifest, as JSON up to a zero byte, then the size of its arrays in 4 bytes (low first), arrays,
//   cells;
//      what is accepted is also built into grids
//   T  --time   C  --camera   I  --surface, a grid surface   S  --surface, an expression
//   N  netCDF   P  PLOT3D   H  MetaImage   X  VTK XML   E  EnSight case   G  EnSight geometry   V  EnSight variable
//   J  a state   B  a probe   A  a path   K  color maps   O  lines of --commands: what follows `set`
//   F  a file of OpenFOAM, as each kind of file   L  legacy VTK   D  a text file of Tecplot
// A refusal is what damaged input should get; anything but that or success ends the process.
void feedParser(const std::uint8_t* data, std::size_t size);
