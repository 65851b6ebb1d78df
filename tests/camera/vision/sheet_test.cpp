#include "eyebridge/camera/sheet.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/files/load.hpp"
#include "fiducials/vision.hpp"

namespace eyebridge::camera::testing {
namespace {

using ::testing::HasSubstr;

constexpr double kPagePixelsPerMillimetre = 4.0;

world::WorldModel maze() {
  return files::load_scenario(EYEBRIDGE_SOURCE_DIR "/worlds/maze-5.maz").world;
}

TEST(FiducialSheet, HasEveryFiducialTrueToSizeOnItsPages) {
  const auto model = maze();
  for (const double size : {0.08, 0.04}) {
    const auto fiducials = place_fiducials(model, {.size = size});
    const FiducialSheet sheet{model, fiducials, "maze-5.maz"};
    std::set<int> ids;
    for (int page = 2; page <= pages_of(sheet); ++page) {
      for (const auto& seen : vision().find_fiducials(
               draw_page(sheet, page, kPagePixelsPerMillimetre), FiducialFamily::Aruco5x5)) {
        EXPECT_TRUE(ids.insert(seen.id).second) << seen.id;
        const double edge = size * 1000.0 * kPagePixelsPerMillimetre;
        for (std::size_t i = 0; i < 4; ++i) {
          EXPECT_NEAR(norm(seen.corners[i] - seen.corners[(i + 1) % 4]), edge, 0.8);
        }
        EXPECT_LT(seen.corners[0].y, seen.corners[3].y);  // upright
        EXPECT_NEAR(seen.corners[0].y, seen.corners[1].y, 0.5);
      }
    }
    EXPECT_EQ(ids.size(), fiducials.size());
  }
}

TEST(FiducialSheet, BeginsAPageWithEachFiducialThatNoLongerFits) {
  const auto model = maze();
  for (const double size : {0.08, 0.04}) {
    const auto all = place_fiducials(model, {.size = size});
    const Frame full = draw_page({model, all, ""}, 2, kPagePixelsPerMillimetre);
    const std::size_t fit = vision().find_fiducials(full, FiducialFamily::Aruco5x5).size();
    ASSERT_GT(fit, 1U);
    ASSERT_GT(all.size(), 2 * fit);
    int pages = 1;  // the map
    for (std::size_t count = 0; count <= 2 * fit + 1; ++count) {
      if (count % fit == 1) ++pages;
      const std::vector<Fiducial> some(all.begin(),
                                       all.begin() + static_cast<std::ptrdiff_t>(count));
      EXPECT_EQ(pages_of({model, some, ""}), pages) << count << " of " << size << " m";
    }
  }
}

TEST(FiducialSheet, ItsMapShowsNoFiducialThatACameraCouldTakeForOne) {
  const auto model = maze();
  const auto fiducials = place_fiducials(model);
  const Frame map = draw_page(FiducialSheet{model, fiducials, "maze-5.maz"}, 1, 4.0);
  EXPECT_EQ(map.width, 840);
  EXPECT_EQ(map.height, 1188);
  EXPECT_TRUE(vision().find_fiducials(map, FiducialFamily::Aruco5x5).empty());
  EXPECT_THROW(draw_page(FiducialSheet{model, fiducials, ""}, 1000, 1.0), std::out_of_range);
}

TEST(FiducialSheet, IsWrittenAsAPdfOfThatManyPages) {
  const auto model = maze();
  const auto fiducials = place_fiducials(model);
  const FiducialSheet sheet{model, fiducials, "maze-5.maz"};
  const std::filesystem::path path =
      ::testing::TempDir() + "/eyebridge_sheet_" + std::to_string(getpid()) + ".pdf";
  write_pdf(sheet, path);
  std::ifstream in(path, std::ios::binary);
  const std::string pdf((std::istreambuf_iterator<char>(in)), {});
  EXPECT_THAT(pdf.substr(0, 5), "%PDF-");
  EXPECT_THAT(pdf, HasSubstr("/Count " + std::to_string(pages_of(sheet))));
}

TEST(FiducialSheet, AFileThatCannotBeWrittenIsNamed) {
  const auto model = maze();
  const auto fiducials = place_fiducials(model);
  try {
    write_pdf(FiducialSheet{model, fiducials, ""}, "/no/such/folder/sheet.pdf");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/no/such/folder/sheet.pdf"));
  }
}

TEST(FiducialSheet, FiducialsLargerThanThePaperAreRefused) {
  world::WorldModel model;
  model.width = model.height = 4.0;
  model.walls = {{{1.0, 1.0}, {2.0, 1.0}, 0.0, 1.0}};
  const auto fiducials = place_fiducials(model, {.size = 0.2});
  EXPECT_THROW(pages_of({model, fiducials, ""}), ConfigError);
}

TEST(BoardSheet, ABoardThatDoesNotFitOnThePaperIsRefused) {
  EXPECT_THROW(draw_page(Board{Board::Kind::Charuco, 12, 7, 0.03}, 1.0), ConfigError);
  EXPECT_NO_THROW(draw_page(Board{Board::Kind::Chessboard, 9, 6, 0.025}, 1.0));  // turned
}

}  // namespace
}  // namespace eyebridge::camera::testing
