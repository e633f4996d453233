#pragma once

#include "base/messages.h"
#include "gpu/device.h"

#include <gtest/gtest.h>

namespace vp::test
{

// A device for the test, with validation where it is installed; without a device the test is skipped. Whatever the test
// does, the validation layer has nothing to say about it.
class GpuTest : public testing::Test
{
protected:
	void SetUp() override
	{
		Result<std::unique_ptr<gpu::Device>> made = gpu::Device::create(options());
		if (!made)
			GTEST_SKIP() << made.error().message;
		device_ = std::move(*made);
	}
	void TearDown() override
	{
		if (!device_)
			return;
		EXPECT_TRUE(device_->waitIdle());
		EXPECT_EQ(device_->validationMessages(), 0u);
	}

	virtual gpu::DeviceOptions options() const
	{
		gpu::DeviceOptions options;
		options.validation = true;
		return options;
	}
	gpu::Device& device() { return *device_; }

private:
	MessageListener messages_{[](Severity, std::string_view line) { fmt::print(stderr, "{}\n", line); }};
	std::unique_ptr<gpu::Device> device_;
};

// Without validation: the layer of Debian 12 (1.3.239) crashes within itself now and then where one thread destroys a
// buffer while another records commands, which Vulkan allows.
class UnvalidatedGpuTest : public GpuTest
{
protected:
	gpu::DeviceOptions options() const override
	{
		gpu::DeviceOptions options;
		options.validation = false;
		return options;
	}
};

// Behaves as on a discrete device: only copies reach device memory.
class StagedGpuTest : public GpuTest
{
protected:
	gpu::DeviceOptions options() const override
	{
		gpu::DeviceOptions options = GpuTest::options();
		options.map_device_memory = false;
		return options;
	}
};

} // namespace vp::test
