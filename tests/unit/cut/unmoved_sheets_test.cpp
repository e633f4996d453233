#include "sliced_sheet.h"
#include "test_grids.h"

#include "cut/cutter.h"
#include "probe/presets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace vp::test
{

namespace
{

class UnmovedSheets : public testing::TestWithParam<bool>
{
protected:
	const grid::BlockSet set_ = setOf(gridNamed("shell"));
	cut::Cutter cutter_{set_};
	cut::CutRequest request_ = [this]
	{
		cut::CutRequest request;
		request.in_generations = GetParam();
		request.probe.frame.origin = set_.bounds().center();
		for (const Vec3 normal : {Vec3(0.0, 0.0, 1.0), Vec3(0.3, 1.0, 0.2), Vec3(1.0, 0.1, 0.4)})
			request.probe.sheets.push_back(probe::makeSheet({0.01, 0.02, 0.03}, normal));
		return request;
	}();

	std::shared_ptr<const cut::Cut> cut(const cut::CutRequest& request)
	{
		return std::make_shared<const cut::Cut>(std::move(cutter_.cut(request).value()));
	}
	// As if nothing were kept.
	void expectRight(const cut::Cut& slice, cut::CutRequest request)
	{
		request.last.reset();
		const auto anew = cut(request);
		ASSERT_EQ(slice.sheets.size(), anew->sheets.size());
		for (std::size_t s = 0; s < slice.sheets.size(); ++s)
		{
			EXPECT_EQ(slice.sheets[s].shown, anew->sheets[s].shown);
			EXPECT_EQ(slice.sheets[s].cuts[0].cutCells(), anew->sheets[s].cuts[0].cutCells());
			EXPECT_EQ(slice.mesh(set_, s).positions, anew->mesh(set_, s).positions) << s;
			EXPECT_EQ(slice.sheets[s].seeds.count, anew->sheets[s].seeds.count);
		}
	}
	std::vector<bool> kept(const cut::Cut& last, const cut::Cut& next) const
	{
		std::vector<bool> same;
		for (std::size_t s = 0; s < next.sheets.size(); ++s)
			same.push_back(s < last.sheets.size() && last.sheets[s].number == next.sheets[s].number);
		return same;
	}
};

} // namespace

TEST_P(UnmovedSheets, AreNotCutAgain)
{
	const auto first = cut(request_);
	for (const cut::SheetCut& sheet : first->sheets)
		EXPECT_GT(sheet.number, 0u);
	request_.last = first;
	const auto second = cut(request_);
	EXPECT_EQ(kept(*first, *second), std::vector<bool>(3, true));
	expectRight(*second, request_);

	request_.last = nullptr;
	EXPECT_EQ(kept(*first, *cut(request_)), std::vector<bool>(3, false));
}

TEST_P(UnmovedSheets, OneThatMovedByTheLeastIsCut)
{
	const auto first = cut(request_);
	request_.last = first;
	request_.probe.sheets[1].origin.x = std::nextafter(request_.probe.sheets[1].origin.x, 1.0);
	const auto second = cut(request_);
	EXPECT_EQ(kept(*first, *second), (std::vector<bool>{true, false, true}));
	expectRight(*second, request_);

	request_.last = second;
	request_.probe.frame.origin.z += 0.1;
	const auto third = cut(request_);
	EXPECT_EQ(kept(*second, *third), std::vector<bool>(3, false));
	expectRight(*third, request_);
}

TEST_P(UnmovedSheets, WhatElseChangesThemIsSeen)
{
	const auto first = cut(request_);
	request_.last = first;
	request_.probe.sheets[0].window = probe::Window{-1.0, 1.0, -1.0, 1.0};
	request_.probe.sheets[1].fx.magnification = 2.0;
	request_.sheet_fields.resize(3);
	request_.sheet_fields[2] = grid::FieldChoice{"s"};
	const auto second = cut(request_);
	EXPECT_EQ(kept(*first, *second), std::vector<bool>(3, false));
	expectRight(*second, request_);
	request_.last = second;
	request_.corners = mesh::Corners::skip;
	EXPECT_EQ(kept(*second, *cut(request_)), std::vector<bool>(3, false));
}

TEST_P(UnmovedSheets, MoreOrFewerOfThem)
{
	const auto first = cut(request_);
	request_.last = first;
	const probe::Sheet added = probe::makeSheet({}, {0.5, 0.5, 0.1});
	request_.probe.sheets.push_back(added);
	const auto more = cut(request_);
	EXPECT_EQ(kept(*first, *more), (std::vector<bool>{true, true, true, false}));
	expectRight(*more, request_);
	request_.last = more;
	request_.probe.sheets.resize(1);
	const auto fewer = cut(request_);
	EXPECT_EQ(kept(*more, *fewer), std::vector<bool>{true});
	expectRight(*fewer, request_);
}

TEST_P(UnmovedSheets, GridSurfacesToo)
{
	request_.surface = surface::GridIndex{0, 2.0};
	const auto first = cut(request_);
	request_.last = first;
	EXPECT_EQ(kept(*first, *cut(request_)), std::vector<bool>{true});
	request_.surface = surface::GridIndex{0, 2.5};
	EXPECT_EQ(kept(*first, *cut(request_)), std::vector<bool>{false});
	request_.surface.reset();
	const auto planes = cut(request_);
	EXPECT_EQ(kept(*first, *planes), std::vector<bool>(3, false));
	expectRight(*planes, request_);
}

// Other values make other meshes of the same cells.
TEST_P(UnmovedSheets, RegatheredOnesHaveAnotherNumber)
{
	const auto first = cut(request_);
	const cut::Cut again = std::move(cutter_.regather(*first, nullptr).value());
	EXPECT_EQ(kept(*first, again), std::vector<bool>(3, false));
}

INSTANTIATE_TEST_SUITE_P(InGenerationsAndNot, UnmovedSheets, testing::Bool());

} // namespace vp::test
