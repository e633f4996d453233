#pragma once

#include "gpu/shader.h"
#include "gpu/shader_array.h"
#include "surface/expression.h"

#include <array>
#include <deque>
#include <memory>
#include <mutex>
#include <string>

namespace vp::classify
{

// The kinds of cells, points and values that a pipeline is made for (shared/classify_types.h).
using PipelineKinds = std::array<std::uint32_t, 3>;

// All but the shader. The descriptor sets of all these pipelines are alike, so a workspace serves any of them.
gpu::ComputePipelineInfo classifyPipelineInfo(const gpu::Device& device, const PipelineKinds& kinds);

// Runs the pipeline once, with no cells, since a driver may compile a shader on its first use. It may compile for the
// formats that are bound, so they are those of real work; `array` stands in for points, cells, cases and axes.
Status warmUp(gpu::Device& device, const gpu::Pipeline& pipeline, const PipelineKinds& kinds,
              const gpu::ShaderArray::Place& array);

// Pipelines that classify curved surfaces, made when they are asked for, and the last of them kept: a sweep asks for
// the same ones. Thread safe; outlives what it gives out.
class SurfacePipelines
{
public:
	explicit SurfacePipelines(gpu::Device& device) : device_(device) {}

	// expression: null for quadrics. array: see warmUp().
	Result<std::shared_ptr<const gpu::Pipeline>> get(std::uint32_t cells_kind, std::uint32_t points_kind,
	                                                 const surface::Expression* expression,
	                                                 const gpu::ShaderArray::Place& array);

	// The first that was made, which stays: workspaces take the layout of their descriptor sets from it.
	const gpu::Pipeline& first() const { return *first_; }

private:
	struct Made
	{
		PipelineKinds kinds;
		std::string text; // text of the expression; empty for quadrics
		std::shared_ptr<const gpu::Pipeline> pipeline;
	};

	Result<gpu::Pipeline> make(const PipelineKinds& kinds, const surface::Expression* expression);

	// An expression on every kind of block of a set, and the expression before it.
	static constexpr std::size_t kKept = 32;

	gpu::Device& device_;
	std::mutex mutex_;
	std::deque<Made> made_; // the last first
	std::shared_ptr<const gpu::Pipeline> first_;
};

} // namespace vp::classify
