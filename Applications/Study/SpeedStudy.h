/**
 * @file    SpeedStudy.h
 * @brief   what shadows cost: every scene, size, number of lights and technique, in unlit frames of
 *          the stock mapper
 */

#ifndef SpeedStudy_h
#define SpeedStudy_h

#include "SpeedMeasurement.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace penumbra
{

struct SpeedStudyResult
{
  std::vector<SpeedRow> Rows;
  /// What is left out or done otherwise than asked, and why.
  std::vector<std::string> Notes;
  std::string OpenGLRenderer;
};

struct SpeedStudyOptions
{
  /// Takes the log of what is measured.
  std::filesystem::path Folder;
  SpeedMeasuring Measuring;
  /// Told how much is done, 0 to 1. May be empty.
  std::function<void(double)> Progress;
};

/**
 * Cells that an interrupted study has measured are not measured again, unless their scene has
 * changed.
 * @throw std::runtime_error where nothing can be drawn, or the log cannot be written.
 */
SpeedStudyResult RunSpeedStudy(
  const std::vector<SpeedCell>& cells, const SpeedStudyOptions& options);

/// Forgets what was measured, once it is written elsewhere: another run measures again.
void EndSpeedStudy(const std::filesystem::path& folder);

}

#endif
