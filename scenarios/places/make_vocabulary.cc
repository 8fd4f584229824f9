#include "scenarios/places/make_vocabulary.h"

#include <utility>

#include "estimator/svin2/vocabulary/vocabulary.h"
#include "scenarios/places/keyframe_views.h"

namespace drydock {

VocabularySummary MakeVocabulary(const std::vector<std::filesystem::path>& recordings, int max_gap,
                                 const svin2::VocabularyTraining& training,
                                 const std::filesystem::path& output) {
  svin2::FeatureTracker::Config config;
  config.keyframes.max_gap = max_gap;
  VocabularySummary summary;
  std::vector<std::vector<svin2::Descriptor>> images;
  for (const std::filesystem::path& recording : recordings) {
    for (KeyframeView& view : ViewKeyframes(recording, config)) {
      summary.descriptors += view.descriptors.size();
      images.push_back(std::move(view.descriptors));
    }
  }
  const svin2::Vocabulary vocabulary(svin2::TrainVocabulary(images, training));
  vocabulary.Save(output);
  summary.images = images.size();
  summary.words = vocabulary.words();
  summary.bytes = std::filesystem::file_size(output);
  return summary;
}

}  // namespace drydock
