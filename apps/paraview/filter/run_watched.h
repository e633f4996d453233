#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

class vtkAlgorithm;

namespace vprobe_paraview
{

// Runs `work` on a thread of its own. This thread reports progress, so that a client can ask to abort, and passes such
// a request on. The text of the progress says what the library is busy with. Warnings of the library are returned; they
// are for this thread to tell.
std::vector<std::string> runWatched(vtkAlgorithm& filter, double progress,
                                    const std::function<void(std::stop_token)>& work);

} // namespace vprobe_paraview
