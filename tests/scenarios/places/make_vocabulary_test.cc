#include "scenarios/places/make_vocabulary.h"

#include <gtest/gtest.h>

#include "estimator/svin2/vocabulary/vocabulary.h"
#include "scenarios/dataset/euroc_writer.h"
#include "scenarios/places/keyframe_views.h"
#include "sensors_models/base/check.h"
#include "tests/estimator/svin2/frontend/synthetic_dive.h"
#include "tests/support/temporary_folder.h"

namespace drydock {
namespace {

Pose PoseAt(int k) { return {ExpSO3({0, 0, 0.004 * k}), {0.0, 0.012 * k, 0.008 * k}}; }

/// Ten frames before a textured wall; the truth of the first `truths`.
void Record(const std::filesystem::path& folder, int truths) {
  const svin2::testing::WallDive wall;
  Rig rig = LoadRig(FindRig("svin2_v3"));
  const auto half = svin2::testing::HalfRig();
  rig.stereo.cameras = half.cameras;
  rig.stereo.T_IC = half.T_IC;
  dataset::EurocWriter writer(rig, folder);
  for (int k = 0; k < 10; ++k) {
    const Time t = SampleTime({}, k, 15.0);
    StereoFrame frame = wall.See(PoseAt(k));
    frame.index = k;
    writer.Add({t, t, std::move(frame)});
    dataset::TruthState state;
    state.T_WI = PoseAt(k);
    if (k < truths) writer.AddTruth(t, state);
  }
  writer.Commit();
}

TEST(MakeVocabulary, TrainsOnWhatTheFrontEndFollows) {
  const testing::TemporaryFolder folder;
  Record(folder.path() / "dive", 10);
  svin2::FeatureTracker::Config config;
  config.keyframes.max_gap = 4;
  const auto views = ViewKeyframes(folder.path() / "dive", config);
  ASSERT_EQ(views.size(), 3U);
  EXPECT_EQ(views[1].t, SampleTime({}, 4, 15.0));
  EXPECT_LT((views[1].T_WI.p() - PoseAt(4).p()).norm(), 1e-9);
  for (const KeyframeView& view : views) EXPECT_GE(view.descriptors.size(), 30U);

  const std::filesystem::path file = folder.path() / "wall.vocabulary";
  svin2::VocabularyTraining training;
  training.levels = 2;
  const VocabularySummary made = MakeVocabulary({folder.path() / "dive"}, 4, training, file);
  EXPECT_EQ(made.images, 3U);
  EXPECT_EQ(made.descriptors, views[0].descriptors.size() + views[1].descriptors.size() +
                                  views[2].descriptors.size());
  EXPECT_EQ(made.bytes, std::filesystem::file_size(file));
  EXPECT_EQ(svin2::Vocabulary::Load(file).words(), made.words);
}

TEST(ViewKeyframes, NeedsTheTruth) {
  const testing::TemporaryFolder folder;
  Record(folder.path() / "dive", 0);
  EXPECT_THROW(ViewKeyframes(folder.path() / "dive", {}), InputError);
}

}  // namespace
}  // namespace drydock
