// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model/view_state.hpp"

#include "model/colours.hpp"
#include "sample_path.hpp"
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace wcam::gui {
namespace {

using test::samplePath;

TEST(ViewState, BeginsWithAllLayersAndTheLastMove) {
  ViewState state;
  EXPECT_EQ(state.layerCount(), 0);
  EXPECT_EQ(state.end(), 0U);
  state.setPath(samplePath(4, 10));
  EXPECT_EQ(state.lower(), 0);
  EXPECT_EQ(state.upper(), 3);
  EXPECT_EQ(state.begin(), 0U);
  EXPECT_EQ(state.end(), 40U);
  EXPECT_EQ(state.move(), 39U);
}

TEST(ViewState, LayersAreClampedOrderedAndMoveTheCursor) {
  ViewState state;
  state.setPath(samplePath(4, 10));
  state.setLayers(9, 1);
  EXPECT_EQ(state.lower(), 1);
  EXPECT_EQ(state.upper(), 3);
  state.setLayers(1, 2);
  EXPECT_EQ(state.begin(), 10U);
  EXPECT_EQ(state.end(), 30U);
  EXPECT_EQ(state.move(), 29U);
  state.setMove(0);
  EXPECT_EQ(state.move(), 10U);
  state.setMove(1000);
  EXPECT_EQ(state.move(), 29U);
}

TEST(ViewState, SingleLayerFollowsTheUpperThumb) {
  ViewState state;
  state.setPath(samplePath(5, 4));
  state.setLayers(0, 3);
  state.setSingle(true);
  EXPECT_EQ(state.lower(), 3);
  EXPECT_EQ(state.upper(), 3);
  state.setLayers(0, 1);
  EXPECT_EQ(state.lower(), 1);
  EXPECT_EQ(state.upper(), 1);
  state.jumpTo(4 * 4 + 2);
  EXPECT_EQ(state.lower(), 4);
  EXPECT_EQ(state.upper(), 4);
  EXPECT_EQ(state.move(), 18U);
  state.setSingle(false);
  EXPECT_EQ(state.lower(), 0);
  EXPECT_EQ(state.upper(), 4);
}

TEST(ViewState, PlaybackRunsOnTheClockAndStopsAtTheEnd) {
  ViewState state;
  state.setPath(samplePath(2, 10));  // a move a second
  std::vector<unsigned> changes;
  state.listen([&](unsigned c) { changes.push_back(c); });
  state.setPlaying(true);
  EXPECT_EQ(state.move(), 0U) << "from the start when the end was shown";
  state.advance(3.0);
  EXPECT_EQ(state.move(), 3U);
  state.setSpeed(5.0);
  state.advance(2.0);
  EXPECT_EQ(state.move(), 14U) << "the way to the second layer takes no time";
  // Many small ticks make the same way as one: 1.9 s.
  for (int i = 0; i < 38; ++i) {
    state.advance(0.01);
  }
  EXPECT_EQ(state.move(), 16U);
  state.advance(100.0);
  EXPECT_EQ(state.move(), 19U);
  EXPECT_FALSE(state.playing());
  EXPECT_FALSE(changes.empty());
}

TEST(ViewState, AnEqualPathKeepsThePlaceAnotherOneDoesNot) {
  ViewState state;
  state.setPath(samplePath(4, 10));
  state.setLayers(1, 2);
  state.setMove(17);
  state.setPath(samplePath(4, 10));
  EXPECT_EQ(state.lower(), 1);
  EXPECT_EQ(state.upper(), 2);
  EXPECT_EQ(state.move(), 17U);
  state.setPath(samplePath(6, 10));
  EXPECT_EQ(state.lower(), 0);
  EXPECT_EQ(state.upper(), 5);
  EXPECT_EQ(state.move(), 59U);
  state.setPath(nullptr);
  EXPECT_EQ(state.layerCount(), 0);
  state.setPlaying(true);
  EXPECT_FALSE(state.playing());
  state.setMove(3);
  state.setLayers(2, 3);
  state.jumpTo(5);
  state.setTime(2.0);
  EXPECT_EQ(state.end(), 0U);
}

TEST(ViewState, AListenerMayForgetItselfAndChangeTheState) {
  ViewState state;
  state.setPath(samplePath(2, 5));
  int calls = 0;
  int id = 0;
  id = state.listen([&](unsigned) {
    ++calls;
    state.forget(id);
    state.setMove(1);
  });
  state.setMove(3);
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(state.move(), 1U);
}

TEST(Colours, ScaleRunsFromTheLowestToTheHighestValue) {
  const auto path = samplePath(3, 8);
  const Coloured all = colourPath(*path, Quantity::Height, std::nullopt);
  ASSERT_FALSE(all.empty);
  EXPECT_FLOAT_EQ(all.low, 1.0F);
  EXPECT_FLOAT_EQ(all.high, 3.0F);
  ASSERT_EQ(all.rgb.size(), 3 * path->size());
  const viewport::Colour low = scaleColour(0.0);
  const viewport::Colour high = scaleColour(1.0);
  EXPECT_EQ(all.rgb[0], low[0]);
  EXPECT_EQ(all.rgb[3 * (path->size() - 1)], high[0]);
  const Coloured narrow = colourPath(*path, Quantity::Height, std::pair(2.0F, 2.5F));
  EXPECT_FLOAT_EQ(narrow.low, 2.0F);
  // What lies outside of the limits has the colour of the nearest one.
  EXPECT_EQ(narrow.rgb[0], low[0]);
}

TEST(Colours, AQuantityWithoutValuesIsSaidToBeEmpty) {
  const Coloured none = colourPath(*samplePath(2, 4), Quantity::TcpSpeed, std::nullopt);
  EXPECT_TRUE(none.empty);
  const Coloured kinds = colourPath(*samplePath(2, 4), Quantity::Feature, std::nullopt);
  EXPECT_EQ(kinds.kinds, std::vector<int>{0});
}

}  // namespace
}  // namespace wcam::gui
