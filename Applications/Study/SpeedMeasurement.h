/**
 * @file    SpeedMeasurement.h
 * @brief   one cell of the speed study, drawn in every way in turn
 */

#ifndef SpeedMeasurement_h
#define SpeedMeasurement_h

#include "RenderProgram.h"
#include "SpeedGrid.h"
#include "SpeedRow.h"

#include <filesystem>
#include <string>
#include <vector>

namespace penumbra
{

struct SpeedMeasuring
{
  /// The program penumbra-dicom-parser. Empty: DICOM is parsed in this process.
  std::filesystem::path DicomParser;
  /// Tells peak memory, of which a process has one.
  const RenderProgram* Program = nullptr;
  /// The techniques' resolutions too, and frames however long they take.
  bool Full = false;
};

struct SpeedCellResult
{
  /// Empty where the cell cannot be drawn.
  std::vector<SpeedRow> Rows;
  /// What is left out or done otherwise than asked, and why.
  std::vector<std::string> Notes;
  std::string OpenGLRenderer;
};

/**
 * All variants have a window each, and draw frames in turn, so that what else the machine does is
 * shared by all: first frames, then rounds of a frame, a light edit and an opacity edit each.
 */
SpeedCellResult MeasureSpeedCell(const SpeedCell& cell, const SpeedMeasuring& measuring);

/// "ct, 256 voxels, 512 pixels, 4 lights".
std::string NameOfCell(const SpeedCell& cell);

}

#endif
