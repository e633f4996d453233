#pragma once

#include <string>

namespace cli
{

// A legacy VTK image of 4 x 4 x 4 points over 0..3, in text. Point arrays "height" (= z), "both" (= x) and the vector
// "wind" (1, 2, 2); cell arrays "both" (= 100 + the cell's id) and "mass" (= 7).
std::string legacyImage();

// Returns the same points and "height" as an XML image of VTK, in text.
std::string xmlImage();

// Two hexahedra side by side, as VTK's XML unstructured grid, in text; point array "height".
std::string xmlHexahedra();

// An XML image of 3 x 3 x 3 cells over 0..3 without arrays; the cell in the middle and the one below it are hidden.
std::string imageWithHiddenCells();

} // namespace cli
