#include "formats.h"
#include "manifest_writer.h"
#include "refusal.h"
#include "text_end.h"
#include "time_choice.h"
#include "xml_check.h"

#include <vtkDataObject.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkNew.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPImageDataReader.h>
#include <vtkXMLPRectilinearGridReader.h>
#include <vtkXMLPStructuredGridReader.h>
#include <vtkXMLPUnstructuredGridReader.h>
#include <vtkXMLRectilinearGridReader.h>
#include <vtkXMLStructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

namespace
{

template <class Reader>
void readWith(const Request& request, ManifestWriter& manifest)
{
	vtkNew<Reader> reader;
	reader->SetFileName(request.file.c_str());
	updateAtTime(*reader, request, manifest);
	manifest.add(reader->GetOutputDataObject(0));
}

} // namespace

void readXml(const Request& request, const std::string& type, ManifestWriter& manifest)
{
	if (type == "PolyData" || type == "PPolyData")
		throw Refusal("nothing to slice: polygonal data hold no three-dimensional cells");
	refuseShortXml(request.file);
	if (type == "ImageData")
		return readWith<vtkXMLImageDataReader>(request, manifest);
	if (type == "RectilinearGrid")
		return readWith<vtkXMLRectilinearGridReader>(request, manifest);
	if (type == "StructuredGrid")
		return readWith<vtkXMLStructuredGridReader>(request, manifest);
	if (type == "UnstructuredGrid")
		return readWith<vtkXMLUnstructuredGridReader>(request, manifest);
	if (type == "PImageData")
		return readWith<vtkXMLPImageDataReader>(request, manifest);
	if (type == "PRectilinearGrid")
		return readWith<vtkXMLPRectilinearGridReader>(request, manifest);
	if (type == "PStructuredGrid")
		return readWith<vtkXMLPStructuredGridReader>(request, manifest);
	if (type == "PUnstructuredGrid")
		return readWith<vtkXMLPUnstructuredGridReader>(request, manifest);
	throw Refusal("a VTK file of type " + type + ", which cannot be read yet; give its pieces one by one");
}

void readLegacy(const Request& request, ManifestWriter& manifest)
{
	vtkNew<vtkGenericDataObjectReader> reader;
	reader->SetFileName(request.file.c_str());
	reader->ReadAllScalarsOn();
	reader->ReadAllVectorsOn();
	reader->ReadAllNormalsOn();
	reader->ReadAllTensorsOn();
	reader->ReadAllColorScalarsOn();
	reader->ReadAllTCoordsOn();
	reader->ReadAllFieldsOn();
	updateAtTime(*reader, request, manifest);
	if (!reader->GetOutputDataObject(0))
		throw damaged("no data set was found");
	if (reader->GetFileType() == VTK_ASCII && endsInsideALine(request.file))
		manifest.warn(kCutTextWarning);
	manifest.add(reader->GetOutputDataObject(0));
}
