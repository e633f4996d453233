#include "gpu/compile_shader.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace vp::test
{

namespace
{

const char* const kSound = "#version 460\nlayout(local_size_x = 1) in;\nvoid main() {}\n";

} // namespace

TEST(CompileShader, GivesSpirv)
{
	const auto codes = gpu::compileComputeShader(kSound);
	ASSERT_TRUE(codes) << codes.error().message;
	ASSERT_GT(codes->size(), 5u);
	EXPECT_EQ(codes->front(), 0x07230203u);
}

TEST(CompileShader, SaysInOneLineWhatIsWrong)
{
	for (const char* source : {"", "void main() { x = 1; }", "#version 460\nvoid f();\nvoid main() { f(); }\n"})
	{
		const auto codes = gpu::compileComputeShader(source);
		ASSERT_FALSE(codes) << source;
		EXPECT_NE(codes.error().message.find("use `classify` cpu"), std::string::npos);
		EXPECT_EQ(codes.error().message.find('\n'), std::string::npos);
	}
}

TEST(CompileShader, ServesSeveralThreads)
{
	std::vector<std::thread> threads;
	std::vector<std::size_t> sizes(4);
	for (std::size_t t = 0; t < sizes.size(); ++t)
		threads.emplace_back([&, t] { sizes[t] = gpu::compileComputeShader(kSound)->size(); });
	for (std::thread& thread : threads)
		thread.join();
	for (const std::size_t size : sizes)
		EXPECT_EQ(size, sizes[0]);
}

} // namespace vp::test
