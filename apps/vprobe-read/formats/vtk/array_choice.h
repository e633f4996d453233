#pragma once

#include <string>

class ManifestWriter;
class vtkXMLReader;
struct Request;

// Tells a reader of VTK XML files not to read the arrays that nobody asked for, and notes them for the manifest. Where
// the file's elements cannot be parsed, all are read, and left out later.
void leaveOutArrays(vtkXMLReader& reader, const Request& request, ManifestWriter& manifest);
