// EGL and OSMesa draw the same pictures where both are Mesa's software rasteriser.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "sensors_models/base/files.h"
#include "tests/integration/cli/drydock_program.h"
#include "tests/support/temporary_folder.h"

namespace drydock::testing {
namespace {

namespace fs = std::filesystem;

class CliRenderers : public ::testing::Test {
 protected:
  /// The device that OpenGL names.
  std::string Record(const std::string& renderer) const {
    const Outcome run =
        RunDrydock(folder_.path(), {"run", BusScenario(), "--set", "duration_s=0.5", "--record",
                                    "--renderer", renderer, "-o", renderer});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const auto manifest =
        nlohmann::json::parse(ReadFile(folder_.path() / renderer / "manifest.json"));
    EXPECT_EQ(manifest["renderer"], renderer);
    return manifest["device"];
  }

  cv::Mat Image(const std::string& renderer, const fs::path& name) const {
    const fs::path file = folder_.path() / renderer / "dataset" / "mav0" / name;
    return cv::imread(file.string(), cv::IMREAD_UNCHANGED);
  }

  const TemporaryFolder folder_;
};

TEST_F(CliRenderers, EglAndOsmesaAgree) {
  const std::string egl = Record("egl"), osmesa = Record("osmesa");
  EXPECT_NE(osmesa.find("llvmpipe"), std::string::npos) << osmesa;
  if (egl.find("llvmpipe") == std::string::npos)
    GTEST_SKIP() << "EGL draws on " << egl << ": a GPU rounds as it likes";
  int images = 0;
  for (const fs::path folder : {"cam0/data", "cam1/data"}) {
    for (const auto& entry :
         fs::directory_iterator(folder_.path() / "egl" / "dataset" / "mav0" / folder)) {
      const fs::path name = folder / entry.path().filename();
      const cv::Mat one = Image("egl", name), other = Image("osmesa", name);
      ASSERT_EQ(one.size(), other.size()) << name;
      ASSERT_EQ(one.type(), other.type()) << name;
      cv::Mat difference;
      cv::absdiff(one, other, difference);
      EXPECT_LE(cv::norm(difference, cv::NORM_INF), 1.0) << name;
      EXPECT_LE(cv::countNonZero(difference), static_cast<int>(difference.total()) / 1000) << name;
      ++images;
    }
  }
  EXPECT_EQ(images, 2 * 8);
}

}  // namespace
}  // namespace drydock::testing
