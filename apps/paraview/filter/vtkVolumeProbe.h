#ifndef vtkVolumeProbe_h
#define vtkVolumeProbe_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkVolumeProbeFilterModule.h" // for the export macro

#include <memory> // for the state

class vtkMultiProcessController;

/**
 * @class vtkVolumeProbe
 * @brief Cuts data sets by a volume probe: one or more sheets, plane or curved.
 *
 * The input is a data set with cells that have a volume, or a composite of such. Its arrays are shared. Neighbors of
 * cells are kept until points or cells change, so that a probe that moves visits only the cells that it cuts.
 *
 * The output is a vtkPolyData for a single sheet, else a vtkMultiBlockDataSet with one part for each sheet, then
 * contour lines, contours and vectors, where they are asked for. On several ranks each cuts its own piece without
 * ghost cells.
 */
class VTKVOLUMEPROBEFILTER_EXPORT vtkVolumeProbe : public vtkDataObjectAlgorithm
{
public:
	static vtkVolumeProbe* New();
	vtkTypeMacro(vtkVolumeProbe, vtkDataObjectAlgorithm);
	void PrintSelf(ostream& os, vtkIndent indent) override;

	///@{
	/**
	 * The probe: 0 a single sheet, 1 three at right angles, 2 vanes about an axis, 3 a stack, 4 from a file.
	 */
	void SetProbe(int probe);
	int GetProbe();
	///@}
	/**
	 * A file that describes a probe (docs/PROBES.md), for probe 4.
	 */
	void SetProbeFile(const char* name);

	///@{
	/**
	 * The plane, and the direction that is up on it.
	 */
	void SetOrigin(double x, double y, double z);
	void SetNormal(double x, double y, double z);
	void SetUp(double x, double y, double z);
	///@}

	///@{
	/**
	 * Of a paddlewheel and of a stack. Without offsets the sheets of a stack stand in equal slabs of the bounds.
	 */
	void SetVanes(int count);
	void SetSheets(int count);
	void SetNumberOfOffsets(int count);
	void SetOffset(int index, double offset);
	///@}

	///@{
	/**
	 * Width and height of each sheet. Without a window a sheet covers the whole cut.
	 */
	void SetUseWindow(bool use);
	void SetWindow(double width, double height);
	///@}

	///@{
	/**
	 * What each sheet cuts by: 0 a plane, 1 a sphere, 2 a cylinder, 3 a cone, 4 an expression, 5 a value of the array.
	 */
	void SetSurface(int surface);
	void SetRadius(double radius);
	void SetAngle(double degrees);
	void SetExpression(const char* expression);
	void SetExpressionMoves(bool moves);
	void SetIsoValue(double value);
	///@}

	/**
	 * Gives the outer faces of the cells that are cut, whole.
	 */
	void SetCrinkle(bool whole_cells);

	///@{
	/**
	 * Ends the search at cells whose values lie outside. The array is array 0 to process, as it is for contours.
	 */
	void SetUseThreshold(bool use);
	void SetThreshold(double lo, double hi);
	void SetComponent(int component);
	///@}

	///@{
	/**
	 * Lines on the sheets on which the array has these values, and surfaces that grow from the sheets.
	 */
	void SetUseContourLines(bool use);
	void SetNumberOfContourLines(int count);
	void SetContourLine(int index, double value);
	void SetUseContours(bool use);
	void SetNumberOfContours(int count);
	void SetContour(int index, double value);
	void SetContourDepth(double depth);
	///@}

	///@{
	/**
	 * Particles that start on the sheets: 0 none, 1 tufts, 2 lines. Array 1 to process moves them.
	 */
	void SetVectors(int vectors);
	void SetVectorLattice(int points);
	void SetVectorSteps(double steps);
	void SetVectorTimeStep(double dt);
	void SetVectorDirection(int direction);
	///@}

	/**
	 * The tolerance to which quadratic tetrahedra are refined where they are cut; 0: they are refused.
	 */
	void SetTolerance(double tolerance);
	/**
	 * Threads of this process; 0: all.
	 */
	void SetThreads(int count);

	/**
	 * The ranks that cut together; the global controller at first.
	 */
	void SetController(vtkMultiProcessController* controller);

	///@{
	/**
	 * Of the first rank: how many grids were taken, how often neighbors of cells were built, and how many cuts were
	 * made.
	 */
	int GetGridsTaken();
	int GetNeighborsBuilt();
	int GetCutsMade();
	///@}

protected:
	vtkVolumeProbe();
	~vtkVolumeProbe() override;

	int FillInputPortInformation(int port, vtkInformation* info) override;
	int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
	int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
	vtkVolumeProbe(const vtkVolumeProbe&) = delete;
	void operator=(const vtkVolumeProbe&) = delete;

	struct State;
	std::unique_ptr<State> State_;
};

#endif
