#include "app/pages/line_plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace {

using testing::HasSubstr;
using testing::Not;

TEST(LinePlot, PutsTheEndsOfALineAtTheEndsOfItsPanel) {
  app::PlotPanel panel = app::panel_at(1, 0);
  panel.least_x = 2;
  panel.most_x = 4;
  EXPECT_EQ(panel.x(2), panel.left);
  EXPECT_EQ(panel.x(4), panel.left + app::kPanelWidth);
  EXPECT_EQ(panel.y(0), panel.top + app::kPanelHeight);
  EXPECT_EQ(panel.y(1), panel.top);
  EXPECT_GE(panel.left, app::panel_at(0, 0).left + app::kPanelWidth);
}

TEST(LinePlot, MarksTheAxesInStepsOfRoundNumbersAndEscapesNames) {
  app::PlotPanel panel = app::panel_at(0, 0);
  panel.least_x = 1;
  panel.most_x = 6;
  const std::string svg =
      app::panel_picture(1, 1, "a < b",
                         app::line_panel(panel, "GZ [m]", "heel [°]",
                                         {{.name = "x & y", .x = {1, 6}, .y = {0, 0.47}}}));
  for (const char* text : {"<svg ", "a &lt; b", "x &amp; y", ">GZ [m]<", ">heel [°]<", ">1<", ">6<",
                           ">0.1<", ">0.4<", "</svg>\n"})
    EXPECT_THAT(svg, HasSubstr(text));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(LinePlot, DrawsALevelLineInTheMiddle) {
  app::PlotPanel panel = app::panel_at(0, 0);
  const std::string svg = app::line_panel(panel, "LCB [m]", "draught [m]",
                                          {{.name = "", .x = {0, 1}, .y = {40, 40}}}, false);
  char middle[64];
  std::snprintf(middle, sizeof middle, "%.1f,%.1f ", panel.left, panel.top + app::kPanelHeight / 2);
  EXPECT_THAT(svg, HasSubstr(middle));
}

}  // namespace
