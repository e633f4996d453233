#include "time_choice.h"

#include "complaints.h"
#include "manifest_writer.h"
#include "refusal.h"

#include <vtkAlgorithm.h>
#include <vtkInformation.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

// Of ascending times. Not by the least distance: far from all of them, they are equally far in floating point.
double nearest(const std::vector<double>& times, double wanted)
{
	const auto above = std::lower_bound(times.begin(), times.end(), wanted);
	if (above == times.begin())
		return times.front();
	if (above == times.end())
		return times.back();
	return wanted - above[-1] <= *above - wanted ? above[-1] : *above;
}

} // namespace

void updateAtTime(vtkAlgorithm& reader, const Request& request, ManifestWriter& manifest)
{
	reader.UpdateInformation();
	refuseOnComplaint();

	std::vector<double> times;
	vtkInformation* about = reader.GetOutputInformation(0);
	const auto key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
	if (about && about->Has(key))
		times.assign(about->Get(key), about->Get(key) + about->Length(key));
	std::erase_if(times, [](double time) { return !std::isfinite(time); });
	if (times.size() == 1 && times[0] == 0.0 && reader.IsA("vtkSimpleReader"))
		times.clear(); // the legacy readers make up a time 0
	std::sort(times.begin(), times.end());
	times.erase(std::unique(times.begin(), times.end()), times.end());

	if (times.empty())
		reader.Update();
	else
		reader.UpdateTimeStep(request.time == Request::Time::first  ? times.front()
		                      : request.time == Request::Time::last ? times.back()
		                                                            : nearest(times, request.time_value));
	refuseOnComplaint();
	if (reader.GetErrorCode() != 0)
		throw damaged("the reader gave up");
	manifest.offerTimes(std::move(times));
}
