#include "array_choice.h"
#include "legacy_copy.h"
#include "old_pieces.h"
#include "plain_xml.h"
#include "shared_faces.h"
#include "tree_leaves.h"
#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/checks/xml_check.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"
#include "vprobe-read/quick/quick_lattice.h"
#include "vprobe-read/text/text_end.h"

#include <vtkAbstractArray.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkHyperTreeGrid.h>
#include <vtkHyperTreeGridToUnstructuredGrid.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLHyperTreeGridReader.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPImageDataReader.h>
#include <vtkXMLPRectilinearGridReader.h>
#include <vtkXMLPStructuredGridReader.h>
#include <vtkXMLPUnstructuredGridReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLRectilinearGridReader.h>
#include <vtkXMLStructuredGridReader.h>

#include <fmt/format.h>

#include <cstdlib>
#include <string_view>

namespace vp::reader::vtk
{

namespace
{

template <class Reader>
vtkSmartPointer<vtkDataObject> loadWith(const Request& request, manifest::Writer& manifest)
{
	vtkNew<Reader> reader;
	reader->SetFileName(request.file.c_str());
	leaveOutArrays(*reader, request, manifest);
	manifest::updateAtTime(*reader, request, manifest);
	return reader->GetOutputDataObject(0);
}

// The array of a piece in the number type of the whole's. VTK copies the bytes of a piece whatever type the index of
// the pieces names: other values would come of that, and bytes behind the end of an array.
vtkSmartPointer<vtkAbstractArray> inTypeOf(vtkAbstractArray* whole, vtkAbstractArray* piece)
{
	if (!whole || !piece)
		return piece;
	const bool same_type = whole->GetDataType() == piece->GetDataType();
	const bool numbers = vtkDataArray::SafeDownCast(whole) && vtkDataArray::SafeDownCast(piece);
	if (whole->GetNumberOfComponents() != piece->GetNumberOfComponents() || !(same_type || numbers))
		throw damaged(fmt::format("a piece has another type of the array {} than the index of the pieces",
		                          piece->GetName() ? piece->GetName() : "without a name"));
	if (same_type)
		return piece;
	const auto converted = vtkSmartPointer<vtkAbstractArray>::Take(whole->NewInstance());
	converted->DeepCopy(piece);
	return converted;
}

template <class Reader>
class PieceReader : public Reader
{
public:
	static PieceReader* New() { VTK_STANDARD_NEW_BODY(PieceReader); }
	vtkTemplateTypeMacro(PieceReader, Reader);

protected:
	void CopyArrayForPoints(vtkAbstractArray* piece, vtkAbstractArray* whole) override
	{
		Reader::CopyArrayForPoints(inTypeOf(whole, piece), whole);
	}
	void CopyArrayForCells(vtkAbstractArray* piece, vtkAbstractArray* whole) override
	{
		Reader::CopyArrayForCells(inTypeOf(whole, piece), whole);
	}
};

class OldPiecesInFiles : public PieceReader<vtkXMLPUnstructuredGridReader>
{
public:
	static OldPiecesInFiles* New() { VTK_STANDARD_NEW_BODY(OldPiecesInFiles); }
	vtkTemplateTypeMacro(OldPiecesInFiles, PieceReader<vtkXMLPUnstructuredGridReader>);

protected:
	vtkXMLDataReader* CreatePieceReader() override { return OldPiecesReader::New(); }
};

// VTK 9.3 would add an array of ids that the file does not hold; 9.1 cannot.
template <class Filter>
void addNoIds(Filter& filter)
{
	if constexpr (requires { filter.AddOriginalIdsOff(); })
		filter.AddOriginalIdsOff();
}

// The leaves of the trees, as voxels with points of their own.
vtkSmartPointer<vtkDataObject> loadTrees(const Request& request, manifest::Writer& manifest)
{
	const vtkSmartPointer<vtkDataObject> read = loadWith<vtkXMLHyperTreeGridReader>(request, manifest);
	const auto trees = vtkHyperTreeGrid::SafeDownCast(read);
	if (!trees)
		throw damaged("no hyper tree grid was found");
	if (trees->GetDimension() != 3)
		throw Refusal(fmt::format("nothing to slice: a hyper tree grid of {} dimensions", trees->GetDimension()));
	// Below that, cells are thinner than the rounding of their places. Each level is a call within a call.
	constexpr unsigned int kMaxTreeLevels = 64;
	if (trees->GetNumberOfLevels() > kMaxTreeLevels)
		throw Refusal(
		    fmt::format("a hyper tree of {} levels; up to {} can be read", trees->GetNumberOfLevels(), kMaxTreeLevels));
	vtkNew<vtkHyperTreeGridToUnstructuredGrid> leaves;
	leaves->SetInputData(trees);
	addNoIds(*leaves);
	leaves->Update();
	if (!setLeafPoints(trees, vtkUnstructuredGrid::SafeDownCast(leaves->GetOutputDataObject(0))))
		manifest.warn("the places of its leaves have 7 digits");
	return leaves->GetOutputDataObject(0);
}

// The layers of a lattice that are asked for. The rest of the file is not read.
void addSlabs(const Request& request, const std::string& type, const quick::Lattice& lattice,
              manifest::Writer& manifest)
{
	const auto& points = lattice.points;
	const std::optional<CellLayers> layers =
	    manifest.parts().beginLattice({{"kind", lattice.kind}, {"points", points[0] * points[1] * points[2]}},
	                                  points[2] - 1, (points[0] - 1) * (points[1] - 1));
	if (!layers)
		return;
	const InsidePart inside(manifest.parts());
	if (!manifest.addQuickly(request.file, request.threads, layers))
		manifest.addLayers(loadXml(request, type, manifest), *layers);
}

} // namespace

namespace
{

vtkSmartPointer<vtkDataObject> loadPlainXml(const Request& request, const std::string& type, manifest::Writer& manifest)
{
	if (type == "ImageData")
		return loadWith<vtkXMLImageDataReader>(request, manifest);
	if (type == "RectilinearGrid")
		return loadWith<vtkXMLRectilinearGridReader>(request, manifest);
	if (type == "StructuredGrid")
		return loadWith<vtkXMLStructuredGridReader>(request, manifest);
	if (type == "UnstructuredGrid")
		return loadWith<OldPiecesReader>(request, manifest);
	if (type == "HyperTreeGrid")
		return loadTrees(request, manifest);
	if (type == "PImageData")
		return loadWith<PieceReader<vtkXMLPImageDataReader>>(request, manifest);
	if (type == "PRectilinearGrid")
		return loadWith<PieceReader<vtkXMLPRectilinearGridReader>>(request, manifest);
	if (type == "PStructuredGrid")
		return loadWith<PieceReader<vtkXMLPStructuredGridReader>>(request, manifest);
	if (type == "PUnstructuredGrid")
		return loadWith<OldPiecesInFiles>(request, manifest);
	if (type == "PolyData")
		return loadWith<vtkXMLPolyDataReader>(request, manifest);
	throw Refusal("a VTK file of type " + type + ", which cannot be read yet; give its pieces one by one");
}

vtkSmartPointer<vtkDataObject> loadXml(const PlainXml& plain, const std::string& type, manifest::Writer& manifest)
{
	if (plain.isEmpty())
		return nullptr;
	for (const std::string& line : plain.warnings())
		manifest.warn(line);
	const vtkSmartPointer<vtkDataObject> data = loadPlainXml(plain.request(), type, manifest);
	if (plain.hasUnknownText())
		throw Refusal(
		    "numbers in text in a file of too many elements, or with a document type; save it with binary data");
	if (!plain.times().empty())
		manifest.offerTimes(plain.times());
	if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
		addSharedFaces(plain.dataFiles(), grid);
	return data;
}

} // namespace

vtkSmartPointer<vtkDataObject> loadXml(const Request& request, const std::string& type, manifest::Writer& manifest)
{
	if (type.empty())
		throw damaged(fmt::format("{} is no VTK XML file", request.file));
	checks::refuseShortXml(request.file);
	const PlainXml plain(request);
	return loadXml(plain, type, manifest);
}

void addXml(const Request& request, const std::string& type, manifest::Writer& manifest)
{
	// For the test that compares both ways.
	const bool is_quick = !std::getenv("VPROBE_READ_WITH_VTK") &&
	                      isOneOf(type, {"ImageData", "RectilinearGrid", "StructuredGrid", "UnstructuredGrid"}) &&
	                      !(request.time == Request::Time::index && request.time_index > 0);
	if (is_quick && request.convert_to.empty())
	{
		checks::refuseShortXml(request.file);
		const auto lattice = manifest.parts().splits() ? quick::quickLattice(request.file) : std::nullopt;
		if (lattice)
			return addSlabs(request, type, *lattice, manifest);
		if (!manifest.parts().begin(manifest.parts().lists() ? cellsOfXml(request.file) : 0))
			return;
		const InsidePart inside(manifest.parts());
		if (manifest.addQuickly(request.file, request.threads, {}, request.stays_above))
			return;
		const PlainXml plain(request);
		// A copy is of the kind that is read without VTK, once it has no more numbers in text.
		if (plain.request().file != request.file && plain.times().empty() && !plain.isEmpty() &&
		    manifest.addQuickly(plain.request().file, request.threads))
		{
			for (const std::string& line : plain.warnings())
				manifest.warn(line);
			return;
		}
		return manifest.add(loadXml(plain, type, manifest));
	}
	manifest.addLone(loadXml(request, type, manifest));
}

void readXml(const Request& request, const std::string& type, manifest::Writer& manifest)
{
	if (type == "PolyData" || type == "PPolyData")
		throw Refusal("nothing to slice: polygonal data hold no three-dimensional cells");
	if (type == "Collection")
		return readCollection(request, manifest);
	if (isOneOf(type, {"vtkMultiBlockDataSet", "vtkMultiPieceDataSet", "vtkPartitionedDataSet",
	                   "vtkPartitionedDataSetCollection"}))
		return readMultiBlock(request, type, manifest);
	if (isOneOf(type, {"vtkHierarchicalBoxDataSet", "vtkOverlappingAMR", "vtkNonOverlappingAMR"}))
		return readAmr(request, type, manifest);
	if (!readPieces(request, type, manifest))
		addXml(request, type, manifest);
}

void readLegacy(const Request& request, manifest::Writer& manifest)
{
	const LegacyCopy copy = copyLegacy(MappedText(request.file).text());
	for (const std::string& line : copy.warnings)
		manifest.warn(line);
	vtkNew<vtkGenericDataObjectReader> reader;
	reader->SetFileName(copy.file ? copy.file->path().c_str() : request.file.c_str());
	reader->ReadAllScalarsOn();
	reader->ReadAllVectorsOn();
	reader->ReadAllNormalsOn();
	reader->ReadAllTensorsOn();
	reader->ReadAllColorScalarsOn();
	reader->ReadAllTCoordsOn();
	reader->ReadAllFieldsOn();
	manifest::updateAtTime(*reader, request, manifest);
	if (!reader->GetOutputDataObject(0))
		throw damaged("no data set was found");
	if (copy.is_text && text::endsInsideALine(request.file))
		manifest.warn(text::kCutTextWarning);
	manifest.addLone(reader->GetOutputDataObject(0));
}

} // namespace vp::reader::vtk
