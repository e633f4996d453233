#pragma once

#include <string>

class vtkXMLReader;

namespace vp::reader::manifest
{
class Writer;
}

namespace vp::reader
{
struct Request;
}

namespace vp::reader::vtk
{

// Tells a reader of VTK XML files not to read the arrays that nobody asked for, and notes them for the manifest. Where
// the file's elements cannot be parsed, all are read, and left out later.
void leaveOutArrays(vtkXMLReader& reader, const Request& request, manifest::Writer& manifest);

} // namespace vp::reader::vtk
