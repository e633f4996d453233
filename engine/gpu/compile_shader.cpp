#include "gpu/compile_shader.h"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <mutex>
#include <string_view>

namespace vp::gpu
{

namespace
{

// The tables of the library live from the first use to the end of the program.
struct Library
{
	Library() { glslang::InitializeProcess(); }
	~Library() { glslang::FinalizeProcess(); }
};

Error compilerError(std::string_view log)
{
	return {ErrorKind::internal, fmt::format("a shader for the surface cannot be compiled ({}); use `classify` cpu",
	                                         log.substr(0, log.find('\n')))};
}

} // namespace

Result<std::vector<std::uint32_t>> compileComputeShader(const std::string& source)
{
	// A user types expressions, so compiling one at a time loses nothing.
	static std::mutex mutex;
	const std::lock_guard lock(mutex);
	static const Library library;

	constexpr auto kMessages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
	constexpr int kVersion = 460;
	const char* const text = source.c_str();
	glslang::TShader shader(EShLangCompute);
	shader.setStrings(&text, 1);
	shader.setEnvInput(glslang::EShSourceGlsl, EShLangCompute, glslang::EShClientVulkan, kVersion);
	shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
	shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
	if (!shader.parse(GetDefaultResources(), kVersion, false, kMessages))
		return compilerError(shader.getInfoLog());
	glslang::TProgram program;
	program.addShader(&shader);
	if (!program.link(kMessages))
		return compilerError(program.getInfoLog());
	std::vector<std::uint32_t> words;
	glslang::SpvOptions options;
	options.disableOptimizer = true; // drivers have their own
	glslang::GlslangToSpv(*program.getIntermediate(EShLangCompute), words, &options);
	return words;
}

} // namespace vp::gpu
