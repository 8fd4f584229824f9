#include "scenarios/report/contact_sheet.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace drydock::report {
namespace {

using testing::ElementsAre;

SheetFrame Frame(int type) {
  const cv::Mat image(60, 80, type, cv::Scalar::all(90));
  return {Time{1'500'000'000}, {image, image}};
}

TEST(ContactSheet, HasOneCellAPair) {
  const cv::Mat one = DrawContactSheet("dive", {Frame(CV_8UC1)});
  const cv::Mat two = DrawContactSheet("dive", {Frame(CV_8UC1), Frame(CV_8UC3)});
  const cv::Mat three = DrawContactSheet("dive", std::vector<SheetFrame>(3, Frame(CV_8UC1)));
  EXPECT_EQ(one.type(), CV_8UC3);
  EXPECT_EQ(one.cols, 1200);
  EXPECT_EQ(one.rows, two.rows);
  EXPECT_GT(three.rows, two.rows);
  EXPECT_EQ(DrawContactSheet("dive", {Frame(CV_8UC1)}, 1).cols, 1200);
}

TEST(ContactSheet, ShowsThePictures) {
  const cv::Mat sheet = DrawContactSheet("", {Frame(CV_8UC1)}, 1);
  EXPECT_EQ(sheet.at<cv::Vec3b>(sheet.rows / 2, 300), cv::Vec3b(90, 90, 90));
  EXPECT_EQ(sheet.at<cv::Vec3b>(sheet.rows / 2, 900), cv::Vec3b(90, 90, 90));
  EXPECT_EQ(sheet.at<cv::Vec3b>(sheet.rows - 2, 2), cv::Vec3b(255, 255, 255));
}

TEST(ContactSheet, EmptySheetIsATitle) { EXPECT_GT(DrawContactSheet("nothing", {}).rows, 0); }

TEST(ContactSheet, RefusesWhatIsNoPicture) {
  EXPECT_THROW(DrawContactSheet("", {{Time{0}, {cv::Mat(), cv::Mat()}}}), std::logic_error);
  EXPECT_THROW(DrawContactSheet("", {Frame(CV_32FC1)}), std::logic_error);
  EXPECT_THROW(DrawContactSheet("", {}, 0), std::logic_error);
}

TEST(SpreadEvenly, KeepsFirstAndLast) {
  EXPECT_THAT(SpreadEvenly(10, 4), ElementsAre(0, 3, 6, 9));
  EXPECT_THAT(SpreadEvenly(3, 8), ElementsAre(0, 1, 2));
  EXPECT_THAT(SpreadEvenly(5, 1), ElementsAre(0));
  EXPECT_THAT(SpreadEvenly(0, 4), ElementsAre());
  EXPECT_THAT(SpreadEvenly(100, 2), ElementsAre(0, 99));
}

}  // namespace
}  // namespace drydock::report
