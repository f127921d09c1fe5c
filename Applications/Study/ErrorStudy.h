/**
 * @file    ErrorStudy.h
 * @brief   error against run time: every scene, renderer and step, held against the reference
 */

#ifndef ErrorStudy_h
#define ErrorStudy_h

#include "RenderProgram.h"
#include "StudyLog.h"
#include "StudyPicture.h"
#include "StudyScenes.h"

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace penumbra
{

/// What draws a scene: a renderer, and how it makes shadows.
struct StudyVariant
{
  std::string Name;
  std::vector<std::string> Settings;
};

/// Those that this program has.
const std::vector<StudyVariant>& GetStudyVariants();

/// One picture of the grid.
struct ErrorRow
{
  std::string Scene;
  std::string Variant;
  /// Of the view rays, in the smallest voxel spacing; shadow rays take twice that.
  double Step = 0.0;
  PictureError Error;
  /// Medians over the frames that were timed.
  double Seconds = 0.0;
  double CpuSeconds = 0.0;
  /// Processor time as a multiple of the stock mapper's unlit frame at steps of one voxel.
  double Relative = 0.0;
};

struct ErrorStudyResult
{
  std::vector<ErrorRow> Rows;
  /// Where the grid ends earlier than it might, and why.
  std::vector<std::string> Notes;
  /// The reference's own estimate of its error, in grey levels of 255, by scene.
  std::map<std::string, double> ReferenceError;
  std::string OpenGLRenderer;
  std::string VTKVersion;
};

struct ErrorStudyOptions
{
  /// Takes what the study leaves there: reference pictures and the log.
  std::filesystem::path Folder;
  /// The whole grid, however long it takes.
  bool Full = false;
  /// Told how much is done, 0 to 1. May be empty.
  std::function<void(double)> Progress;
};

/**
 * @throw std::runtime_error where the reference of a scene cannot be rendered; a picture that
 * cannot is a note.
 */
ErrorStudyResult RunErrorStudy(const std::vector<StudyScene>& scenes, const RenderProgram& program,
  const ErrorStudyOptions& options);

}

#endif
