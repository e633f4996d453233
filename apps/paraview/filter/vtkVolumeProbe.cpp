#include "vtkVolumeProbe.h"
#include "requests.h"

#include <vtkCompositeDataSet.h>
#include <vtkDataSet.h>
#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkMultiProcessController.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <fstream>
#include <iterator>

using namespace vprobe_paraview;

vtkStandardNewMacro(vtkVolumeProbe);

struct vtkVolumeProbe::State
{
	Settings settings;
	double tolerance = 0.0;
	KeptGrid grid;
	vtkSmartPointer<vtkMultiProcessController> controller;

	template <class T, class U>
	static void set(vtkVolumeProbe& probe, T& place, const U& value)
	{
		if (place == T(value))
			return;
		place = T(value);
		probe.Modified();
	}
	static void resize(vtkVolumeProbe& probe, std::vector<double>& list, int count)
	{
		if (list.size() == static_cast<std::size_t>(std::max(count, 0)))
			return;
		list.resize(static_cast<std::size_t>(std::max(count, 0)));
		probe.Modified();
	}
	static void setAt(vtkVolumeProbe& probe, std::vector<double>& list, int index, double value)
	{
		if (index < 0 || static_cast<std::size_t>(index) >= list.size())
			return;
		set(probe, list[static_cast<std::size_t>(index)], value);
	}
};

vtkVolumeProbe::vtkVolumeProbe() : State_(std::make_unique<State>())
{
	this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkVolumeProbe::~vtkVolumeProbe() = default;

void vtkVolumeProbe::SetProbe(int probe)
{
	State::set(*this, State_->settings.probe, static_cast<Probe>(std::clamp(probe, 0, 4)));
}

int vtkVolumeProbe::GetProbe()
{
	return static_cast<int>(State_->settings.probe);
}

void vtkVolumeProbe::SetProbeFile(const char* name)
{
	State::set(*this, State_->settings.probe_file, name ? name : "");
}

void vtkVolumeProbe::SetOrigin(double x, double y, double z)
{
	State::set(*this, State_->settings.origin, vprobe::Vector3{x, y, z});
}

void vtkVolumeProbe::SetNormal(double x, double y, double z)
{
	State::set(*this, State_->settings.normal, vprobe::Vector3{x, y, z});
}

void vtkVolumeProbe::SetUp(double x, double y, double z)
{
	State::set(*this, State_->settings.up, vprobe::Vector3{x, y, z});
}

void vtkVolumeProbe::SetVanes(int count)
{
	State::set(*this, State_->settings.vanes, count);
}

void vtkVolumeProbe::SetSheets(int count)
{
	State::set(*this, State_->settings.sheets, count);
}

void vtkVolumeProbe::SetNumberOfOffsets(int count)
{
	State::resize(*this, State_->settings.offsets, count);
}

void vtkVolumeProbe::SetOffset(int index, double offset)
{
	State::setAt(*this, State_->settings.offsets, index, offset);
}

void vtkVolumeProbe::SetUseWindow(bool use)
{
	State::set(*this, State_->settings.has_window, use);
}

void vtkVolumeProbe::SetWindow(double width, double height)
{
	State::set(*this, State_->settings.window, std::array<double, 2>{width, height});
}

void vtkVolumeProbe::SetSurface(int surface)
{
	State::set(*this, State_->settings.surface, static_cast<Surface>(std::clamp(surface, 0, 5)));
}

void vtkVolumeProbe::SetRadius(double radius)
{
	State::set(*this, State_->settings.radius, radius);
}

void vtkVolumeProbe::SetAngle(double degrees)
{
	State::set(*this, State_->settings.angle, degrees);
}

void vtkVolumeProbe::SetExpression(const char* expression)
{
	State::set(*this, State_->settings.expression, expression ? expression : "");
}

void vtkVolumeProbe::SetExpressionMoves(bool moves)
{
	State::set(*this, State_->settings.expression_moves, moves);
}

void vtkVolumeProbe::SetIsoValue(double value)
{
	State::set(*this, State_->settings.iso_value, value);
}

void vtkVolumeProbe::SetCrinkle(bool whole_cells)
{
	State::set(*this, State_->settings.crinkle, whole_cells);
}

void vtkVolumeProbe::SetUseThreshold(bool use)
{
	State::set(*this, State_->settings.has_threshold, use);
}

void vtkVolumeProbe::SetThreshold(double lo, double hi)
{
	State::set(*this, State_->settings.threshold, std::array<double, 2>{lo, hi});
}

void vtkVolumeProbe::SetComponent(int component)
{
	State::set(*this, State_->settings.component, component);
}

void vtkVolumeProbe::SetUseContourLines(bool use)
{
	State::set(*this, State_->settings.has_contour_lines, use);
}

void vtkVolumeProbe::SetNumberOfContourLines(int count)
{
	State::resize(*this, State_->settings.line_values, count);
}

void vtkVolumeProbe::SetContourLine(int index, double value)
{
	State::setAt(*this, State_->settings.line_values, index, value);
}

void vtkVolumeProbe::SetUseContours(bool use)
{
	State::set(*this, State_->settings.has_contours, use);
}

void vtkVolumeProbe::SetNumberOfContours(int count)
{
	State::resize(*this, State_->settings.contours, count);
}

void vtkVolumeProbe::SetContour(int index, double value)
{
	State::setAt(*this, State_->settings.contours, index, value);
}

void vtkVolumeProbe::SetContourDepth(double depth)
{
	State::set(*this, State_->settings.contour_depth, depth);
}

void vtkVolumeProbe::SetVectors(int vectors)
{
	State::set(*this, State_->settings.vectors, static_cast<Vectors>(std::clamp(vectors, 0, 2)));
}

void vtkVolumeProbe::SetVectorLattice(int points)
{
	State::set(*this, State_->settings.vector_lattice, points);
}

void vtkVolumeProbe::SetVectorSteps(double steps)
{
	State::set(*this, State_->settings.vector_steps, steps);
}

void vtkVolumeProbe::SetVectorTimeStep(double dt)
{
	State::set(*this, State_->settings.vector_dt, dt);
}

void vtkVolumeProbe::SetVectorDirection(int direction)
{
	State::set(*this, State_->settings.vector_direction, direction);
}

void vtkVolumeProbe::SetTolerance(double tolerance)
{
	State::set(*this, State_->tolerance, tolerance);
}

void vtkVolumeProbe::SetThreads(int count)
{
	State::set(*this, State_->settings.threads, count);
}

void vtkVolumeProbe::SetController(vtkMultiProcessController* controller)
{
	State::set(*this, State_->controller, controller);
}

int vtkVolumeProbe::GetGridsTaken()
{
	return State_->grid.counts().grids;
}

int vtkVolumeProbe::GetNeighborsBuilt()
{
	return State_->grid.counts().neighbors;
}

int vtkVolumeProbe::GetCutsMade()
{
	return State_->grid.counts().cuts;
}

int vtkVolumeProbe::FillInputPortInformation(int, vtkInformation* info)
{
	info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
	info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
	return 1;
}

int vtkVolumeProbe::RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
	vtkInformation* info = outputs->GetInformationObject(0);
	vtkDataObject* there = vtkDataObject::GetData(info);
	vtkSmartPointer<vtkDataObject> wanted = vtkSmartPointer<vtkPolyData>::New();
	if (State_->settings.hasParts())
		wanted = vtkSmartPointer<vtkMultiBlockDataSet>::New();
	if (!there || there->GetDataObjectType() != wanted->GetDataObjectType())
		info->Set(vtkDataObject::DATA_OBJECT(), wanted);
	return 1;
}

namespace
{

// "point:NAME" or "cell:NAME" of an array to process; empty where none is chosen.
std::string arraySetting(vtkAlgorithm& filter, int index)
{
	vtkInformation* info = filter.GetInputArrayInformation(index);
	const char* name = info ? info->Get(vtkDataObject::FIELD_NAME()) : nullptr;
	if (!name || !*name)
		return {};
	const bool is_of_cells = info->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_CELLS;
	return (is_of_cells ? "cell:" : "point:") + std::string(name);
}

// A probe's file is small. What is larger is none.
std::string textOf(const std::string& file)
{
	constexpr std::streamoff kLargest = 1 << 24;
	std::ifstream stream(file, std::ios::binary | std::ios::ate);
	if (!stream || stream.tellg() < 0 || stream.tellg() > kLargest)
		return {};
	stream.seekg(0);
	return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

int vtkVolumeProbe::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
	vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
	vtkDataObject* output = vtkDataObject::GetData(outputs);
	Request request{*this, State_->settings, State_->tolerance, State_->grid, Ranks(State_->controller)};
	request.settings.array = arraySetting(*this, 0);
	request.settings.vector_array = arraySetting(*this, 1);
	if (request.settings.probe == Probe::file)
		request.settings.probe_text = textOf(request.settings.probe_file);
	const std::string error = request.run(*input, *output);
	// One message, from the rank that the client hears.
	if (!request.ranks.isFirst())
		return 1;
	for (const std::string& warning : request.warnings)
		vtkWarningMacro(<< warning);
	if (!error.empty())
	{
		this->SetErrorCode(vtkErrorCode::UserError);
		vtkErrorMacro(<< error);
	}
	return 1;
}

void vtkVolumeProbe::PrintSelf(ostream& os, vtkIndent indent)
{
	this->Superclass::PrintSelf(os, indent);
	const KeptGrid::Counts& counts = State_->grid.counts();
	os << indent << "Probe: " << this->GetProbe() << "\n"
	   << indent << "GridsTaken: " << counts.grids << "\n"
	   << indent << "NeighborsBuilt: " << counts.neighbors << "\n"
	   << indent << "CutsMade: " << counts.cuts << "\n";
}
